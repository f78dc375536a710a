// vtkMoteMeshMapper on cells that touch: blocks, parts of one grid and copies of a sector have no
// walls between them, whether they have the same points there or not. It needs no display.
#include "GridParts.h"
#include "MeshTestSupport.h"
#include "SurfaceTriangles.h"
#include "VolumeTestSupport.h"

#include "vtkDoubleArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

using namespace mote::testing;

namespace
{

/// Hexahedra of nx * ny * nz: where(x, y, z) has the place of a point, of numbers from 0 to 1. They
/// join the cells that are there.
template <typename Where>
void addBlock(vtkUnstructuredGrid* grid, std::array<int, 3> n, const Where& where)
{
  if (!grid->GetPoints())
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    grid->SetPoints(points);
    grid->Allocate(1);
  }
  const vtkIdType first = grid->GetNumberOfPoints();
  for (int z = 0; z <= n[2]; ++z)
    for (int y = 0; y <= n[1]; ++y)
      for (int x = 0; x <= n[0]; ++x)
      {
        const Point p = where(double(x) / n[0], double(y) / n[1], double(z) / n[2]);
        grid->GetPoints()->InsertNextPoint(p[0], p[1], p[2]);
      }
  const auto id = [&](int x, int y, int z)
  { return first + x + (n[0] + 1) * (y + vtkIdType(n[1] + 1) * z); };
  for (int z = 0; z < n[2]; ++z)
    for (int y = 0; y < n[1]; ++y)
      for (int x = 0; x < n[0]; ++x)
      {
        const vtkIdType corners[] = {id(x, y, z), id(x + 1, y, z), id(x + 1, y + 1, z),
          id(x, y + 1, z), id(x, y, z + 1), id(x + 1, y, z + 1), id(x + 1, y + 1, z + 1),
          id(x, y + 1, z + 1)};
        grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
      }
}

/// A ring of nr * na * nz cells from radius r0 to r1; `share` of it, from `phase` on.
void addRing(vtkUnstructuredGrid* grid, double r0, double r1, std::array<int, 3> n,
  double phase = 0.0, double share = 1.0)
{
  addBlock(grid, n,
    [=](double x, double y, double z) -> Point
    {
      const double r = r0 + (r1 - r0) * x, angle = 2.0 * M_PI * (share * y + phase);
      return {r * std::cos(angle), r * std::sin(angle), z};
    });
}

vtkIdType trianglesOf(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkMoteMeshMapper> mapper;
  mapper->SetInputData(grid);
  mapper->Update();
  return mapper->GetNumberOfTriangles();
}

/// Those of a block's faces.
vtkIdType facesOf(std::array<int, 3> n)
{
  return 4 * (n[0] * n[1] + n[1] * n[2] + n[2] * n[0]);
}

} // namespace

