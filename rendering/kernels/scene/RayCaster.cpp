#include "RayCaster.h"

#include "../core/Error.h"
#include "BundleTracer.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

namespace mote
{

namespace
{

constexpr int tileSize = 32; ///< pixels a side of a task

} // namespace

void RayCaster::sampleOffset(int sample, double& x, double& y)
{
  // The R2 sequence of M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences"
  // (2018), shifted so that its first point is the pixel's centre.
  const auto part = [](double v) { return v - std::floor(v) - 0.5; };
  x = part(0.5 + sample * 0.7548776662466927);
  y = part(0.5 + sample * 0.5698402909980532);
}

void RayCaster::setBundleSide(int side)
{
  if (side != 0 && side != 2 && side != 4 && side != 8 && side != 16)
    throw Error("Bundles of rays are 2, 4, 8 or 16 pixels wide, or 0 for an automatic choice.");
  bundleSide_ = side;
}

bool RayCaster::addSample(const Camera& camera, Film& film, const Progress& progress) const
{
  const BundleTracer tracer(scene_, camera, film, bundleSide_, limits_);
  if (film.samples() > 0)
    film.splitNearestDepth();
  const int columns = (film.width() + tileSize - 1) / tileSize;
  const int rows = (film.height() + tileSize - 1) / tileSize;
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
            tracer.traceTile(column * tileSize, row * tileSize, tileSize);
            report();
          }
      });
  };
  if (threads_ > 0)
    tbb::task_arena(threads_).execute(trace);
  else
    trace();
  if (progress && !stop)
    stop = !progress(1.0);
  film.setSamples(stop ? 0 : film.samples() + 1);
  return !stop;
}

} // namespace mote
