// Integrals over slices and boundaries, against what is known of them.

#include <kernels/hexahedra/SurfaceIntegral.h>

#include <support/Volumes.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <vector>

using namespace mote;
using namespace mote::testing;

namespace
{

/// 1, x, and the flow of a field through the surface.
template <typename Flow>
Integrand areaAndFlow(const Flow& flow)
{
  return [flow](const SurfacePoint& at, double* values)
  {
    values[0] = 1.0;
    values[1] = at.place.x;
    values[2] = glm::dot(flow(at.place), at.normal);
  };
}

Vec3d position(const Vec3d& p)
{
  return p;
}

SliceShape planeAt(const Vec3d& point, const Vec3d& normal)
{
  SliceShape shape;
  shape.point = point;
  shape.axis = normal;
  return shape;
}

} // namespace

TEST(SurfaceIntegral, OfPlanesInABlockIsExact)
{
  // The block's inside is crooked, its faces are flat.
  HexCells cells = hexBlock(6, 5, 4);
  cells.move(
    [](const Vec3d& p)
    {
      const double bend =
        std::sin(M_PI * p.x / 6.0) * std::sin(M_PI * p.y / 5.0) * std::sin(M_PI * p.z / 4.0);
      return p + 0.3 * bend * Vec3d(1.0, -0.7, 0.8);
    });
  const auto mesh = cells.mesh();
  for (const double z : {0.013, 1.0, 1.7, 3.99})
  {
    const auto found = integrateSlice(*mesh, planeAt({0.0, 0.0, z}, {0.0, 0.0, 2.0}), 3,
      areaAndFlow([](const Vec3d& p) { return Vec3d(9.0, p.y, p.x + p.z); }));
    EXPECT_NEAR(found.values[0], 30.0, 3e-6) << z;
    EXPECT_NEAR(found.values[1], 90.0, 1e-5) << z;
    EXPECT_NEAR(found.values[2], 90.0 + 30.0 * z, 1e-5) << z;
    EXPECT_LT(found.errors[0], 1e-4);
    EXPECT_GE(found.cells, 30U);
  }
  // Aslant, as long as the block is wide.
  const auto slanted =
    integrateSlice(*mesh, planeAt({3.0, 2.5, 2.0}, {0.0, -0.3, 1.0}), 3, areaAndFlow(position));
  EXPECT_NEAR(slanted.values[0], 30.0 * std::sqrt(1.09), 3e-6);
  // Half planes end at their axis, wherever that is in a cell.
  SliceShape half = planeAt({2.3, 2.1, 2.0}, {0.0, 0.0, 1.0});
  half.kind = SliceShape::Kind::HalfPlane;
  half.out = {1.0, 0.0, 0.5};
  const auto found = integrateSlice(*mesh, half, 3, areaAndFlow(position));
  EXPECT_NEAR(found.values[0], 3.7 * 4.0, 3e-6);
  EXPECT_NEAR(found.values[2], 2.1 * 3.7 * 4.0, 1e-5); // towards growing angles: y
}

TEST(SurfaceIntegral, OfHalfPlanesBeginAtAnAxisOfCornersAndEdges)
{
  const auto mesh = hexBlock(4, 4, 3).mesh();
  for (const Vec3d& out : {Vec3d(1, 0, 0), Vec3d(0, -1, 0)})
    for (const Vec3d& axis : {Vec3d(0, 0, 1), Vec3d(0, 0, -1)})
    {
      SliceShape half = planeAt({2.0, 2.0, 0.0}, axis);
      half.kind = SliceShape::Kind::HalfPlane;
      half.out = out;
      const auto found = integrateSlice(*mesh, half, 3, areaAndFlow(position));
      EXPECT_NEAR(found.values[0], 2.0 * 3.0, 1e-9);
      EXPECT_NEAR(found.values[1], (2.0 + out.x) * 6.0, 1e-9);
    }
  // Along a diagonal of cells, through corners alone.
  SliceShape half = planeAt({2.0, 2.0, 0.0}, {0.0, 0.0, 1.0});
  half.kind = SliceShape::Kind::HalfPlane;
  half.out = {1.0, 1.0, 0.0};
  EXPECT_NEAR(
    integrateSlice(*mesh, half, 3, areaAndFlow(position)).values[0], 3.0 * std::sqrt(8.0), 1e-9);
}

