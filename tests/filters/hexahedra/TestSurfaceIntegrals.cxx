// Integrals over sections and boundaries, of fields whose integrals are known.

#include "MeshTools.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkCompositeDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkMoteSurfaceIntegrals.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{

using Field = std::function<std::vector<double>(const double*)>;

void addPointArray(vtkPointSet* data, const char* name, const Field& field)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const std::vector<double> value = field(data->GetPoint(i));
    array->SetNumberOfComponents(static_cast<int>(value.size()));
    array->InsertNextTuple(value.data());
  }
  data->GetPointData()->AddArray(array);
}

/// n^3 hexahedra in a box from `lower` with edges of 1, with these fields at points:
/// p = x y + 5 z, U = (-y, x, 2): a solid rotation that moves along its axis.
Grid box(const Vec& lower, int n = 4)
{
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto id = [&](int i, int j, int k)
  { return static_cast<vtkIdType>((k * (n + 1) + j) * (n + 1) + i); };
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        points->InsertNextPoint(
          lower[0] + double(i) / n, lower[1] + double(j) / n, lower[2] + double(k) / n);
  grid->SetPoints(points);
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
      {
        const vtkIdType ids[8] = {id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k),
          id(i, j + 1, k), id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1),
          id(i, j + 1, k + 1)};
        grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
      }
  addPointArray(grid, "p", [](const double* x) { return std::vector{x[0] * x[1] + 5.0 * x[2]}; });
  addPointArray(grid, "U", [](const double* x) { return std::vector{-x[1], x[0], 2.0}; });
  return grid;
}

struct Integrals
{
  explicit Integrals(vtkDataObject* data) { filter->SetInputDataObject(data); }
  double operator()(vtkIdType row, const char* column)
  {
    filter->Update();
    EXPECT_EQ(filter->GetErrorMessage(), "");
    vtkAbstractArray* found = filter->GetOutput()->GetColumnByName(column);
    EXPECT_TRUE(found) << column;
    return found ? found->GetVariantValue(row).ToDouble() : NAN;
  }
  std::string text(vtkIdType row, const char* column)
  {
    filter->Update();
    return filter->GetOutput()->GetValueByName(row, column).ToString();
  }
  void plane(const char* name, double z)
  {
    const double center[3] = {0.0, 0.0, z}, normal[3] = {0.0, 0.0, 1.0};
    filter->AddPlane(name, center, normal);
  }
  vtkNew<vtkMoteSurfaceIntegrals> filter;
};

} // namespace

TEST(SurfaceIntegrals, OfPlanesAreAreaFlowAndMeans)
{
  const Grid grid = box({1.0, 0.0, 0.0});
  Integrals found(grid);
  found.plane("low", 0.3);
  found.plane("high", 0.8);
  found.filter->AddArray("p");
  found.filter->AddArray("U");
  found.filter->SetVelocityArrayName("U");
  found.filter->SetPressureArrayName("p");
  found.filter->SetDensity(4.0);
  EXPECT_EQ(found.text(0, "section"), "low");
  EXPECT_EQ(found.text(1, "section"), "high");
  EXPECT_NEAR(found(0, "area"), 1.0, 1e-12);
  EXPECT_NEAR(found(0, "flow"), 2.0, 1e-12);
  EXPECT_NEAR(found(0, "p"), 1.5 * 0.5 + 5.0 * 0.3, 1e-9);
  EXPECT_NEAR(found(1, "p_integral"), 1.5 * 0.5 + 5.0 * 0.8, 1e-9);
  EXPECT_NEAR(found(1, "p_flow_mean"), 1.5 * 0.5 + 5.0 * 0.8, 1e-9);
  EXPECT_NEAR(found(0, "U:0"), -0.5, 1e-12);
  EXPECT_NEAR(found(0, "U:1"), 1.5, 1e-12);
  EXPECT_TRUE(std::isnan(found(0, "torque")));
  // p + 2 v^2: x^2 + y^2 has the mean 7/3 + 1/3.
  EXPECT_NEAR(found(0, "total_pressure"), 0.75 + 1.5 + 2.0 * (8.0 / 3.0 + 4.0), 1e-8);
  EXPECT_NEAR(found(0, "head"), 0.0, 1e-12);
  EXPECT_NEAR(found(1, "head"), 2.5 / (4.0 * 9.80665), 1e-9);
  EXPECT_LT(found(1, "head_error"), 1e-6);
  // A pressure over the density counts as often.
  found.filter->KinematicPressureOn();
  EXPECT_NEAR(found(1, "head"), 4.0 * 2.5 / (4.0 * 9.80665), 1e-9);
}

