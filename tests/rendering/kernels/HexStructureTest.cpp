// Every structure over hexahedra gives the answers of asking every cell.

#include <kernels/core/Error.h>
#include <kernels/hexahedra/HexStructure.h>
#include <kernels/hexahedra/TrilinearCell.h>

#include <support/HexMeshes.h>
#include <support/Structure.h>
#include <support/Volumes.h>

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

using namespace mote;
using namespace mote::testing;

namespace
{

using Mesh = std::shared_ptr<const HexMesh>;

std::shared_ptr<HexStructure> build(const Mesh& mesh, HexStructureKind kind,
  std::optional<CylinderAxis> axis = CylinderAxis{}, int leafSize = 1, bool trimmed = false)
{
  HexStructureOptions options;
  options.kind = kind;
  options.axis = axis;
  options.bvh.leafSize = leafSize;
  options.grid.trimmed = trimmed;
  return makeHexStructure(mesh, options);
}

std::vector<CellSpan> spans(const HexStructure& structure, const HexRay& ray)
{
  std::vector<CellSpan> all;
  withStructure(structure,
    [&](const auto& s)
    {
      s.forCellsAlong(ray,
        [&](const CellSpan& span)
        {
          all.push_back(span);
          return true;
        });
    });
  return all;
}

std::uint32_t anyCellAt(const HexMesh& mesh, const Vec3d& p)
{
  const CrossingPoint point(p, glm::length(mesh.bounds().size()));
  for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
    if (point.isIn(mesh, c))
      return c;
  return HexMesh::noCell;
}

/// A mesh and the frame that it lies in.
struct Case
{
  const char* name;
  Mesh mesh;
  CylinderAxis axis;
};

Case placed(const char* name, HexCells cells, const Vec3d& away, bool tilted)
{
  const Vec3d h = tilted ? glm::normalize(Vec3d(1, 2, -0.5)) : Vec3d(0, 0, 1);
  const Vec3d u = tilted ? glm::normalize(glm::cross(h, Vec3d(0, 0, 1))) : Vec3d(1, 0, 0);
  const Vec3d v = glm::cross(h, u);
  cells.move([&](const Vec3d& p) { return away + p.x * u + p.y * v + p.z * h; });
  return {name, cells.mesh(), {away, h}};
}

std::vector<Case> cases()
{
  HexCells onAxis = hexBlock(6, 6, 5, 0.3);
  onAxis.move([](const Vec3d& p) { return p - Vec3d(2.9, 3.05, 0.0); });
  HexCells disc = hexRing({4, 9, 3, 0.0, 1.0, 1.0}); // wedges at the axis
  const RingShape twisted{6, 24, 6, 1.0, 2.0, 1.5, 0.4, 0.3, 3};
  RingShape part = twisted;
  part.turn = 2.0;
  return {placed("ring", hexRing({5, 20, 4}), Vec3d(0.0), false),
    placed("twisted", hexRing(twisted), Vec3d(0.0), false),
    placed("tilted", hexRing(twisted), Vec3d(3, -1, 2), true),
    placed("far", hexRing(twisted), Vec3d(1e6, -1e6, 2e6), true),
    placed("part", hexRing(part), Vec3d(0.0), false), placed("onAxis", onAxis, Vec3d(0.0), false),
    placed("disc", disc, Vec3d(0.0), false),
    placed("coarse", hexRing({1, 3, 1, 0.2, 2.0, 1.0}), Vec3d(0.0), false),
    placed("one", hexBlock(1, 1, 1), Vec3d(0.5, 0, 0), false),
    placed("none", HexCells{}, Vec3d(0.0), false)};
}

bool meet(const Box& a, const Box& b)
{
  return !Box{glm::max(a.lower, b.lower), glm::min(a.upper, b.upper)}.empty();
}

/// Whether one of a lattice of the cell's points is in the box.
bool reachesInto(const TrilinearCell& cell, const Box& box)
{
  for (int i = 0; i < 5 * 5 * 5; ++i)
  {
    const Vec3d p = cell.point(0.25 * Vec3d(i % 5, i / 5 % 5, i / 25));
    if (meet(box, {p, p}))
      return true;
  }
  return false;
}

/// Rays at random and the unkind ones: along the axis, across it, in the planes through it, from
/// inside.
std::vector<HexRay> raysFor(const Case& c)
{
  std::vector<HexRay> rays;
  const Box box = c.mesh->bounds().empty() ? Box{Vec3d(0.0), Vec3d(1.0)} : c.mesh->bounds();
  const Vec3d size = box.size(), o = c.axis.origin, h = c.axis.direction;
  const auto ends = randomPoints(160, box.lower - 0.4 * size, box.upper + 0.4 * size, 5);
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
    rays.push_back({ends[i], ends[i + 1] - ends[i]});
  const auto inside = randomPoints(60, box.lower, box.upper, 6);
  for (std::size_t i = 0; i + 1 < inside.size(); i += 2)
    rays.push_back({inside[i], inside[i + 1] - inside[i], 0.0, i % 4 == 0 ? 0.7 : 1e9});
  const Vec3d other = std::abs(h.x) < 0.9 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const Vec3d u = glm::normalize(glm::cross(h, other)), v = glm::cross(h, u);
  rays.push_back({o - 5.0 * h, h});
  for (const double x : {0.25, 1.0, 1.5, 2.0})
    for (const Vec3d& across : {u, v, -u, Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0.6, 0.8, 0)})
    {
      rays.push_back({o + x * across - 5.0 * h, h});
      rays.push_back({o + x * across + 5.0 * h, -2.0 * h});
      rays.push_back({o - 7.0 * across + 0.3 * x * h, across});
      rays.push_back({o - 7.0 * across, across + 0.1 * x * h});
      rays.push_back({o + x * across, glm::cross(h, across) + 1e-3 * h, -20.0, 20.0});
    }
  return rays;
}

} // namespace

