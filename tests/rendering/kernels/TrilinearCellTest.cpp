// A cell's own coordinates, weights and gradients.

#include <kernels/hexahedra/TrilinearCell.h>

#include <support/HexMeshes.h>
#include <support/HexOracle.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

using namespace mote;
using namespace mote::testing;

namespace
{

/// Cells that are twisted by 10 degrees a layer.
HexCells twisted()
{
  HexCells cells = hexBlock(4, 4, 4, 0.15);
  cells.move(
    [](const Vec3d& p)
    {
      const double a = p.z * 10.0 / 180.0 * M_PI, x = p.x - 2.0, y = p.y - 2.0;
      return Vec3d(x * std::cos(a) - y * std::sin(a), x * std::sin(a) + y * std::cos(a), p.z);
    });
  return cells;
}

double largestError(const HexMesh& mesh, double slack)
{
  double worst = 0.0;
  for (std::size_t c = 0; c < mesh.cellCount(); ++c)
  {
    const TrilinearCell cell(mesh, c);
    for (const Vec3d& rst : randomPoints(50, Vec3d(slack), Vec3d(1.0 - slack), 7))
    {
      Vec3d found;
      EXPECT_TRUE(cell.coordinates(cell.point(rst), found)) << c;
      worst = std::max(worst, glm::length(found - rst));
    }
  }
  return worst;
}

} // namespace

TEST(TrilinearCell, CoordinatesComeBack)
{
  EXPECT_LT(largestError(*hexBlock(4, 4, 4, 0.3).mesh(), 0.0), 1e-11);
  EXPECT_LT(largestError(*twisted().mesh(), 0.0), 1e-11);
}

TEST(TrilinearCell, CoordinatesComeBackFromFarAway)
{
  HexCells cells = hexBlock(4, 4, 4, 0.3);
  cells.move([](const Vec3d& p) { return p + Vec3d(1e6, -1e6, 1e6); });
  // Points are rounded to 1e-10 there.
  EXPECT_LT(largestError(*cells.mesh(), 0.0), 5e-9);
}

TEST(TrilinearCell, CoordinatesComeBackInFlatCells)
{
  HexCells cells = hexBlock(4, 4, 4, 0.3);
  cells.move([](const Vec3d& p) { return Vec3d(p.x + p.y, p.y - p.x, 1e-5 * p.z + 0.3 * p.x); });
  EXPECT_LT(largestError(*cells.mesh(), 0.0), 1e-8);
}

TEST(TrilinearCell, CoordinatesComeBackInCollapsedCells)
{
  const std::vector<Vec3d> p = {{0, 0, 0}, {1, 0.1, 0}, {1.1, 1, 0.2}, {0, 1, 0}, {0.4, 0.6, 1.3}};
  HexCells cells;
  cells.addCell(HexCellType::Pyramid, p);
  cells.addCell(HexCellType::Tetrahedron, std::vector<Vec3d>{p[0], p[1], p[3], p[4]});
  cells.addCell(HexCellType::Wedge,
    std::vector<Vec3d>{p[0], p[1], p[3], p[0] + p[4], p[1] + p[4], p[3] + 1.2 * p[4]});
  EXPECT_LT(largestError(*cells.mesh(), 0.01), 1e-9);
}

TEST(TrilinearCell, EveryPointInsideHasCoordinatesThatGiveItBack)
{
  const HexMesh mesh(hexBlock(3, 3, 3, 0.45, 5).input());
  int inside = 0;
  for (std::size_t c = 0; c < mesh.cellCount(); ++c)
  {
    const TrilinearCell cell(mesh, c);
    const HexOracle oracle(mesh.corners(c));
    const Vec3d middle = cellCenter(mesh.corners(c));
    for (const Vec3d& p : randomPoints(40, middle - Vec3d(0.8), middle + Vec3d(0.8), 3))
    {
      HexOracle::Vec exact;
      if (!oracle.coordinates(p, exact))
        continue;
      ++inside;
      Vec3d rst;
      cell.coordinates(p, rst);
      EXPECT_LT(glm::length(cell.point(rst) - p), 1e-10);
    }
  }
  EXPECT_GT(inside, 200);
}