TEST(MeshNeighbors, HaveNoWallsBetweenThem)
{
  // Two blocks of 3^3 cells side by side, and one whose cells are smaller.
  const auto blockAt = [](double x, int n)
  {
    auto grid = makeBox(n, [](const Point& p) { return p[0]; });
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      double p[3];
      grid->GetPoint(i, p);
      points->InsertNextPoint(p[0] + x, p[1], p[2]);
    }
    grid->SetPoints(points);
    return grid;
  };
  const auto left = blockAt(0.0, 3), right = blockAt(2.0, 3), other = blockAt(4.0, 5);
  vtkNew<vtkMoteMeshMapper> a, b, c;
  a->SetInputData(left);
  b->SetInputData(right);
  c->SetInputData(other);
  for (vtkMoteMeshMapper* one : {a.Get(), b.Get(), c.Get()})
    for (vtkMoteMeshMapper* beside : {a.Get(), b.Get(), c.Get()})
      one->AddNeighbor(beside);
  const auto triangles = [](vtkMoteMeshMapper* one)
  {
    one->Update();
    return one->GetNumberOfTriangles();
  };
  constexpr vtkIdType side = 2 * 9, wide = 2 * 25;
  EXPECT_EQ(a->GetNumberOfNeighbors(), 2);
  EXPECT_EQ(triangles(a), 5 * side);
  EXPECT_EQ(triangles(b), 4 * side) << "what has other points there covers, too";
  EXPECT_EQ(triangles(c), 5 * wide);
  // Where a cell of the neighbor is hidden, the face is seen.
  vtkNew<vtkUnsignedCharArray> shown;
  shown->SetNumberOfValues(27);
  shown->Fill(1);
  shown->SetValue(0, 0); // at the lowest x
  b->SetVisibleCells(shown);
  const vtkMTimeType before = a->GetPictureMTime();
  EXPECT_EQ(triangles(a), 5 * side + 2);
  EXPECT_EQ(triangles(b), 4 * side + 6 - 4) << "three faces came to light, two outer ones went";
  b->SetVisibleCells(nullptr);
  EXPECT_EQ(triangles(a), 5 * side);
  EXPECT_GT(a->GetPictureMTime(), before);
  // Where a point is another, blocks are moved away, or gone.
  right->GetPoints()->SetPoint(0, 1.1, -1.0, -1.0);
  right->GetPoints()->Modified();
  right->Modified();
  EXPECT_EQ(triangles(a), 5 * side + 2);
  b->SetInputData(blockAt(2.5, 3));
  EXPECT_EQ(triangles(a), 6 * side);
  b->SetInputData(blockAt(2.0, 3));
  EXPECT_EQ(triangles(a), 5 * side);
  a->RemoveAllNeighbors();
  EXPECT_EQ(triangles(a), 6 * side);
  {
    vtkNew<vtkMoteMeshMapper> gone;
    gone->SetInputData(blockAt(-2.0, 3));
    a->AddNeighbor(gone);
    EXPECT_EQ(triangles(a), 5 * side);
  }
  EXPECT_EQ(triangles(a), 6 * side);
}

TEST(MeshNeighbors, OfWedgesAndTetrahedraShareTheirTriangles)
{
  for (const int type : {VTK_TETRA, VTK_WEDGE, VTK_PYRAMID, VTK_HEXAHEDRON})
  {
    const auto whole = gridOf(type);
    // Cut in two by the numbers of cells: wherever the parts touch there is no wall.
    vtkNew<vtkMoteMeshMapper> all, halves[2];
    all->SetInputData(whole);
    vtkSmartPointer<vtkUnstructuredGrid> parts[2];
    for (int k = 0; k < 2; ++k)
    {
      parts[k] = vtkSmartPointer<vtkUnstructuredGrid>::New();
      parts[k]->SetPoints(whole->GetPoints());
      parts[k]->Allocate(whole->GetNumberOfCells());
      for (vtkIdType i = 0; i < whole->GetNumberOfCells(); ++i)
        if ((i % 3 == 0) == (k == 0))
          parts[k]->InsertNextCell(whole->GetCellType(i), whole->GetCell(i)->GetPointIds());
      halves[k]->SetInputData(parts[k]);
    }
    halves[0]->AddNeighbor(halves[1]);
    halves[1]->AddNeighbor(halves[0]);
    for (vtkMoteMeshMapper* one : {all.Get(), halves[0].Get(), halves[1].Get()})
      one->Update();
    EXPECT_EQ(halves[0]->GetNumberOfTriangles() + halves[1]->GetNumberOfTriangles(),
      all->GetNumberOfTriangles())
      << type;
  }
}

TEST(MeshParts, OfOneGridHaveNoWallsWhereTheyMeet)
{
  // A rotor in its stator, which have other cells around and along the axis, from few that are flat
  // to many. Rings of cells are not closed, so that their ends are walls.
  for (const int around : {24, 60, 361})
  {
    SCOPED_TRACE(around);
    const std::array<int, 3> inner = {2, around, 3}, outer = {3, 3 * around / 4, 4};
    vtkNew<vtkUnstructuredGrid> grid;
    addRing(grid, 1.0, 2.0, inner);
    EXPECT_EQ(trianglesOf(grid), facesOf(inner));
    addRing(grid, 2.0, 3.0, outer, 0.1);
    const vtkIdType met = 2 * (inner[1] * inner[2] + outer[1] * outer[2]);
    EXPECT_EQ(trianglesOf(grid), facesOf(inner) + facesOf(outer) - met);
    // Where cells are hidden the walls behind them are seen.
    vtkNew<vtkMoteMeshMapper> mapper;
    vtkNew<vtkUnsignedCharArray> shown;
    shown->SetNumberOfValues(grid->GetNumberOfCells());
    shown->Fill(1);
    for (int i = 0; i < outer[0] * outer[1] * outer[2]; ++i)
      shown->SetValue(grid->GetNumberOfCells() - 1 - i, 0);
    mapper->SetInputData(grid);
    mapper->SetVisibleCells(shown);
    mapper->Update();
    EXPECT_EQ(mapper->GetNumberOfTriangles(), facesOf(inner));
  }
}

