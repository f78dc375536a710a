// Averages over circles, of fields whose averages are known.

#include "MeshTools.h"

#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkMoteMeridionalAverage.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace
{

/// A ring of hexahedra about z: radii 1 to 2, heights 0 to 1, or what `place` makes of it.
Grid ring(const std::function<Vec(Vec)>& place)
{
  const int around = 60;
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto id = [&](int i, int j, int k) { return vtkIdType((k * around + j % around) * 9 + i); };
  for (int k = 0; k <= 8; ++k)
    for (int j = 0; j < around; ++j)
      for (int i = 0; i <= 8; ++i)
      {
        const double r = 1.0 + i / 8.0, a = 2.0 * 3.14159265358979323846 * j / around;
        points->InsertNextPoint(place({r * std::cos(a), r * std::sin(a), k / 8.0}).data());
      }
  grid->SetPoints(points);
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < around; ++j)
      for (int i = 0; i < 8; ++i)
      {
        const vtkIdType ids[8] = {id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k),
          id(i, j + 1, k), id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1),
          id(i, j + 1, k + 1)};
        grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
      }
  return grid;
}

Vec same(Vec p)
{
  return p;
}

struct Average
{
  Average(vtkDataObject* data, const char* name, int resolution = 40)
  {
    filter->SetInputDataObject(data);
    filter->SetArrayName(name);
    filter->SetResolution(resolution);
  }
  vtkTable* table()
  {
    filter->Update();
    return filter->GetOutput(0);
  }

  vtkNew<vtkMoteMeridionalAverage> filter;
};

TEST(MeridionalAverage, FieldsOfRadiusAndHeightComeBack)
{
  const Grid grid = ring(same);
  addField(grid, "f", 1, [](Vec p) { return Vec{3.0 * std::hypot(p[0], p[1]) + 2.0 * p[2]}; });
  Average average(grid, "f");
  vtkTable* table = average.table();
  ASSERT_GT(table->GetNumberOfRows(), 300);
  double volume = 0.0;
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    const double r = valueAt(table, i, "radial"), z = valueAt(table, i, "axial");
    volume += valueAt(table, i, "volume");
    if (r < 1.05 || r > 1.95) // where bins are full; one spans 0.25 of the field
      continue;
    EXPECT_NEAR(valueAt(table, i, "f"), 3.0 * r + 2.0 * z, 0.05) << r << " " << z;
  }
  const double prism = 0.5 * 60 * std::sin(2.0 * 3.14159265358979323846 / 60) * (4.0 - 1.0);
  EXPECT_NEAR(volume, prism, 1e-10);
}

TEST(MeridionalAverage, WhatGoesRoundAveragesOut)
{
  const Grid grid = ring(same);
  addField(grid, "x", 1, [](Vec p) { return Vec{p[0]}; });
  addField(grid, "one", 1, [](Vec) { return Vec{7.25}; });
  addField(grid, "high", 1, [](Vec p) { return Vec{1e8 + p[0]}; });
  Average x(grid, "x"), one(grid, "one"), high(grid, "high");
  for (vtkIdType i = 0; i < high.table()->GetNumberOfRows(); ++i)
    EXPECT_NEAR(
      valueAt(high.table(), i, "high_deviation"), valueAt(x.table(), i, "x_deviation"), 1e-5);
  vtkTable* table = x.table();
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    EXPECT_NEAR(valueAt(table, i, "x"), 0.0, 1e-12);
    const double r = valueAt(table, i, "radial");
    EXPECT_NEAR(valueAt(table, i, "x_deviation"), r / std::sqrt(2.0), 0.03);
  }
  table = one.table();
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    EXPECT_NEAR(valueAt(table, i, "one"), 7.25, 1e-12);
    EXPECT_NEAR(valueAt(table, i, "one_deviation"), 0.0, 1e-12);
  }
}

