// Volumes, quality and means of meshes whose answers are known.

#include "MeshTools.h"

#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkIdList.h>
#include <vtkMeshQuality.h>
#include <vtkMoteMeshStatistics.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

struct Statistics
{
  explicit Statistics(vtkDataObject* data)
  {
    filter->SetInputDataObject(data);
    filter->Update();
    cells = filter->GetOutput(0);
    arrays = filter->GetOutput(1);
  }
  double of(const char* column) const { return valueAt(cells, 0, column); }

  vtkNew<vtkMoteMeshStatistics> filter;
  vtkTable *cells, *arrays;
};

/// A mesh over the unit cube whose inner points were moved anyhow.
Grid shaken(double by)
{
  auto random = std::make_shared<std::mt19937>(3);
  return block(5,
    [random, by](Vec p)
    {
      std::uniform_real_distribution<double> d(-by, by);
      for (double& x : p)
        if (x > 1e-9 && x < 1 - 1e-9)
          x += d(*random);
      return p;
    });
}

TEST(MeshStatistics, WarpedCellsFillTheCube)
{
  const Grid grid = shaken(0.04);
  addField(grid, "linear", 1, [](Vec p) { return Vec{2.0 + p[0] - 3.0 * p[1] + 5.0 * p[2]}; });
  addField(grid, "same", 3, [](Vec) { return Vec{3.0, 0.0, 4.0}; });
  const Statistics s(grid);
  EXPECT_EQ(s.of("cells"), 125);
  EXPECT_EQ(s.of("hexahedra"), 125);
  EXPECT_EQ(s.of("inverted"), 0);
  EXPECT_NEAR(s.of("volume"), 1.0, 1e-13);
  EXPECT_LT(s.of("min_volume"), 0.008);
  EXPECT_GT(s.of("max_volume"), 0.008);
  ASSERT_EQ(s.arrays->GetNumberOfRows(), 2);
  EXPECT_NEAR(valueAt(s.arrays, 0, "mean"), 3.5, 1e-12);
  EXPECT_NEAR(valueAt(s.arrays, 0, "min"), -1.0, 1e-12);
  EXPECT_NEAR(valueAt(s.arrays, 0, "max"), 8.0, 1e-12);
  EXPECT_NEAR(valueAt(s.arrays, 1, "mean"), 5.0, 1e-12);
}

TEST(MeshStatistics, QualityIsThatOfVTK)
{
  const Grid grid = shaken(0.09);
  double least = 1.0, sum = 0.0;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    const double quality = vtkMeshQuality::HexScaledJacobian(grid->GetCell(i));
    least = std::min(least, quality);
    sum += quality;
  }
  const Statistics s(grid);
  EXPECT_NEAR(s.of("min_scaled_jacobian"), least, 0.2);
  EXPECT_LE(least, s.of("min_scaled_jacobian") + 1e-12); // VTK asks the middle, too
  EXPECT_NEAR(s.of("mean_scaled_jacobian"), sum / 125, 1e-2);
}

TEST(MeshStatistics, RegularCellsHaveQualityOne)
{
  const double h = std::sqrt(3.0) / 2.0;
  const std::vector<Vec> triangle = {{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}};
  const auto with = [](std::vector<Vec> points, std::initializer_list<Vec> more)
  {
    points.insert(points.end(), more);
    return points;
  };
  const Grid tetrahedron =
    cellsOf(VTK_TETRA, with(triangle, {{0.5, h / 3, std::sqrt(2.0 / 3.0)}}), {{0, 1, 2, 3}});
  const auto prism = with(triangle, {{0, 0, 1}, {1, 0, 1}, {0.5, h, 1}});
  const Grid wedge = cellsOf(VTK_WEDGE, prism, {{0, 1, 2, 3, 4, 5}});
  const Grid turned = cellsOf(VTK_WEDGE, prism, {{3, 4, 5, 0, 1, 2}});
  const Grid pyramid = cellsOf(VTK_PYRAMID,
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, std::sqrt(0.5)}}, {{0, 1, 2, 3, 4}});
  const Grid voxel = cellsOf(VTK_VOXEL,
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}},
    {{0, 1, 2, 3, 4, 5, 6, 7}});
  const struct
  {
    Grid grid;
    const char* type;
    double volume;
  } cases[] = {{tetrahedron, "tetrahedra", std::sqrt(2.0) / 12.0}, {wedge, "wedges", h / 2.0},
    {turned, "wedges", h / 2.0}, {pyramid, "pyramids", std::sqrt(2.0) / 6.0},
    {voxel, "hexahedra", 1.0}};
  for (const auto& one : cases)
  {
    // A linear field's mean is its value at the centroid.
    addField(one.grid, "z", 1, [](Vec p) { return Vec{p[2]}; });
    const Statistics s(one.grid);
    EXPECT_EQ(s.of(one.type), 1);
    EXPECT_NEAR(s.of("volume"), one.volume, 1e-14) << one.type;
    EXPECT_NEAR(s.of("min_scaled_jacobian"), 1.0, 1e-12) << one.type;
    EXPECT_NEAR(s.of("max_aspect_ratio"), 1.0, 1e-12) << one.type;
    EXPECT_EQ(s.of("inverted"), 0) << one.type;
    const double height = pointOf(one.grid, one.grid->GetNumberOfPoints() - 1)[2];
    const bool tip = one.type[0] == 't' || one.type[0] == 'p';
    EXPECT_NEAR(valueAt(s.arrays, 0, "mean"), height / (tip ? 4.0 : 2.0), 1e-13) << one.type;
  }
}

