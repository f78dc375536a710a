#pragma once

#include <kernels/core/RawVector.h>
#include <kernels/core/RayBundle.h>

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace mote::bench
{

/// What every method writes for a pixel: t along the view axis (infinity for none) and the number
/// that the method gives the particle. Row 0 is the bottom row.
///
/// Pixels are kept in blocks of 4x4, two cache lines each, because that is how bundles and packets
/// of rays are ordered: a method writes whole lines, not sixteen rows a page apart. The image
/// reaches up to 15 pixels over its right and upper edge, so that blocks of up to 16x16 pixels are
/// written without a look at the edge.
class HitImage
{
public:
  static constexpr int blockSide = 4;
  static constexpr int blockPixels = blockSide * blockSide;
  static constexpr int largestBundle = 16;

  HitImage(int width, int height)
    : width_(width)
    , height_(height)
    , columns_(roundedUp(width) / blockSide)
    , blocks_(static_cast<std::size_t>(columns_) * (roundedUp(height) / blockSide))
  {
  }

  int width() const { return width_; }
  int height() const { return height_; }

  float t(int x, int y) const { return blockAt(x, y).t[place(x, y)]; }

  void put(int x, int y, float depth, std::uint32_t id)
  {
    Block& block = blockAt(x, y);
    block.t[place(x, y)] = depth;
    block.particle[place(x, y)] = id;
  }

  /// Writes the 4x4 pixels whose lower left one is (x, y), both multiples of 4, row by row.
  template <typename T, typename Id>
  void putBlock(int x, int y, const T* depths, const Id* ids)
  {
    Block& block = blockAt(x, y);
    for (int i = 0; i < blockPixels; ++i)
      block.t[i] = static_cast<float>(depths[i]);
    for (int i = 0; i < blockPixels; ++i)
      block.particle[i] = static_cast<std::uint32_t>(ids[i]);
  }

  /// Writes what a bundle of `side` x `side` rays has hit to the square of pixels at (x0, y0): four
  /// rows of four at a time where it is that large.
  void putBundle(const RayBundle& bundle, int side, int x0, int y0)
  {
    const int pixels = side < blockSide ? 1 : blockPixels;
    for (int i = 0; i < bundle.count; i += pixels)
    {
      int x = 0, y = 0;
      bundleOffset(side, i, x, y);
      if (pixels > 1)
        putBlock(x0 + x, y0 + y, bundle.t + i, bundle.slot + i);
      else
        put(x0 + x, y0 + y, static_cast<float>(bundle.t[i]),
          static_cast<std::uint32_t>(bundle.slot[i]));
    }
  }

private:
  struct alignas(64) Block
  {
    float t[blockPixels];
    std::uint32_t particle[blockPixels];
  };

  static int roundedUp(int size)
  {
    return (size + largestBundle - 1) / largestBundle * largestBundle;
  }
  std::size_t blockIndex(int x, int y) const
  {
    return static_cast<std::size_t>(y / blockSide) * columns_ + x / blockSide;
  }
  Block& blockAt(int x, int y) { return blocks_[blockIndex(x, y)]; }
  const Block& blockAt(int x, int y) const { return blocks_[blockIndex(x, y)]; }
  static int place(int x, int y) { return (y % blockSide) * blockSide + x % blockSide; }

  int width_;
  int height_;
  int columns_; ///< blocks a row
  RawVector<Block> blocks_;
};

constexpr int tileSide = 32; ///< pixels a side of a task

/// Calls cast(x0, y0) for the lower left corner of every tile of 32x32 pixels, a task each: the
/// same share of the work for every method.
template <typename Cast>
void forTiles(int width, int height, const Cast& cast)
{
  const int columns = (width + tileSide - 1) / tileSide, rows = (height + tileSide - 1) / tileSide;
  tbb::parallel_for(tbb::blocked_range2d<int>(0, rows, 1, 0, columns, 1),
    [&](const tbb::blocked_range2d<int>& tiles)
    {
      for (int row = tiles.rows().begin(); row != tiles.rows().end(); ++row)
        for (int column = tiles.cols().begin(); column != tiles.cols().end(); ++column)
          cast(column * tileSide, row * tileSide);
    });
}

/// Calls cast(x, y) for the lower left corner of every `block` x `block` pixels of a tile, `block`
/// being a divisor of its side.
template <typename Cast>
void forBlocksOfTile(int x0, int y0, int width, int height, int block, const Cast& cast)
{
  for (int y = y0; y < std::min(height, y0 + tileSide); y += block)
    for (int x = x0; x < std::min(width, x0 + tileSide); x += block)
      cast(x, y);
}

/// The same for all blocks of an image, in tiles.
template <typename Cast>
void forBlocks(int width, int height, int block, const Cast& cast)
{
  forTiles(
    width, height, [&](int x0, int y0) { forBlocksOfTile(x0, y0, width, height, block, cast); });
}

} // namespace mote::bench
