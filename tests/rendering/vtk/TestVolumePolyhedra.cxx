// vtkMoteVolumeMapper: polyhedra look as the cells that they are made of, and are built once.
#include "VolumeTestSupport.h"

#include <support/HexGrid.h>

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPiecewiseFunction.h"

#include <array>
#include <cmath>

using namespace mote::testing;

namespace
{

/// A block of warped cells in [-1, 1]^3.
HexCells block()
{
  HexCells cells = hexBlock(4, 4, 4, 0.2, 2);
  cells.move([](const mote::Vec3d& p) { return 0.5 * p - mote::Vec3d(1.0); });
  return cells;
}

const std::vector<std::vector<std::size_t>> groups = {{0}, {5, 21}, {22, 23}, {26, 42}, {62, 63}};

double largestDifference(const Picture& a, const Picture& b, int pixels)
{
  double most = 0.0;
  for (int i = 0; i < pixels; ++i)
    for (int c = 0; c < 4; ++c)
      most = std::max(most, std::abs(double(a.color(i)[c]) - double(b.color(i)[c])));
  return most;
}

} // namespace

TEST(VolumePolyhedra, LookAsTheCellsThatTheyAreMadeOf)
{
  for (const char* integrator : {"trilinear", "cell-by-cell"})
  {
    const auto pictureOf = [&](const HexCells& cells, vtkIdType count)
    {
      VolumeStage stage(gridOf(cells));
      stage.camera()->Azimuth(25);
      stage.camera()->Elevation(15);
      stage.mapper->SetIntegratorName(integrator);
      stage.mapper->SetSampleDistance(0.01);
      stage.mapper->SetTolerance(1e-4);
      stage.paint({1, 0.5, 0.25}, 0.6);
      stage.property()->GetScalarOpacity()->RemoveAllPoints();
      stage.property()->GetScalarOpacity()->AddPoint(-4.0, 0.0);
      stage.property()->GetScalarOpacity()->AddPoint(4.0, 0.9);
      Picture picture = stage.trace(40, 40);
      EXPECT_EQ(stage.mapper->GetReport(), "");
      EXPECT_EQ(stage.mapper->GetNumberOfCells(), count);
      EXPECT_EQ(stage.mapper->GetNumberOfCellsLeftOut(), 0);
      EXPECT_GT(picture.color(20 + 40 * 20)[3], 0.3);
      return picture;
    };
    const Picture plain = pictureOf(block(), 64), mixed = pictureOf(merged(block(), groups), 60);
    EXPECT_LT(largestDifference(mixed, plain, 40 * 40), 5e-4) << integrator;
  }
}

TEST(VolumePolyhedra, CellValuesAreThoseOfTheCell)
{
  const auto grid = gridOf(merged(block(), {{0, 1, 2}}));
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("number");
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
    numbers->InsertNextValue(c == 0 ? 1.0 : 0.0);
  grid->GetCellData()->SetScalars(numbers);
  VolumeStage stage(grid, true);
  stage.mapper->SetScalarModeToUseCellData();
  stage.paint({1, 1, 1}, 0.5);
  stage.property()->GetScalarOpacity()->RemoveAllPoints();
  stage.property()->GetScalarOpacity()->AddPoint(0.4, 0.0);
  stage.property()->GetScalarOpacity()->AddPoint(0.6, 0.5);
  const Picture picture = stage.trace(60, 60); // sees [-1.5, 1.5]^2
  EXPECT_GT(picture.color(picture.at(30, 14))[3], 0.1);
  EXPECT_EQ(picture.color(picture.at(30, 40))[3], 0);
  EXPECT_EQ(picture.color(picture.at(47, 14))[3], 0);
}

TEST(VolumePolyhedra, AreBuiltOnceForTheSameFaces)
{
  const auto grid = gridOf(merged(block(), groups));
  VolumeStage stage(grid, true);
  stage.mapper->Update();
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 1);
  // A reader's next step: the same numbers in other arrays.
  vtkNew<vtkUnstructuredGrid> next;
  next->DeepCopy(grid);
  stage.mapper->SetInputData(next);
  stage.mapper->Update();
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 1);
  // A face less is another mesh.
  vtkNew<vtkUnstructuredGrid> open;
  open->DeepCopy(grid);
  open->GetFaces()->SetValue(open->GetFaceLocations()->GetValue(5), 9);
  stage.mapper->SetInputData(open);
  {
    Complaints complaints(stage.mapper);
    stage.mapper->Update();
    EXPECT_EQ(complaints.warnings, 1);
  }
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 2);
  EXPECT_EQ(stage.mapper->GetNumberOfCells(), 59);
}

TEST(VolumePolyhedra, WhatIsLeftOutIsCountedByReason)
{
  HexCells cells = merged(block(), {{4, 20, 36, 39, 55, 7, 23, 6, 22, 5, 52}});
  cells.points[3 * 124] = std::nan(""); // the last cell's corner
  const auto grid = gridOf(cells);
  const vtkIdType face[4] = {0, 1, 6, 5};
  grid->InsertNextCell(VTK_QUAD, 4, face);
  const vtkIdType flat[4] = {0, 1, 2, 5};
  grid->InsertNextCell(VTK_TETRA, 4, flat);
  VolumeStage stage(grid, true);
  Complaints complaints(stage.mapper);
  stage.mapper->Update();
  using Mapper = vtkMoteVolumeMapper;
  Mapper* const mapper = stage.mapper;
  EXPECT_EQ(mapper->GetNumberOfCellsLeftOut(Mapper::OTHER_TYPE), 1);
  EXPECT_EQ(mapper->GetNumberOfCellsLeftOut(Mapper::UNFIT_POLYHEDRON), 1);
  EXPECT_EQ(mapper->GetNumberOfCellsLeftOut(Mapper::NOT_FINITE), 1);
  EXPECT_EQ(mapper->GetNumberOfCellsLeftOut(Mapper::TOO_FAR), 0);
  EXPECT_EQ(mapper->GetNumberOfCellsLeftOut(Mapper::NO_VOLUME), 1);
  EXPECT_EQ(mapper->GetNumberOfCellsLeftOut(), 4);
  EXPECT_EQ(mapper->GetNumberOfCellsLeftOut(77), 0);
  EXPECT_EQ(mapper->GetNumberOfCells() + 4, grid->GetNumberOfCells());
}
