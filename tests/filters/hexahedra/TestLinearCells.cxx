// Cells of higher order as linear ones: the same space and values, through the same nodes, and
// nothing between neighbours.
#include "vtkMoteLinearCells.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellSizeFilter.h"
#include "vtkCellTypeSource.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

namespace
{

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;
using Map = std::function<void(double*)>;

constexpr double quarter = 1.5707963267948966;

/// No right angles, and of volume 6 for each that there was.
void shear(double* p)
{
  p[0] = 2.0 * p[0] + 0.3 * p[1];
  p[1] = 3.0 * p[1] - 0.2 * p[2];
}

double linear(const double* p)
{
  return 2.0 * p[0] - p[1] + 0.5 * p[2] + 7.0;
}

/// Moves the points, and gives them the array `value`: linear in place.
Grid placed(vtkUnstructuredGrid* grid, const Map& map)
{
  auto moved = Grid::New();
  moved->ShallowCopy(grid);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> value;
  value->SetName("value");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double p[3];
    grid->GetPoint(i, p);
    map(p);
    points->InsertNextPoint(p);
    value->InsertNextValue(linear(p));
  }
  moved->SetPoints(points);
  moved->GetPointData()->AddArray(value);
  vtkNew<vtkIntArray> number;
  number->SetName("number");
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    number->InsertNextValue(100 + static_cast<int>(i));
  moved->GetCellData()->AddArray(number);
  return moved;
}

/// A unit cube of n^3 blocks of such cells.
Grid blocksOf(int type, int n, int order = 2)
{
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(type);
  source->SetCellOrder(order);
  source->SetBlocksDimensions(n, n, n);
  source->SetOutputPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return placed(source->GetOutput(),
    [=](double* p)
    {
      for (int k = 0; k < 3; ++k)
        p[k] /= n;
    });
}

/// One cell of a type that has its own parametric coordinates for places.
Grid oneOf(int type)
{
  vtkNew<vtkGenericCell> cell;
  cell->SetCellType(type);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdList> ids;
  const double* places = cell->GetParametricCoords();
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
    ids->InsertNextId(points->InsertNextPoint(places + 3 * i));
  auto grid = Grid::New();
  grid->SetPoints(points);
  grid->InsertNextCell(type, ids);
  return grid;
}

Grid cut(vtkUnstructuredGrid* grid, vtkTypeUInt64 mostBytes = 0)
{
  const auto made = vtkSmartPointer<vtkDataSet>::Take(vtkMoteLinearCells::Of(grid, mostBytes));
  return vtkUnstructuredGrid::SafeDownCast(made);
}

/// The volume of all cells, each of which is more than nothing. Wedges are in either order in files
/// and in VTK's own cells of higher order, but in one in a grid.
double volumeOf(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkCellSizeFilter> sizes;
  sizes->SetInputData(grid);
  sizes->Update();
  auto* sized = vtkDataSet::SafeDownCast(sizes->GetOutput());
  vtkDataArray* volumes = sized->GetCellData()->GetArray("Volume");
  const double side =
    grid->GetCellType(0) == VTK_WEDGE && volumes->GetComponent(0, 0) < 0.0 ? -1.0 : 1.0;
  double sum = 0.0;
  for (vtkIdType i = 0; i < volumes->GetNumberOfTuples(); ++i)
  {
    const double volume = side * volumes->GetComponent(i, 0);
    EXPECT_GT(volume, 0.0) << "cell " << i;
    sum += volume;
  }
  return sum;
}

/// The area of all faces that one cell alone has.
double outerAreaOf(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(grid);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(surface->GetOutputPort());
  vtkNew<vtkMassProperties> mass;
  mass->SetInputConnection(triangles->GetOutputPort());
  mass->Update();
  return mass->GetSurfaceArea();
}

void expectLinear(vtkUnstructuredGrid* grid)
{
  vtkDataArray* value = grid->GetPointData()->GetArray("value");
  ASSERT_TRUE(value);
  ASSERT_EQ(value->GetNumberOfTuples(), grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double p[3];
    grid->GetPoint(i, p);
    ASSERT_NEAR(value->GetComponent(i, 0), linear(p), 1e-9) << "point " << i;
  }
}

struct Kind
{
  int type, order;
  vtkIdType parts, inBlock; ///< linear cells of one, cells of a block of vtkCellTypeSource
};