TEST(MeshParts, ThatAreCoveredInPartKeepTheirFaces)
{
  const auto box = [](double x0, double x1, double y1) {
    return [=](double x, double y, double z) -> Point { return {x0 + (x1 - x0) * x, y1 * y, z}; };
  };
  const std::array<int, 3> two = {2, 2, 2}, three = {3, 3, 3};
  const auto met = [&](double gap, double width)
  {
    vtkNew<vtkUnstructuredGrid> grid;
    addBlock(grid, two, box(0.0, 1.0, 1.0));
    addBlock(grid, three, box(1.0 + gap, 2.0, width));
    return facesOf(two) + facesOf(three) - trianglesOf(grid);
  };
  EXPECT_EQ(met(0.0, 1.0), 2 * (4 + 9));
  EXPECT_EQ(met(1e-8, 1.0), 2 * (4 + 9)) << "rounding";
  EXPECT_EQ(met(-1e-8, 1.0), 2 * (4 + 9));
  EXPECT_EQ(met(0.01, 1.0), 0) << "a gap";
  EXPECT_EQ(met(0.0, 0.9), 2 * (2 + 9)) << "two of four faces are covered, and two in part";
  EXPECT_EQ(met(0.0, 1.2), 2 * (4 + 6)) << "and of nine six";
}

TEST(MeshParts, AreNotOnBothSidesOfWallsOfTheirOwn)
{
  // A baffle: cells on both sides of it, which meet behind it.
  vtkNew<vtkUnstructuredGrid> grid;
  for (const double y : {0.0, 1.0})
    addBlock(grid, {4, 2, 1}, [=](double x, double t, double z) -> Point { return {x, y + t, z}; });
  EXPECT_EQ(trianglesOf(grid), 2 * facesOf({4, 2, 1}) - 2 * 8) << "two parts";
  // Joined by the cell behind: its points are theirs.
  const vtkIdType side = 5 * 3;
  const vtkIdType top = 10, below = 10 + 2 * side; // the last rows of points
  const vtkIdType corners[] = {
    top, top + 1, below + 1, below, top + side, top + side + 1, below + side + 1, below + side};
  const vtkIdType before = 2 * facesOf({4, 2, 1});
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
  EXPECT_GE(trianglesOf(grid), before);
}

TEST(MeshParts, OfCellsWithPointsOfTheirOwnHaveOneSurface)
{
  for (const int type : {VTK_TETRA, VTK_WEDGE, VTK_PYRAMID, VTK_HEXAHEDRON})
  {
    SCOPED_TRACE(type);
    const auto whole = gridOf(type);
    const auto apart = cellsApart(whole);
    vtkNew<vtkDoubleArray> cellOf; // values of points, which differ from cell to cell
    for (vtkIdType i = 0; i < apart->GetNumberOfCells(); ++i)
      for (vtkIdType k = 0; k < apart->GetCell(i)->GetNumberOfPoints(); ++k)
        cellOf->InsertNextValue(static_cast<double>(i));
    EXPECT_EQ(trianglesOf(apart), trianglesOf(whole));
    // Cells that are hidden bring the same faces to light.
    vtkNew<vtkUnsignedCharArray> shown;
    shown->SetNumberOfValues(whole->GetNumberOfCells());
    for (vtkIdType i = 0; i < whole->GetNumberOfCells(); ++i)
      shown->SetValue(i, i % 3 == 0 ? 0 : 1);
    vtkIdType counts[2];
    vtkNew<vtkMoteMeshMapper> mapper;
    mapper->SetVisibleCells(shown);
    for (vtkUnstructuredGrid* grid : {whole.Get(), apart.Get()})
    {
      mapper->SetInputData(grid);
      mapper->Update();
      counts[grid == apart.Get()] = mapper->GetNumberOfTriangles();
    }
    EXPECT_EQ(counts[0], counts[1]);
    // Corners are those of the face's own cell, whose values they have.
    const mote::SurfaceTriangles found = mote::surfaceTrianglesOf(apart);
    ASSERT_EQ(found.cells.size(), found.view().count());
    for (std::size_t t = 0; t < found.cells.size(); ++t)
      for (int k = 0; k < 3; ++k)
        ASSERT_EQ(cellOf->GetValue(static_cast<vtkIdType>(found.view().value(t, k))),
          static_cast<double>(found.cells[t]));
  }
}