TEST(MeridionalAverage, VectorsHaveTheirParts)
{
  const Grid grid = ring(same);
  // 2 outwards, 3 r round, 5 up.
  addField(grid, "v", 3,
    [](Vec p)
    {
      const double r = std::hypot(p[0], p[1]);
      return Vec{2.0 * p[0] / r - 3.0 * p[1], 2.0 * p[1] / r + 3.0 * p[0], 5.0};
    });
  Average average(grid, "v");
  vtkTable* table = average.table();
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    const double r = valueAt(table, i, "radial");
    if (r < 1.05 || r > 1.95)
      continue;
    EXPECT_NEAR(valueAt(table, i, "v_axial"), 5.0, 1e-12);
    EXPECT_NEAR(valueAt(table, i, "v_radial"), 2.0, 0.01);
    EXPECT_NEAR(valueAt(table, i, "v_circumferential"), 3.0 * r, 0.05);
    EXPECT_NEAR(valueAt(table, i, "v_magnitude"), std::sqrt(4 + 9 * r * r + 25), 0.05);
  }
}

TEST(MeridionalAverage, ComponentsAndPlacesOfArrays)
{
  const Grid grid = ring(same);
  addField(grid, "v", 3, [](Vec p) { return Vec{p[0], p[1], 7.0}; });
  const auto columnOf = [](Average& average)
  { return std::string(average.table()->GetColumnName(3)); };
  Average third(grid, "v");
  third.filter->SetComponent(2);
  EXPECT_EQ(columnOf(third), "v:2");
  EXPECT_NEAR(valueAt(third.table(), 40, "v:2"), 7.0, 1e-9);
  EXPECT_NEAR(valueAt(third.table(), 40, "v:2_deviation"), 0.0, 1e-6);
  Average whole(grid, "v");
  whole.filter->SetComponent(vtkMoteMeridionalAverage::MAGNITUDE);
  EXPECT_EQ(columnOf(whole), "v:magnitude");
  const double r = valueAt(whole.table(), 40, "radial");
  EXPECT_NEAR(valueAt(whole.table(), 40, "v:magnitude"), std::hypot(r, 7.0), 0.02);
  // Points and cells have an array of one name.
  vtkNew<vtkDoubleArray> ofCells;
  ofCells->SetName("v");
  ofCells->SetNumberOfValues(grid->GetNumberOfCells());
  ofCells->Fill(3.0);
  grid->GetCellData()->AddArray(ofCells);
  Average cells(grid, "v");
  EXPECT_EQ(columnOf(cells), "v_axial");
  cells.filter->SetAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  EXPECT_EQ(columnOf(cells), "v");
  EXPECT_NEAR(valueAt(cells.table(), 40, "v"), 3.0, 1e-9);
}

TEST(MeridionalAverage, RangesTakeAPart)
{
  const Grid grid = ring(same);
  addField(grid, "f", 1, [](Vec p) { return Vec{3.0 * std::hypot(p[0], p[1]) + 2.0 * p[2]}; });
  const auto volumeOf = [](vtkTable* table)
  {
    double sum = 0.0;
    for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
      sum += valueAt(table, i, "volume");
    return sum;
  };
  Average average(grid, "f");
  const double all = volumeOf(average.table());
  average.filter->SetRadialRange(1.2, 1.5);
  average.filter->SetAxialRange(0.25, 9.0);
  vtkTable* table = average.table();
  EXPECT_NEAR(volumeOf(table) / all, 0.75 * (1.5 * 1.5 - 1.2 * 1.2) / 3.0, 0.005);
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    const double r = valueAt(table, i, "radial"), z = valueAt(table, i, "axial");
    EXPECT_TRUE(r > 1.2 && r < 1.5 && z > 0.25 && z < 1.0) << r << " " << z;
    EXPECT_NEAR(valueAt(table, i, "f"), 3.0 * r + 2.0 * z, 0.07);
  }
  const double* origin = average.filter->GetImage()->GetOrigin();
  EXPECT_NEAR(origin[0], 0.275, 1e-9); // bins are a fortieth of the diameter
  EXPECT_NEAR(origin[1], 1.225, 1e-9);
}