constexpr Kind kinds[] = {{VTK_QUADRATIC_TETRA, 2, 8, 12}, {VTK_QUADRATIC_HEXAHEDRON, 2, 8, 1},
  {VTK_QUADRATIC_WEDGE, 2, 8, 2}, {VTK_QUADRATIC_PYRAMID, 2, 10, 6},
  {VTK_LAGRANGE_TETRAHEDRON, 2, 8, 12}, {VTK_LAGRANGE_TETRAHEDRON, 3, 27, 12},
  {VTK_LAGRANGE_HEXAHEDRON, 1, 1, 1}, {VTK_LAGRANGE_HEXAHEDRON, 2, 8, 1},
  {VTK_LAGRANGE_HEXAHEDRON, 3, 27, 1}, {VTK_LAGRANGE_WEDGE, 2, 8, 2},
  {VTK_LAGRANGE_WEDGE, 4, 64, 2}};

} // namespace

TEST(TestLinearCells, FillTheSameSpaceWithTheSameValues)
{
  constexpr int n = 3;
  for (const Kind& kind : kinds)
  {
    SCOPED_TRACE(std::to_string(kind.type) + " of order " + std::to_string(kind.order));
    const Grid grid = placed(blocksOf(kind.type, n, kind.order), shear);
    ASSERT_EQ(grid->GetNumberOfCells(), n * n * n * kind.inBlock);
    EXPECT_EQ(vtkMoteLinearCells::CountIn(grid), grid->GetNumberOfCells());
    const Grid made = cut(grid);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->GetNumberOfCells(), grid->GetNumberOfCells() * kind.parts);
    EXPECT_EQ(vtkMoteLinearCells::CountIn(made), 0);
    EXPECT_NEAR(volumeOf(made), 6.0, 1e-9);
    expectLinear(made);
    // What has no neighbour is the outside alone: points in faces are made once. (The source makes
    // some nodes of cubic tetrahedra twice.)
    if (kind.type == VTK_LAGRANGE_TETRAHEDRON && kind.order == 3)
      continue;
    EXPECT_NEAR(outerAreaOf(made), outerAreaOf(placed(blocksOf(VTK_HEXAHEDRON, 1), shear)), 1e-6);
  }
}

TEST(TestLinearCells, EachIsOfTheCellThatItWasCutFrom)
{
  for (const Kind& kind : kinds)
  {
    const Grid grid = blocksOf(kind.type, 2, kind.order);
    const Grid made = cut(grid);
    auto* original = vtkIdTypeArray::SafeDownCast(made->GetCellData()->GetArray("OriginalCellIds"));
    vtkDataArray* number = made->GetCellData()->GetArray("number");
    ASSERT_TRUE(original && number);
    std::vector<vtkIdType> parts(grid->GetNumberOfCells());
    for (vtkIdType i = 0; i < made->GetNumberOfCells(); ++i)
    {
      const vtkIdType from = original->GetValue(i);
      ++parts[from];
      EXPECT_EQ(number->GetComponent(i, 0), 100 + from);
      double outer[6], inner[6];
      grid->GetCellBounds(from, outer);
      made->GetCellBounds(i, inner);
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_GE(inner[2 * k], outer[2 * k] - 1e-12);
        EXPECT_LE(inner[2 * k + 1], outer[2 * k + 1] + 1e-12);
      }
    }
    EXPECT_EQ(parts, std::vector<vtkIdType>(parts.size(), kind.parts));
  }
}

TEST(TestLinearCells, NodesInFacesAndMiddlesAreUsed)
{
  struct
  {
    int type;
    double volume;
    vtkIdType cells, made;
  } const types[] = {{VTK_TRIQUADRATIC_HEXAHEDRON, 6.0, 8, 0},
    {VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 6.0, 8, 3}, {VTK_QUADRATIC_HEXAHEDRON, 6.0, 8, 7},
    {VTK_BIQUADRATIC_QUADRATIC_WEDGE, 3.0, 8, 0}, {VTK_QUADRATIC_LINEAR_WEDGE, 3.0, 4, 0},
    {VTK_QUADRATIC_WEDGE, 3.0, 8, 3}, {VTK_QUADRATIC_TETRA, 1.0, 8, 0}};
  for (const auto& of : types)
  {
    SCOPED_TRACE(of.type);
    const Grid grid = placed(oneOf(of.type), shear), made = cut(grid);
    EXPECT_EQ(made->GetNumberOfCells(), of.cells);
    EXPECT_EQ(made->GetNumberOfPoints(), grid->GetNumberOfPoints() + of.made);
    EXPECT_NEAR(volumeOf(made), of.volume, 1e-12);
    expectLinear(made);
    std::set<vtkIdType> used;
    vtkNew<vtkIdList> corners;
    for (vtkIdType i = 0; i < made->GetNumberOfCells(); ++i)
    {
      made->GetCellPoints(i, corners);
      used.insert(corners->begin(), corners->end());
    }
    EXPECT_EQ(static_cast<vtkIdType>(used.size()), made->GetNumberOfPoints());
  }
}