TEST(SurfaceIntegrals, OfABoundaryAreFlowAndTorque)
{
  // By Gauss the torque is the integral of x dp/dy - y dp/dx, here x^2 - y^2.
  const Grid grid = box({1.0, 0.0, 0.0});
  Integrals found(grid);
  found.filter->AddBoundary("walls");
  found.filter->SetVelocityArrayName("U");
  found.filter->SetPressureArrayName("p");
  EXPECT_NEAR(found(0, "area"), 6.0, 1e-12);
  EXPECT_NEAR(found(0, "flow"), 0.0, 1e-12);
  EXPECT_NEAR(found(0, "torque"), 7.0 / 3.0 - 1.0 / 3.0, 1e-12);
  EXPECT_EQ(found(0, "cells"), 96.0);
  // About an axis elsewhere the force counts, too: dp/dy is 3/2 in the mean.
  found.filter->AxisFromInputOff();
  found.filter->SetOrigin(1.0, 0.0, 7.0);
  EXPECT_NEAR(found(0, "torque"), 2.0 - 1.5, 1e-12);
  found.filter->SetAxis(0.0, 0.0, -3.0);
  EXPECT_NEAR(found(0, "torque"), 1.5 - 2.0, 1e-12);
}

TEST(SurfaceIntegrals, GhostsDoNotCount)
{
  const Grid grid = box({1.0, 0.0, 0.0});
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    grid->GetCellBounds(cell, bounds);
    // Beyond x = 1.5 all are hidden or another's.
    marks->InsertNextValue(bounds[0] < 1.49 ? 0
                           : bounds[2] < 0.49
                             ? static_cast<unsigned char>(vtkDataSetAttributes::HIDDENCELL)
                             : static_cast<unsigned char>(vtkDataSetAttributes::DUPLICATECELL));
  }
  grid->GetCellData()->AddArray(marks);
  Integrals found(grid);
  const double center[3] = {1.5, 0.5, 0.3}, normal[3] = {0.0, 0.0, 1.0};
  found.filter->AddPlane("middle", center, normal);
  found.filter->AddBoundary("walls");
  EXPECT_NEAR(found(0, "area"), 0.5, 1e-12);
  EXPECT_NEAR(found(1, "area"), 3.0, 1e-12);
}

TEST(SurfaceIntegrals, OfPartsAddUp)
{
  const Grid one = box({1.0, 0.0, 0.0}), two = box({2.0, 0.0, 0.0}, 3);
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("c");
  cells->SetNumberOfValues(two->GetNumberOfCells());
  cells->Fill(3.0);
  two->GetCellData()->AddArray(cells);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, one);
  blocks->SetBlock(1, two);
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "first");
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "second");
  Integrals found(blocks);
  found.plane("middle", 0.5);
  found.filter->AddArray("p");
  found.filter->AddArray("c");
  EXPECT_EQ(found.text(0, "part"), "first");
  EXPECT_EQ(found.text(1, "part"), "second");
  EXPECT_EQ(found.text(2, "part"), "all");
  EXPECT_NEAR(found(2, "area"), 2.0, 1e-12);
  EXPECT_NEAR(found(2, "p"), 2.0 * 0.5 + 2.5, 1e-9);
  EXPECT_NEAR(found(1, "c"), 3.0, 1e-12);
  EXPECT_TRUE(std::isnan(found(0, "c"))) << "a part without it";
}

TEST(SurfaceIntegrals, OfPolygonsHaveTheirOwnSide)
{
  vtkNew<vtkPolyData> patch;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& [x, y] : {std::pair(0.0, 0.0), {2.0, 0.0}, {2.0, 1.0}, {1.0, 2.0}, {0.0, 1.0}})
    points->InsertNextPoint(x, y, 0.5);
  patch->SetPoints(points);
  vtkNew<vtkCellArray> polygons;
  const vtkIdType ids[5] = {0, 1, 2, 3, 4};
  polygons->InsertNextCell(5, ids);
  patch->SetPolys(polygons);
  addPointArray(patch, "U", [](const double*) { return std::vector{0.0, 7.0, -3.0}; });
  addPointArray(patch, "x", [](const double* p) { return std::vector{p[0]}; });
  Integrals found(patch);
  found.filter->AddBoundary("patch");
  found.filter->AddArray("x");
  found.filter->SetVelocityArrayName("U");
  EXPECT_NEAR(found(0, "area"), 3.0, 1e-12);
  EXPECT_NEAR(found(0, "flow"), -9.0, 1e-12);
  EXPECT_NEAR(found(0, "x"), 1.0, 1e-12);
}