TEST(MeshStatistics, BadCellsAreCounted)
{
  const double nan = std::nan("");
  std::vector<Vec> points;
  for (int i = 0; i < 12; ++i)
    points.push_back({double(i & 1), double((i >> 1) & 1), double(i >> 2)});
  points.push_back({nan, 0, 0});
  const Grid grid = cellsOf(VTK_HEXAHEDRON, points,
    {{0, 1, 3, 2, 4, 5, 7, 6},    // right
      {8, 9, 11, 10, 4, 5, 7, 6}, // inside out
      {0, 1, 3, 2, 0, 1, 3, 2},   // flat
      {12, 1, 3, 2, 4, 5, 7, 6}});
  const vtkIdType square[4] = {0, 1, 3, 2};
  grid->InsertNextCell(VTK_QUAD, 4, square);
  vtkNew<vtkDoubleArray> array;
  array->SetName("a");
  for (const double value : {4.0, nan, 100.0, 1.0, 1.0})
    array->InsertNextValue(value);
  grid->GetCellData()->AddArray(array);
  const Statistics s(grid);
  EXPECT_EQ(s.of("cells"), 5);
  EXPECT_EQ(s.of("hexahedra"), 3);
  EXPECT_EQ(s.of("other"), 1);
  EXPECT_EQ(s.of("inverted"), 1);
  EXPECT_EQ(s.of("zero_volume"), 1);
  EXPECT_EQ(s.of("non_finite"), 1);
  EXPECT_NEAR(s.of("volume"), 2.0, 1e-14);
  EXPECT_EQ(s.of("min_volume"), 0.0);
  EXPECT_LT(s.of("min_scaled_jacobian"), -0.99);
  EXPECT_EQ(valueAt(s.arrays, 0, "non_finite"), 1);
  EXPECT_NEAR(valueAt(s.arrays, 0, "mean"), 4.0, 1e-14); // the flat one weighs nothing
  EXPECT_EQ(valueAt(s.arrays, 0, "max"), 100.0);
}

TEST(MeshStatistics, NothingIsNotANumber)
{
  vtkNew<vtkUnstructuredGrid> empty;
  const Statistics s(empty);
  EXPECT_EQ(s.of("cells"), 0);
  EXPECT_EQ(s.of("volume"), 0.0);
  EXPECT_TRUE(std::isnan(s.of("min_scaled_jacobian")));
  EXPECT_EQ(s.arrays->GetNumberOfRows(), 0);
}

TEST(MeshStatistics, WhatDoesNotFitTogetherIsASentence)
{
  const auto sentence = [](vtkDataSet* data)
  {
    vtkNew<vtkMoteMeshStatistics> filter;
    vtkNew<vtkTest::ErrorObserver> errors, executive;
    filter->AddObserver(vtkCommand::ErrorEvent, errors);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executive);
    filter->SetInputData(data);
    filter->Update();
    EXPECT_EQ(filter->GetOutput(0)->GetNumberOfRows(), 0);
    return errors->GetErrorMessage();
  };
  for (const vtkIdType id : {8, 999999999, -1})
  {
    const Grid grid = block(1, [](Vec p) { return p; });
    grid->GetCells()->GetConnectivityArray()->SetComponent(6, 0, static_cast<double>(id));
    EXPECT_NE(sentence(grid).find(
                "cell 0 names the point " + std::to_string(id) + ", and there are 8 points"),
      std::string::npos)
      << sentence(grid);
  }
  vtkNew<vtkRectilinearGrid> lacking; // z has one value
  lacking->SetDimensions(2, 2, 2);
  vtkNew<vtkDoubleArray> places;
  places->InsertNextValue(0.0);
  places->InsertNextValue(1.0);
  lacking->SetXCoordinates(places);
  lacking->SetYCoordinates(places);
  EXPECT_NE(sentence(lacking).find("1 Z coordinates"), std::string::npos) << sentence(lacking);
  vtkNew<vtkStructuredGrid> curved;
  vtkNew<vtkPoints> few;
  few->InsertNextPoint(0, 0, 0);
  curved->SetDimensions(2, 2, 2);
  curved->SetPoints(few);
  EXPECT_NE(sentence(curved).find("places for 1 of them"), std::string::npos) << sentence(curved);
}

TEST(MeshStatistics, BlocksOfThePump)
{
  vtkNew<vtkMotePumpSource> source;
  source->SetScale(0.02);
  source->Update();
  const Statistics s(source->GetOutputDataObject(0));
  ASSERT_EQ(s.cells->GetNumberOfRows(), 3);
  ASSERT_EQ(s.arrays->GetNumberOfRows(), 6);
  EXPECT_EQ(s.cells->GetValueByName(1, "block").ToString(), "rotor");
  const double pipe = 3.14159265358979 * 0.05 * 0.05 * 0.16;
  EXPECT_NEAR(s.of("volume"), pipe, 0.01 * pipe); // chords
  for (vtkIdType row = 0; row < 3; ++row)
  {
    EXPECT_EQ(valueAt(s.cells, row, "inverted"), 0);
    EXPECT_EQ(valueAt(s.cells, row, "cells"), valueAt(s.cells, row, "hexahedra"));
    EXPECT_GT(valueAt(s.cells, row, "max_aspect_ratio"), 3.0);
  }
  for (vtkIdType row = 0; row < 6; ++row)
  {
    EXPECT_GT(valueAt(s.arrays, row, "mean"), valueAt(s.arrays, row, "min"));
    EXPECT_LT(valueAt(s.arrays, row, "mean"), valueAt(s.arrays, row, "max"));
  }
}

} // namespace
