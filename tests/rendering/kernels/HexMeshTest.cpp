// Hexahedral meshes as they come: types, what is left out or mended, what is refused.

#include <kernels/core/Error.h>
#include <kernels/hexahedra/HexMesh.h>

#include <support/HexMeshes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace mote;
using namespace mote::testing;

namespace
{

const std::vector<Vec3d> cube = {
  {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

std::vector<Vec3d> shifted(std::vector<Vec3d> points, const Vec3d& by)
{
  for (Vec3d& p : points)
    p += by;
  return points;
}

std::string refusal(const HexMeshInput& input)
{
  try
  {
    const HexMesh mesh(input);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return {};
}

} // namespace

TEST(HexMesh, TakesEveryTypeWithItsVolume)
{
  HexCells cells;
  cells.addCell(HexCellType::Hexahedron, cube);
  cells.addCell(HexCellType::Voxel,
    std::vector<Vec3d>{cube[0], cube[1], cube[3], cube[2], cube[4], cube[5], cube[7], cube[6]});
  cells.addCell(
    HexCellType::Wedge, std::vector<Vec3d>{cube[0], cube[1], cube[3], cube[4], cube[5], cube[7]});
  cells.addCell(
    HexCellType::Wedge, std::vector<Vec3d>{cube[0], cube[3], cube[1], cube[4], cube[7], cube[5]});
  cells.addCell(
    HexCellType::Pyramid, std::vector<Vec3d>{cube[0], cube[1], cube[2], cube[3], {0.5, 0.5, 3}});
  cells.addCell(HexCellType::Tetrahedron, std::vector<Vec3d>{cube[0], cube[1], cube[3], cube[4]});
  const HexMesh mesh(cells.input());
  const double volumes[] = {1, 1, 0.5, 0.5, 1, 1.0 / 6.0};
  ASSERT_EQ(mesh.cellCount(), 6U);
  for (std::size_t c = 0; c < 6; ++c)
    EXPECT_NEAR(cellVolume(mesh.corners(c)), volumes[c], 1e-14) << c;
  const HexMeshReport& r = mesh.report();
  EXPECT_EQ(r.hexahedra, 2U);
  EXPECT_EQ(r.wedges, 2U);
  EXPECT_EQ(r.pyramids, 1U);
  EXPECT_EQ(r.tetrahedra, 1U);
  EXPECT_NEAR(r.volume, 4.0 + 1.0 / 6.0, 1e-14);
  EXPECT_EQ(r.sentence(), "");
  EXPECT_EQ(mesh.bounds().upper, Vec3d(1, 1, 3));
}

TEST(HexMesh, CountsWhatItLeavesOutAndMends)
{
  for (const double away : {0.0, 1e6})
  {
    const auto at = [away](std::vector<Vec3d> p) { return shifted(p, Vec3d(away)); };
    HexCells cells;
    auto flat = cube, inverted = cube, bad = cube, crossing = cube;
    for (std::size_t i = 4; i < 8; ++i)
      flat[i].z = 0.0, inverted[i].z = -1.0;
    bad[3].y = std::numeric_limits<double>::quiet_NaN();
    crossing[6] = {-0.5, -0.5, 0.9};
    cells.addCell(HexCellType::Hexahedron, at(flat));
    cells.addCell(HexCellType::Hexahedron, at(inverted));
    cells.addCell(HexCellType::Hexahedron, at(bad));
    cells.addCell(HexCellType::Hexahedron, at(crossing));
    cells.addCell(static_cast<HexCellType>(42), at(cube));
    const HexMesh mesh(cells.input());
    const HexMeshReport& r = mesh.report();
    EXPECT_EQ(r.cells, 5U);
    EXPECT_EQ(r.kept, 2U);
    EXPECT_EQ(r.zeroVolume, 1U);
    EXPECT_EQ(r.inverted, 1U);
    EXPECT_EQ(r.nonFinite, 1U);
    EXPECT_EQ(r.selfCrossing, 1U);
    EXPECT_EQ(r.otherTypes, 1U);
    EXPECT_EQ(r.flat, 0U);
    EXPECT_EQ(r.sentence(),
      "Of 5 cells: 1 of other types left out, 1 with points that are not finite left out, 1 of no "
      "volume left out, 1 listed inside out and mirrored, 1 crossing themselves.");
    ASSERT_EQ(mesh.cellCount(), 2U);
    EXPECT_EQ(mesh.inputCell(0), 1U);
    EXPECT_EQ(mesh.inputCell(1), 3U);
    EXPECT_NEAR(cellVolume(mesh.corners(0)), 1.0, 1e-9);
  }
}

TEST(HexMesh, CellsBeyondAllReachAreLeftOut)
{
  for (const double place : {1e31, -1e200, 1e308})
  {
    auto far = cube;
    far[6].x = place;
    HexCells cells;
    cells.addCell(HexCellType::Hexahedron, far);
    cells.addCell(HexCellType::Hexahedron, cube);
    const HexMesh mesh(cells.input());
    EXPECT_EQ(mesh.report().tooFar, 1U);
    EXPECT_EQ(mesh.report().sentence(), "Of 2 cells: 1 with points beyond 1e30 left out.");
    EXPECT_EQ(mesh.bounds().upper, Vec3d(1.0));
  }
}

TEST(HexMesh, FlatButSoundCellsAreKept)
{
  HexCells cells = hexBlock(3, 3, 3, 0.3);
  cells.move([](const Vec3d& p) { return p * Vec3d(1, 1, 1e-5) + Vec3d(1e3); });
  EXPECT_EQ(cells.mesh()->report().kept, 27U);
}

TEST(HexMesh, RefusesWhatPointsNowhere)
{
  HexCells cells = hexBlock(1, 1, 1);
  cells.connectivity[5] = 8;
  EXPECT_EQ(refusal(cells.input()), "Cell 0 names the point 8, and there are 8 points.");
  cells.connectivity[5] = -1;
  EXPECT_EQ(refusal(cells.input()), "Cell 0 names the point -1, and there are 8 points.");
  cells.offsets[1] = 9;
  EXPECT_EQ(refusal(cells.input()), "The offsets of cell 0 point outside of the connectivity.");
  cells.offsets[1] = 7;
  EXPECT_EQ(refusal(cells.input()), "Cell 0 has 7 points where its type has 8.");
  cells.offsets.pop_back();
  EXPECT_EQ(
    refusal(cells.input()), "There are 1 offsets for 1 cells; one more than cells is needed.");
}

TEST(HexMesh, OfNothingIsEmpty)
{
  const HexMesh mesh{HexMeshInput{}};
  EXPECT_EQ(mesh.cellCount(), 0U);
  EXPECT_TRUE(mesh.bounds().empty());
}