TEST(HexStructure, RaysPassTheSameCellsInOrder)
{
  for (const Case& c : cases())
    for (const HexStructureKind kind : hexKinds)
      for (const int leafSize : {1, 5})
      {
        const auto structure = build(c.mesh, kind, c.axis, leafSize, leafSize > 1);
        std::size_t passed = 0, wrong = 0;
        for (const HexRay& ray : raysFor(c))
        {
          const auto expected = allSpans(*c.mesh, ray), found = spans(*structure, ray);
          wrong += !std::equal(expected.begin(), expected.end(), found.begin(), found.end());
          passed += expected.size();
        }
        EXPECT_EQ(wrong, 0U) << c.name << " " << hexStructureNames()[static_cast<int>(kind)];
        EXPECT_EQ(passed > 0, c.mesh->cellCount() > 0) << c.name;
      }
}

TEST(HexStructure, PointsAreInTheSameCells)
{
  for (const Case& c : cases())
    for (const HexStructureKind kind : hexKinds)
    {
      const auto structure = build(c.mesh, kind, c.axis);
      const Box box = c.mesh->bounds().empty() ? Box{Vec3d(0.0), Vec3d(1.0)} : c.mesh->bounds();
      auto points = randomPoints(300, box.lower, box.upper, 9);
      for (std::size_t i = 0; i < c.mesh->cellCount(); i += 7)
      {
        points.push_back(cellCenter(c.mesh->corners(i)));
        const HexCorners q = c.mesh->corners(i);
        points.push_back(0.25 * (q[0] + q[1] + q[5] + q[4])); // on a face
        points.push_back(q[6]);
      }
      points.push_back(c.axis.origin + 0.1 * c.axis.direction);
      points.push_back(c.axis.origin);
      std::size_t wrong = 0;
      std::uint32_t hint = HexMesh::noCell;
      for (const Vec3d& p : points)
      {
        const std::uint32_t expected = anyCellAt(*c.mesh, p);
        wrong += cellAt(*structure, p) != expected;
        wrong += cellAt(*structure, p, hint) != expected;
        hint = expected;
      }
      EXPECT_EQ(wrong, 0U) << c.name << " " << hexStructureNames()[static_cast<int>(kind)];
    }
}

