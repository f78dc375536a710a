#pragma once

#include <cstdint>

namespace mote
{

/// What a cast did, summed over bundles.
struct CastCounts
{
  std::uint64_t slices = 0;    ///< visited, across the major axis
  std::uint64_t cells = 0;     ///< visited
  std::uint64_t particles = 0; ///< in those cells
  std::uint64_t inFrustum = 0; ///< left after culling by the frustum
  std::uint64_t tests = 0;     ///< of a particle against a block of 16 rays
  std::uint64_t hits = 0;      ///< particles that were the nearest hit so far of a ray
};

} // namespace mote
