// Polyhedra, and cells that barely cross themselves: in parts, which fill the same space.

#include <kernels/core/Error.h>
#include <kernels/hexahedra/TrilinearCell.h>

#include <support/Volumes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr VolumeIntegrator integrators[] = {
  VolumeIntegrator::InverseDistance, VolumeIntegrator::Trilinear, VolumeIntegrator::CellByCell};

using Ids = std::vector<std::int64_t>;

/// Lines through the middle region of a box, from all around.
struct Lines
{
  explicit Lines(const Box& box, std::size_t count = 80)
    : from(randomPoints(count, box.center() - 2.0 * box.size(), box.center() + 2.0 * box.size(), 3))
    , to(randomPoints(count, box.lower, box.upper, 4))
  {
  }
  template <typename Visit>
  void forEach(const Visit& visit) const
  {
    for (std::size_t i = 0; i < from.size(); ++i)
      visit(from[i], to[i] - from[i]);
  }
  std::vector<Vec3d> from, to;
};

double chord(const HexMesh& mesh, const Vec3d& from, const Vec3d& way)
{
  double sum = 0.0;
  for (const CellSpan& span : allSpans(mesh, {from, way}))
    sum += (span.tOut - span.tIn) * glm::length(way);
  return sum;
}

/// How much of a line is where all normals . p <= reach.
double chordOfHull(
  const std::vector<std::pair<Vec3d, double>>& planes, const Vec3d& from, const Vec3d& way)
{
  double in = 0.0, out = INFINITY;
  for (const auto& [normal, reach] : planes)
  {
    const double speed = glm::dot(normal, way), left = reach - glm::dot(normal, from);
    if (speed > 0.0)
      out = std::min(out, left / speed);
    else if (speed < 0.0)
      in = std::max(in, left / speed);
    else if (left < 0.0)
      return 0.0;
  }
  return std::max(0.0, out - in) * glm::length(way);
}

/// An even cloud's depth is the chord that `expected` tells, by every integrator and structure.
template <typename Expected>
void expectChords(const std::shared_ptr<const HexMesh>& mesh, const Expected& expected)
{
  for (const bool ofCells : {false, true})
    for (const VolumeIntegrator integrator : integrators)
      for (const HexStructureKind kind :
        {HexStructureKind::CartesianBvh, HexStructureKind::CylindricalGrid})
      {
        const std::size_t count = ofCells ? mesh->report().cells : mesh->pointCount();
        CloudObject volume =
          volumeOf(mesh, std::vector<double>(count, 7.0), evenTransfer(0.3F), kind, ofCells);
        volume.sampling.integrator = integrator;
        volume.sampling.step = 0.05;
        const double perLength = -std::log1p(-double(0.3F));
        double met = 0.0;
        Lines(mesh->bounds())
          .forEach(
            [&](const Vec3d& from, const Vec3d& way)
            {
              const double depth = perLength * expected(from, way);
              EXPECT_NEAR(opticalDepth(gathered(volume, from, way)), depth, 1e-6 * depth + 1e-9);
              met += depth;
            });
        EXPECT_GT(met, 1.0);
      }
}

using Planes = std::vector<std::pair<Vec3d, double>>;

/// The planes of foam()'s cells.
std::vector<Planes> foamHulls(const std::vector<Vec3d>& middles)
{
  std::vector<Planes> hulls;
  for (const Vec3d& at : middles)
  {
    hulls.emplace_back();
    for (const Vec3d& normal : foamNormals())
      hulls.back().emplace_back(normal, foamReach(normal) + glm::dot(normal, at));
  }
  return hulls;
}

/// Groups of neighbours of a 4 x 4 x 4 block: alone, in twos, and three in a row.
const std::vector<std::vector<std::size_t>> groups = {
  {0}, {5, 21}, {22, 23}, {26, 42}, {40, 41}, {12, 13, 14}, {51, 55}, {63}};

} // namespace

