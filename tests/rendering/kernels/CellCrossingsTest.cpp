// Where lines and points are in cells: nothing lost, nothing claimed twice.

#include <kernels/hexahedra/CellCrossings.h>
#include <kernels/hexahedra/TrilinearCell.h>

#include <support/HexMeshes.h>
#include <support/HexOracle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

int claims(const HexMesh& mesh, const Vec3d& p)
{
  const CrossingPoint point(p, glm::length(mesh.bounds().size()));
  int sum = 0;
  for (std::size_t c = 0; c < mesh.cellCount(); ++c)
    sum += point.isIn(mesh, c);
  return sum;
}

/// All cells' intervals on a line, in order.
std::vector<CellInterval> allIntervals(const HexMesh& mesh, const Vec3d& o, const Vec3d& d)
{
  const CrossingLine line(o, d);
  std::vector<CellInterval> all;
  CellIntervals intervals;
  for (std::size_t c = 0; c < mesh.cellCount(); ++c)
    if (line.intersect(mesh, c, intervals))
      all.insert(all.end(), intervals.begin(), intervals.end());
  std::sort(all.begin(), all.end(),
    [](const CellInterval& a, const CellInterval& b) { return a.in < b.in; });
  return all;
}

/// Expects gaps and overlaps of the intervals to be no longer than `slack`, and gives their sum.
double chord(const HexMesh& mesh, const Vec3d& o, const Vec3d& d, double slack = 0.0)
{
  double sum = 0.0, reach = 0.0, gap = 0.0, overlap = 0.0;
  bool first = true;
  for (const CellInterval& i : allIntervals(mesh, o, d))
  {
    sum += i.out - i.in;
    gap = first ? 0.0 : std::max(gap, i.in - reach);
    overlap = first ? 0.0 : std::max(overlap, std::min(reach, i.out) - i.in);
    reach = first ? i.out : std::max(reach, i.out);
    first = false;
  }
  EXPECT_LE(gap, slack) << o.x << " " << o.y << " " << o.z;
  EXPECT_LE(overlap, slack) << o.x << " " << o.y << " " << o.z;
  return sum;
}

/// A mesh whose sides are plane and whose cells inside are warped: n^3 cells that fill a box.
HexCells warpedBlock(int n, const Vec3d& away, double jitter = 0.3)
{
  HexCells cells = hexBlock(n, n, n, jitter, 3);
  cells.move([&](const Vec3d& p) { return p + away; });
  return cells;
}

double boxChord(const Vec3d& o, const Vec3d& d, const Box& box)
{
  double in = -1e300, out = 1e300;
  for (int k = 0; k < 3; ++k)
  {
    const double a = (box.lower[k] - o[k]) / d[k], b = (box.upper[k] - o[k]) / d[k];
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  }
  return std::max(0.0, out - in);
}

/// Expects of random points in the mesh's box that one cell has them, and of lines through them
/// that the cells' intervals follow one another and fill the box.
void expectFilledBox(const HexMesh& mesh, double slack)
{
  const Vec3d size = mesh.bounds().size();
  const auto points = randomPoints(300, Vec3d(0.001), Vec3d(0.999), 6);
  for (std::size_t i = 0; i + 1 < points.size(); i += 2)
  {
    const Vec3d p = mesh.bounds().lower + points[i] * size, d = (points[i + 1] - points[i]) * size;
    EXPECT_EQ(claims(mesh, p), 1);
    EXPECT_NEAR(chord(mesh, p, d, slack), boxChord(p, d, mesh.bounds()), 1e-9);
  }
}

} // namespace

