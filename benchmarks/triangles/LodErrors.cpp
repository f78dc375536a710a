#include "LodErrors.h"

#include "paper/RlodPaperTree.h"

#include <support/Triangles.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace mote::bench
{

namespace
{

struct Hit
{
  std::uint64_t slot;
  Vec3d at;
  double pixel;
};

template <typename Tree>
double displacement(const Tree& tree, const Hit& hit)
{
  if (!RlodTree::isLod(hit.slot))
    return 0.0;
  const Vec3d local = (hit.at - tree.origin()) / tree.unit();
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::uint64_t slot : tree.slotsBelow(hit.slot))
  {
    const auto corners = tree.localCorners(slot);
    nearest = std::min(nearest,
      testing::distanceFrom({Vec3d(corners[0]), Vec3d(corners[1]), Vec3d(corners[2])}, local));
  }
  return nearest * tree.unit() / hit.pixel;
}

/// Casts both pictures: counts pixels that differ and keeps hits.
template <typename Tree>
std::vector<Hit> hitsOf(
  const Tree& tree, const CameraRays& rays, int width, int height, double poe, LodErrors& errors)
{
  std::vector<Hit> hits;
  for (int y0 = 0; y0 < height; y0 += 16)
    for (int x0 = 0; x0 < width; x0 += 16)
    {
      RayBundle exact;
      rays.fillBundle(exact, 16, x0, y0, 0.0, 0.0);
      RayBundle rough = exact;
      tree.cast(exact, 0);
      tree.cast(rough, 0, poe);
      for (int i = 0; i < exact.count; ++i)
      {
        int x = 0, y = 0;
        bundleOffset(16, i, x, y);
        if (x0 + x >= width || y0 + y >= height)
          continue;
        errors.holes += exact.object[i] == 0 && rough.object[i] != 0;
        errors.extra += exact.object[i] != 0 && rough.object[i] == 0;
        if (rough.object[i] == 0)
          hits.push_back({rough.slot[i], rough.originOf(i) + rough.t[i] * rough.directionOf(i),
            rough.footprint + rough.t[i] * rough.footprintPerT});
      }
    }
  return hits;
}

template <typename Tree>
LodErrors measure(const Tree& tree, const CameraRays& rays, int width, int height, double poe)
{
  LodErrors errors;
  const std::vector<Hit> hits = hitsOf(tree, rays, width, height, poe, errors);
  const std::size_t every = 1 + hits.size() / 60000;
  std::vector<double> displacements((hits.size() + every - 1) / every);
  if (displacements.empty())
    return errors;
  tbb::parallel_for(std::size_t{0}, displacements.size(),
    [&](std::size_t k) { displacements[k] = displacement(tree, hits[k * every]); });
  std::sort(displacements.begin(), displacements.end());
  double squares = 0.0;
  for (const double d : displacements)
    squares += d * d;
  const auto count = static_cast<double>(displacements.size());
  errors.rms = std::sqrt(squares / count);
  errors.most = displacements.back();
  errors.mostOfMany = displacements[static_cast<std::size_t>(0.999 * (count - 1.0))];
  errors.lods = static_cast<double>(std::count_if(hits.begin(), hits.end(),
                  [](const Hit& hit) { return RlodTree::isLod(hit.slot); })) /
                static_cast<double>(hits.size());
  return errors;
}

} // namespace

LodErrors measureLods(
  const RlodTree& tree, const CameraRays& rays, int width, int height, double poe)
{
  return measure(tree, rays, width, height, poe);
}

LodErrors measureLods(
  const RlodPaperTree& tree, const CameraRays& rays, int width, int height, double poe)
{
  return measure(tree, rays, width, height, poe);
}

} // namespace mote::bench
