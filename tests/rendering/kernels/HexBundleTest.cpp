// Bundles of rays through the Cartesian hierarchy tell of what single rays do, to the last bit.

#include <kernels/core/RayBundle.h>
#include <kernels/hexahedra/HexBvhBundle.h>
#include <kernels/hexahedra/HexStructure.h>

#include <support/HexMeshes.h>
#include <support/Targets.h>
#include <support/Volumes.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

struct Bundle
{
  std::vector<HexRay> rays;
  BundleFrustum::Sides sides;
};

/// side x side rays about the one given, from its origin or beside it.
Bundle bundleAbout(
  const HexRay& middle, const BundleFrustum::Sides& sides, int side, bool isFan, bool isUneven)
{
  Bundle bundle{{}, sides};
  for (int i = 0; i < side * side; ++i)
  {
    int column = 0, row = 0;
    bundleOffset(side, i, column, row);
    const Vec3d off = double(column - side / 2) * sides.x + double(row - side / 2) * sides.y;
    HexRay ray = middle;
    (isFan ? ray.direction : ray.origin) += off;
    if (isUneven)
    {
      ray.tMin = 0.01 * column;
      ray.tMax = i % 3 == 0 ? 0.6 : 2.0;
    }
    bundle.rays.push_back(ray);
  }
  return bundle;
}

/// Bundles from outside, from inside and from points, along axes and edges, narrow and wide.
std::vector<Bundle> bundlesFor(const HexMesh& mesh)
{
  const Vec3d lower = mesh.bounds().lower, size = mesh.bounds().size();
  const auto ends = randomPoints(120, lower - 0.8 * size, mesh.bounds().upper + 0.8 * size, 8);
  const auto inside = randomPoints(120, lower, mesh.bounds().upper, 9);
  std::vector<Bundle> bundles;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
  {
    const bool isFan = i % 2 == 0;
    const double width = i % 5 == 0 ? 0.2 : i % 5 == 1 ? 1e-6 : 0.02;
    const Vec3d at = inside[i];
    const Vec3d from = i % 7 == 0 ? inside[i + 1] : i % 7 == 1 ? mesh.point(i) : ends[i];
    if (i % 3 == 0) // through the block's points and along its edges
    {
      Vec3d axis(0.0), x(0.0), y(0.0);
      const int k = static_cast<int>(i / 3 % 3);
      axis[k] = i % 2 == 0 ? 10.0 : -10.0;
      x[(k + 1) % 3] = y[(k + 2) % 3] = 0.5;
      const Vec3d& p = mesh.point(i % mesh.pointCount());
      bundles.push_back(bundleAbout({p - axis, 2.0 * axis}, {x, y}, 8, isFan, false));
      continue;
    }
    const Vec3d way = at - from;
    Vec3d x, y;
    acrossAxes(way, x, y);
    const double length = width * glm::length(way);
    const BundleFrustum::Sides sides{length * glm::normalize(x + 0.2 * y), 0.7 * length * y};
    bundles.push_back(bundleAbout({from, way}, sides, i % 4 == 3 ? 4 : 8, isFan, i % 11 == 0));
  }
  return bundles;
}

CartesianBvh hierarchy(const std::shared_ptr<const HexMesh>& mesh)
{
  HexStructureOptions options;
  options.kind = HexStructureKind::CartesianBvh;
  options.bvh.leafSize = 2;
  return std::get<CartesianBvh>(*makeHexStructure(mesh, options));
}

HexField fieldOf(const HexMesh& mesh)
{
  const auto values =
    pointValues(mesh, [](const Vec3d& p) { return std::sin(3.0 * p.x) + p.y * p.z; });
  return {mesh, HexScalar{{values.data(), values.size(), 1}}};
}

std::vector<CellSpan> single(const CartesianBvh& bvh, const HexRay& ray, std::size_t most)
{
  std::vector<CellSpan> spans;
  bvh.forCellsAlong(ray,
    [&](const CellSpan& span)
    {
      spans.push_back(span);
      return spans.size() < most;
    });
  return spans;
}

/// Checks a bundle, of which each ray wants `most` spans. False where it must go ray by ray.
bool isAsSingle(const CartesianBvh& bvh, const HexField& field, const Bundle& bundle,
  std::size_t most, BundleSpans& room, std::size_t& told)
{
  const std::size_t n = bundle.rays.size();
  std::vector<std::vector<ValuedSpan>> found(n);
  if (!bvh.forCellsAlongBundle(bundle.rays.data(), static_cast<int>(n), bundle.sides, &field, room,
        [&](std::size_t ray, const ValuedSpan& span)
        {
          found[ray].push_back(span);
          return found[ray].size() < most;
        }))
    return false;
  for (std::size_t i = 0; i < n; ++i)
  {
    const HexRay& ray = bundle.rays[i];
    const CrossingLine line(ray.origin, ray.direction);
    std::vector<CellSpan> spans;
    for (const ValuedSpan& f : found[i])
    {
      spans.push_back(f.span);
      const auto value = [&](const FacePoint& point)
      {
        return point.value([&](std::size_t corner)
          { return double(field.ofPoint(bvh.mesh().cell(f.span.cell)[corner])); });
      };
      EXPECT_TRUE(f.span.inFace == noFace ||
                  f.valueIn == value(line.entry(bvh.mesh(), f.span.cell, f.span.inFace)));
      EXPECT_TRUE(f.span.outFace == noFace ||
                  f.valueOut == value(line.exit(bvh.mesh(), f.span.cell, f.span.outFace)));
    }
    EXPECT_TRUE(spans == single(bvh, ray, most));
    told += spans.size();
  }
  return true;
}

} // namespace

