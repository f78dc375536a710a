#pragma once

#include <kernels/core/Camera.h>
#include <kernels/particles/ParticleSet.h>

#include <cstddef>
#include <limits>
#include <vector>

/// The oracle: answers the question that the kernels answer, independently of how they do it. It
/// shares with them the types that state the question and nothing else.
namespace mote::reference
{

/// One ray; hits with tMin < t < tMax count, t in lengths of `direction`.
struct Ray
{
  Vec3d origin{0.0};
  Vec3d direction{0.0, 0.0, 1.0};
  double tMin = 0.0;
  double tMax = std::numeric_limits<double>::infinity();
};

/// The nearest hit, or none.
struct Hit
{
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  double t = std::numeric_limits<double>::infinity();
  std::size_t particle = none; ///< input index
  explicit operator bool() const { return particle != none; }
};

/// One sphere in double, with its place in the input.
struct Sphere
{
  Vec3d center;
  double radius;
  std::size_t particle;
};

/// The valid particles of a set: coordinates and radius finite, radius above zero.
std::vector<Sphere> validSpheres(const ParticleSet& particles);

/// Takes the sphere into `hit` where it is nearer, or as near with a smaller input index. The
/// nearer crossing with t > tMin counts, so from within a sphere its far side is met. Computed in
/// long double.
void meet(const Ray& ray, const Sphere& sphere, Hit& hit);

/// Tries every sphere.
Hit bruteForce(const std::vector<Sphere>& spheres, const Ray& ray);

/// The ray through image position (x, y), in pixels.
Ray cameraRay(const CameraRays& rays, double x, double y);

} // namespace mote::reference