TEST(Polyhedra, OfOtherCellsFacesAreTheseCells)
{
  for (const HexCellType type :
    {HexCellType::Hexahedron, HexCellType::Wedge, HexCellType::Pyramid, HexCellType::Tetrahedron})
  {
    const std::vector<Vec3d> corners = {{0, 0, 0}, {1.1, 0, 0}, {1, 1, 0.1}, {0, 1.2, 0}, {0, 0, 1},
      {1, 0, 1.3}, {1, 0.9, 1}, {0, 1, 1}};
    const std::map<HexCellType, std::vector<Vec3d>> points = {{HexCellType::Hexahedron, corners},
      {HexCellType::Wedge,
        {corners[0], corners[3], corners[1], corners[4], corners[7], corners[5]}},
      {HexCellType::Pyramid, {corners[0], corners[1], corners[2], corners[3], {0.4, 0.5, 1}}},
      {HexCellType::Tetrahedron, {corners[0], corners[1], corners[3], corners[4]}}};
    const std::map<HexCellType, std::vector<Ids>> faces = {
      {HexCellType::Hexahedron,
        {{1, 2, 6, 5}, {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {7, 6, 2, 3}, {0, 4, 7, 3}}},
      {HexCellType::Wedge, {{0, 1, 4, 3}, {5, 4, 3}, {1, 4, 5, 2}, {2, 0, 1}, {0, 3, 5, 2}}},
      {HexCellType::Pyramid, {{0, 1, 4}, {1, 2, 4}, {0, 1, 2, 3}, {2, 3, 4}, {0, 4, 3}}},
      {HexCellType::Tetrahedron, {{3, 1, 0}, {0, 1, 2}, {1, 2, 3}, {0, 2, 3}}}};
    HexCells plain, faced;
    plain.addCell(type, points.at(type));
    for (const Vec3d& p : points.at(type))
      faced.addPoint(p);
    faced.addPolyhedron(faces.at(type));
    const auto a = plain.mesh(), b = faced.mesh();
    EXPECT_EQ(b->report().sentence(), "");
    EXPECT_EQ(b->report().polyhedra, 1U);
    EXPECT_EQ(b->report().inParts, 0U) << int(type);
    ASSERT_EQ(b->cellCount(), 1U);
    EXPECT_EQ(b->allPointCount(), b->pointCount());
    EXPECT_NEAR(b->report().volume, a->report().volume, 1e-15);
    Lines(a->bounds())
      .forEach([&](const Vec3d& from, const Vec3d& way)
        { EXPECT_NEAR(chord(*b, from, way), chord(*a, from, way), 1e-14); });
  }
}

TEST(Polyhedra, AmongWarpedHexahedraLoseNothingAndCountNothingTwice)
{
  const HexCells block = hexBlock(4, 4, 4, 0.25, 6);
  const auto mesh = merged(block, groups).mesh();
  const HexMeshReport& report = mesh->report();
  EXPECT_EQ(report.sentence(), "");
  EXPECT_EQ(report.cells, 57U);
  EXPECT_EQ(report.kept, 57U);
  EXPECT_EQ(report.polyhedra, 8U);
  EXPECT_EQ(report.inParts, 6U);
  EXPECT_EQ(mesh->cellCount(), 51U + 5 * 10 + 14);
  EXPECT_NEAR(report.volume, 64.0, 1e-12);
  EXPECT_EQ(mesh->pointCount(), 125U);
  EXPECT_EQ(mesh->allPointCount(), 131U);
  const FaceAdjacency adjacency(*mesh);
  EXPECT_EQ(adjacency.boundary().size(), 6U * 16); // all others are shared
  const Planes box = {{{1, 0, 0}, 4.0}, {{0, 1, 0}, 4.0}, {{0, 0, 1}, 4.0}, {{-1, 0, 0}, 0.0},
    {{0, -1, 0}, 0.0}, {{0, 0, -1}, 0.0}};
  expectChords(
    mesh, [&](const Vec3d& from, const Vec3d& way) { return chordOfHull(box, from, way); });
}

TEST(Polyhedra, OfALinearFieldLookAsHexahedraDo)
{
  const HexCells block = hexBlock(4, 4, 4, 0.25, 6);
  TransferFunction ramp;
  ramp.knots = {{0.0, Vec4f(1, 1, 1, 0.0F)}, {16.0, Vec4f(1, 0, 0, 0.6F)}};
  const auto linear = [](const Vec3d& p) { return p.x + 2.0 * p.y + p.z; };
  const auto plain = block.mesh(), mesh = merged(block, groups).mesh();
  CloudObject one = volumeOf(plain, pointValues(*plain, linear), ramp);
  CloudObject other = volumeOf(mesh, pointValues(*mesh, linear), ramp);
  for (const VolumeIntegrator integrator :
    {VolumeIntegrator::Trilinear, VolumeIntegrator::CellByCell})
  {
    for (CloudObject* volume : {&one, &other})
    {
      volume->sampling.integrator = integrator;
      volume->sampling.step = 0.02;
      volume->sampling.tolerance = 1e-6;
    }
    Lines(plain->bounds())
      .forEach(
        [&](const Vec3d& from, const Vec3d& way)
        {
          const RayColor a = gathered(one, from, way), b = gathered(other, from, way);
          EXPECT_NEAR(b.transmittance, a.transmittance, 2e-6);
          EXPECT_NEAR(b.color.y, a.color.y, 2e-6);
        });
  }
}

TEST(Polyhedra, OfAFoamFillSpace)
{
  const auto hulls = foamHulls(foamMiddles(2));
  const auto mesh = foam(2).mesh();
  const HexMeshReport& report = mesh->report();
  EXPECT_EQ(report.sentence(), "");
  EXPECT_EQ(report.inParts, 16U);
  EXPECT_NEAR(report.volume, 16 * 4.0, 1e-11);
  EXPECT_EQ(mesh->cellCount(), 16U * (6 + 2 * 8));
  // Neighbours cut their hexagons alike.
  const FaceAdjacency adjacency(*mesh);
  std::size_t inner = 0;
  for (std::uint32_t c = 0; c < mesh->cellCount(); ++c)
    for (std::size_t f = 0; f < 6; ++f)
      if (const std::uint32_t other = adjacency.next(c, f); other != HexMesh::noCell)
        inner += mesh->inputCell(other) != mesh->inputCell(c);
  EXPECT_EQ(adjacency.boundary().size() + inner, mesh->cellCount());
  expectChords(mesh,
    [&](const Vec3d& from, const Vec3d& way)
    {
      double sum = 0.0;
      for (const Planes& hull : hulls)
        sum += chordOfHull(hull, from, way);
      return sum;
    });
}

TEST(Polyhedra, HangingPointsOnEdgesAreNoMatter)
{
  // A cube beside four of half its size: it has five points more, one face is four, and sides that
  // meet it have points in the middle of an edge.
  HexCells cells = hexBlock(2, 2, 2);
  cells.move([](const Vec3d& p) { return 0.5 * p; });
  HexCells big;
  big.points = cells.points;
  SharedPoints points{big, {}};
  for (std::size_t i = 0; i < big.points.size(); i += 3)
    points.known.insert({{std::lround(big.points[i] * 1e6), std::lround(big.points[i + 1] * 1e6),
                           std::lround(big.points[i + 2] * 1e6)},
      static_cast<std::int64_t>(i / 3)});
  for (std::size_t c = 0; c < 8; ++c)
    big.addCell(
      HexCellType::Hexahedron, Ids(cells.connectivity.begin() + 8 * static_cast<long>(c),
                                 cells.connectivity.begin() + 8 * static_cast<long>(c) + 8));
  const auto at = [&](double x, double y, double z) { return points.at({x, y, z}); };
  std::vector<Ids> faces;
  for (const double y : {0.0, 0.5})
    for (const double z : {0.0, 0.5})
      faces.push_back({at(1, y, z), at(1, y + 0.5, z), at(1, y + 0.5, z + 0.5), at(1, y, z + 0.5)});
  faces.push_back({at(2, 0, 0), at(2, 1, 0), at(2, 1, 1), at(2, 0, 1)});
  for (const double s : {0.0, 1.0})
  {
    faces.push_back({at(1, s, 0), at(1, s, 0.5), at(1, s, 1), at(2, s, 1), at(2, s, 0)});
    faces.push_back({at(1, 0, s), at(1, 0.5, s), at(1, 1, s), at(2, 1, s), at(2, 0, s)});
  }
  big.addPolyhedron(faces);
  for (const double noise : {0.0, 1e-7})
  {
    HexCells shaken = big;
    const auto by = randomPoints(big.points.size() / 3, Vec3d(-noise), Vec3d(noise), 9);
    for (std::size_t i = 0; i < shaken.points.size(); ++i)
      shaken.points[i] += by[i / 3][static_cast<int>(i % 3)];
    const auto mesh = shaken.mesh();
    EXPECT_EQ(mesh->report().sentence(), "");
    EXPECT_NEAR(mesh->report().volume, 2.0, 1e-5 * (noise > 0.0) + 1e-13);
    const Planes box = {{{1, 0, 0}, 2.0}, {{0, 1, 0}, 1.0}, {{0, 0, 1}, 1.0}, {{-1, 0, 0}, 0.0},
      {{0, -1, 0}, 0.0}, {{0, 0, -1}, 0.0}};
    if (noise == 0.0)
      expectChords(
        mesh, [&](const Vec3d& from, const Vec3d& way) { return chordOfHull(box, from, way); });
  }
}

TEST(Polyhedra, ValuesAndCellsAreTheInputsOwn)
{
  const HexCells cells = merged(hexBlock(4, 4, 4, 0.2), groups);
  const auto mesh = cells.mesh();
  std::vector<double> ofPoints, ofCells;
  for (std::size_t p = 0; p < mesh->pointCount(); ++p)
    ofPoints.push_back(std::sin(double(p)));
  for (std::size_t c = 0; c < mesh->report().cells; ++c)
    ofCells.push_back(double(c));
  const HexField points(*mesh, {{ofPoints.data(), ofPoints.size(), 1}, 0, false});
  const HexField values(*mesh, {{ofCells.data(), ofCells.size(), 1}, 0, true});
  for (std::size_t m = 0; m < mesh->middleCount(); ++m)
  {
    double sum = 0.0;
    Vec3d place(0.0);
    for (const std::uint32_t p : mesh->aroundMiddle(m))
    {
      sum += ofPoints[p];
      place += mesh->point(p);
    }
    const auto n = double(mesh->aroundMiddle(m).size());
    EXPECT_NEAR(points.ofPoint(mesh->pointCount() + m) + points.offset(), sum / n, 1e-6);
    EXPECT_NEAR(glm::length(mesh->point(mesh->pointCount() + m) - place / n), 0.0, 1e-12);
  }
  const auto structure = makeHexStructure(mesh, {});
  for (std::size_t c = 0; c < mesh->cellCount(); ++c)
  {
    EXPECT_EQ(values.ofCell(c) + values.offset(), double(mesh->inputCell(c)));
    EXPECT_TRUE(c == 0 || mesh->inputCell(c - 1) <= mesh->inputCell(c));
  }
  std::set<std::size_t> seen;
  for (std::size_t c = 0; c < mesh->cellCount(); ++c)
    seen.insert(mesh->inputCell(c));
  EXPECT_EQ(seen.size(), 57U);
}

TEST(Polyhedra, IsoSurfacesNameTheInputsCells)
{
  const auto mesh = merged(hexBlock(4, 4, 4), {{0, 1, 2}, {20, 36}}).mesh();
  const CloudObject volume =
    volumeOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return p.z; }), evenTransfer(0.5F));
  const IsoSurface surface(volume.structure, volume.field, {0.5});
  for (int x = 0; x < 4; ++x)
  {
    const auto hit = surface.first({{x + 0.4, 0.3, -1.0}, {0.0, 0.0, 1.0}});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 1.5, 1e-6);
    const std::uint64_t slot = hit->cell;
    std::uint64_t id = 99;
    surface.inputIds(&slot, 1, &id);
    EXPECT_EQ(id, x < 3 ? 0U : 1U);
  }
}