TEST(HexBundle, TellsOfWhatSingleRaysDo)
{
  BundleSpans room;
  std::size_t together = 0;
  for (const std::int64_t target : everyTarget())
  {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnlyTargets only(target);
    for (const HexCells& cells : unevenMeshes())
    {
      const auto mesh = cells.mesh();
      const CartesianBvh bvh = hierarchy(mesh);
      const HexField field = fieldOf(*mesh);
      std::size_t told = 0;
      int fans = 0, asked = 0;
      for (const Bundle& bundle : bundlesFor(*mesh))
        fans += isAsSingle(bvh, field, bundle, ++asked % 4 == 0 ? 3 : 1000, room, told);
      if (fans == 0)
        continue; // no SIMD that is worth it
      EXPECT_GT(fans, 60);
      EXPECT_LT(fans, asked); // some have rays along different axes
      EXPECT_GT(told, 4000U);
      ++together;
    }
  }
  RecordProperty("together", static_cast<int>(together));
#if HWY_ARCH_X86
  EXPECT_GE(together, unevenMeshes().size());
#endif
}

TEST(HexBundle, PassesOverWhatIsNotKept)
{
  const auto mesh = hexRing({6, 24, 6, 1.0, 2.0, 1.5, 0.4, 0.3, 3}).mesh();
  CartesianBvh bvh = hierarchy(mesh);
  const HexField field = fieldOf(*mesh);
  bvh.setRanges(cellRanges(*mesh, field));
  const auto keep = [](const ScalarRange& r) { return r.upper > 0.5F && r.lower < 0.9F; };
  BundleSpans room;
  std::size_t all = 0, kept = 0;
  for (const Bundle& bundle : bundlesFor(*mesh))
    bvh.forCellsAlongBundle(
      bundle.rays.data(), static_cast<int>(bundle.rays.size()), bundle.sides, &field, room,
      [&](std::size_t, const ValuedSpan&)
      {
        ++kept;
        return true;
      },
      keep);
  std::size_t wanted = 0;
  for (const Bundle& bundle : bundlesFor(*mesh))
    if (LineBundle(bundle.rays.data(), static_cast<int>(bundle.rays.size())).isCoherent())
      for (const HexRay& ray : bundle.rays)
      {
        all += single(bvh, ray, 1000).size();
        bvh.forCellsAlong(
          ray,
          [&](const CellSpan&)
          {
            ++wanted;
            return true;
          },
          keep);
      }
  EXPECT_EQ(kept, wanted);
  EXPECT_TRUE(kept < all || all == 0);
}

TEST(HexBundle, RefusesWhatIsNoBundle)
{
  const auto mesh = hexBlock(3, 3, 3).mesh();
  const CartesianBvh bvh = hierarchy(mesh);
  BundleSpans room;
  const auto none = [](std::size_t, const ValuedSpan&) { return ADD_FAILURE(), true; };
  const BundleFrustum::Sides sides{{0.1, 0, 0}, {0, 0.1, 0}};
  const HexRay along{{1, 1, -4}, {0, 0, 1}};
  HexRay other = along;
  other.origin.x += 0.3;
  other.direction.y += 0.2; // neither the origin nor the direction is the same
  const HexRay skew[] = {along, other};
  EXPECT_FALSE(bvh.forCellsAlongBundle(skew, 2, sides, nullptr, room, none));
  const HexRay longer[] = {along, {along.origin, {0, 0, 2}}};
  EXPECT_FALSE(bvh.forCellsAlongBundle(longer, 2, sides, nullptr, room, none));
  const HexRay across[] = {along, {along.origin, {3, 0, 1}}};
  EXPECT_FALSE(bvh.forCellsAlongBundle(across, 2, sides, nullptr, room, none));
  const HexRay behind[] = {{along.origin, along.direction, -1.0}};
  EXPECT_FALSE(bvh.forCellsAlongBundle(behind, 1, sides, nullptr, room, none));
  const BundleFrustum::Sides flat{{0.1, 0, 0}, {0.1, 0, 0}};
  EXPECT_FALSE(bvh.forCellsAlongBundle(&along, 1, flat, nullptr, room, none));
}
