// Cells in (r, theta, h): bounds hold them, and are tight; the axis is found.

#include <kernels/hexahedra/CylindricalSpace.h>
#include <kernels/hexahedra/TrilinearCell.h>

#include <support/HexMeshes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr double turn = 2.0 * std::numbers::pi;

bool holds(const SpaceBounds& b, Vec3d c)
{
  bool in = c.x >= b.lower[0] && c.x <= b.upper[0] && c.z >= b.lower[2] && c.z <= b.upper[2];
  bool angle = false;
  for (const double shift : {-turn, 0.0, turn})
    angle = angle || (c.y + shift >= b.lower[1] && c.y + shift <= b.upper[1]);
  return in && angle;
}

} // namespace

TEST(CylindricalSpace, BoundsHoldTheWholeCell)
{
  HexCells cells = hexBlock(7, 7, 2, 0.4, 2);
  cells.move([](const Vec3d& p) { return p - Vec3d(3.4, 3.6, 1.0); });
  const auto mesh = cells.mesh();
  const CylindricalSpace space({Vec3d(0.1, 0, 0), Vec3d(0.2, 0.1, 1)}, 10.0, 0.7);
  std::size_t out = 0, whole = 0, seam = 0;
  for (std::size_t c = 0; c < mesh->cellCount(); ++c)
  {
    const TrilinearCell cell(*mesh, c);
    const SpaceBounds b = space.boundsOf(cell.corners());
    EXPECT_LE(b.upper[1] - b.lower[1], static_cast<float>(turn) + 1e-5F);
    whole += b.lower[0] == 0.0F;
    seam += b.upper[1] > turn && b.lower[0] > 0.0F;
    for (Vec3d rst : randomPoints(200, Vec3d(0.0), Vec3d(1.0), static_cast<unsigned>(c)))
    {
      out += !holds(b, space.coordinates(cell.point(rst)));
      rst[static_cast<int>(c % 3)] = c % 2;
      out += !holds(b, space.coordinates(cell.point(rst)));
    }
  }
  EXPECT_EQ(out, 0U);
  EXPECT_GE(whole, 2U); // the cells on the axis
  EXPECT_LE(whole, 4U);
  EXPECT_GT(seam, 0U);
}

TEST(CylindricalSpace, BoundsAreTight)
{
  const CylindricalSpace space({}, 4.0);
  const auto mesh = hexRing({4, 16, 4}).mesh();
  for (std::size_t c = 0; c < mesh->cellCount(); ++c)
  {
    const SpaceBounds b = space.boundsOf(mesh->corners(c));
    EXPECT_NEAR(b.upper[1] - b.lower[1], turn / 16, 1e-5);
    EXPECT_NEAR(b.upper[2] - b.lower[2], 0.25, 1e-5);
    // The chord of the inner side is nearer to the axis than its corners are.
    const double corner = std::round(b.upper[0] * 4.0) / 4.0 - 0.25;
    EXPECT_NEAR(b.upper[0], corner + 0.25, 1e-5);
    EXPECT_NEAR(b.lower[0], corner * std::cos(turn / 32), 1e-5);
  }
}

TEST(CylindricalSpace, AnAxisIsFound)
{
  const RingShape shapes[] = {
    {8, 40, 8}, {8, 40, 8, 1.0, 2.0, 4.0, 0.5, 0.3, 7}, {4, 64, 20, 0.2, 3.0, 0.4, 0.0, 0.0, 0}};
  for (const RingShape& shape : shapes)
    for (const bool tilted : {false, true})
      for (const double away : {0.0, 1e6})
      {
        const Vec3d h = tilted ? glm::normalize(Vec3d(1, -2, 0.7)) : Vec3d(0, 0, 1);
        const Vec3d u = tilted ? glm::normalize(glm::cross(h, Vec3d(0, 0, 1))) : Vec3d(1, 0, 0);
        const Vec3d v = glm::cross(h, u), o(away, 2.0 + away, 3.0);
        HexCells cells = hexRing(shape);
        cells.move([&](const Vec3d& p) { return o + p.x * u + p.y * v + p.z * h; });
        const CylinderAxis axis = findAxis(*cells.mesh());
        EXPECT_LT(glm::length(glm::cross(axis.direction, h)), 2e-3);
        EXPECT_LT(glm::length(glm::cross(axis.origin - o, h)), 5e-3);
      }
}

TEST(CylindricalSpace, AnAxisOfAPartOfARingIsFound)
{
  RingShape shape{8, 20, 8};
  shape.turn = 1.5;
  const CylinderAxis axis = findAxis(*hexRing(shape).mesh());
  EXPECT_LT(glm::length(glm::cross(axis.direction, Vec3d(0, 0, 1))), 1e-9);
  EXPECT_LT(glm::length(glm::cross(axis.origin, Vec3d(0, 0, 1))), 1e-9);
}

TEST(CylindricalSpace, TheAxisOfNothingIsZ)
{
  EXPECT_EQ(findAxis(HexMesh(HexMeshInput{})).direction, Vec3d(0, 0, 1));
}
