#pragma once

#include "../core/Progress.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace mote
{

/// Side in pixels of the squares that an image is worked on in.
constexpr int tileSize = 32;

/// Which tiles of an image are done, row after row from the bottom: 1, or 0. Empty: none.
using TilesDone = std::vector<std::uint8_t>;

/// How many pixels of an image lie in tiles that are done.
std::size_t pixelsDone(const TilesDone& tiles, int width, int height);

/// Calls visit(x0, y0) for the lower left corner of every tile of an image, in parallel on
/// `threads` threads (0: all that TBB's present arena allows). False where `progress` asked to
/// stop; it is called between tiles with the share done, on any of the threads but on one at a
/// time. Where `tiles` is given the tiles that are done are left out, and those that are visited
/// are noted there, so that another call goes on with the rest; then the answer tells whether all
/// are done.
bool forTiles(int width, int height, int threads, const Progress& progress,
  const std::function<void(int x0, int y0)>& visit, TilesDone* tiles = nullptr);

} // namespace mote
