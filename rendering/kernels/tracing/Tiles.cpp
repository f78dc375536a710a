#include "Tiles.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <mutex>

namespace mote
{

namespace
{

/// Tiles along a side of so many pixels.
int tilesAlong(int pixels)
{
  return (pixels + tileSize - 1) / tileSize;
}

} // namespace

std::size_t pixelsDone(const TilesDone& tiles, int width, int height)
{
  const int columns = tilesAlong(width);
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < tiles.size(); ++i)
    if (tiles[i])
    {
      const int x0 = static_cast<int>(i) % columns * tileSize;
      const int y0 = static_cast<int>(i) / columns * tileSize;
      pixels +=
        static_cast<std::size_t>(std::min(tileSize, width - x0)) * std::min(tileSize, height - y0);
    }
  return pixels;
}

bool forTiles(int width, int height, int threads, const Progress& progress,
  const std::function<void(int x0, int y0)>& visit, TilesDone* tiles)
{
  const int columns = tilesAlong(width), rows = tilesAlong(height);
  TilesDone own;
  TilesDone& marks = tiles ? *tiles : own;
  marks.resize(static_cast<std::size_t>(columns) * rows);
  std::atomic<int> done{static_cast<int>(std::count(marks.begin(), marks.end(), 1))};
  std::atomic<bool> stop{false};
  std::mutex reporting;
  const auto report = [&]
  {
    const int n = ++done;
    // Whoever finds another thread reporting goes on with its next tile.
    if (progress && reporting.try_lock())
    {
      if (!progress(double(n) / (columns * rows)))
        stop = true;
      reporting.unlock();
    }
  };
  const auto trace = [&]
  {
    tbb::parallel_for(tbb::blocked_range2d<int>(0, rows, 1, 0, columns, 1),
      [&](const tbb::blocked_range2d<int>& range)
      {
        for (int row = range.rows().begin(); row != range.rows().end(); ++row)
          for (int column = range.cols().begin(); column != range.cols().end(); ++column)
          {
            std::uint8_t& mark = marks[static_cast<std::size_t>(row) * columns + column];
            if (stop)
              return;
            if (mark)
              continue;
            visit(column * tileSize, row * tileSize);
            mark = 1;
            report();
          }
      });
  };
  if (threads > 0)
    tbb::task_arena(threads).execute(trace);
  else
    trace();
  if (progress && !stop)
    stop = !progress(1.0);
  return tiles ? done == columns * rows : !stop;
}

} // namespace mote
