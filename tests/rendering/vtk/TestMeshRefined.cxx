// vtkMoteMeshMapper on meshes that are refined here and there: where a face of a coarse cell meets
// several of finer cells there is no wall. It needs no display.
#include "MeshTestSupport.h"
#include "VolumeTestSupport.h"

#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <functional>
#include <map>

using namespace mote::testing;

namespace
{

constexpr vtkIdType coarse = 26;      // cells of 3 x 3 x 3 about the middle one, which is cut
constexpr vtkIdType outside = 2 * 54; // triangles
using Where = std::function<Point(const Point&)>;

/// A grid to which points are added by their places, each once, and moved from there.
class PlacedGrid
{
public:
  explicit PlacedGrid(Where where, int type = VTK_DOUBLE)
    : where_(std::move(where))
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(type);
    grid->SetPoints(points);
    grid->Allocate(1);
  }

  vtkIdType point(const Point& place)
  {
    const auto [it, isNew] = ids_.emplace(place, grid->GetNumberOfPoints());
    if (isNew)
      grid->GetPoints()->InsertNextPoint(where_(place).data());
    return it->second;
  }
  /// A point that is the last one of its place from now on, beside those before it.
  void forget(const Point& place) { ids_.erase(place); }
  /// A box from corner to corner.
  void addBox(const Point& low, const Point& high)
  {
    std::array<vtkIdType, 8> ids;
    for (std::size_t i = 0; i < 8; ++i)
      ids[i] = this->point({((i ^ i >> 1) & 1 ? high : low)[0], (i >> 1 & 1 ? high : low)[1],
        (i >> 2 ? high : low)[2]});
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids.data());
  }
  /// n x n x n boxes in one of size 1.
  void addCut(const Point& low, std::array<int, 3> n)
  {
    const auto at = [&](int x, int y, int z) -> Point {
      return {low[0] + double(x) / n[0], low[1] + double(y) / n[1], low[2] + double(z) / n[2]};
    };
    for (int z = 0; z < n[2]; ++z)
      for (int y = 0; y < n[1]; ++y)
        for (int x = 0; x < n[0]; ++x)
          this->addBox(at(x, y, z), at(x + 1, y + 1, z + 1));
  }

  vtkNew<vtkUnstructuredGrid> grid;

private:
  Where where_;
  std::map<Point, vtkIdType> ids_;
};

Point inPlace(const Point& p)
{
  return p;
}

/// 3 x 3 x 3 cells of which that in the middle is cut.
PlacedGrid refined(std::array<int, 3> n, const Where& where = inPlace, int type = VTK_DOUBLE)
{
  PlacedGrid placed(where, type);
  for (int i = 0; i < 27; ++i)
    if (i != 13)
      placed.addCut({double(i % 3), double(i / 3 % 3), double(i / 9)}, {1, 1, 1});
  placed.addCut({1.0, 1.0, 1.0}, n);
  return placed;
}

vtkIdType trianglesOf(vtkUnstructuredGrid* grid, vtkUnsignedCharArray* shown = nullptr)
{
  vtkNew<vtkMoteMeshMapper> mapper;
  mapper->SetInputData(grid);
  mapper->SetVisibleCells(shown);
  mapper->Update();
  return mapper->GetNumberOfTriangles();
}

/// All cells but those from `first` to before `end`.
vtkSmartPointer<vtkUnsignedCharArray> without(
  vtkUnstructuredGrid* grid, vtkIdType first, vtkIdType end)
{
  auto shown = vtkSmartPointer<vtkUnsignedCharArray>::New();
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    shown->InsertNextValue(i >= first && i < end ? 0 : 1);
  return shown;
}

} // namespace

TEST(MeshRefined, HasNoWallsWhereCoarseCellsMeetFineOnes)
{
  const Where warped = [](const Point& p) -> Point {
    return {1e3 + p[0] + 0.1 * std::sin(p[1] + p[2]), p[1] - 0.2 * p[0] * p[2], 0.3 * p[2]};
  };
  for (const auto& n : {std::array{2, 2, 2}, {4, 4, 4}, {2, 1, 1}, {1, 3, 2}})
    for (const int type : {VTK_FLOAT, VTK_DOUBLE})
      for (const Where& where : {Where(inPlace), warped})
      {
        SCOPED_TRACE(testing::Message() << n[0] << n[1] << n[2] << " " << type);
        const PlacedGrid placed = refined(n, where, type);
        EXPECT_EQ(trianglesOf(placed.grid), outside);
        // Cells with points of their own, too.
        EXPECT_EQ(trianglesOf(cellsApart(placed.grid)), outside);
      }
}

TEST(MeshRefined, MayHaveHangingPointsOnACurvedBoundary)
{
  // Those of coarse cells lie at whole numbers.
  const auto hangs = [](double x) { return x != std::floor(x); };
  const PlacedGrid placed = refined({2, 2, 2},
    [&](const Point& p) -> Point
    {
      const double off = hangs(p[0]) || hangs(p[1]) || hangs(p[2]) ? 0.04 : 0.0;
      return {p[0] + off * (p[0] - 1.5), p[1] + off * (p[1] - 1.5), p[2] + off * (p[2] - 1.5)};
    });
  EXPECT_EQ(trianglesOf(placed.grid), outside);
}

