#pragma once

#include <cstdint>

namespace mote
{

/// A block of look-ups in occlusion maps on their way, number after number, so that SIMD does many
/// at a time.
struct OcclusionLookUp
{
  static constexpr int capacity = 256;

  int count = 0;
  /// First texel of each map of 2 x 2 texels or more; else such a map that nobody asks.
  const std::uint8_t* map[capacity];
  alignas(64) std::int32_t shift[capacity]; ///< log2 of the texels along a side
  std::uint16_t plain[capacity];            ///< hits on particles with one texel or none
  int plains = 0;

  /// Looks up where these normals lie in the maps found: bilinear, `maximum` is what 255 stands
  /// for. Between equal texels lies nothing but their value, to the last bit. Values of `plain`
  /// hits mean nothing.
  void blend(const float* nx, const float* ny, const float* nz, float maximum, float* values) const;
};

} // namespace mote
