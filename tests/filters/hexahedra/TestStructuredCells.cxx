// Images and structured grids as hexahedra: the same cells, the same order, none inside out.
#include "vtkMoteStructuredCells.h"

#include "vtkCellData.h"
#include "vtkCellSizeFilter.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <set>

namespace
{

vtkSmartPointer<vtkUnstructuredGrid> gridOf(vtkDataSet* data)
{
  const auto made = vtkSmartPointer<vtkDataSet>::Take(vtkMoteStructuredCells::Of(data));
  return vtkUnstructuredGrid::SafeDownCast(made);
}

/// The volumes of all cells together; those that are inside out count as negative.
double volumeOf(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkCellSizeFilter> sizes;
  sizes->SetInputData(grid);
  sizes->Update();
  auto* sized = vtkDataSet::SafeDownCast(sizes->GetOutput());
  vtkDataArray* volumes = sized->GetCellData()->GetArray("Volume");
  double sum = 0.0;
  for (vtkIdType i = 0; i < volumes->GetNumberOfTuples(); ++i)
    sum += volumes->GetComponent(i, 0);
  return sum;
}

void expectSameCells(vtkDataSet* data, vtkUnstructuredGrid* grid)
{
  ASSERT_TRUE(grid);
  ASSERT_EQ(grid->GetNumberOfCells(), data->GetNumberOfCells());
  ASSERT_EQ(grid->GetNumberOfPoints(), data->GetNumberOfPoints());
  double a[6], b[6];
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    data->GetCellBounds(i, a);
    grid->GetCellBounds(i, b);
    for (int k = 0; k < 6; ++k)
      EXPECT_DOUBLE_EQ(a[k], b[k]) << "cell " << i;
  }
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, a);
    grid->GetPoint(i, b);
    for (int k = 0; k < 3; ++k)
      EXPECT_DOUBLE_EQ(a[k], b[k]) << "point " << i;
  }
}

vtkSmartPointer<vtkStructuredGrid> wedge(double direction)
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(4, 3, 5);
  vtkNew<vtkPoints> points;
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 4; ++i)
        points->InsertNextPoint(direction * i * (1.0 + 0.1 * j), j, k + 0.2 * i);
  grid->SetPoints(points);
  return grid;
}

} // namespace

TEST(TestStructuredCells, ImagesAreVoxels)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(2, 5, -1, 2, 0, 1);
  image->SetOrigin(1.0, 2.0, 3.0);
  image->SetSpacing(0.5, 1.0, 2.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  const auto grid = gridOf(image);
  expectSameCells(image, grid);
  EXPECT_EQ(grid->GetCellType(0), VTK_VOXEL);
  EXPECT_EQ(grid->GetPointData()->GetScalars(), image->GetPointData()->GetScalars());
  // Turned, they are hexahedra.
  image->SetDirectionMatrix(0, 1, 0, -1, 0, 0, 0, 0, 1);
  const auto turned = gridOf(image);
  expectSameCells(image, turned);
  EXPECT_EQ(turned->GetCellType(0), VTK_HEXAHEDRON);
  EXPECT_NEAR(volumeOf(turned), 9.0, 1e-9);
}

TEST(TestStructuredCells, GridsKeepTheirOrderAndAreNotInsideOut)
{
  for (const double direction : {1.0, -1.0})
  {
    const auto grid = wedge(direction);
    const auto cells = gridOf(grid);
    expectSameCells(grid, cells);
    EXPECT_GT(volumeOf(cells), 0.0);
  }
  for (const bool isDescending : {false, true})
  {
    vtkNew<vtkRectilinearGrid> grid;
    grid->SetDimensions(3, 3, 3);
    vtkNew<vtkDoubleArray> along, other;
    for (const double x : {0.0, 1.0, 4.0})
    {
      along->InsertNextValue(isDescending ? 4.0 - x : x);
      other->InsertNextValue(x);
    }
    grid->SetXCoordinates(along);
    grid->SetYCoordinates(other);
    grid->SetZCoordinates(other);
    const auto cells = gridOf(grid);
    expectSameCells(grid, cells);
    EXPECT_NEAR(volumeOf(cells), 64.0, 1e-9);
  }
}

TEST(TestStructuredCells, FlatGridsAndOthersStay)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 1);
  EXPECT_FALSE(gridOf(image));
  image->SetDimensions(10, 10, 10);
  const auto kept =
    vtkSmartPointer<vtkDataSet>::Take(vtkMoteStructuredCells::Of(image, 1000)); // bytes
  EXPECT_EQ(kept.Get(), image.Get());
  const auto cells = gridOf(image);
  EXPECT_EQ(gridOf(cells), cells);
}

