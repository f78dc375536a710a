#pragma once

#include <cstdint>

namespace mote
{

/// A block of look-ups in occlusion maps, number after number, so that SIMD does many at a time.
struct OcclusionLookUp
{
  static constexpr int capacity = 64;

  alignas(64) float nx[capacity];
  alignas(64) float ny[capacity];
  alignas(64) float nz[capacity];
  alignas(64) float side[capacity]; ///< texels along a side of each map
  // Filled by place():
  alignas(64) std::int32_t upper[capacity];  ///< row above the place, -1 beyond the pole
  alignas(64) std::int32_t column[capacity]; ///< on its left, -1 for the last
  alignas(64) float down[capacity];          ///< share of the way to the next row
  alignas(64) float along[capacity];         ///< and to the next column
  /// Bytes of the four texels around the place, by row and column, and, once blended, the value.
  alignas(64) std::int32_t texel[4][capacity];
  alignas(64) float value[capacity];

  /// Finds where the normals of the first `count` lie in their maps.
  void place(int count);
  /// Makes values of texels: `maximum` is that of 255. Between equal texels lies nothing but their
  /// value, to the last bit.
  void blend(int count, float maximum);
};

} // namespace mote
