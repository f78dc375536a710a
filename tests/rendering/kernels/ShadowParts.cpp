#include "ShadowParts.h"

#include <gtest/gtest.h>

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mote::testing
{

Film tracedFilm(
  const Scene& scene, const Camera& camera, int width, int height, const Tracing& tracing)
{
  Film film;
  film.resize(width, height > 0 ? height : width, Film::Id);
  RayCaster caster(scene);
  caster.setThreads(tracing.threads);
  caster.setBundleSide(tracing.side);
  for (int k = 0; k < tracing.samples; ++k)
    EXPECT_TRUE(caster.addSample(camera, film));
  return film;
}

Light shadowLight(Light::Kind kind, const Vec3d& vector, int samples, double size)
{
  Light light;
  light.kind = kind;
  light.vector = vector;
  light.shadows = true;
  light.samples = samples;
  light.size = size;
  return light;
}

FilmDifference differenceOf(const Film& a, const Film& b)
{
  FilmDifference found;
  for (std::size_t i = 0; i < a.pixels(); ++i)
  {
    double most = 0.0;
    for (std::size_t c = 4 * i; c < 4 * i + 4; ++c)
      most = std::max(most, std::abs(double(a.color()[c]) - b.color()[c]));
    if (!(most <= 0.01))
      ++found.pixels;
    else
      found.rest = std::max(found.rest, most);
  }
  return found;
}

double rmsOf(const Film& a, const Film& b)
{
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels(); ++i)
    if (a.object()[i] >= 0 && b.object()[i] >= 0)
    {
      const double difference = double(a.color()[4 * i]) - b.color()[4 * i];
      sum += difference * difference;
      ++count;
    }
  return std::sqrt(sum / double(std::max<std::size_t>(count, 1)));
}

void ShadowOracle::add(const Particles& particles, const Mat4d& toWorld)
{
  addTo(scene_, objectOf(particles, toWorld));
  objects_.push_back({reference::validSpheres(particles.set()), toWorld, glm::inverse(toWorld)});
}

ShadowOracle::Surface ShadowOracle::surfaceAt(
  const Film& film, std::size_t pixel, const reference::Ray& ray) const
{
  Surface at;
  at.object = static_cast<std::size_t>(film.object()[pixel]);
  at.sphere = film.id()[pixel];
  const Object& object = objects_[at.object];
  const reference::Sphere& sphere = object.spheres[at.sphere];
  // The film's depth is a float: the point is put back onto its sphere.
  const Vec3d near = ray.origin + double(film.depth()[pixel]) * ray.direction;
  const Vec3d outward = glm::normalize(transformPoint(object.toLocal, near) - sphere.center);
  at.position = transformPoint(object.toWorld, sphere.center + sphere.radius * outward);
  at.normal = glm::normalize(glm::transpose(Mat3d(object.toLocal)) * outward);
  if (glm::dot(at.normal, ray.direction) > 0.0)
    at.normal = -at.normal;
  return at;
}

bool ShadowOracle::isLit(const Surface& at, const LightSample& sample, double grown) const
{
  const bool isPoint = sample.kind == Light::Kind::Point;
  for (std::size_t k = 0; k < objects_.size(); ++k)
  {
    const Object& object = objects_[k];
    reference::Ray ray;
    // Towards a direction the rays start a thousand lengths away: out of these small scenes.
    const Vec3d start = isPoint ? sample.place : at.position + 1000.0 * sample.place;
    ray.origin = transformPoint(object.toLocal, start);
    ray.direction = transformPoint(object.toLocal, at.position) - ray.origin;
    ray.tMax = 1.0;
    for (reference::Sphere sphere : object.spheres)
    {
      if (k == at.object && sphere.particle == at.sphere)
        continue;
      sphere.radius += grown;
      reference::Hit hit;
      if (sphere.radius > 0.0)
        reference::meet(ray, sphere, hit);
      if (hit)
        return false;
    }
  }
  return true;
}

ShadowReport ShadowOracle::judge(
  const Camera& camera, int width, int height, const Tracing& tracing) const
{
  const Film film = tracedFilm(scene_, camera, width, height, tracing);
  const CameraRays rays(camera, width, height);
  std::vector<std::vector<LightSample>> lights;
  for (const Light& light : scene_.lights)
    lights.push_back(lightSamples(light, scene_.bounds().center(), 0));
  ShadowReport report;
  for (std::size_t i = 0; i < film.pixels(); ++i)
  {
    if (film.object()[i] < 0)
      continue;
    const auto x = static_cast<double>(i % std::size_t(width));
    const auto y = static_cast<double>(i / std::size_t(width));
    const Surface at = surfaceAt(film, i, reference::cameraRay(rays, x + 0.5, y + 0.5));
    double low = 0.0, high = 0.0, all = 0.0;
    for (const auto& samples : lights)
      for (const LightSample& sample : samples)
      {
        const Vec3d way =
          sample.kind == Light::Kind::Point ? sample.place - at.position : sample.place;
        const double light =
          std::max(0.0, glm::dot(at.normal, glm::normalize(way))) / double(samples.size());
        all += light;
        low += light > 0.0 && isLit(at, sample, slack_) ? light : 0.0;
        high += light > 0.0 && isLit(at, sample, -slack_) ? light : 0.0;
      }
    const double red = film.color()[4 * i];
    const double margin = 1e-5;
    const bool right = red >= std::min(low, 1.0) - margin && red <= std::min(high, 1.0) + margin;
    ++report.pixels;
    report.shadowed += high < 0.99 * all;
    report.ambiguous += high > low;
    report.wrong += !right;
    if (!right && report.complaint.empty())
    {
      std::ostringstream text;
      text << "pixel " << x << ' ' << y << " of object " << at.object << ", sphere " << at.sphere
           << " is " << red << ", not between " << low << " and " << high << "; unshadowed " << all;
      report.complaint = text.str();
    }
  }
  return report;
}

} // namespace mote::testing
