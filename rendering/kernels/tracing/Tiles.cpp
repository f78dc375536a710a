#include "detail/Tiles.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <mutex>

namespace mote
{

bool forTiles(int width, int height, int threads, const Progress& progress,
  const std::function<void(int x0, int y0)>& visit)
{
  const int columns = (width + tileSize - 1) / tileSize;
  const int rows = (height + tileSize - 1) / tileSize;
  std::atomic<int> done{0};
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
      [&](const tbb::blocked_range2d<int>& tiles)
      {
        for (int row = tiles.rows().begin(); row != tiles.rows().end(); ++row)
          for (int column = tiles.cols().begin(); column != tiles.cols().end(); ++column)
          {
            if (stop)
              return;
            visit(column * tileSize, row * tileSize);
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
  return !stop;
}

} // namespace mote