TEST(Polyhedra, ThatAreOpenOrTooConcaveAreLeftOutAndCounted)
{
  // Five cells about a notch, with their middle in it; and a cell that lacks a face.
  HexCells cells = merged(hexBlock(3, 3, 3), {{9, 12, 15, 11, 14, 17, 16}});
  HexCells open = merged(hexBlock(1, 1, 1), {{0}});
  std::vector<Ids> faces;
  for (int f = 0; f < 5; ++f)
    faces.emplace_back(open.faces.begin() + 1 + 5 * f + 1, open.faces.begin() + 1 + 5 * f + 5);
  cells.addPolyhedron(faces);
  const auto mesh = cells.mesh();
  EXPECT_EQ(mesh->report().unfit, 2U);
  EXPECT_EQ(mesh->report().kept, 20U);
  EXPECT_EQ(mesh->cellCount(), 20U);
  EXPECT_EQ(mesh->report().sentence(),
    "Of 22 cells: 2 polyhedra left out, not closed or too concave to be cut about their middle.");
  EXPECT_NEAR(mesh->report().volume, 20.0, 1e-12);
}

TEST(Polyhedra, ThatNameWhatIsNotThereAreRefused)
{
  const auto refusal = [](const HexCells& cells) -> std::string
  {
    try
    {
      cells.mesh();
    }
    catch (const Error& error)
    {
      return error.what();
    }
    return {};
  };
  const HexCells cells = merged(hexBlock(2, 1, 1), {{0, 1}});
  for (const std::int64_t id : {std::int64_t(12), std::int64_t(-1)})
  {
    HexCells bad = cells;
    bad.faces[2] = id;
    EXPECT_EQ(
      refusal(bad), "Cell 0 names the point " + std::to_string(id) + ", and there are 12 points.");
  }
  HexCells bad = cells;
  bad.faces[0] = 11;
  EXPECT_EQ(refusal(bad), "The faces of cell 0 reach beyond the list of faces.");
  bad.faceLocations[0] = 1000;
  EXPECT_EQ(refusal(bad), "The faces of cell 0 reach beyond the list of faces.");
  HexCells none = cells;
  none.faceLocations[0] = -1;
  EXPECT_EQ(none.mesh()->report().otherTypes, 1U);
}

