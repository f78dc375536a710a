#pragma once

#include <kernels/core/RawVector.h>

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace mote::bench
{

/// What every method writes for a pixel: t along the view axis (infinity for none) and the number
/// that the method gives the particle. Row 0 is the bottom row.
struct HitImage
{
  int width = 0;
  int height = 0;
  RawVector<float> t;
  RawVector<std::uint32_t> particle;

  HitImage(int w, int h)
    : width(w)
    , height(h)
    , t(static_cast<std::size_t>(w) * h)
    , particle(t.size())
  {
  }
  void put(int x, int y, float depth, std::uint32_t id)
  {
    const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
    t[pixel] = depth;
    particle[pixel] = id;
  }
};

/// Calls cast(x0, y0) for the lower left corner of every `block` x `block` pixels, in tiles of
/// 32 x 32 pixels a task: the same share of the work for every method.
template <typename Cast>
void forBlocks(int width, int height, int block, const Cast& cast)
{
  constexpr int tile = 32;
  const int columns = (width + tile - 1) / tile, rows = (height + tile - 1) / tile;
  tbb::parallel_for(tbb::blocked_range2d<int>(0, rows, 1, 0, columns, 1),
    [&](const tbb::blocked_range2d<int>& tiles)
    {
      for (int row = tiles.rows().begin(); row != tiles.rows().end(); ++row)
        for (int column = tiles.cols().begin(); column != tiles.cols().end(); ++column)
          for (int y = row * tile; y < std::min(height, (row + 1) * tile); y += block)
            for (int x = column * tile; x < std::min(width, (column + 1) * tile); x += block)
              cast(x, y);
    });
}

} // namespace mote::bench
