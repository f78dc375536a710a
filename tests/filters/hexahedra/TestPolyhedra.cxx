// Polyhedra in statistics, averages and the locator.

#include "LocatorTools.h"

#include <support/HexGrid.h>

#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkMoteMeridionalAverage.h>
#include <vtkMoteMeshStatistics.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace mote::testing;

namespace
{

HexCells warped()
{
  return hexBlock(4, 4, 4, 0.2, 2);
}

const std::vector<std::vector<std::size_t>> groups = {{0}, {5, 21}, {22, 23}, {26, 42}, {62, 63}};

TEST(Polyhedra, AreCountedByNameWithTheirVolumeAndMeans)
{
  const auto plain = gridOf(warped()), grid = gridOf(merged(warped(), groups));
  vtkNew<vtkDoubleArray> even;
  even->SetName("even");
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
    even->InsertNextValue(3.5);
  grid->GetCellData()->AddArray(even);
  vtkNew<vtkMoteMeshStatistics> statistics, expected;
  statistics->SetInputData(grid);
  statistics->Update();
  expected->SetInputData(plain);
  expected->Update();
  vtkTable *const cells = statistics->GetOutput(0), *const arrays = statistics->GetOutput(1);
  EXPECT_EQ(valueAt(cells, 0, "cells"), 60);
  EXPECT_EQ(valueAt(cells, 0, "polyhedra"), 5);
  EXPECT_EQ(valueAt(cells, 0, "hexahedra"), 55);
  EXPECT_EQ(valueAt(cells, 0, "other"), 0);
  EXPECT_NEAR(valueAt(cells, 0, "volume"), 64.0, 1e-11);
  EXPECT_GT(valueAt(cells, 0, "max_volume"), 1.5);
  for (const char* column : {"min", "mean", "max"})
    EXPECT_NEAR(valueAt(arrays, 0, column), valueAt(expected->GetOutput(1), 0, column), 1e-12);
  EXPECT_NEAR(valueAt(arrays, 1, "mean"), 3.5, 1e-13);
}

TEST(Polyhedra, AloneHaveVolumeAndNoQuality)
{
  const auto grid = gridOf(merged(hexBlock(2, 1, 1), {{0, 1}}));
  vtkNew<vtkMoteMeshStatistics> statistics;
  statistics->SetInputData(grid);
  statistics->Update();
  vtkTable* const cells = statistics->GetOutput(0);
  EXPECT_EQ(valueAt(cells, 0, "polyhedra"), 1);
  EXPECT_NEAR(valueAt(cells, 0, "min_volume"), 2.0, 1e-13);
  EXPECT_TRUE(std::isnan(valueAt(cells, 0, "min_scaled_jacobian")));
}

TEST(Polyhedra, ThatNameWhatIsNotThereAreRefused)
{
  const auto grid = gridOf(merged(warped(), groups));
  grid->GetFaces()->SetValue(grid->GetFaceLocations()->GetValue(5) + 3, 999);
  vtkNew<vtkMoteMeshStatistics> statistics;
  vtkNew<vtkTest::ErrorObserver> errors;
  statistics->AddObserver(vtkCommand::ErrorEvent, errors);
  statistics->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  statistics->SetInputData(grid);
  statistics->Update();
  EXPECT_NE(errors->GetErrorMessage().find("cell 5 has faces"), std::string::npos)
    << errors->GetErrorMessage();
}

TEST(Polyhedra, AreAveragedAsTheCellsThatTheyAreMadeOf)
{
  const auto sumsOf = [](vtkUnstructuredGrid* grid)
  {
    vtkNew<vtkMoteMeridionalAverage> average;
    average->SetInputData(grid);
    average->SetArrayName("linear");
    average->SetResolution(4);
    average->Update();
    vtkTable* const bins = average->GetOutput();
    std::array<double, 2> sums{};
    for (vtkIdType row = 0; row < bins->GetNumberOfRows(); ++row)
    {
      const double volume = valueAt(bins, row, "volume");
      sums[0] += volume;
      sums[1] += volume * valueAt(bins, row, "linear");
    }
    return sums;
  };
  const auto plain = sumsOf(gridOf(warped())), mixed = sumsOf(gridOf(merged(warped(), groups)));
  EXPECT_NEAR(plain[0], 64.0, 1e-11);
  EXPECT_NEAR(mixed[0], 64.0, 1e-11);
  EXPECT_NEAR(mixed[1], plain[1], 1e-10);
}

TEST(Polyhedra, AreFoundWithLinearValues)
{
  const auto grid = gridOf(merged(warped(), groups)), plain = gridOf(warped());
  vtkDataArray* const linear = grid->GetPointData()->GetScalars();
  for (const std::string& name : names)
  {
    const Locator locator = locatorOf(grid, name), parts = locatorOf(plain, name);
    EXPECT_EQ(locator->GetNumberOfCells(), 60);
    std::set<vtkIdType> seen;
    for (const mote::Vec3d& at : randomPoints(2000, mote::Vec3d(0.01), mote::Vec3d(3.99), 5))
    {
      Vec p = {at.x, at.y, at.z}, pcoords;
      vtkNew<vtkGenericCell> cell;
      std::vector<double> weights(64);
      const vtkIdType id = locator->FindCell(p.data(), 0.0, cell, pcoords.data(), weights.data());
      ASSERT_GE(id, 0);
      ASSERT_EQ(cell->GetCellType(), grid->GetCellType(id));
      double value = 0.0;
      for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
        value += weights[i] * linear->GetComponent(cell->GetPointId(int(i)), 0);
      EXPECT_NEAR(value, p[0] + 2.0 * p[1] - p[2], 1e-9);
      const vtkIdType part = parts->FindCell(p.data());
      EXPECT_EQ(grid->GetCellType(id) == VTK_POLYHEDRON, part == 0 || part == 5 || part == 21 ||
                                                           part == 22 || part == 23 || part == 26 ||
                                                           part == 42 || part == 62 || part == 63);
      seen.insert(id);
    }
    EXPECT_EQ(seen.size(), 60U);
  }
}

TEST(Polyhedra, AreToldOnceAlongLinesAndInBoxes)
{
  const auto grid = gridOf(merged(hexBlock(4, 2, 2), {{0, 1}, {6, 7}}));
  for (const std::string& name : names)
  {
    const Locator locator = locatorOf(grid, name);
    const double from[3] = {-1.0, 0.4, 0.3}, to[3] = {5.0, 0.4, 0.3};
    vtkNew<vtkIdList> cells;
    locator->FindCellsAlongLine(from, to, 0.0, cells);
    ASSERT_EQ(cells->GetNumberOfIds(), 3);
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(cells->GetId(i), i);
    double box[6] = {-1.0, 5.0, -1.0, 5.0, -1.0, 5.0};
    locator->FindCellsWithinBounds(box, cells);
    ASSERT_EQ(cells->GetNumberOfIds(), 14);
    for (int i = 0; i < 14; ++i)
      EXPECT_EQ(cells->GetId(i), i);
    // From within a polyhedron, whose parts' faces are none of its own.
    const double inside[3] = {0.3, 0.4, 0.3};
    double t = 0.0;
    Vec x, pcoords;
    int subId = 0;
    vtkIdType id = -1;
    vtkNew<vtkGenericCell> cell;
    ASSERT_EQ(
      locator->IntersectWithLine(inside, to, 0.0, t, x.data(), pcoords.data(), subId, id, cell), 1);
    EXPECT_NEAR(x[0], 2.0, 1e-12);
    EXPECT_EQ(id, 1);
    Vec beside = {-0.5, 0.5, 0.5}, closest;
    double distance2 = 0.0;
    locator->FindClosestPoint(beside.data(), closest.data(), cell, id, subId, distance2);
    EXPECT_EQ(id, 0);
    EXPECT_NEAR(distance2, 0.25, 1e-9);
  }
}

} // namespace