TEST(Polyhedra, CellsThatBarelyCrossThemselvesAreInParts)
{
  const Planes box = {{{1, 0, 0}, 3.0}, {{0, 1, 0}, 3.0}, {{0, 0, 1}, 3.0}, {{-1, 0, 0}, 0.0},
    {{0, -1, 0}, 0.0}, {{0, 0, -1}, 0.0}};
  const auto across = [&](const Vec3d& from, const Vec3d& way)
  { return chordOfHull(box, from, way); };
  // A corner of the middle cell goes through the plane of its three neighbours, at a third.
  for (const double by : {0.3, 0.34, 0.36, 0.38, 0.9})
  {
    HexCells cells = hexBlock(3, 3, 3);
    cells.move([by](const Vec3d& p) { return p == Vec3d(1.0) ? p + Vec3d(by) : p; });
    const auto mesh = cells.mesh();
    const HexMeshReport& report = mesh->report();
    EXPECT_EQ(report.kept, 27U);
    EXPECT_EQ(report.inParts, by > 1.0 / 3.0 && by < 0.5 ? 1U : 0U) << by;
    EXPECT_EQ(report.selfCrossing > 0, by > 0.5) << by;
    EXPECT_EQ(report.sentence().empty(), by < 0.5);
    EXPECT_EQ(mesh->cellCount(), 27U + 5 * report.inParts);
    if (by > 0.5)
      continue;
    EXPECT_NEAR(report.volume, 27.0, 1e-12);
    for (std::size_t c = 0; c < mesh->cellCount(); ++c)
      EXPECT_GE(jacobianRange(mesh->corners(c)).smallest, -1e-6) << c;
    expectChords(mesh, across);
  }
}
