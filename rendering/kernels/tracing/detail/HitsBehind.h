#pragma once

#include "SceneRays.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace mote
{

/// A ray that goes on behind what it has met.
struct PassingRay
{
  int ray = 0;                       ///< of the bundle that it comes from
  Vec3d origin{0.0}, direction{0.0}; ///< in the world, from the rays' reference point
  double t = 0.0;                    ///< of the last hit
  double limit = 0.0;                ///< farthest t that counts
  std::int32_t object = -1;          ///< last surface that was hit; -1 afterwards: nothing is left
  std::uint64_t slot = 0;
  std::vector<std::pair<std::int32_t, std::uint64_t>> passed; ///< what has been hit: object, slot
  int again = 0; ///< hits in a row that lie where the one before did, to rounding
};

/// Sends each ray on to what it meets next. Everything counts once, where it is met first: not the
/// far side of a sphere that was passed. Footprints are those of RayBundle, in the world, where
/// surfaces may err by some.
void findNextHits(const SceneRays& scene, std::vector<PassingRay>& rays, double footprint = 0.0,
  double footprintPerT = 0.0);

} // namespace mote
