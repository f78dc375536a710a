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
