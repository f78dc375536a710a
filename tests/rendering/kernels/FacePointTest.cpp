// Where lines pass faces, as weights of corners: the same from both sides, and where they are.

#include <kernels/hexahedra/CellCrossings.h>

#include <support/HexMeshes.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace mote;
using namespace mote::testing;

namespace
{

/// A part of a line in a cell and where its ends are.
struct Passed
{
  CellSpan span;
  FacePoint from, to;
};

std::vector<Passed> passedCells(const HexMesh& mesh, const Vec3d& o, const Vec3d& d)
{
  const CrossingLine line(o, d);
  std::vector<Passed> all;
  CellIntervals intervals;
  for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
    if (line.intersect(mesh, c, intervals))
      for (const CellInterval& i : intervals)
        all.push_back({i.within(c, -1e300, 1e300), line.entry(mesh, c, i.inFace),
          line.exit(mesh, c, i.outFace)});
  std::sort(all.begin(), all.end(),
    [](const Passed& a, const Passed& b) { return a.span.tIn < b.span.tIn; });
  return all;
}

/// Interpolates what the points of the mesh have.
template <typename OfPoint>
double valueAt(
  const HexMesh& mesh, std::uint32_t cell, const FacePoint& point, const OfPoint& ofPoint)
{
  return point.value([&](std::size_t i) { return ofPoint(mesh.cell(cell)[i]); });
}

/// How far the interpolated point is from the line's own.
double distance(
  const HexMesh& mesh, std::uint32_t cell, const FacePoint& point, const Vec3d& expected)
{
  Vec3d p;
  for (int k = 0; k < 3; ++k)
    p[k] = valueAt(mesh, cell, point, [&](std::size_t i) { return mesh.point(i)[k]; });
  return glm::length(p - expected);
}

/// Expects ends to be where t says, and of spans that follow one another the same value where they
/// meet. Gives how many meet.
std::size_t expectShared(const HexMesh& mesh, const Vec3d& o, const Vec3d& d, double slack)
{
  const auto ofPoint = [](std::size_t i) { return static_cast<double>(i * 7919 % 101) / 3.0; };
  std::size_t shared = 0;
  const Passed* last = nullptr;
  const auto passed = passedCells(mesh, o, d);
  for (const Passed& p : passed)
  {
    EXPECT_LE(distance(mesh, p.span.cell, p.from, o + p.span.tIn * d), slack);
    EXPECT_LE(distance(mesh, p.span.cell, p.to, o + p.span.tOut * d), slack);
    EXPECT_NEAR(p.to.value([](std::size_t) { return 1.0; }), 1.0, 1e-14);
    for (const double w : p.to.weights)
      EXPECT_GE(w, 0.0);
    if (last != nullptr && last->span.tOut == p.span.tIn)
    {
      EXPECT_EQ(valueAt(mesh, last->span.cell, last->to, ofPoint),
        valueAt(mesh, p.span.cell, p.from, ofPoint));
      ++shared;
    }
    last = &p;
  }
  return shared;
}

std::size_t expectSharedOnLines(const HexMesh& mesh, double slack)
{
  const Vec3d size = mesh.bounds().size();
  const auto points = randomPoints(400, Vec3d(0.0), Vec3d(1.0), 6);
  std::size_t shared = 0;
  for (std::size_t i = 0; i + 1 < points.size(); i += 2)
    shared += expectShared(
      mesh, mesh.bounds().lower + points[i] * size, (points[i + 1] - points[i]) * size, slack);
  return shared;
}

} // namespace

TEST(FacePoint, WarpedCellsAgreeOnWhatTheyShare)
{
  EXPECT_GT(expectSharedOnLines(HexMesh(hexBlock(4, 4, 4, 0.3, 3).input()), 1e-13), 1000U);
  EXPECT_GT(
    expectSharedOnLines(HexMesh(hexRing({3, 24, 4, 1.0, 2.0, 1.0, 0.4, 0.2, 5}).input()), 1e-13),
    500U);
}

TEST(FacePoint, TrianglesAgreeOnWhatTheyShare)
{
  HexCells cells = hexBlock(3, 3, 3, 0.3);
  HexCells wedges;
  wedges.points = cells.points;
  for (std::size_t c = 0; c < cells.types.size(); ++c)
  {
    const std::int64_t* k = &cells.connectivity[8 * c];
    wedges.addCell(
      HexCellType::Wedge, std::vector<std::int64_t>{k[0], k[1], k[2], k[4], k[5], k[6]});
    wedges.addCell(
      HexCellType::Wedge, std::vector<std::int64_t>{k[0], k[2], k[3], k[4], k[6], k[7]});
  }
  EXPECT_GT(expectSharedOnLines(HexMesh(wedges.input()), 1e-13), 800U);
}

TEST(FacePoint, AlongAxesOfABlockItIsExact)
{
  const HexMesh mesh(hexBlock(4, 4, 4).input());
  EXPECT_EQ(expectShared(mesh, {-1, 1.25, 2.5}, {1, 0, 0}, 0.0), 3U);
  EXPECT_EQ(expectShared(mesh, {0.75, 9, 2.5}, {0, -1, 0}, 0.0), 3U);
  EXPECT_EQ(expectShared(mesh, {2.5, 0.125, -7}, {0, 0, 1}, 0.0), 3U);
}

TEST(FacePoint, AFacePassedTwiceHasTwoPoints)
{
  // The lid's middle hangs low between two opposite corners.
  HexCells cells;
  cells.addCell(
    HexCellType::Hexahedron, std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                               {0, 0, 1}, {1, 0, 0.2}, {1, 1, 1}, {0, 1, 0.2}});
  const HexMesh mesh(cells.input());
  const Vec3d o(-1, -1, 0.8), d(3, 3, 0);
  const auto passed = passedCells(mesh, o, d);
  ASSERT_EQ(passed.size(), 2U);
  EXPECT_EQ(passed[0].span.outFace, 1);
  EXPECT_EQ(passed[1].span.inFace, 1);
  EXPECT_LT(passed[0].span.tOut, passed[1].span.tIn);
  for (const Passed& p : passed)
  {
    EXPECT_LE(distance(mesh, 0, p.from, o + p.span.tIn * d), 1e-14);
    EXPECT_LE(distance(mesh, 0, p.to, o + p.span.tOut * d), 1e-14);
  }
}

TEST(FacePoint, ARaysOwnEndsAreOnNoFace)
{
  const HexMesh mesh(hexBlock(1, 1, 1).input());
  CellIntervals intervals;
  ASSERT_TRUE(CrossingLine({-1, 0.5, 0.5}, {1, 0, 0}).intersect(mesh, 0, intervals));
  const CellSpan whole = intervals.of[0].within(0, 0.0, 9.0);
  EXPECT_EQ(whole, (CellSpan{0, 1.0, 2.0, 4, 5}));
  EXPECT_EQ(intervals.of[0].within(0, 1.0, 2.0), whole);
  EXPECT_EQ(intervals.of[0].within(0, 1.25, 1.75), (CellSpan{0, 1.25, 1.75, noFace, noFace}));
}