TEST(MeshParts, OfCellsThatRoundTheirPointsEachByItselfAreWelded)
{
  const std::array<int, 3> n = {4, 5, 3};
  vtkNew<vtkUnstructuredGrid> whole;
  addBlock(whole, n,
    [](double x, double y, double z) -> Point {
      return {1e3 + x / 3.0 + 0.1 * y * z, 0.7 * y - 0.3 * x * x, z / 7.0};
    });
  const auto apart = cellsApart(whole);
  vtkPoints* points = apart->GetPoints();
  ASSERT_EQ(points->GetDataType(), VTK_DOUBLE);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    Point p;
    points->GetPoint(i, p.data());
    for (double& x : p)
      x = std::nextafter(x, i % 3 == 0 ? -1e9 : i % 3 == 1 ? x : 1e9);
    points->SetPoint(i, p.data());
  }
  mote::PointSets parts(points->GetNumberOfPoints());
  parts.joinCells(apart);
  const std::vector<vtkIdType> welds = mote::weldsOf(apart, parts);
  ASSERT_EQ(welds.size(), static_cast<std::size_t>(points->GetNumberOfPoints()));
  EXPECT_EQ(std::set<vtkIdType>(welds.begin(), welds.end()).size(),
    static_cast<std::size_t>(whole->GetNumberOfPoints()));
  EXPECT_EQ(trianglesOf(apart), facesOf(n));
}

TEST(MeshBoundaryCells, StandForFacesOfTheVolume)
{
  // Cells of the boundary beside those of the volume, in either direction and cut in either way, a
  // line, a wall within and a sheet outside.
  const std::array<int, 3> n = {3, 3, 3};
  vtkNew<vtkUnstructuredGrid> grid;
  addBlock(grid, n, [](double x, double y, double z) -> Point { return {x, y, z}; });
  const auto id = [](int x, int y, int z) -> vtkIdType { return x + 4 * (y + 4 * z); };
  const auto add = [&](int type, std::vector<vtkIdType> corners)
  { grid->InsertNextCell(type, static_cast<vtkIdType>(corners.size()), corners.data()); };
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
    {
      std::vector<vtkIdType> quad = {
        id(x, y, 0), id(x + 1, y, 0), id(x + 1, y + 1, 0), id(x, y + 1, 0)};
      if (x == 1)
        std::reverse(quad.begin(), quad.end());
      if (y == 1)
        std::rotate(quad.begin(), quad.begin() + 1, quad.end());
      add(VTK_QUAD, quad);
    }
  add(VTK_LINE, {id(0, 0, 0), id(1, 0, 0)});
  EXPECT_EQ(trianglesOf(grid), facesOf(n));
  add(VTK_QUAD, {id(1, 1, 1), id(2, 1, 1), id(2, 2, 1), id(1, 2, 1)});
  for (const double y : {0.0, 1.0})
    grid->GetPoints()->InsertNextPoint(5.0, y, 0.0);
  add(VTK_TRIANGLE, {id(0, 0, 0), 64, 65});
  vtkNew<vtkMoteMeshMapper> mapper;
  mapper->SetInputData(grid);
  mapper->Update();
  EXPECT_EQ(mapper->GetNumberOfTriangles(), facesOf(n) + 2 + 1);
  EXPECT_EQ(mapper->GetNumberOfCellsLeftOut(), 0) << "the line is not missed";
  // Triangles of picked faces are those of cells with a volume.
  const mote::SurfaceTriangles found = mote::surfaceTrianglesOf(grid);
  int flat = 0;
  for (const vtkIdType cell : found.cells)
    flat += cell >= 27;
  EXPECT_EQ(flat, 3);
  // Without the volume they are there.
  vtkNew<vtkUnsignedCharArray> some;
  some->SetNumberOfValues(grid->GetNumberOfCells());
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    some->SetValue(i, i < 27 ? 0 : 1);
  mapper->SetVisibleCells(some);
  mapper->Update();
  EXPECT_EQ(mapper->GetNumberOfTriangles(), 2 * 9 + 2 + 1);
}

