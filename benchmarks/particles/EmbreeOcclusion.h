#pragma once

#include "../EmbreeDevice.h"
#include "OcclusionRays.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
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

/// The rays of a packet, all as far as `reach`.
EmbreeRays embreeRays(const OcclusionRays::Packet& packet, double reach);

/// The same for many rays, in parallel.
void embreeOccluded(std::size_t mode, RTCScene scene, RTCIntersectContextFlags flags,
  const OcclusionRays& rays, OcclusionAnswers& answers);

/// Writes `size` rays from `first` on; those past the end are passed over.
template <int size>
void fillRays(const EmbreeRays& from, int first, RTCRayNt<size>& rays)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const auto copy = [&](const float* numbers, float* to)
  { std::copy_n(numbers + first, size, to); };
  copy(from.origin[0], rays.org_x);
  copy(from.origin[1], rays.org_y);
  copy(from.origin[2], rays.org_z);
  copy(from.direction[0], rays.dir_x);
  copy(from.direction[1], rays.dir_y);
  copy(from.direction[2], rays.dir_z);
  for (int i = 0; i < size; ++i)
  {
    const bool used = first + i < from.count;
    rays.tnear[i] = used ? from.begin(first + i) : infinity;
    rays.tfar[i] = used ? from.end(first + i) : -infinity;
    rays.time[i] = 0.0f;
    rays.mask[i] = ~0u;
    rays.id[i] = rays.flags[i] = 0;
  }
}

/// One of the rays.
inline RTCRay singleRay(const EmbreeRays& from, int i)
{
  const auto &o = from.origin, &d = from.direction;
  return {o[0][i], o[1][i], o[2][i], from.begin(i), d[0][i], d[1][i], d[2][i], 0.0f, from.end(i),
    ~0u, 0, 0};
}

} // namespace mote::bench