TEST(CellCrossings, PointsOnAndBesideSharedFacesHaveOneCell)
{
  for (const double away : {0.0, 100.0, 1e6})
  {
    const HexMesh mesh(warpedBlock(4, Vec3d(away, -away, away)).input());
    const Box box = mesh.bounds().expanded(-1e-12);
    int asked = 0;
    for (std::size_t c = 0; c < mesh.cellCount(); ++c)
    {
      const TrilinearCell cell(mesh, c);
      for (Vec3d rst : randomPoints(24, Vec3d(0.0), Vec3d(1.0), static_cast<unsigned>(c)))
      {
        rst[asked % 3] = asked % 2;
        const double beside[] = {0.0, 1e-16, -1e-16, 1e-13, -1e-13, 1e-9, -1e-9, 1e-4, -1e-4};
        Vec3d p = cell.point(rst);
        p[asked % 3] += beside[asked % 9] * std::max(1.0, away);
        ++asked;
        if (glm::all(glm::greaterThan(p, box.lower)) && glm::all(glm::lessThan(p, box.upper)))
        {
          EXPECT_EQ(claims(mesh, p), 1) << p.x << " " << p.y << " " << p.z;
        }
      }
    }
  }
}

TEST(CellCrossings, PointsOnEdgesAndCornersHaveOneCell)
{
  const HexMesh mesh(warpedBlock(4, Vec3d(0.0)).input());
  const Box box = mesh.bounds().expanded(-1e-12);
  for (std::size_t c = 0; c < mesh.cellCount(); ++c)
    for (std::size_t i = 0; i < 8; ++i)
      for (const double s : {0.0, 0.25, 1.0 / 3.0, 0.5})
      {
        const HexCorners q = mesh.corners(c);
        const Vec3d p = q[i] + s * (q[(i + 3) % 8] - q[i]);
        if (glm::all(glm::greaterThan(p, box.lower)) && glm::all(glm::lessThan(p, box.upper)))
        {
          EXPECT_EQ(claims(mesh, p), 1);
        }
      }
}

TEST(CellCrossings, PointsAgreeWithTheOracle)
{
  const HexMesh mesh(hexBlock(3, 3, 3, 0.45, 5).input());
  int inside = 0;
  for (std::size_t c = 0; c < mesh.cellCount(); ++c)
  {
    if (jacobianRange(mesh.corners(c)).smallest <= 0.0)
      continue;
    const HexOracle oracle(mesh.corners(c));
    const Vec3d middle = cellCenter(mesh.corners(c));
    for (const Vec3d& p : randomPoints(60, middle - Vec3d(0.8), middle + Vec3d(0.8), 9))
    {
      const bool in = oracle.contains(p);
      EXPECT_EQ(CrossingPoint(p, 3.0).isIn(mesh, c), in);
      inside += in;
    }
  }
  EXPECT_GT(inside, 100);
}

TEST(CellCrossings, ChordsAgreeWithTheOracle)
{
  const HexMesh mesh(hexBlock(3, 3, 3, 0.4, 8).input());
  const std::vector<Vec3d> ends = randomPoints(200, Vec3d(-1.0), Vec3d(4.0), 21);
  int met = 0;
  CellIntervals intervals;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
  {
    const std::size_t c = i / 2 % mesh.cellCount();
    if (jacobianRange(mesh.corners(c)).smallest <= 0.0)
      continue;
    const Vec3d middle = cellCenter(mesh.corners(c)), side = ends[i] - Vec3d(1.5);
    const Vec3d from = middle + side, to = middle - side + 0.3 * (ends[i + 1] - Vec3d(1.5));
    double sum = 0.0;
    if (CrossingLine(from, to - from).intersect(mesh, c, intervals))
      for (const CellInterval& v : intervals)
        sum += std::max(0.0, std::min(v.out, 1.0) - std::max(v.in, 0.0));
    EXPECT_NEAR(sum, HexOracle(mesh.corners(c)).share(from, to, 100), 1e-9);
    met += sum > 0.0;
  }
  EXPECT_GT(met, 60);
}