TEST(SurfaceIntegrals, OfPatchesHaveHeadAgainstTheInletAndDoNotCountTwice)
{
  const Grid grid = box({1.0, 0.0, 0.0});
  addPointArray(grid, "pressure", [](const double* p) { return std::vector{10.0 * p[0]}; });
  // The ends of the box along x as patches, and a wall.
  const auto patch = [&](double x, double sign)
  {
    auto made = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const auto& [y, z] : {std::pair(0.0, 0.0), {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
      points->InsertNextPoint(x, sign > 0.0 ? y : 1.0 - y, z);
    made->SetPoints(points);
    vtkNew<vtkCellArray> polygons;
    const vtkIdType ids[4] = {0, 1, 2, 3};
    polygons->InsertNextCell(4, ids);
    made->SetPolys(polygons);
    addPointArray(made, "U", [](const double*) { return std::vector{1.0, 0.0, 0.0}; });
    addPointArray(made, "pressure", [](const double* p) { return std::vector{10.0 * p[0]}; });
    return made;
  };
  const auto outlet = patch(1.0, 1.0), inlet = patch(0.0, -1.0), wall = patch(0.5, 1.0);
  addPointArray(wall, "U", [](const double*) { return std::vector{1e-18, 3.0, 0.0}; });
  vtkNew<vtkMultiBlockDataSet> blocks;
  const std::pair<const char*, vtkDataSet*> all[] = {
    {"mesh", grid}, {"case: outlet", outlet}, {"case: inlet", inlet}, {"case: wall", wall}};
  for (unsigned i = 0; i < 4; ++i)
  {
    blocks->SetBlock(i, all[i].second);
    blocks->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), all[i].first);
  }
  Integrals found(blocks);
  found.filter->AddBoundary("boundary");
  found.filter->SetVelocityArrayName("U");
  found.filter->SetPressureArrayName("pressure");
  found.filter->AddArray("pressure");
  EXPECT_NEAR(found(1, "flow"), 1.0, 1e-12);
  EXPECT_NEAR(found(2, "flow"), -1.0, 1e-12);
  EXPECT_NEAR(found(1, "head"), 10.0 / 9.80665, 1e-9) << "against the inlet, which comes later";
  EXPECT_NEAR(found(2, "head"), 0.0, 1e-12);
  for (const char* column : {"pressure_flow_mean", "total_pressure", "head"})
    for (const int row : {0, 3}) // as much goes in as out; nothing goes through
      EXPECT_TRUE(std::isnan(found(row, column))) << column << row;
  EXPECT_NEAR(found(3, "pressure"), 5.0, 1e-12);
  EXPECT_NE(found.filter->GetReport().find("mesh boundary, case: wall boundary"), std::string::npos)
    << found.filter->GetReport();
  EXPECT_EQ(found.text(4, "part"), "all");
  EXPECT_NEAR(found(4, "area"), found(0, "area"), 1e-12) << "patches bound the mesh";
}

TEST(SurfaceIntegrals, WhatCannotBeIsToldInASentence)
{
  const Grid grid = box({1.0, 0.0, 0.0}, 1);
  const auto told = [&](const std::function<void(vtkMoteSurfaceIntegrals*)>& change)
  {
    Integrals found(grid);
    vtkNew<vtkTest::ErrorObserver> observer;
    found.filter->AddObserver(vtkCommand::ErrorEvent, observer);
    found.filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
    change(found.filter);
    found.filter->Update();
    EXPECT_TRUE(observer->GetError());
    EXPECT_EQ(found.filter->GetOutput()->GetNumberOfRows(), 0);
    return found.filter->GetErrorMessage();
  };
  const double zero[3] = {0.0, 0.0, 0.0}, up[3] = {0.0, 0.0, 1.0};
  EXPECT_EQ(told([](auto*) {}), "there is no section to integrate over");
  EXPECT_NE(told([&](auto* f) { f->AddPlane("a", zero, zero); }).find("axis"), std::string::npos);
  EXPECT_NE(
    told([&](auto* f) { f->AddCylinder("a", zero, up, -1.0); }).find("radius"), std::string::npos);
  EXPECT_EQ(told(
              [](auto* f)
              {
                f->AddBoundary("a");
                f->AddArray("q");
              }),
    "there is no array 'q'");
  EXPECT_EQ(told(
              [](auto* f)
              {
                f->AddBoundary("a");
                f->SetVelocityArrayName("p");
              }),
    "the velocity 'p' has 1 components, not 3");
}