TEST(HexStructure, BoxesMeetTheirCells)
{
  for (const Case& c : cases())
    for (const HexStructureKind kind : hexKinds)
      for (const bool trimmed : {false, true})
      {
        const auto structure = build(c.mesh, kind, c.axis, 1, trimmed);
        const Box all = c.mesh->bounds().empty() ? Box{Vec3d(0.0), Vec3d(1.0)} : c.mesh->bounds();
        auto middles = randomPoints(60, all.lower - 0.2 * all.size(), all.upper, 4);
        middles.push_back(c.axis.origin);
        std::size_t lost = 0, strange = 0, met = 0;
        for (std::size_t i = 0; i < middles.size(); ++i)
        {
          const Vec3d half = (i % 3 == 0 ? 0.3 : 0.02) * all.size();
          const Box box{middles[i] - half, middles[i] + half};
          const auto found = cellsWithin(*structure, box);
          strange += !std::is_sorted(found.begin(), found.end(), std::less_equal<>());
          for (std::uint32_t cell = 0; cell < c.mesh->cellCount(); ++cell)
          {
            const bool isFound = std::binary_search(found.begin(), found.end(), cell);
            met += isFound;
            strange += isFound && !meet(box, boundsOf(c.mesh->corners(cell)));
            lost += !isFound && reachesInto(TrilinearCell(*c.mesh, cell), box);
          }
        }
        EXPECT_EQ(lost, 0U) << c.name << " " << hexStructureNames()[static_cast<int>(kind)];
        EXPECT_EQ(strange, 0U) << c.name << " " << hexStructureNames()[static_cast<int>(kind)];
        EXPECT_EQ(met > 0, c.mesh->cellCount() > 0) << c.name;
        EXPECT_EQ(cellsWithin(*structure, all.expanded(1.0)).size(), c.mesh->cellCount());
      }
}

TEST(HexStructure, NoPointNoCell)
{
  for (const HexStructureKind kind : hexKinds)
  {
    const auto structure = build(hexRing({}).mesh(), kind);
    EXPECT_EQ(cellAt(*structure, Vec3d(NAN, 0, 0)), HexMesh::noCell);
    EXPECT_EQ(cellAt(*structure, Vec3d(INFINITY, 0, 0)), HexMesh::noCell);
    EXPECT_EQ(cellAt(*structure, Vec3d(1e300, 0, 0)), HexMesh::noCell);
    EXPECT_EQ(cellAt(*structure, Vec3d(0.0, 0, 0.5)), HexMesh::noCell); // in the hole
  }
}

TEST(HexStructure, StopsWhereItIsToldTo)
{
  for (const HexStructureKind kind : hexKinds)
  {
    const auto structure = build(hexRing({}).mesh(), kind);
    int told = 0;
    WalkCounts counts;
    withStructure(*structure,
      [&](const auto& s)
      {
        s.forCellsAlong(
          {Vec3d(-5, 0.1, 0.5), Vec3d(1, 0, 0)}, [&](const CellSpan&) { return ++told < 3; },
          KeepAll{}, counts);
      });
    EXPECT_EQ(told, 3);
    EXPECT_GE(counts.cells, 3U);
    EXPECT_GT(counts.nodes, 0U);
  }
}

TEST(HexStructure, PassesOverWhatIsNotKept)
{
  const Mesh mesh = hexRing({8, 48, 8}).mesh();
  std::vector<double> height;
  for (std::size_t p = 0; p < mesh->pointCount(); ++p)
    height.push_back(mesh->point(p).x);
  const HexField field(*mesh, HexScalar{{height.data(), height.size(), 1}});
  const RawVector<ScalarRange> ranges = cellRanges(*mesh, field);
  const auto keep = [&](const ScalarRange& r) { return r.upper > 1.5 - field.offset(); };
  const HexRay ray{Vec3d(-5, -0.2, 0.4), Vec3d(1, 0.08, 0.01)};
  for (const HexStructureKind kind : hexKinds)
  {
    const auto structure = build(mesh, kind);
    setRanges(*structure, field);
    std::vector<CellSpan> found;
    WalkCounts all, some;
    withStructure(*structure,
      [&](const auto& s)
      {
        s.forCellsAlong(
          ray, [&](const CellSpan&) { return true; }, KeepAll{}, all);
        s.forCellsAlong(
          ray,
          [&](const CellSpan& span)
          {
            if (keep(ranges[span.cell]))
              found.push_back(span);
            return true;
          },
          keep, some);
      });
    std::vector<CellSpan> expected;
    for (const CellSpan& span : allSpans(*mesh, ray))
      if (keep(ranges[span.cell]))
        expected.push_back(span);
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), found.begin(), found.end()));
    EXPECT_FALSE(expected.empty());
    EXPECT_LT(2 * some.cells, all.cells);
  }
}