TEST(TestLinearCells, BentCellsErrByAQuarterOfWhatTheirCornersDo)
{
  // A quarter of a ring between the radii 1 and 2, of height 1.
  const Map bend = [](double* p)
  {
    const double r = 1.0 + p[0], angle = quarter * p[1];
    p[0] = r * std::cos(angle);
    p[1] = r * std::sin(angle);
  };
  const double exact = 0.75 * 2.0 * quarter;
  constexpr int n = 3;
  for (const auto& [straight, bent] :
    {std::pair(VTK_TETRA, VTK_QUADRATIC_TETRA), std::pair(VTK_HEXAHEDRON, VTK_QUADRATIC_HEXAHEDRON),
      std::pair(VTK_HEXAHEDRON, VTK_LAGRANGE_HEXAHEDRON), std::pair(VTK_WEDGE, VTK_QUADRATIC_WEDGE),
      std::pair(VTK_PYRAMID, VTK_QUADRATIC_PYRAMID)})
  {
    const double ofCorners = exact - volumeOf(placed(blocksOf(straight, n), bend));
    const double ofParts = exact - volumeOf(cut(placed(blocksOf(bent, n), bend)));
    EXPECT_GT(ofCorners, 0.01 * exact);
    EXPECT_LT(std::abs(ofParts), 0.27 * ofCorners) << bent;
  }
}

TEST(TestLinearCells, OtherCellsStay)
{
  const Grid hexahedra = blocksOf(VTK_HEXAHEDRON, 2);
  EXPECT_EQ(cut(hexahedra), hexahedra);
  EXPECT_EQ(vtkMoteLinearCells::CountIn(hexahedra), 0);
  EXPECT_EQ(vtkMoteLinearCells::Of(nullptr), nullptr);

  // A polyhedron, a bent triangle and a linear tetrahedron beside a bent one.
  auto mixed = Grid::New();
  mixed->DeepCopy(oneOf(VTK_QUADRATIC_TETRA));
  const vtkIdType tetrahedron[] = {0, 1, 2, 3}, triangle[] = {0, 1, 2, 4, 5, 6};
  const vtkIdType faces[] = {3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 3, 2};
  mixed->InsertNextCell(VTK_QUADRATIC_TRIANGLE, 6, triangle);
  mixed->InsertNextCell(VTK_POLYHEDRON, 4, tetrahedron, 4, faces);
  mixed->InsertNextCell(VTK_TETRA, 4, tetrahedron);
  EXPECT_EQ(vtkMoteLinearCells::CountIn(mixed), 1);
  const Grid made = cut(mixed);
  ASSERT_EQ(made->GetNumberOfCells(), 8 + 3);
  for (vtkIdType i = 0; i < 8; ++i)
    EXPECT_EQ(made->GetCellType(i), VTK_TETRA);
  for (vtkIdType i = 1; i < 4; ++i)
  {
    EXPECT_EQ(made->GetCellType(7 + i), mixed->GetCellType(i));
    vtkNew<vtkIdList> was, is;
    mixed->GetCellPoints(i, was);
    made->GetCellPoints(7 + i, is);
    ASSERT_EQ(is->GetNumberOfIds(), was->GetNumberOfIds());
    for (vtkIdType k = 0; k < is->GetNumberOfIds(); ++k)
      EXPECT_EQ(is->GetId(k), was->GetId(k));
  }
  vtkNew<vtkIdList> stream;
  made->GetFaceStream(9, stream);
  EXPECT_EQ(stream->GetNumberOfIds(), 1 + 16);
}

TEST(TestLinearCells, WhatWouldTakeTooMuchMemoryStays)
{
  const Grid grid = blocksOf(VTK_QUADRATIC_HEXAHEDRON, 4);
  EXPECT_EQ(cut(grid, 5000), grid);
  EXPECT_NE(cut(grid, 1 << 20), grid);
}

TEST(TestLinearCells, CellsWithoutTheNodesOfTheirTypeStay)
{
  for (const int type : {VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_TETRA, VTK_QUADRATIC_PYRAMID,
         VTK_LAGRANGE_HEXAHEDRON, VTK_LAGRANGE_TETRAHEDRON, VTK_LAGRANGE_WEDGE})
    for (const vtkIdType nodes : {0, 1, 5, 7, 9, 30})
    {
      auto grid = Grid::New();
      vtkNew<vtkPoints> points;
      vtkNew<vtkIdList> ids;
      for (vtkIdType i = 0; i < nodes; ++i)
        ids->InsertNextId(points->InsertNextPoint(double(i % 3), double(i % 5), double(i)));
      grid->SetPoints(points);
      grid->InsertNextCell(type, ids);
      const Grid made = cut(grid);
      ASSERT_TRUE(made);
      EXPECT_EQ(made->GetNumberOfCells(), 1) << type << " with " << nodes;
      EXPECT_EQ(made->GetCellType(0), type);
    }
}