TEST(SurfaceIntegral, OfWholePlanesAddUpToTheVolume)
{
  const auto mesh = hexBlock(3, 3, 3, 0.4).mesh();
  double volume = 0.0;
  constexpr int planes = 60;
  const Box bounds = mesh->bounds();
  const double step = bounds.size().z / planes;
  for (int i = 0; i < planes; ++i)
    volume += step * integrateSlice(*mesh,
                       planeAt({0.0, 0.0, bounds.lower.z + (i + 0.5) * step}, {0, 0, 1}), 3,
                       areaAndFlow(position))
                       .values[0];
  EXPECT_NEAR(volume / mesh->report().volume, 1.0, 1e-3);
}

TEST(SurfaceIntegral, OfCylindersInARingIsThatOfTheirShape)
{
  RingShape ring;
  ring.twist = 0.3;
  const auto mesh = hexRing(ring).mesh();
  SliceShape shape;
  shape.kind = SliceShape::Kind::Cylinder;
  shape.radius = 1.45;
  // A source on the axis sends the same through every cylinder.
  const auto found = integrateSlice(*mesh, shape, 3,
    areaAndFlow([](const Vec3d& p) { return Vec3d(p.x, p.y, 5.0) / (p.x * p.x + p.y * p.y); }));
  EXPECT_NEAR(found.values[0] / (2.0 * M_PI * 1.45 * ring.height), 1.0, 1e-6);
  EXPECT_NEAR(found.values[1], 0.0, 1e-6);
  EXPECT_NEAR(found.values[2] / (2.0 * M_PI * ring.height), 1.0, 1e-6);
  EXPECT_LT(found.errors[2], 1e-3);
}

TEST(SurfaceIntegral, WhereNothingFlowsThroughTheSpeedTellsWhatIsEnough)
{
  RingShape ring;
  ring.twist = 0.3;
  const auto mesh = hexRing(ring).mesh();
  SliceShape shape;
  shape.kind = SliceShape::Kind::Cylinder;
  shape.radius = 1.45;
  std::atomic<long> calls = 0;
  const auto around = [&](const Vec3d& p)
  {
    ++calls;
    return Vec3d(-p.y, p.x, 0.5 + 0.1 * p.z);
  };
  const Integrand sizes = [&](const SurfacePoint& at, double* values)
  {
    values[0] = 1.0;
    values[1] = std::abs(at.place.x);
    values[2] = glm::length(around(at.place));
  };
  integrateSlice(*mesh, shape, 3, areaAndFlow(around), nullptr, 1e-5);
  const long without = calls.exchange(0);
  const auto found = integrateSlice(*mesh, shape, 3, areaAndFlow(around), nullptr, 1e-5, sizes);
  EXPECT_LT(4 * calls, without);
  EXPECT_NEAR(found.values[0] / (2.0 * M_PI * 1.45 * ring.height), 1.0, 1e-5);
  EXPECT_NEAR(found.values[2], 0.0, 1e-5);
}

TEST(SurfaceIntegral, OfBoundariesObeysGauss)
{
  for (const HexCells& cells :
    {hexBlock(4, 3, 5, 0.4), hexRing({}), merged(hexBlock(4, 4, 4, 0.2), {{0, 1, 2}, {20, 36}})})
  {
    const auto mesh = cells.mesh();
    const FaceAdjacency adjacency(*mesh);
    const auto found = integrateBoundary(*mesh, adjacency, 3, areaAndFlow(position));
    EXPECT_NEAR(found.values[2] / (3.0 * mesh->report().volume), 1.0, 1e-12);
    EXPECT_LT(found.errors[2], 1e-10);
    EXPECT_EQ(found.cells, adjacency.boundary().size());
    // What a pressure that is the same everywhere does adds up to nothing.
    const auto torque = integrateBoundary(*mesh, adjacency, 1,
      [](const SurfacePoint& at, double* values)
      { values[0] = 7.0 * glm::cross(at.place, at.normal).z; });
    EXPECT_NEAR(torque.values[0], 0.0, 1e-10);
  }
}

