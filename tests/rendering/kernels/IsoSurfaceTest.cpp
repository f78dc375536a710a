// Iso-surfaces of a field on hexahedra.

#include <kernels/hexahedra/IsoSurface.h>

#include <support/Structure.h>
#include <support/Volumes.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

IsoSurface surfaceOf(std::shared_ptr<const HexMesh> mesh, const std::vector<double>& scalar,
  const std::vector<double>& isoValues, HexStructureKind kind = HexStructureKind::CylindricalBvh)
{
  const CloudObject volume = volumeOf(mesh, scalar, evenTransfer(0.5F), kind);
  return {volume.structure, volume.field, isoValues};
}

Vec3d gradientAt(const IsoSurface& surface, const IsoHit& hit, const Vec3d& point)
{
  return surface.normalAt(std::uint64_t{hit.surface} << 32 | hit.cell, point);
}

} // namespace

TEST(IsoSurface, OfALinearFieldIsAPlaneWithoutHoles)
{
  const auto mesh = hexBlock(6, 6, 6, 0.35).mesh();
  const Vec3d normal = glm::normalize(Vec3d(0.2, 0.1, 1.0));
  const auto linear = [&](const Vec3d& p) { return glm::dot(normal, p) + 300.0; };
  for (const HexStructureKind kind : hexKinds)
  {
    const IsoSurface surface = surfaceOf(mesh, pointValues(*mesh, linear), {303.3}, kind);
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x)
      {
        // Every fourth goes along edges and corners of the unmoved lattice.
        const Vec3d from(0.3 + 5.4 * x / 39.0, 0.3 + 5.4 * y / 39.0, -3.0), way(0.03, 0.02, 1.0);
        const double exact = (303.3 - linear(from)) / glm::dot(normal, way);
        const auto hit = surface.first({from, way});
        ASSERT_TRUE(hit) << x << " " << y;
        EXPECT_NEAR(hit->t, exact, 2e-6);
        EXPECT_NEAR(
          glm::length(gradientAt(surface, *hit, from + hit->t * way) - normal), 0.0, 1e-5);
      }
  }
}

TEST(IsoSurface, TheFirstOfSeveralIsSeenFromEitherSide)
{
  const auto mesh = hexBlock(6, 2, 2).mesh();
  const IsoSurface surface =
    surfaceOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return p.x; }), {4.25, 4.75, 1.5});
  auto hit = surface.first({{-1, 1.1, 0.9}, {1, 0, 0}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 2.5, 1e-6);
  EXPECT_EQ(hit->surface, 2U);
  hit = surface.first({{7, 1.1, 0.9}, {-1, 0, 0}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 2.25, 1e-6); // two in one cell: the nearer one
  EXPECT_EQ(hit->surface, 1U);
  EXPECT_FALSE(surface.first({{-1, 1.1, 2.5}, {1, 0, 0}}));
}

TEST(IsoSurface, AtTheValueOfPointsIsNeitherLostNorDoubled)
{
  // The surface runs along faces of cells: x = 3.
  const auto mesh = hexBlock(6, 3, 3).mesh();
  const IsoSurface surface =
    surfaceOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return p.x; }), {3.0});
  for (const double y : {0.5, 1.0, 1.7, 2.0})
    for (const double sign : {-1.0, 1.0})
    {
      const auto hit = surface.first({{3.0 - 5.0 * sign, y, 1.0}, {sign, 0, 0}});
      ASSERT_TRUE(hit);
      EXPECT_NEAR(hit->t, 5.0, 1e-9);
    }
}

