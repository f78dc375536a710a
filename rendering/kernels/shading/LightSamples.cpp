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

LightSquare::LightSquare(const Light& light, const Vec3d& faced)
  : kind_(light.kind)
{
  const bool isPoint = kind_ == Light::Kind::Point;
  const Vec3d direction = unitOf(light.vector);
  isLight_ = isFinite(light.vector) && (isPoint || direction != Vec3d(0.0));
  middle_ = isPoint ? light.vector : -direction;
  if (!isLight_ || !(light.size > 0.0) || !std::isfinite(light.size))
    return;
  const Vec3d towards = unitOf(faced - light.vector);
  acrossAxes(
    isPoint ? (towards == Vec3d(0.0) ? Vec3d(0.0, 0.0, 1.0) : towards) : direction, u_, v_);
  const double degree = M_PI / 180.0;
  edge_ = isPoint ? light.size : 2.0 * std::tan(0.5 * degree * std::min(light.size, 170.0));
}

LightSample LightSquare::at(double x, double y) const
{
  const Vec3d place = middle_ + edge_ * (x * u_ + y * v_);
  return {kind_, kind_ == Light::Kind::Point || !hasSize() ? place : glm::normalize(place)};
}

void LightSquare::move(const Vec3d& by)
{
  if (kind_ == Light::Kind::Point)
    middle_ += by;
}

std::vector<LightSample> lightSamples(const Light& light, const Vec3d& faced, int filmSample)
{
  if (light.kind == Light::Kind::Headlight)
    return {LightSample{}};
  const LightSquare square(light, faced);
  if (!square.isLight())
    return {};
  const int n = light.shadows ? std::clamp(light.samples, 1, 64) : 1;
  if (n == 1 || !square.hasSize())
    return {square.at(0.0, 0.0)};

  // Other irrational steps than those of the pixel's own samples, which these must not follow.
  const auto place = [](double at) { return at - std::floor(at) - 0.5; };
  const double shiftU = filmSample * (std::sqrt(2.0) - 1.0);
  const double shiftV = filmSample * (std::sqrt(3.0) - 1.0);
  std::vector<LightSample> samples;
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column)
      samples.push_back(square.at(place((column + (row + 0.5) / n) / n + shiftU),
        place((row + (column + 0.5) / n) / n + shiftV)));
  return samples;
}

} // namespace mote