TEST(SurfaceIntegral, BoundariesOfRefinedMeshesAreTheirOutside)
{
  HexCells cells = refinedBlock();
  cells.move([](const Vec3d& p) { return p + Vec3d(0.8 * p.y, 0.0, 0.6 * p.x); });
  const auto mesh = cells.mesh();
  ASSERT_EQ(mesh->cellCount(), 7U + 63U + 8U);
  const FaceAdjacency adjacency(*mesh);
  const auto found = integrateBoundary(*mesh, adjacency, 3, areaAndFlow(position));
  EXPECT_NEAR(found.values[2], 3.0 * mesh->report().volume, 1e-12);
  EXPECT_EQ(found.cells, 24U - 3U + 3U * 16U);
  EXPECT_GT(adjacency.boundary().size(), found.cells);
  const auto plain = [&]
  {
    HexCells whole = hexBlock(2, 2, 2);
    whole.move([](const Vec3d& p) { return p + Vec3d(0.8 * p.y, 0.0, 0.6 * p.x); });
    return whole.mesh();
  }();
  const auto expected = integrateBoundary(*plain, FaceAdjacency(*plain), 3, areaAndFlow(position));
  EXPECT_NEAR(found.values[0], expected.values[0], 1e-12);
}

TEST(SurfaceIntegral, CellsAreThoseThatTheSurfaceMeets)
{
  const auto mesh = hexBlock(3, 2, 2).mesh();
  const Integrand area = [](const SurfacePoint&, double* values) { values[0] = 1.0; };
  for (const auto& [z, cells] : {std::pair(0.5, 6U), std::pair(1.25, 6U), std::pair(7.0, 0U)})
  {
    const auto found = integrateSlice(*mesh, planeAt({0.0, 0.0, z}, {0, 0, 1}), 1, area);
    EXPECT_EQ(found.cells, cells) << z;
    EXPECT_NEAR(found.values[0], cells, 1e-12) << z;
  }
  // Not those whose boxes alone it meets.
  HexCells crooked = hexBlock(4, 4, 4);
  crooked.move([](const Vec3d& p) { return p + Vec3d(0.8 * p.y, 0.0, 0.6 * p.x); });
  const auto slanted = crooked.mesh();
  const Vec3d normal(0.3, -1.0, 0.5);
  for (const double height : {-2.1, 0.37, 2.9})
  {
    unsigned met = 0;
    for (std::size_t k = 0; k < slanted->cellCount(); ++k)
    {
      bool above = false, below = false;
      for (const Vec3d& corner : slanted->corners(k))
        (glm::dot(normal, corner) > height ? above : below) = true;
      met += above && below;
    }
    const Vec3d point = normal * (height / glm::dot(normal, normal));
    EXPECT_EQ(integrateSlice(*slanted, planeAt(point, normal), 1, area).cells, met) << height;
    EXPECT_GT(met, 3U);
  }
}

TEST(SurfaceIntegral, HiddenCellsAreNotThere)
{
  const auto mesh = hexBlock(3, 1, 1).mesh();
  const std::vector<unsigned char> isVisible = {1, 0, 1};
  const HiddenCells hidden(*mesh, isVisible.data());
  const auto slice =
    integrateSlice(*mesh, planeAt({0.0, 0.0, 0.5}, {0, 0, 1}), 3, areaAndFlow(position), &hidden);
  EXPECT_NEAR(slice.values[0], 2.0, 1e-12);
  EXPECT_NEAR(slice.values[1], 0.5 + 2.5, 1e-12);
  const FaceAdjacency adjacency(*mesh);
  const auto boundary = integrateBoundary(*mesh, adjacency, 3, areaAndFlow(position), &hidden);
  // Without the faces towards the hidden cell, at x = 1 and 2.
  EXPECT_NEAR(boundary.values[0], 10.0, 1e-12);
  EXPECT_NEAR(boundary.values[2], 6.0 - (1.0 - 2.0), 1e-12);
}