TEST(TestStructuredCells, BlankedCellsAndGhostsAreLeftOut)
{
  const auto grid = wedge(1.0);
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("number");
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    numbers->InsertNextValue(double(i));
  grid->GetCellData()->AddArray(numbers);
  grid->BlankCell(4);
  auto cells = gridOf(grid);
  ASSERT_EQ(cells->GetNumberOfCells(), grid->GetNumberOfCells() - 1);
  EXPECT_EQ(cells->GetCellData()->GetArray("number")->GetComponent(4, 0), 5.0);
  grid->UnBlankCell(4);
  grid->BlankPoint(0); // a corner of the first cell alone
  cells = gridOf(grid);
  ASSERT_EQ(cells->GetNumberOfCells(), grid->GetNumberOfCells() - 1);
  EXPECT_EQ(cells->GetCellData()->GetArray("number")->GetComponent(0, 0), 1.0);
}

namespace
{

/// A structured grid whose points are where(i, j, k), with x + y + z as "f".
template <typename Where>
vtkSmartPointer<vtkStructuredGrid> structured(std::array<int, 3> n, const Where& where)
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(n.data());
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> f;
  f->SetName("f");
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i)
      {
        const std::array<double, 3> p = where(i, j, k);
        points->InsertNextPoint(p.data());
        f->InsertNextValue(p[0] + p[1] + p[2]);
      }
  grid->SetPoints(points);
  grid->GetPointData()->AddArray(f);
  return grid;
}

/// How many points cells name.
std::size_t namedPoints(vtkUnstructuredGrid* grid)
{
  std::set<vtkIdType> named;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    named.insert(ids->begin(), ids->end());
  }
  return named.size();
}

/// Around a body.
std::array<double, 3> aroundBody(int i, int j, int k)
{
  const double angle = 2.0 * M_PI * (i % 16) / 16;
  return {(1.0 + j) * std::cos(angle), (1.0 + j) * std::sin(angle), double(k)};
}

/// Around a profile from x = 0 to 1, of so much thickness, and on both sides of its wake, to x = 3:
/// i goes from the end of the wake around the nose at i = 10 and back.
std::array<double, 3> aroundProfile(int i, int j, int k, double thickness)
{
  const int from = std::abs(i - 10);
  const double x = from > 5 ? 1.0 + 0.4 * (from - 5) : 0.2 * from;
  const double half = from >= 5 ? 0.0 : thickness * std::sin(M_PI * x);
  return {x - (i == 10 ? 0.1 * j : 0.0), (i < 10 ? -1 : 1) * (half + 0.3 * j), double(k)};
}

} // namespace

TEST(TestStructuredCells, AreJoinedWhereAGridMeetsItself)
{
  const auto around = structured({17, 4, 3}, aroundBody);
  EXPECT_EQ(namedPoints(gridOf(around)), 16U * 4U * 3U);
  expectSameCells(around, gridOf(around));
  // Not where values differ.
  vtkNew<vtkDoubleArray> angle;
  angle->SetName("angle");
  for (vtkIdType point = 0; point < around->GetNumberOfPoints(); ++point)
    angle->InsertNextValue(static_cast<double>(point % 17));
  around->GetPointData()->AddArray(angle);
  EXPECT_EQ(namedPoints(gridOf(around)), 17U * 4U * 3U);
  // Nor where it only comes near.
  const auto open = structured({17, 4, 3},
    [](int i, int j, int k)
    {
      auto p = aroundBody(i, j, k);
      p[2] += 1e-3 * i;
      return p;
    });
  EXPECT_EQ(namedPoints(gridOf(open)), 17U * 4U * 3U);
}

TEST(TestStructuredCells, AreJoinedInTheWakeOfAProfile)
{
  const auto profile =
    structured({21, 4, 3}, [](int i, int j, int k) { return aroundProfile(i, j, k, 0.1); });
  EXPECT_EQ(namedPoints(gridOf(profile)), (21U * 4U - 6U) * 3U); // x from 1 to 3
  expectSameCells(profile, gridOf(profile));
  // A plate without thickness stays.
  const auto plate =
    structured({21, 4, 3}, [](int i, int j, int k) { return aroundProfile(i, j, k, 0.0); });
  EXPECT_EQ(namedPoints(gridOf(plate)), 21U * 4U * 3U);
}

TEST(TestStructuredCells, PolesStay)
{
  const auto ball = structured({13, 7, 4},
    [](int i, int j, int k) -> std::array<double, 3>
    {
      const double a = 2.0 * M_PI * i / 12, b = M_PI * j / 6, r = 1.0 + k;
      return {r * std::sin(b) * std::cos(a), r * std::sin(b) * std::sin(a), r * std::cos(b)};
    });
  EXPECT_EQ(namedPoints(gridOf(ball)), (12U * 5U + 2U * 13U) * 4U);
}