TEST(MeshRefined, ShowsFacesOfCellsBesideHiddenOnes)
{
  const PlacedGrid placed = refined({2, 2, 2});
  vtkUnstructuredGrid* grid = placed.grid;
  ASSERT_EQ(grid->GetNumberOfCells(), coarse + 8);
  EXPECT_EQ(trianglesOf(grid, without(grid, coarse, coarse + 8)), outside + 2 * 6);
  EXPECT_EQ(trianglesOf(grid, without(grid, 0, coarse)), 2 * 24);
  // Without one fine cell three coarse faces are seen in part: they and what is left of the fine
  // ones on them are shown, and the three faces within.
  EXPECT_EQ(trianglesOf(grid, without(grid, coarse, coarse + 1)), outside + 2 * (3 + 3 * 3 + 3));
  // Without a coarse one its five neighbours' faces and four fine ones, but not its own.
  const vtkIdType beside = 12; // at x = 0, in the middle of a side
  EXPECT_EQ(trianglesOf(grid, without(grid, beside, beside + 1)), outside - 2 + 2 * (4 + 4));
}

TEST(MeshRefined, HasNoWallsBetweenTetrahedraOfTwoSizes)
{
  PlacedGrid placed(inPlace);
  const std::array<Point, 4> at = {Point{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  const auto id = [&](std::size_t i, std::size_t k)
  {
    return placed.point(
      {(at[i][0] + at[k][0]) / 2, (at[i][1] + at[k][1]) / 2, (at[i][2] + at[k][2]) / 2});
  };
  const auto add = [&](const std::array<vtkIdType, 4>& cell)
  { placed.grid->InsertNextCell(VTK_TETRA, 4, cell.data()); };
  add({id(0, 0), id(0, 1), id(0, 2), id(0, 3)});
  add({id(0, 1), id(1, 1), id(1, 2), id(1, 3)});
  add({id(0, 2), id(1, 2), id(2, 2), id(2, 3)});
  add({id(0, 3), id(1, 3), id(2, 3), id(3, 3)});
  add({id(0, 1), id(2, 3), id(0, 2), id(0, 3)}); // about the line from 01 to 23
  add({id(0, 1), id(2, 3), id(0, 3), id(1, 3)});
  add({id(0, 1), id(2, 3), id(1, 3), id(1, 2)});
  add({id(0, 1), id(2, 3), id(1, 2), id(0, 2)});
  EXPECT_EQ(trianglesOf(placed.grid), 4 * 4);
  const vtkIdType beyond = placed.point({3, 3, 3});
  add({id(1, 1), id(2, 2), id(3, 3), beyond});
  EXPECT_EQ(trianglesOf(placed.grid), 3 * 4 + 3);
}

TEST(MeshRefined, HasNoWallsBetweenQuadrilateralsAndTriangles)
{
  PlacedGrid placed(inPlace);
  placed.addBox({0, 0, 0}, {1, 1, 1});
  const auto id = [&](int x, int y, int z) {
    return placed.point({double(x), double(y), double(z)});
  };
  // The cube beside it as five tetrahedra.
  const std::array<std::array<vtkIdType, 4>, 5> cells = {
    std::array{id(1, 0, 0), id(2, 0, 0), id(1, 1, 0), id(1, 0, 1)},
    {id(2, 1, 0), id(1, 1, 0), id(2, 0, 0), id(2, 1, 1)},
    {id(2, 0, 1), id(1, 0, 1), id(2, 1, 1), id(2, 0, 0)},
    {id(1, 1, 1), id(2, 1, 1), id(1, 0, 1), id(1, 1, 0)},
    {id(2, 0, 0), id(1, 1, 0), id(1, 0, 1), id(2, 1, 1)}};
  for (const auto& cell : cells)
    placed.grid->InsertNextCell(VTK_TETRA, 4, cell.data());
  EXPECT_EQ(trianglesOf(placed.grid), 2 * 5 + 2 * 5);
  EXPECT_EQ(trianglesOf(cellsApart(placed.grid)), 2 * 5 + 2 * 5);
  // Without the tetrahedra the quadrilateral shows, without the hexahedron their triangles do.
  EXPECT_EQ(trianglesOf(placed.grid, without(placed.grid, 1, 6)), 2 * 6);
  EXPECT_EQ(trianglesOf(placed.grid, without(placed.grid, 0, 1)), 2 * 6);
}

TEST(MeshRefined, KeepsThinWallsWhoseSidesHaveOtherCells)
{
  // 2 x 2 cells below and 4 x 4 above, which share points at the rim alone.
  PlacedGrid placed(inPlace);
  for (int i = 0; i < 4; ++i)
    placed.addBox(
      {2.0 * (i % 2), 2.0 * (i / 2), 0.0}, {2.0 * (i % 2) + 2.0, 2.0 * (i / 2) + 2.0, 1.0});
  placed.forget({2.0, 2.0, 1.0});
  for (int i = 0; i < 16; ++i)
    placed.addCut({double(i % 4), double(i / 4), 1.0}, {1, 1, 1});
  EXPECT_EQ(trianglesOf(placed.grid), 4 * (4 + 2 + 2) + 4 * (16 + 4 + 4));
}
