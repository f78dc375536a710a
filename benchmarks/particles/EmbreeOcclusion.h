#pragma once

#include "../EmbreeDevice.h"
#include "OcclusionRays.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace mote::bench
{

/// Up to 64 rays in float, from the middle of the spheres, that ask Embree for anything in their
/// way. Arrays hold 64 numbers, whatever the count.
struct EmbreeRays
{
  static constexpr int capacity = 64;

  int count = 0;
  std::array<const float*, 3> origin{}, direction{};
  const float* nearest = nullptr;  ///< where each ray begins, in lengths of its direction; null: 0
  const float* farthest = nullptr; ///< where each ray ends; null: `reach`
  float reach = 0.0f;

  float begin(int i) const { return nearest != nullptr ? nearest[i] : 0.0f; }
  float end(int i) const { return farthest != nullptr ? farthest[i] : reach; }
};

/// The ways that Embree has of answering 64 rays.
const std::vector<std::string>& embreeOcclusionModes();

/// Bits of the rays that meet a sphere, in the way of that number. `flags` say whether the rays run
/// alike.
std::uint64_t embreeOccluded(
  std::size_t mode, RTCScene scene, RTCIntersectContextFlags flags, const EmbreeRays& rays);

/// The same for rays that have little in common, in parallel.
void embreeOccluded(
  std::size_t mode, RTCScene scene, const OcclusionRays& rays, OcclusionAnswers& answers);

} // namespace mote::bench