TEST(MeridionalAverage, AnyAxis)
{
  // The ring about another line: x, through (5, 1, -2).
  const Grid upright = ring(same);
  const Grid lying = ring([](Vec p) { return Vec{5.0 + p[2], 1.0 + p[0], -2.0 + p[1]}; });
  addField(upright, "f", 1, [](Vec p) { return Vec{p[0] * p[0] + p[2]}; });
  addField(lying, "f", 1, [](Vec p) { return Vec{(p[1] - 1) * (p[1] - 1) + p[0] - 5.0}; });
  Average a(upright, "f"), b(lying, "f");
  b.filter->SetAxis(10, 0, 0);
  b.filter->SetOrigin(5, 1, -2);
  vtkTable *first = a.table(), *second = b.table();
  ASSERT_EQ(first->GetNumberOfRows(), second->GetNumberOfRows());
  for (vtkIdType i = 0; i < first->GetNumberOfRows(); ++i)
    for (const char* column : {"axial", "radial", "volume", "f", "f_deviation"})
      EXPECT_NEAR(valueAt(first, i, column), valueAt(second, i, column), 1e-9);
}

TEST(MeridionalAverage, TheImageHoldsTheTable)
{
  const Grid grid = ring(same);
  addField(grid, "f", 1, [](Vec p) { return Vec{std::hypot(p[0], p[1])}; });
  Average average(grid, "f", 20);
  vtkTable* table = average.table();
  vtkImageData* image = average.filter->GetImage();
  EXPECT_EQ(image->GetDimensions()[0], 10); // heights 0 to 1 in bins of 0.1
  EXPECT_EQ(image->GetDimensions()[1], 20); // radii 0 to 2
  vtkDataArray* values = image->GetPointData()->GetArray("f");
  vtkDataArray* volumes = image->GetPointData()->GetArray("volume");
  vtkIdType row = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double at[3];
    image->GetPoint(i, at);
    if (volumes->GetComponent(i, 0) == 0.0)
    {
      EXPECT_TRUE(std::isnan(values->GetComponent(i, 0)));
      EXPECT_LT(at[1], 1.0);
      continue;
    }
    EXPECT_NEAR(at[0], valueAt(table, row, "axial"), 1e-12);
    EXPECT_NEAR(at[1], valueAt(table, row, "radial"), 1e-12);
    EXPECT_EQ(values->GetComponent(i, 0), valueAt(table, row, "f"));
    ++row;
  }
  EXPECT_EQ(row, table->GetNumberOfRows());
}

TEST(MeridionalAverage, ThePumpTurnsAboutItsOwnAxis)
{
  vtkNew<vtkMotePumpSource> source;
  source->SetScale(0.005);
  source->SetAxis(1, 1, 0);
  source->SetOrigin(3, 4, 5);
  source->Update();
  Average average(source->GetOutputDataObject(0), "velocity", 60);
  vtkTable* table = average.table();
  ASSERT_GT(table->GetNumberOfRows(), 500);
  double volume = 0.0;
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    volume += valueAt(table, i, "volume");
    const double r = valueAt(table, i, "radial") / 0.1, z = valueAt(table, i, "axial") / 0.1;
    const bool inPipe = r < 0.35 && z<-0.5, inRotor = r> 0.6 && r < 0.95 && z > 0.3;
    EXPECT_GT(valueAt(table, i, "velocity_axial"), inPipe ? 0.5 : -20.0);
    EXPECT_GT(valueAt(table, i, "velocity_circumferential"), inRotor ? 5.0 : -1.0);
  }
  EXPECT_NEAR(volume, 0.00375, 0.0001);
}

