#pragma once

#include <cstdint>
#include <limits>

namespace mote
{

/// Up to 64 rays that travel together, and what they have hit so far.
///
/// Ray i is origin + t * direction in double; the direction need not have unit length, and t counts
/// in its lengths (camera rays make t the distance along the view axis). Rays are best stored so
/// that neighbours in the array are neighbours in the image: Z order, see packetOffset().
struct RayPacket
{
  static constexpr int capacity = 64;
  static constexpr std::uint64_t noHit = std::numeric_limits<std::uint64_t>::max();

  alignas(64) double origin[3][capacity];
  alignas(64) double direction[3][capacity];
  alignas(64) double tMin[capacity]; ///< hits at t <= tMin do not count
  alignas(64) double t[capacity];    ///< in: farthest t that counts; out: t of the nearest hit
  alignas(64) std::uint64_t slot[capacity];  ///< particle's place in its structure, or noHit
  alignas(64) std::int32_t object[capacity]; ///< index of the object in the scene, or -1
  int count = 0;                             ///< rays in use, from the front
};

/// Column and row of ray i in an 8x8 block, in Z order: every aligned run of 4, 8 or 16 rays is
/// a compact 2x2, 4x2 or 4x4 block, so that SIMD vectors of any width hold neighbours.
inline void packetOffset(int i, int& x, int& y)
{
  x = (i & 1) | ((i >> 1) & 2) | ((i >> 2) & 4);
  y = ((i >> 1) & 1) | ((i >> 2) & 2) | ((i >> 3) & 4);
}

} // namespace mote
