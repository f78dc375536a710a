#pragma once

#include "../../core/RawVector.h"
#include "../../particles/NearParticle.h"
#include "OcclusionSamples.h"

#include <cstdint>
#include <vector>

namespace mote
{

/// The spheres around a particle, prepared for its own rays: whether a ray from its surface meets
/// one takes an addition and a comparison.
///
/// All lengths count in the particle's radius, from its centre. A ray from P, |P| = 1, in direction
/// w enters a sphere (c, r) that P does not lie in where c w > P w + T, T being the length of the
/// tangent from P, the root of |c|^2 + 1 - r^2 - 2 c P: one number for all rays of P. Where rays
/// end after the length R, and T is longer, (T^2 + R^2) / (2 R) stands in its place.
struct OcclusionNear
{
  static constexpr std::size_t lanes = OcclusionDirections::lanes;

  /// Takes the spheres in `found` that float numbers can tell about, at most about `most`, those
  /// that look largest first. Rays end after `reach`.
  void place(const std::vector<NearParticle>& found, const Vec3d& center, double radius,
    std::uint64_t self, double reach, std::size_t most);

  /// Fills, for each of `count` places on the unit sphere and each block of directions, the bits of
  /// rays that rise above the surface, and of those which no sphere stops.
  void ask(const OcclusionDirections& directions, const Vec3f* places, std::size_t count,
    std::uint16_t* facing, std::uint16_t* unmet);

  std::size_t count = 0;          ///< spheres; numbers are there for a multiple of `lanes`
  RawVector<float> x, y, z, r, k; ///< c, r and |c|^2 + 1 - r^2
  RawVector<float> nearest;       ///< the least T over the particle's surface
  float reach = 0.0f;
  /// Whether the spheres are all that were found, and all of those that come between the surface
  /// and the planes that touch it.
  bool hasAll = false, hasTouching = false;

private:
  struct Looks
  {
    double distance; ///< between the surfaces, in radii of the other
    std::size_t found;
  };
  std::vector<Looks> order_;
  RawVector<float> along_;           ///< c w, by sphere and direction
  RawVector<std::uint16_t> mayMeet_; ///< blocks of a group, by sphere
};

/// Adds the cosines of the rays of a place, times their directions' light, to
/// `all`, and those of the rays that are set in `unmet` to `open`.
void addOcclusionRays(const OcclusionDirections& directions, const float* light, const Vec3f& place,
  const std::uint16_t* facing, const std::uint16_t* unmet, float& open, float& all);

} // namespace mote
