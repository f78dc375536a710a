#pragma once

#include "../particles/EmbreeOcclusion.h"
#include "SecondaryRays.h"

#include <vector>

namespace mote::bench
{

/// Finds what rays meet first by Embree, in parallel: one by one, in packets of 16, or in streams
/// of 64, by the number of the mode.
void embreeNearest(std::size_t mode, RTCScene scene, RTCIntersectContextFlags flags,
  const OcclusionRays& rays, std::vector<PacketHits>& hits);

} // namespace mote::bench