TEST(MeridionalAverage, OneCellOverManyBins)
{
  // The cube from (1, 0, 0) to (2, 1, 1), whose parts between two radii have known volumes.
  const auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 8; ++i)
    points->InsertNextPoint(1.0 + (i % 4 == 1 || i % 4 == 2), i % 4 > 1, i > 3);
  const vtkIdType ids[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  grid->SetPoints(points);
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
  addField(grid, "f", 1, [](Vec p) { return Vec{p[2]}; });
  // Of the square's part within a circle, by the integral of its height over x.
  const auto within = [](double radius)
  {
    constexpr int steps = 20000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
      sum += std::clamp(
        std::sqrt(std::max(0.0, radius * radius - std::pow(1.0 + (i + 0.5) / steps, 2))), 0.0, 1.0);
    return sum / steps;
  };
  for (const int resolution : {7, 40, 200})
  {
    Average average(grid, "f", resolution);
    vtkTable* table = average.table();
    const double size = std::sqrt(5.0) / resolution;
    double volume = 0.0, off = 0.0, largest = 0.0;
    std::map<double, double> areas;
    for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
    {
      const double r = valueAt(table, i, "radial"), z = valueAt(table, i, "axial");
      const double high = std::min(1.0, z + 0.5 * size), low = z - 0.5 * size;
      if (areas.count(r) == 0)
        areas[r] = within(r + 0.5 * size) - within(r - 0.5 * size);
      const double expected = areas[r] * (high - low), own = valueAt(table, i, "volume");
      volume += own;
      off += std::abs(own - expected);
      largest = std::max(largest, std::abs(own - expected));
      EXPECT_NEAR(valueAt(table, i, "f"), 0.5 * (low + high), 1e-9) << resolution;
    }
    EXPECT_NEAR(volume, 1.0, 1e-9) << resolution;
    EXPECT_LT(off, 0.004) << resolution; // of a volume of 1
    EXPECT_LT(largest, 0.01 * size * size) << resolution;
  }
}

TEST(MeridionalAverage, WrongRequestsGetASentence)
{
  const Grid grid = ring(same);
  addField(grid, "pair", 2, [](Vec) { return Vec{1, 2, 3}; });
  addField(grid, "nan", 1, [](Vec) { return Vec{std::nan("")}; });
  addField(grid, "f", 1, [](Vec) { return Vec{1.0}; });
  const auto sentence = [&](const char* name, double axis)
  {
    Average average(grid, name);
    vtkNew<vtkTest::ErrorObserver> errors, executive;
    average.filter->AddObserver(vtkCommand::ErrorEvent, errors);
    average.filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executive);
    average.filter->SetAxis(0, 0, axis);
    EXPECT_EQ(average.table()->GetNumberOfRows(), 0);
    return average.filter->GetErrorMessage();
  };
  EXPECT_NE(sentence("g", 1).find("no array of numbers named 'g'"), std::string::npos);
  EXPECT_NE(sentence("pair", 1).find("has 2 components"), std::string::npos);
  EXPECT_NE(sentence("nan", 1).find("finite value"), std::string::npos);
  EXPECT_NE(sentence("f", 0).find("axis needs"), std::string::npos);
  Average average(grid, "f");
  vtkNew<vtkTest::ErrorObserver> errors, executive;
  average.filter->AddObserver(vtkCommand::ErrorEvent, errors);
  average.filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executive);
  average.filter->SetRadialRange(5.0, 6.0);
  average.filter->Update();
  EXPECT_NE(average.filter->GetErrorMessage().find("ranges of place"), std::string::npos);
}

TEST(MeridionalAverage, NumbersThatAreTooLargeGetASentence)
{
  const auto sentence = [](double size, double value, int components)
  {
    const Grid grid = ring([=](Vec p) { return Vec{size * p[0], size * p[1], size * p[2]}; });
    addField(grid, "f", components, [=](Vec p) { return Vec{value * p[0], value, value}; });
    Average average(grid, "f");
    vtkNew<vtkTest::ErrorObserver> errors, executive;
    average.filter->AddObserver(vtkCommand::ErrorEvent, errors);
    average.filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executive);
    vtkTable* table = average.table();
    EXPECT_EQ(table->GetNumberOfRows() == 0, !average.filter->GetErrorMessage().empty());
    return average.filter->GetErrorMessage();
  };
  EXPECT_EQ(sentence(1e30, 1e30, 1), "");
  for (const int components : {1, 3})
    EXPECT_NE(sentence(1.0, 1e200, components).find("so large"), std::string::npos);
  EXPECT_NE(sentence(1e150, 1.0, 1).find("so large"), std::string::npos);
  EXPECT_NE(sentence(0.0, 1.0, 1).find("no cell with volume"), std::string::npos); // one place
}

} // namespace