TEST(IsoSurface, IsFoundTwiceWithinACell)
{
  // One cell in which the field rises and falls along the diagonal.
  HexCells cells = hexBlock(1, 1, 1);
  const auto mesh = cells.mesh();
  const IsoSurface surface = surfaceOf(
    mesh, pointValues(*mesh, [](const Vec3d& p) { return p.x == p.y ? 1.0 : 0.0; }), {0.75});
  // Along y = 1 - x the field is 2 x (1 - x) <= 1/2; along y = x it is 1 - 2 x (1 - x).
  EXPECT_FALSE(surface.first({{-1, 2, 0.5}, {1, -1, 0}}));
  const auto hit = surface.first({{-1, -1, 0.5}, {1, 1, 0}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 1.0 + 0.5 - 0.5 * std::sqrt(0.5), 1e-6);
}

TEST(IsoSurface, OfASphereIsASphere)
{
  const auto mesh = hexBlock(24, 24, 24, 0.3).mesh();
  const Vec3d middle(12.1, 11.9, 12.0);
  const IsoSurface surface = surfaceOf(
    mesh, pointValues(*mesh, [&](const Vec3d& p) { return glm::length(p - middle); }), {9.0});
  const auto from = randomPoints(300, Vec3d(-20.0), Vec3d(44.0), 7);
  for (const Vec3d& p : from)
  {
    if (glm::length(p - middle) < 10.0)
      continue;
    const auto hit = surface.first({p, middle - p});
    ASSERT_TRUE(hit);
    const Vec3d at = p + hit->t * (middle - p);
    EXPECT_NEAR(glm::length(at - middle), 9.0, 0.06); // what the cells' size leaves
    EXPECT_GT(
      glm::dot(glm::normalize(gradientAt(surface, *hit, at)), glm::normalize(at - middle)), 0.98);
  }
}

TEST(IsoSurface, RaysTogetherMeetWhatEachMeetsAlone)
{
  // Cells are warped, and the field is flat in some and bends in others.
  const auto mesh = hexBlock(14, 14, 14, 0.4).mesh();
  const Vec3d middle(7.0);
  auto values = pointValues(*mesh, [&](const Vec3d& p)
    { return std::max(3.0, glm::length(p - middle)) + 0.3 * std::sin(3 * p.x); });
  values[1000] = NAN;
  const IsoSurface inBoxes =
    surfaceOf(mesh, values, {5.0, 4.0, 3.1, 9.5}, HexStructureKind::CartesianBvh);
  const IsoSurface inRings = surfaceOf(mesh, values, {5.0, 4.0, 3.1, 9.5});
  for (const IsoSurface& surface : {inBoxes, inRings})
    for (const auto kind : {RayBundle::Kind::CommonOrigin, RayBundle::Kind::CommonDirection})
      for (const int count : {256, 70, 3})
      {
        RayBundle bundle;
        bundle.kind = kind;
        bundle.count = count;
        bundle.origin = middle + Vec3d(20.0, -9.0, 13.0);
        bundle.direction = middle - bundle.origin;
        acrossAxes(bundle.direction, bundle.dx, bundle.dy);
        for (int i = 0; i < count; ++i)
        {
          int x, y;
          bundleOffset(16, i, x, y);
          bundle.x[i] = 0.5F * static_cast<float>(x - 8);
          bundle.y[i] = 0.5F * static_cast<float>(y - 8);
          // Some end before they come to anything, or behind where they begin.
          bundle.t[i] = i % 11 == 0 ? 0.6 : i % 13 == 0 ? -1.0 : 1e30;
          bundle.slot[i] = RayBundle::noHit;
          bundle.object[i] = -1;
        }
        RayBundle dark = bundle, lit = bundle;
        surface.cast(lit, 5);
        surface.occlude(dark, 5);
        int hits = 0;
        for (int i = 0; i < count; ++i)
        {
          const auto alone =
            surface.first({bundle.originOf(i), bundle.directionOf(i), bundle.tMin, bundle.t[i]});
          ASSERT_EQ(lit.slot[i] != RayBundle::noHit, alone.has_value()) << i;
          ASSERT_EQ(dark.t[i] < -1e30, alone.has_value()) << i;
          if (!alone)
            continue;
          ++hits;
          EXPECT_EQ(lit.t[i], alone->t);
          EXPECT_EQ(lit.slot[i], std::uint64_t{alone->surface} << 32 | alone->cell);
          EXPECT_EQ(lit.object[i], 5);
        }
        EXPECT_GT(hits, count / 4);
      }
}

TEST(IsoSurface, ValuesOfCellsJumpAndHaveNone)
{
  const auto mesh = hexBlock(6, 6, 6).mesh();
  std::vector<double> values;
  for (std::size_t c = 0; c < mesh->cellCount(); ++c)
    values.push_back(cellCenter(mesh->corners(c)).x);
  for (const auto kind : {HexStructureKind::CartesianBvh, HexStructureKind::CylindricalBvh})
  {
    const CloudObject volume = volumeOf(mesh, values, evenTransfer(0.5F), kind, true);
    const IsoSurface surface(volume.structure, volume.field, {2.0, 3.5});
    RayBundle bundle;
    CameraRays(lookAt({-9.0, 3.1, 2.9}, {3.0, 3.0, 3.0}, 30.0), 16, 16)
      .fillBundle(bundle, 16, 0, 0, 0.0, 0.0);
    surface.cast(bundle, 0);
    for (int i = 0; i < bundle.count; ++i)
      EXPECT_EQ(bundle.slot[i], RayBundle::noHit);
  }
}

TEST(IsoSurface, CellsWithNaNHaveNone)
{
  const auto mesh = hexBlock(3, 1, 1).mesh();
  auto values = pointValues(*mesh, [](const Vec3d& p) { return p.x; });
  for (std::size_t p = 0; p < mesh->pointCount(); ++p)
    if (mesh->point(p).x == 0.0)
      values[p] = NAN;
  const IsoSurface surface = surfaceOf(mesh, values, {0.5, 2.5});
  const auto hit = surface.first({{-1, 0.5, 0.5}, {1, 0, 0}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 3.5, 1e-6);
}
