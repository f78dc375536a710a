#pragma once

#include <kernels/core/RawVector.h>

#include <algorithm>
#include <cstdint>

namespace mote::bench
{

/// What every method writes for a pixel: t along the view axis, infinity for none, the triangle of
/// the input, and its normal, of any length. In blocks of 4x4 pixels, and up to 15 pixels over the
/// right and upper edge, as HitImage is.
class TriangleImage
{
public:
  struct alignas(64) Block
  {
    float t[16];
    std::uint32_t triangle[16];
    float normal[3][16];
  };

  TriangleImage(int width, int height)
    : width_(width)
    , height_(height)
    , columns_((width + 15) / 16 * 4)
    , blocks_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>((height + 15) / 16 * 4))
  {
  }

  int width() const { return width_; }
  int height() const { return height_; }
  Block& blockAt(int x, int y)
  {
    return blocks_[static_cast<std::size_t>(y / 4 * columns_ + x / 4)];
  }
  const Block& blockAt(int x, int y) const
  {
    return blocks_[static_cast<std::size_t>(y / 4 * columns_ + x / 4)];
  }
  static int place(int x, int y) { return y % 4 * 4 + x % 4; }
  float t(int x, int y) const { return blockAt(x, y).t[place(x, y)]; }

private:
  int width_, height_;
  int columns_; ///< blocks a row
  RawVector<Block> blocks_;
};

} // namespace mote::bench