TEST(CellCrossings, ChordsOfATwistedRingAgreeWithTheOracle)
{
  const HexMesh mesh(hexRing({1, 8, 2, 1.0, 2.0, 1.0, 0.4, 0.2}).input());
  const auto from = randomPoints(3, Vec3d(-3, -2, 0.2), Vec3d(-2, -1, 0.8), 31);
  const auto to = randomPoints(3, Vec3d(2, 1, 0.2), Vec3d(3, 2, 0.8), 32);
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    double exact = 0.0;
    for (std::size_t c = 0; c < mesh.cellCount(); ++c)
      exact += HexOracle(mesh.corners(c)).share(from[i], to[i], 60);
    EXPECT_GT(exact, 0.1);
    double sum = 0.0;
    for (const CellInterval& part : allIntervals(mesh, from[i], to[i] - from[i]))
      sum += part.out - part.in;
    EXPECT_NEAR(sum, exact, 1e-9);
  }
}

TEST(CellCrossings, AConcaveCellHasSeveralIntervals)
{
  // The lid's middle hangs low between two opposite corners.
  const HexCorners c = {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(1, 1, 0), Vec3d(0, 1, 0),
    Vec3d(0, 0, 1), Vec3d(1, 0, 0.2), Vec3d(1, 1, 1), Vec3d(0, 1, 0.2)};
  // Along the other diagonal the lid is at 0.2 at both ends and at 0.6 in the middle; along this
  // one at 1 at the ends.
  const Vec3d from(-1, -1, 0.8), to(2, 2, 0.8);
  CellIntervals intervals;
  ASSERT_TRUE(CrossingLine(from, to - from).intersect(c, intervals));
  ASSERT_EQ(intervals.count, 2);
  // On the diagonal the lid is 1 - 1.6 u (1 - u).
  const double u = 0.5 - std::sqrt(0.25 - 0.2 / 1.6);
  EXPECT_NEAR(intervals.of[0].in, 1.0 / 3.0, 1e-14);
  EXPECT_NEAR(intervals.of[0].out, (1.0 + u) / 3.0, 1e-14);
  EXPECT_NEAR(intervals.of[1].in, (2.0 - u) / 3.0, 1e-14);
  EXPECT_NEAR(intervals.of[1].out, 2.0 / 3.0, 1e-14);
  EXPECT_TRUE(CrossingPoint({0.05, 0.05, 0.8}, 1.0).isIn(c));
  EXPECT_FALSE(CrossingPoint({0.5, 0.5, 0.8}, 1.0).isIn(c));
}

TEST(CellCrossings, ChordsOfAMeshAreExactAndWithoutGaps)
{
  for (const double away : {0.0, 1e6})
  {
    const HexMesh mesh(warpedBlock(5, Vec3d(away)).input());
    const auto points = randomPoints(400, Vec3d(away - 2.0), Vec3d(away + 7.0), 4);
    int met = 0;
    for (std::size_t i = 0; i + 1 < points.size(); i += 2)
    {
      const Vec3d d = points[i + 1] - points[i];
      const double expected = boxChord(points[i], d, mesh.bounds());
      EXPECT_NEAR(chord(mesh, points[i], d), expected, away > 0 ? 1e-8 : 1e-12);
      met += expected > 0.0;
    }
    EXPECT_GT(met, 80);
  }
}

TEST(CellCrossings, LinesAlongEdgesFacesAndThroughCornersLoseNothing)
{
  // Not moved: lines lie in the faces and edges exactly.
  const HexMesh mesh(hexBlock(4, 4, 4).input());
  const double between[] = {1.0, 2.0, 2.5, 3.0};
  for (const double y : between)
    for (const double z : between)
    {
      EXPECT_EQ(chord(mesh, {-1, y, z}, {1, 0, 0}), 4.0);
      EXPECT_EQ(chord(mesh, {y, 9, z}, {0, -2, 0}), 2.0);
      EXPECT_EQ(chord(mesh, {y, z, -3}, {0, 0, 0.5}), 8.0);
      EXPECT_EQ(chord(mesh, {-1, y - 1, z}, {1, 1, 0}),
        boxChord({-1, y - 1, z}, {1, 1, 1e-300}, mesh.bounds()));
    }
  EXPECT_EQ(chord(mesh, {-1, -1, -1}, {1, 1, 1}), 4.0);
}

