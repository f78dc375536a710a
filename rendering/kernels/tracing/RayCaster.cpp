#include "RayCaster.h"

#include "../core/Error.h"
#include "detail/BundleTracer.h"

#include <cmath>

namespace mote
{

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

bool RayCaster::addSample(
  const Camera& camera, Film& film, const Progress& progress, TilesDone* tiles) const
{
  const BundleTracer tracer(scene_, camera, film, bundleSide_, limits_);
  if (film.samples() > 0)
  {
    film.splitNearestDepth();
    film.splitLatestDepth();
  }
  const bool complete = forTiles(
    film.width(), film.height(), threads_, progress,
    [&](int x0, int y0) { tracer.traceTile(x0, y0, tileSize); }, tiles);
  if (complete)
    film.setSamples(film.samples() + 1);
  else if (!tiles)
    film.setSamples(0);
  if (complete && tiles)
    tiles->clear();
  return complete;
}

} // namespace mote