TEST(MeshParts, FarFromTheOriginMeetAsFloatNumbersDo)
{
  for (const int type : {VTK_FLOAT, VTK_DOUBLE})
  {
    const std::array<int, 3> two = {2, 2, 2}, seven = {7, 7, 7};
    vtkNew<vtkUnstructuredGrid> grid;
    vtkNew<vtkPoints> points;
    points->SetDataType(type);
    grid->SetPoints(points);
    grid->Allocate(1);
    for (const auto& [n, begin] : {std::pair(two, 0.0), std::pair(seven, 1.0)})
      addBlock(grid, n,
        [&](double x, double y, double z) -> Point
        {
          // Turned, so that no coordinate is that of a plane.
          const double along = 5e4 + 0.8 * (x + begin) - 0.6 * y;
          return {along, 3e4 + 0.6 * (x + begin) + 0.8 * y, z};
        });
    EXPECT_EQ(facesOf(two) + facesOf(seven) - trianglesOf(grid), 2 * (4 + 49)) << type;
  }
}

TEST(MeshNeighbors, DoNotCoverSharpTrailingEdges)
{
  // Above and below a blade that is a wedge of six degrees: the two blocks meet along its edge.
  for (const int cells : {1, 4, 20})
    for (const double width : {0.2, 1.0, 10.0})
    {
      vtkNew<vtkMoteMeshMapper> mappers[2];
      const std::array<int, 3> n = {cells, 2, 2};
      for (int k = 0; k < 2; ++k)
      {
        vtkNew<vtkUnstructuredGrid> grid;
        addBlock(grid, n,
          [=](double x, double y, double z) -> Point
          {
            const double sign = k == 0 ? 1.0 : -1.0, bow = 0.02 * x * (1.0 - x);
            const double blade = (1.0 - x) * std::tan(M_PI / 60.0) + bow;
            return {x, sign * (y + (1.0 - y) * blade), sign * width * (z - 0.5)};
          });
        mappers[k]->SetInputData(grid);
      }
      mappers[0]->AddNeighbor(mappers[1]);
      mappers[1]->AddNeighbor(mappers[0]);
      for (vtkMoteMeshMapper* one : {mappers[0].Get(), mappers[1].Get()})
      {
        one->Update();
        EXPECT_EQ(one->GetNumberOfTriangles(), facesOf(n)) << cells << " cells, " << width;
      }
    }
}

TEST(MeshSectors, HaveNoWallsWhereTheirSidesHaveOtherPoints)
{
  const std::array<int, 3> n = {6, 10, 4};
  vtkNew<vtkUnstructuredGrid> grid;
  addBlock(grid, n,
    [](double x, double y, double z) -> Point
    {
      // A twisted sixth, whose cells have other widths at the one side than at the other.
      const double s = x + 0.3 * y * x * (1.0 - x), r = 1.0 + s;
      const double angle = M_PI / 3.0 * y + 0.5 * s;
      return {r * std::cos(angle), r * std::sin(angle), z};
    });
  vtkNew<vtkMoteMeshMapper> mapper;
  mapper->SetInputData(grid);
  mapper->SetRepetitions(5);
  mapper->Update();
  EXPECT_EQ(mapper->GetNumberOfTriangles(), facesOf(n));
  mapper->SetRepetitions(6);
  mapper->Update();
  EXPECT_EQ(mapper->GetNumberOfTriangles(), facesOf(n) - 4 * n[0] * n[2]);
}