TEST(HexStructure, DoesNotDependOnThreads)
{
  const RingShape shape{16, 60, 24, 1.0, 2.0, 1.5, 0.4, 0.3, 5};
  const Mesh mesh = hexRing(shape).mesh();
  const auto rays = raysFor({"", mesh, {}});
  for (const HexStructureKind kind : hexKinds)
  {
    const auto answers = [&](std::size_t threads)
    {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      const auto structure = build(mesh, kind, std::nullopt);
      WalkCounts counts;
      std::size_t bytes = 0, references = 0;
      withStructure(*structure,
        [&](const auto& s)
        {
          for (const HexRay& ray : rays)
            s.forCellsAlong(
              ray, [](const CellSpan&) { return true; }, KeepAll{}, counts);
          bytes = s.bytes();
          references = s.references();
        });
      return std::array<std::size_t, 4>{counts.cells, counts.nodes, bytes, references};
    };
    EXPECT_EQ(answers(1), answers(4));
  }
}

TEST(HexStructure, CopiesHaveRangesOfTheirOwn)
{
  const Mesh mesh = hexRing({}).mesh();
  const std::vector<double> low(mesh->pointCount(), 1.0), high(mesh->pointCount(), 2.0);
  const auto keepsHigh = [](const HexStructure& structure, double offset)
  {
    bool any = false;
    withStructure(structure,
      [&](const auto& s)
      {
        s.forCellsAlong(
          HexRay{Vec3d(-5, -0.2, 0.4), Vec3d(1, 0.08, 0.01)},
          [&](const CellSpan&) { return any = true; },
          [&](const ScalarRange& r) { return r.upper > 1.5 - offset; });
      });
    return any;
  };
  const HexField lowField(*mesh, HexScalar{{low.data(), low.size(), 1}});
  const HexField highField(*mesh, HexScalar{{high.data(), high.size(), 1}});
  for (const HexStructureKind kind : hexKinds)
  {
    const auto structure = build(mesh, kind);
    setRanges(*structure, highField);
    auto copy = std::make_unique<HexStructure>(*structure);
    setRanges(*copy, lowField);
    EXPECT_TRUE(keepsHigh(*structure, highField.offset()));
    EXPECT_FALSE(keepsHigh(*copy, lowField.offset()));
    *copy = *structure;
    EXPECT_TRUE(keepsHigh(*copy, highField.offset()));
    withStructure(*copy, [](const auto& s) { EXPECT_LE(s.ownBytes(), s.bytes()); });
  }
  withStructure(*build(mesh, HexStructureKind::CartesianBvh),
    [](const auto& s) { EXPECT_EQ(s.ownBytes(), 0U) << "all else is shared"; });
}

TEST(HexStructure, LeafSizeIsKept)
{
  const Mesh mesh = hexRing({}).mesh();
  for (const int leafSize : {1, 2, 8})
    withStructure(*build(mesh, HexStructureKind::CylindricalBvh, CylinderAxis{}, leafSize),
      [&](const auto& s)
      {
        EXPECT_LE(s.largestLeaf(), static_cast<std::size_t>(leafSize));
        EXPECT_EQ(s.references(), mesh->cellCount());
      });
}

HexStructureShape shapeOf(const Mesh& mesh, HexStructureKind kind, int leafSize = 1)
{
  return withStructure(*build(mesh, kind, CylinderAxis{}, leafSize),
    [](const auto& s) -> HexStructureShape { return s.shape(); });
}

TEST(HexStructure, ShapesHaveEveryNode)
{
  const Mesh mesh = hexRing({}).mesh();
  const std::size_t n = mesh->cellCount();
  for (const HexStructureKind kind :
    {HexStructureKind::CylindricalBvh, HexStructureKind::CartesianBvh})
  {
    const HexStructureShape fine = shapeOf(mesh, kind), coarse = shapeOf(mesh, kind, 8);
    EXPECT_EQ(fine.nodes, 2 * n - 1);
    EXPECT_GE(std::size_t{1} << (fine.levels - 1), n);
    EXPECT_LT(fine.levels, 4 * coarse.levels);
    EXPECT_LT(coarse.levels, fine.levels);
    EXPECT_LT(coarse.nodes, fine.nodes);
    EXPECT_LT(coarse.area, fine.area);
  }
  for (const HexStructureKind kind :
    {HexStructureKind::CylindricalGrid, HexStructureKind::CartesianGrid})
  {
    EXPECT_EQ(shapeOf(mesh, kind).levels, 2U);
    EXPECT_GT(shapeOf(mesh, kind).nodes, n);
  }
  for (const HexStructureKind kind : hexKinds)
    EXPECT_EQ(shapeOf(HexCells{}.mesh(), kind).nodes, 0U);
}

