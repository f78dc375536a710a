#pragma once

#include "Light.h"

#include <vector>

namespace mote
{

/// One of the points, or directions, that stand for a light with size.
struct LightSample
{
  Light::Kind kind = Light::Kind::Headlight;
  Vec3d place{0.0}; ///< Point: where it is. Directional: unit vector towards it
};

/// The square that a light shines from: of points about the place of a point light, facing
/// `faced`, or of directions. Sizes that are not finite or not above 0 are 0, angles up to 170
/// degrees.
class LightSquare
{
public:
  LightSquare(const Light& light, const Vec3d& faced);

  /// Whether it shines: numbers are finite, and a direction has a length.
  bool isLight() const { return isLight_; }
  bool hasSize() const { return edge_ > 0.0; }
  /// The sample at a place of the square, [-1/2, 1/2] from its middle.
  LightSample at(double x, double y) const;
  /// Moves places, and not directions.
  void move(const Vec3d& by);

private:
  Light::Kind kind_;
  bool isLight_ = false;
  Vec3d middle_{0.0}, u_{0.0}, v_{0.0};
  double edge_ = 0.0;
};

/// The samples of a light, in world coordinates; each sends the same share of the light.
///
/// A light that casts shadows has samples x samples of them: a point light over the square about it
/// that faces `faced`, a directional light over the square of directions about its own. One sample,
/// and any light without shadows, stands in the middle. The pattern is stratified, has samples^2
/// different distances from either edge (Kensler, "Correlated Multi-Jittered Sampling", 2013,
/// without the jitter), and moves on round the square with `filmSample`, so that the mean over film
/// samples tends to the whole square.
///
/// A light that is no light gives none: numbers that are not finite, a direction of length 0.
/// Light::samples is clamped to [1, 64], Light::size to [0, 170] degrees or to what is finite.
std::vector<LightSample> lightSamples(const Light& light, const Vec3d& faced, int filmSample);

} // namespace mote
