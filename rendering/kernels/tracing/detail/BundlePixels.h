#pragma once

#include "../../core/RayBundle.h"

#include <cstdint>

namespace mote
{

/// Columns and rows of the rays of a bundle.
struct BundlePixels
{
  std::uint8_t column[RayBundle::capacity], row[RayBundle::capacity];

  explicit BundlePixels(int side)
  {
    for (int i = 0; i < side * side; ++i)
    {
      int x = 0, y = 0;
      bundleOffset(side, i, x, y);
      column[i] = static_cast<std::uint8_t>(x);
      row[i] = static_cast<std::uint8_t>(y);
    }
  }
};

inline const BundlePixels& pixelsOf(int side)
{
  static const BundlePixels two(2), four(4), eight(8), sixteen(16);
  return side == 2 ? two : side == 4 ? four : side == 8 ? eight : sixteen;
}

} // namespace mote
