#include "LightSamples.h"

#include "../core/RayBundle.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

bool isFinite(const Vec3d& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Unit vector along `v` whatever its length, or 0 where there is none.
Vec3d unitOf(const Vec3d& v)
{
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest > 0.0 && std::isfinite(largest) ? glm::normalize(v / largest) : Vec3d(0.0);
}

} // namespace

std::vector<LightSample> lightSamples(const Light& light, const Vec3d& faced, int filmSample)
{
  if (light.kind == Light::Kind::Headlight)
    return {LightSample{}};
  const bool isPoint = light.kind == Light::Kind::Point;
  const Vec3d direction = unitOf(light.vector);
  if (!isFinite(light.vector) || (!isPoint && direction == Vec3d(0.0)))
    return {};
  const Vec3d middle = isPoint ? light.vector : -direction;
  const int n = light.shadows ? std::clamp(light.samples, 1, 64) : 1;
  if (n == 1 || !(light.size > 0.0) || !std::isfinite(light.size))
    return {LightSample{light.kind, middle}};

  const Vec3d towards = unitOf(faced - light.vector);
  Vec3d u, v;
  acrossAxes(isPoint ? (towards == Vec3d(0.0) ? Vec3d(0.0, 0.0, 1.0) : towards) : direction, u, v);
  const double degree = M_PI / 180.0;
  const double edge =
    isPoint ? light.size : 2.0 * std::tan(0.5 * degree * std::min(light.size, 170.0));
  // Other irrational steps than those of the pixel's own samples, which these must not follow.
  const auto place = [](double at) { return at - std::floor(at) - 0.5; };
  const double shiftU = filmSample * (std::sqrt(2.0) - 1.0);
  const double shiftV = filmSample * (std::sqrt(3.0) - 1.0);
  std::vector<LightSample> samples;
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column)
    {
      const double a = place((column + (row + 0.5) / n) / n + shiftU);
      const double b = place((row + (column + 0.5) / n) / n + shiftV);
      const Vec3d at = middle + edge * (a * u + b * v);
      samples.push_back({light.kind, isPoint ? at : glm::normalize(at)});
    }
  return samples;
}

} // namespace mote