TEST(HexStructure, ShapesHaveTheAreasOfBoxesAndSectors)
{
  const HexStructureShape box = shapeOf(hexBlock(1, 1, 1).mesh(), HexStructureKind::CartesianBvh);
  EXPECT_NEAR(box.area, 6.0, 1e-5);
  EXPECT_EQ(box.area, box.leafArea);
  // Three thirds of a ring from r = 0.1, in the middle of chords, to 2; two of them count as all.
  const HexStructureShape ring =
    shapeOf(hexRing({1, 3, 1, 0.2, 2.0, 1.0}).mesh(), HexStructureKind::CylindricalBvh);
  const double round = 2.1 * (1.9 + 1.0) * 2.0 * std::numbers::pi, ends = 2.0 * 1.9 * 1.0;
  EXPECT_NEAR(ring.leafArea, round + 3.0 * ends, 1e-4);
  EXPECT_NEAR(ring.area, 3.0 * round + 3.0 * ends, 1e-4);
}

TEST(HexStructure, TrimmedGridsReferToLess)
{
  const Mesh mesh = hexRing({12, 48, 12, 1.0, 2.0, 1.0, 0.6, 0.2}).mesh();
  for (const HexStructureKind kind :
    {HexStructureKind::CylindricalGrid, HexStructureKind::CartesianGrid})
  {
    std::size_t references[2];
    for (const bool trimmed : {false, true})
      references[trimmed] = withStructure(*build(mesh, kind, CylinderAxis{}, 1, trimmed),
        [](const auto& s) { return s.references(); });
    EXPECT_LT(references[1], 0.8 * references[0]);
  }
}

TEST(HexStructure, UnkindCellsTakeNoMoreThanKilobytes)
{
  std::vector<Case> unkind;
  for (const double thickness : {1e-3, 1e-9}) // a sheet, and plates in a stack
  {
    HexCells sheet = hexBlock(60, 60, 1), stack = hexBlock(1, 1, 3600);
    sheet.move([=](const Vec3d& p) { return p * Vec3d(1, 1, thickness); });
    stack.move([](const Vec3d& p) { return p * Vec3d(1, 1, 1e-6); });
    unkind.push_back(placed("sheet", sheet, Vec3d(3, 4, 0), false));
    unkind.push_back(placed("stack", stack, Vec3d(3, 4, 0), false));
  }
  HexCells heap, sector = hexRing({20, 20, 9}), needle = hexBlock(1, 1, 1);
  for (int i = 0; i < 3000; ++i) // all over one another
    heap.addCell(
      HexCellType::Hexahedron, std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                 {0, 0, 1}, {1, 0, 1}, {1, 1, 1 + 1e-6 * i}, {0, 1, 1}});
  RingShape narrow{20, 20, 9};
  narrow.turn = 1e-5;
  sector = hexRing(narrow);
  needle = hexBlock(12, 12, 12);
  needle.points[0] = -1e12; // one cell much larger than all others
  unkind.push_back(placed("heap", heap, Vec3d(3, 4, 0), false));
  unkind.push_back(placed("sector", sector, Vec3d(0.0), false));
  unkind.push_back(placed("needle", needle, Vec3d(3, 4, 0), true));
  for (const Case& c : unkind)
    for (const HexStructureKind kind :
      {HexStructureKind::CylindricalGrid, HexStructureKind::CartesianGrid})
      for (const bool trimmed : {false, true})
      {
        SCOPED_TRACE(std::string(c.name) + " " + hexStructureNames()[static_cast<int>(kind)]);
        const auto structure = build(c.mesh, kind, c.axis, 1, trimmed);
        const std::size_t bytes =
          withStructure(*structure, [](const auto& s) { return s.bytes(); });
        EXPECT_LT(bytes, 4096 * c.mesh->cellCount() + 100000);
        if (c.name == std::string("heap")) // asking every cell takes long
          continue;
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < c.mesh->cellCount(); i += 97)
        {
          const Vec3d p = cellCenter(c.mesh->corners(i));
          wrong += cellAt(*structure, p) != anyCellAt(*c.mesh, p);
        }
        EXPECT_EQ(wrong, 0U);
      }
}

TEST(HexStructure, RefusesAnAxisWithoutDirection)
{
  EXPECT_THROW(build(hexRing({}).mesh(), HexStructureKind::CylindricalGrid,
                 CylinderAxis{Vec3d(0.0), Vec3d(0.0)}),
    Error);
}
