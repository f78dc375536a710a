// What the traversal's culling leaves out, and what that saves: the kernel itself, compiled once
// more with counters and once more without culling.

#include "../Views.h"
#include "Tables.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "particles/tables/CullingTables.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <kernels/particles/detail/CoherentGridCastBundle-inl.h>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

struct CountingPolicy
{
  static constexpr bool any = false, culls = true, counts = true;
};
struct NotCullingPolicy
{
  static constexpr bool any = false, culls = false, counts = false;
};

bool castCounting(const CoherentGridView& view, RayBundle& bundle, CastCounts* counts)
{
  return castBundle<CountingPolicy>(view, bundle, 0, counts);
}

bool castNotCulling(const CoherentGridView& view, RayBundle& bundle, CastCounts*)
{
  return castBundle<NotCullingPolicy>(view, bundle, 0, nullptr);
}

bool castCulling(const CoherentGridView& view, RayBundle& bundle, CastCounts*)
{
  return castBundle<NearestPolicy>(view, bundle, 0, nullptr);
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "../StructureMethod.h"

namespace mote
{

HWY_EXPORT(castCounting);
HWY_EXPORT(castNotCulling);
HWY_EXPORT(castCulling);

namespace bench
{

namespace
{

const int sides[] = {2, 4, 8, 16};

std::string bundleName(int side)
{
  return format("%dx%d", side, side);
}

std::shared_ptr<CoherentGrid> buildGrid(const TableRun& run)
{
  auto grid = std::make_shared<CoherentGrid>();
  CoherentGridOptions options;
  options.keepIndices = false;
  options.cellsPerParticle = run.options.lambda;
  grid->build(run.input.set, options);
  return grid;
}

/// Casts the image bundle by bundle, as castBundles() does, with one of the kernels above.
template <typename Kernel>
void castImage(
  const CoherentGrid& grid, int side, const CameraRays& rays, HitImage& image, const Kernel& kernel)
{
  const CoherentGridView view(grid);
  forTiles(image.width(), image.height(),
    [&](int x0, int y0)
    {
      RayBundle bundle;
      forBlocksOfTile(x0, y0, image.width(), image.height(), side,
        [&](int x, int y)
        {
          rays.fillBundle(bundle, side, x, y, 0.0, 0.0);
          bySplitting(bundle, [&](RayBundle& part) { return kernel(view, part); });
          image.putBundle(bundle, side, x, y);
        });
    });
}

struct Counted
{
  CastCounts counts;
  double bundles;
};

/// Sums over the image; on one thread, for the sums are not atomic.
Counted countImage(
  const TableRun& run, const CoherentGrid& grid, int side, const View& view, HitImage& image)
{
  Counted counted{{}, 0.0};
  const CameraRays rays(
    cameraOf(view, run.input.statistics.bounds), run.options.width, run.options.height);
  timed(1,
    [&]
    {
      castImage(grid, side, rays, image,
        [&](const CoherentGridView& g, RayBundle& bundle)
        {
          const bool done = HWY_DYNAMIC_DISPATCH(castCounting)(g, bundle, &counted.counts);
          counted.bundles += done;
          return done;
        });
    });
  return counted;
}

double share(std::uint64_t part, std::uint64_t of)
{
  return of == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(of);
}

} // namespace

Section cullingTable(TableRun& run)
{
  const auto grid = buildGrid(run);
  HitImage image(run.options.width, run.options.height);
  Section section;
  section.table = Table(2);
  section.table.add({"view", "bundle", "slices", "cells", "particles", "in frustum", "tested rays",
    "nearest hits", "tests/ray", "hits/test"});
  for (const View& view : run.views)
    for (const int side : sides)
    {
      const auto [counts, bundles] = countImage(run, *grid, side, view, image);
      const std::uint64_t tests = 16 * counts.tests;
      const double rays = static_cast<double>(run.options.width) * run.options.height;
      const double testsPerRay = static_cast<double>(tests) / rays;
      const auto perBundle = [bundles = bundles](std::uint64_t n)
      { return static_cast<double>(n) / bundles; };
      section.table.add({view.name, bundleName(side), format("%.1f", perBundle(counts.slices)),
        format("%.0f", perBundle(counts.cells)), format("%.0f", perBundle(counts.particles)),
        format("%.1f %%", 100.0 * share(counts.inFrustum, counts.particles)),
        format("%.1f %%", 100.0 * static_cast<double>(tests) /
                            (static_cast<double>(counts.particles) * side * side)),
        format("%.1f", perBundle(counts.hits)), format("%.1f", testsPerRay),
        format("%.2f", share(counts.hits, counts.tests))});
      Measurement m = run.measurement("cgt", "counting " + bundleName(side));
      m.view = view.name;
      m.threads = 1;
      m.errors = compare(
        image, run.references.depths(run.input, view, run.options.width, run.options.height));
      m.more = {{"bundles", bundles}, {"slices", perBundle(counts.slices)},
        {"cells", perBundle(counts.cells)}, {"particles_in_cells", perBundle(counts.particles)},
        {"particles_in_frustum", perBundle(counts.inFrustum)}, {"tests_per_ray", testsPerRay},
        {"nearest_hits", perBundle(counts.hits)}};
      run.record(m);
    }
  section.notes = {"slices to particles, nearest hits: means a bundle; nearest hits are particles "
                   "that were some ray's nearest so far.",
    "in frustum: share of the particles in the visited cells that the frustum overlaps.",
    "tested rays: share of the pairs of a ray and a particle there that are tested, 16 rays at "
    "once; "
    "tests/ray counts them."};
  return section;
}

Section cullingSpeedTable(TableRun& run)
{
  const auto grid = buildGrid(run);
  Contest contest = run.contest();
  const auto add = [&](int side, const char* what, auto kernel)
  {
    contest.add({"cgt", {bundleName(side) + what},
      [grid, side, kernel](std::size_t, const CameraRays& rays, HitImage& image)
      { castImage(*grid, side, rays, image, kernel); },
      &run.input, run.threads});
  };
  for (const int side : sides)
  {
    add(side, " culling",
      [](const CoherentGridView& g, RayBundle& bundle)
      { return HWY_DYNAMIC_DISPATCH(castCulling)(g, bundle, nullptr); });
    add(side, " not culling",
      [](const CoherentGridView& g, RayBundle& bundle)
      { return HWY_DYNAMIC_DISPATCH(castNotCulling)(g, bundle, nullptr); });
  }
  contest.race();
  contest.check(run.references);
  run.record(contest);
  Section section;
  std::vector<std::string> titles = {"bundle"};
  for (const View& view : run.views)
    for (const char* what : {" culling Mrays/s", " without", " ratio"})
      titles.push_back(view.name + what);
  section.table.add(titles);
  for (std::size_t c = 0; c < contest.size(); c += 2)
  {
    std::vector<std::string> row = {bundleName(sides[c / 2])};
    for (std::size_t v = 0; v < run.views.size(); ++v)
    {
      const double with = contest.at(c, v).mrays(), without = contest.at(c + 1, v).mrays();
      row.push_back(format("%.2f", with));
      row.push_back(format("%.2f", without));
      row.push_back(format("%.2f", with / without));
    }
    section.table.add(row);
  }
  section.notes.push_back(
    "Without: all particles in the visited cells meet all rays whose block is not hit nearer.");
  return section;
}

} // namespace bench
} // namespace mote

#endif
