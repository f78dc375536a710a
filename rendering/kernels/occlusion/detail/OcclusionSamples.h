#pragma once

#include "../../core/Vec.h"

#include <cstdint>
#include <vector>

namespace mote
{

/// Unit vectors spread evenly over the sphere, in blocks of up to 16 that lie together: Fibonacci's
/// spiral, parted by medians. What a block has too few of is 0.
struct OcclusionDirections
{
  static constexpr int lanes = 16;

  /// Of `count` of them one in `period`, or with `others` all others.
  explicit OcclusionDirections(int count, int period = 1, bool others = false);
  /// The same turned at random, by a rotation that `seed` chooses evenly.
  void turn(std::uint32_t seed, OcclusionDirections& turned) const;

  int blocks = 0;
  std::vector<float> x, y, z; ///< `lanes` a block
};

/// Places on the unit sphere that stand for the texels of a map.
struct OcclusionPlaces
{
  static constexpr int jitters = 8;

  explicit OcclusionPlaces(int side);

  int side;
  int texels;                       ///< side * side
  std::vector<std::uint32_t> order; ///< of the texels, in which neighbours lie together
  std::vector<Vec3f> middles;       ///< of the texels
  std::vector<Vec3f>
    jittered; ///< `jitters` a texel, evenly over its area, its middle's nearest first
};

} // namespace mote
