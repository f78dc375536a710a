#pragma once

#include "../../core/Progress.h"

#include <functional>

namespace mote
{

/// Side in pixels of the squares that an image is worked on in.
constexpr int tileSize = 32;

/// Calls visit(x0, y0) for the lower left corner of every tile of an image, in parallel on
/// `threads` threads (0: all that TBB's present arena allows). False where `progress` asked to
/// stop; it is called between tiles with the share done, on any of the threads but on one at a
/// time.
bool forTiles(int width, int height, int threads, const Progress& progress,
  const std::function<void(int x0, int y0)>& visit);

} // namespace mote
