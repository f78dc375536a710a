#pragma once

#include <kernels/tracing/Picking.h>

#include <support/Particles.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace mote::testing
{

/// An object over the particles; they must outlive nothing, the structure copies them.
inline SurfaceObject objectOf(const Particles& particles, const Mat4d& toWorld = Mat4d(1.0))
{
  SurfaceObject object;
  object.surface = ParticleSurface(makeParticleStructure(particles.set()));
  object.toWorld = toWorld;
  return object;
}

/// The structure of a surface of particles.
inline const std::shared_ptr<const ParticleStructure>& particlesOf(const SurfaceObject& object)
{
  return std::get<ParticleSurface>(object.surface).structure();
}

/// Adds a surface; its id is its place.
inline void addTo(Scene& scene, SurfaceObject object)
{
  object.id = static_cast<std::int32_t>(scene.surfaces.size());
  scene.surfaces.push_back(std::move(object));
}

/// A scene of one sphere of radius `radius` about the origin.
inline Scene oneSphere(double radius = 1.0)
{
  Particles particles;
  particles.add(Vec3d(0.0), radius);
  Scene scene;
  addTo(scene, objectOf(particles));
  return scene;
}

/// The share of the sky that a sphere takes from a surface, also where it stands partly below its
/// horizon: I. Quilez, "Sphere ambient occlusion" (2014), after the form factor of Snyder.
inline double occlusionBySphere(
  const Vec3d& position, const Vec3d& normal, const Vec3d& center, double radius)
{
  const Vec3d way = center - position;
  const double distance = glm::length(way), cosine = glm::dot(normal, way) / distance;
  const double h2 = distance * distance / (radius * radius), k2 = 1.0 - h2 * cosine * cosine;
  if (k2 <= 0.0 || h2 <= 1.0)
    return std::max(0.0, cosine) / h2;
  const double edge =
    std::clamp(-cosine * std::sqrt((h2 - 1.0) / (1.0 - cosine * cosine)), -1., 1.);
  const double part = cosine * std::acos(edge) - std::sqrt(k2 * (h2 - 1.0));
  return (part / h2 + std::atan(std::sqrt(k2 / (h2 - 1.0)))) / M_PI;
}

/// Turned, moved, and scaled by up to 3 times as much along one axis as along another.
inline Mat4d unevenTransform(Random& random)
{
  Mat4d m = glm::translate(Mat4d(1.0), random.inBox(Vec3d(-0.5), Vec3d(0.5)));
  m = glm::rotate(m, random(0.0, 6.0), random.direction());
  return glm::scale(m, random.inBox(Vec3d(0.5), Vec3d(1.5)));
}

} // namespace mote::testing