TEST(TrilinearCell, AnApexHasCoordinates)
{
  const std::vector<Vec3d> p = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
  HexCells cells;
  cells.addCell(HexCellType::Pyramid, p);
  const TrilinearCell cell(*cells.mesh(), 0);
  Vec3d rst;
  cell.coordinates(p[4], rst);
  EXPECT_NEAR(rst.z, 1.0, 1e-9);
  EXPECT_LT(glm::length(cell.point(rst) - p[4]), 1e-9);
}

TEST(TrilinearCell, LinearFieldsAreReproduced)
{
  const HexMesh mesh(twisted().input());
  const Vec3d slope(0.3, -1.2, 0.7);
  const auto field = [&](const Vec3d& p) { return 2.0 + glm::dot(slope, p); };
  const double range = glm::dot(glm::abs(slope), mesh.bounds().size());
  for (std::size_t c = 0; c < mesh.cellCount(); ++c)
  {
    const TrilinearCell cell(mesh, c);
    CornerValues values;
    for (std::size_t i = 0; i < 8; ++i)
      values[i] = field(cell.corners()[i]);
    for (const Vec3d& at : randomPoints(20, Vec3d(0.0), Vec3d(1.0), 11))
    {
      const Vec3d p = cell.point(at);
      Vec3d rst;
      ASSERT_TRUE(cell.coordinates(p, rst));
      EXPECT_NEAR(weighted(values, TrilinearCell::weights(rst)), field(p), 1e-9 * range);
      EXPECT_LT(glm::length(cell.gradient(values, rst) - slope), 1e-9);
    }
  }
}

TEST(TrilinearCell, GradientsAtAnApexAreFinite)
{
  const std::vector<Vec3d> p = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
  HexCells cells;
  cells.addCell(HexCellType::Pyramid, p);
  const TrilinearCell cell(*cells.mesh(), 0);
  CornerValues values;
  for (std::size_t i = 0; i < 8; ++i)
    values[i] = cell.corners()[i].x + 2.0 * cell.corners()[i].z;
  for (const Vec3d& at : {Vec3d(0.3, 0.6, 1.0), Vec3d(0.5, 0.5, 1.0), Vec3d(0.0, 0.5, 1.0)})
    EXPECT_LT(glm::length(cell.gradient(values, at) - Vec3d(1, 0, 2)), 1e-6);
}

TEST(TrilinearCell, WhereNewtonsMethodFailsTheBestPlaceInTheCellIsFound)
{
  HexCorners corners = HexMesh(hexBlock(1, 1, 1).input()).corners(0);
  const auto shifts = randomPoints(8, Vec3d(-0.35), Vec3d(0.35), 5);
  for (std::size_t i = 0; i < 8; ++i)
    corners[i] += shifts[i];
  const TrilinearCell cell(corners);
  int searched = 0;
  for (const Vec3d& p : randomPoints(3000, Vec3d(-2.0, -2.0, -1.5), Vec3d(2.0, 2.0, 2.5), 7))
  {
    Vec3d found;
    if (cell.coordinates(p, found))
      continue;
    ++searched;
    double nearest = std::numeric_limits<double>::infinity();
    constexpr int steps = 20;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps; ++j)
        for (int k = 0; k <= steps; ++k)
          nearest = std::min(nearest, glm::length(cell.point(Vec3d(i, j, k) / double(steps)) - p));
    // The nearest in the cell's own measure, which is not quite that of space.
    EXPECT_LT(glm::length(cell.point(found) - p), 1.1 * nearest);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_GE(found[k], 0.0);
      EXPECT_LE(found[k], 1.0);
    }
  }
  EXPECT_GT(searched, 20);
}