TEST(CellCrossings, LinesThroughCornersOfWarpedCellsLoseNothing)
{
  const HexMesh mesh(warpedBlock(5, Vec3d(0.0)).input());
  const auto from = randomPoints(mesh.pointCount(), Vec3d(-9.0), Vec3d(-3.0), 12);
  for (std::size_t i = 0; i < mesh.pointCount(); ++i)
  {
    const Vec3d d = mesh.point(i) - from[i];
    EXPECT_NEAR(chord(mesh, from[i], d, 1e-14), boxChord(from[i], d, mesh.bounds()), 1e-12);
    // Along an edge of the cell that begins there.
    const HexCorners q = mesh.corners(i % mesh.cellCount());
    const Vec3d e = q[6] - q[5], o = q[5] - 20.0 * e;
    EXPECT_NEAR(chord(mesh, o, e, 1e-13), boxChord(o, e, mesh.bounds()), 1e-11);
  }
}

TEST(CellCrossings, CollapsedCellsFillWhatTheyShare)
{
  // A cube of six pyramids about its middle, of which three are two tetrahedra each.
  HexCells cells;
  const Vec3d q[8] = {
    {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const Vec3d m(0.4, 0.55, 0.5);
  const int faces[6][4] = {
    {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 4, 7, 3}, {1, 2, 6, 5}};
  for (int f = 0; f < 6; ++f)
  {
    const auto k = [&](int i) { return q[faces[f][i]]; };
    if (f % 2 == 0)
      cells.addCell(HexCellType::Pyramid, std::vector<Vec3d>{k(0), k(3), k(2), k(1), m});
    else
      for (const int i : {1, 2})
        cells.addCell(HexCellType::Tetrahedron, std::vector<Vec3d>{k(0), k(i + 1), k(i), m});
  }
  const HexMesh mesh(cells.input());
  EXPECT_EQ(mesh.report().kept, 9U);
  EXPECT_NEAR(mesh.report().volume, 1.0, 1e-13);
  expectFilledBox(mesh, 1e-14);
  for (int i = 0; i < 8; ++i)
    EXPECT_EQ(claims(mesh, m + 0.5 * (q[i] - m)), 1);
  EXPECT_EQ(claims(mesh, m), 1);
}

TEST(CellCrossings, WedgesFillWhatTheyShare)
{
  // Every hexahedron cut in two along a diagonal of its warped lid: the cut is warped as well.
  const HexCells whole = hexBlock(3, 3, 3, 0.3);
  HexCells cells;
  cells.points = whole.points;
  for (std::size_t c = 0; c < whole.types.size(); ++c)
  {
    const std::int64_t* k = &whole.connectivity[8 * c];
    cells.addCell(
      HexCellType::Wedge, std::vector<std::int64_t>{k[0], k[1], k[2], k[4], k[5], k[6]});
    cells.addCell(
      HexCellType::Wedge, std::vector<std::int64_t>{k[0], k[2], k[3], k[4], k[6], k[7]});
  }
  const HexMesh mesh(cells.input());
  EXPECT_EQ(mesh.report().wedges, 54U);
  EXPECT_NEAR(mesh.report().volume, 27.0, 1e-12);
  expectFilledBox(mesh, 1e-14);
}

TEST(CellCrossings, FlatCellsLoseNothing)
{
  HexCells cells = hexBlock(4, 4, 4, 0.3);
  cells.move([](const Vec3d& p) { return p * Vec3d(1.0, 1.0, 1e-5); });
  const HexMesh mesh(cells.input());
  expectFilledBox(mesh, 1e-11);
}
