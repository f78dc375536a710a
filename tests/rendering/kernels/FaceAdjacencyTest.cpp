// Which cells share the faces of a mesh.

#include <kernels/hexahedra/FaceAdjacency.h>

#include <support/HexMeshes.h>

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <algorithm>
#include <set>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr std::uint8_t corners[6][4] = {
  {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 4, 7, 3}, {1, 2, 6, 5}};

std::set<std::uint32_t> pointsOf(const HexMesh& mesh, std::size_t cell, std::size_t face)
{
  std::set<std::uint32_t> points;
  for (const std::uint8_t corner : corners[face])
    points.insert(mesh.cell(cell)[corner]);
  return points;
}

/// Faces that have a neighbour; checks that the neighbour has the same points and knows of it.
std::size_t sharedFaces(const HexMesh& mesh, const FaceAdjacency& adjacency)
{
  std::size_t shared = 0;
  for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
    for (std::size_t f = 0; f < 6; ++f)
    {
      const std::uint32_t other = adjacency.next(c, f);
      if (other == HexMesh::noCell)
        continue;
      ++shared;
      int back = 0;
      for (std::size_t g = 0; g < 6; ++g)
        back += adjacency.next(other, g) == c && pointsOf(mesh, other, g) == pointsOf(mesh, c, f);
      EXPECT_EQ(back, 1) << "cell " << c << " face " << f;
    }
  return shared;
}

const std::vector<Vec3d> unitCube = {
  {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

} // namespace

TEST(FaceAdjacency, BlocksShareAllInnerFaces)
{
  const auto mesh = hexBlock(5, 4, 3, 0.3).mesh();
  const FaceAdjacency adjacency(*mesh);
  EXPECT_EQ(sharedFaces(*mesh, adjacency), 2U * (4 * 4 * 3 + 5 * 3 * 3 + 5 * 4 * 2));
  EXPECT_EQ(adjacency.boundary().size(), 2U * (5 * 4 + 4 * 3 + 3 * 5));
  EXPECT_LE(adjacency.bytes(), 24 * mesh->cellCount() + 8 * adjacency.boundary().size());
}

TEST(FaceAdjacency, RingsClose)
{
  const auto ring = hexRing({3, 9, 3}).mesh();
  const FaceAdjacency adjacency(*ring);
  sharedFaces(*ring, adjacency);
  EXPECT_EQ(adjacency.boundary().size(), 2U * (9 * 3 + 9 * 3));
}

TEST(FaceAdjacency, CellsOfAllTypesShareFaces)
{
  // A cube under a pyramid, beside it a wedge, and a tetrahedron on a face of the pyramid.
  HexCells cells;
  for (const Vec3d& p : unitCube)
    cells.addPoint(p);
  cells.addPoint({0.5, 0.5, 2.0});  // 8
  cells.addPoint({2.0, 0.0, 0.0});  // 9
  cells.addPoint({2.0, 1.0, 0.0});  // 10
  cells.addPoint({0.5, -1.0, 1.5}); // 11
  cells.addCell(HexCellType::Hexahedron, std::vector<std::int64_t>{0, 1, 2, 3, 4, 5, 6, 7});
  cells.addCell(HexCellType::Pyramid, std::vector<std::int64_t>{4, 5, 6, 7, 8});
  cells.addCell(HexCellType::Wedge, std::vector<std::int64_t>{1, 9, 5, 2, 10, 6});
  cells.addCell(HexCellType::Tetrahedron, std::vector<std::int64_t>{4, 5, 8, 11});
  const auto mesh = cells.mesh();
  ASSERT_EQ(mesh->cellCount(), 4U);
  const FaceAdjacency adjacency(*mesh);
  EXPECT_EQ(sharedFaces(*mesh, adjacency), 6U);
  EXPECT_EQ(adjacency.boundary().size(), 6U + 5U + 5U + 4U - 6U);
}

TEST(FaceAdjacency, WhatIsNotTheSameFaceIsBoundary)
{
  HexCells cells;
  cells.addCell(HexCellType::Hexahedron, unitCube);
  std::vector<Vec3d> beside = unitCube;
  for (Vec3d& p : beside)
    p.x += 1.0;
  cells.addCell(HexCellType::Hexahedron, beside); // the same places, other points
  const auto apart = cells.mesh();
  EXPECT_EQ(FaceAdjacency(*apart).boundary().size(), 12U);
  // A cell given three times: no face looks the other way.
  HexCells thrice;
  for (const Vec3d& p : unitCube)
    thrice.addPoint(p);
  for (int i = 0; i < 3; ++i)
    thrice.addCell(HexCellType::Hexahedron, std::vector<std::int64_t>{0, 1, 2, 3, 4, 5, 6, 7});
  const auto same = thrice.mesh();
  EXPECT_EQ(FaceAdjacency(*same).boundary().size(), 18U);
  EXPECT_EQ(FaceAdjacency(*HexCells().mesh()).boundary().size(), 0U);
}

TEST(FaceAdjacency, ThreadsMakeNoDifference)
{
  const auto mesh = hexBlock(30, 30, 30, 0.2).mesh();
  const FaceAdjacency many(*mesh);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const FaceAdjacency single(*mesh);
  EXPECT_TRUE(std::equal(many.data(), many.data() + mesh->cellCount(), single.data()));
  EXPECT_TRUE(many.boundary() == single.boundary());
}