TEST(TrilinearCell, InverseDistanceWeights)
{
  const HexMesh mesh(hexBlock(1, 1, 1).input());
  const TrilinearCell cell(mesh, 0);
  for (const double w : cell.inverseDistanceWeights(Vec3d(0.5)))
    EXPECT_NEAR(w, 0.125, 1e-15);
  EXPECT_EQ(cell.inverseDistanceWeights({1, 1, 0})[2], 1.0);
  const Vec3d p(0.25, 0.5, 0.75);
  double sum = 0.0;
  for (const Vec3d& q : cell.corners())
    sum += 1.0 / glm::length(p - q);
  EXPECT_NEAR(
    cell.inverseDistanceWeights(p)[6], 1.0 / glm::length(p - cell.corners()[6]) / sum, 1e-15);
}

TEST(TrilinearCell, BendsAreBoundedAndLinearFieldsHaveNone)
{
  const auto mesh = twisted().mesh();
  const auto linear = [](const Vec3d& p) { return 3.0 + p.x - 2.0 * p.y + 0.5 * p.z; };
  const auto curved = [](const Vec3d& p) { return p.x * p.y + std::sin(p.y + 2.0 * p.z); };
  for (std::size_t c = 0; c < mesh->cellCount(); ++c)
  {
    const TrilinearCell cell(*mesh, c);
    CornerValues even, uneven;
    for (std::size_t i = 0; i < 8; ++i)
    {
      even[i] = linear(mesh->corners(c)[i]);
      uneven[i] = curved(mesh->corners(c)[i]);
    }
    EXPECT_LT(bendOf(mesh->corners(c), even), 1e-13);
    const double bound = bendOf(mesh->corners(c), uneven);
    const auto ends = randomPoints(20, Vec3d(0.0), Vec3d(1.0), 7);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    {
      const Vec3d a = cell.point(ends[i]), b = cell.point(ends[i + 1]);
      Vec3d middle;
      ASSERT_TRUE(cell.coordinates(0.5 * (a + b), middle));
      const auto at = [&](const Vec3d& rst)
      { return weighted(uneven, TrilinearCell::weights(rst)); };
      EXPECT_LE(std::abs(at(middle) - 0.5 * (at(ends[i]) + at(ends[i + 1]))), bound);
    }
  }
}

TEST(TrilinearCell, BendsAreTheSameHoweverTheCornersAreListed)
{
  const auto mesh = hexBlock(3, 3, 3, 0.1).mesh();
  const auto curved = [](const Vec3d& p) { return p.x * p.y + std::sin(p.y + 2.0 * p.z); };
  // Of a corner's bits, which coordinates are 1; and which bits a corner of the cell has.
  constexpr std::array<std::size_t, 8> cornerOf = {0, 1, 3, 2, 4, 5, 7, 6};
  constexpr std::size_t orders[][3] = {
    {0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (std::size_t c = 0; c < mesh->cellCount(); ++c)
  {
    const HexCorners corners = mesh->corners(c);
    CornerValues values;
    for (std::size_t i = 0; i < 8; ++i)
      values[i] = curved(corners[i]);
    const double expected = bendOf(corners, values);
    for (const auto& order : orders)
      for (std::size_t flips = 0; flips < 8; ++flips)
      {
        HexCorners turned;
        CornerValues theirs;
        for (std::size_t bits = 0; bits < 8; ++bits)
        {
          std::size_t from = flips;
          for (std::size_t k = 0; k < 3; ++k)
            from ^= (bits >> k & 1) << order[k];
          turned[cornerOf[bits]] = corners[cornerOf[from]];
          theirs[cornerOf[bits]] = values[cornerOf[from]];
        }
        EXPECT_NEAR(bendOf(turned, theirs), expected, 1e-12 + 1e-9 * expected) << c;
      }
  }
}
