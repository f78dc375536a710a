// Streamlines of fields whose lines are known, and against those that VTK finds.

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellTypeSource.h>
#include <vtkDoubleArray.h>
#include <vtkMoteInterpolatedVelocityField.h>
#include <vtkMoteStreamlines.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamTracer.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnstructuredGrid.h>

#include <tbb/global_control.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// Cells of a type that fill [-2, 2]^2 x [low, high], with solid rotation about z and a speed along
/// it: U = (-y, x, 0.5), whose lines are helices, and the arrays height = z and same = 7.
Grid rotation(int type, double low = 0.0, double high = 4.0, int count = 8)
{
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(type);
  source->SetBlocksDimensions(count, count, count);
  source->SetOutputPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  Grid grid = source->GetOutput();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto names = {"U", "height", "same"};
  vtkNew<vtkDoubleArray> arrays[3];
  arrays[0]->SetNumberOfComponents(3);
  for (int k = 0; k < 3; ++k)
    arrays[k]->SetName(names.begin()[k]);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double p[3];
    grid->GetPoint(i, p);
    p[0] = 4.0 * p[0] / count - 2.0;
    p[1] = 4.0 * p[1] / count - 2.0;
    p[2] = low + (high - low) * p[2] / count;
    points->InsertNextPoint(p);
    arrays[0]->InsertNextTuple3(-p[1], p[0], 0.5);
    arrays[1]->InsertNextValue(p[2]);
    arrays[2]->InsertNextValue(7.0);
  }
  grid->SetPoints(points);
  while (grid->GetPointData()->GetNumberOfArrays() > 0)
    grid->GetPointData()->RemoveArray(0);
  while (grid->GetCellData()->GetNumberOfArrays() > 0)
    grid->GetCellData()->RemoveArray(0);
  for (const auto& array : arrays)
    grid->GetPointData()->AddArray(array);
  return grid;
}

/// Calls visit(previous point, point, index of the point) along each line.
void alongLines(
  vtkPolyData* lines, const std::function<void(const double*, const double*, vtkIdType)>& visit)
{
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (lines->GetLines()->InitTraversal(); lines->GetLines()->GetNextCell(count, ids);)
    for (vtkIdType k = 1; k < count; ++k)
    {
      double a[3], b[3];
      lines->GetPoint(ids[k - 1], a);
      lines->GetPoint(ids[k], b);
      visit(a, b, ids[k]);
    }
}

} // namespace

TEST(Streamlines, OfARotationAreHelices)
{
  for (const int type : {VTK_HEXAHEDRON, VTK_WEDGE, VTK_TETRA, VTK_PYRAMID})
  {
    SCOPED_TRACE(type);
    vtkNew<vtkMoteStreamlines> lines;
    lines->SetInputData(rotation(type));
    lines->SetNumberOfSeeds(40);
    lines->Update();
    vtkPolyData* found = lines->GetOutput();
    EXPECT_GE(found->GetNumberOfCells(), 55);
    EXPECT_EQ(lines->GetOutput(1)->GetNumberOfPoints(), 40);
    vtkDataArray* height = found->GetPointData()->GetArray("height");
    ASSERT_NE(height, nullptr);
    int steps = 0;
    double rises = 0.0, turns = 0.0;
    alongLines(found,
      [&](const double* a, const double* b, vtkIdType point)
      {
        ++steps;
        const double from = std::hypot(a[0], a[1]), to = std::hypot(b[0], b[1]);
        EXPECT_NEAR(from, to, 2e-5);
        EXPECT_NEAR(height->GetTuple1(point), b[2], 1e-6);
        rises += b[2] - a[2];
        turns += std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
      });
    EXPECT_GT(steps, 400);
    EXPECT_NEAR(rises, 0.5 * turns, 1e-4 * std::abs(rises));
  }
}

TEST(Streamlines, AreThoseOfVtk)
{
  const Grid grid = rotation(VTK_HEXAHEDRON);
  vtkNew<vtkPolyData> seeds;
  vtkNew<vtkPoints> places;
  for (int i = 0; i < 20; ++i)
    places->InsertNextPoint(0.1 + 0.09 * i, 0.03 * i, 0.2 + 0.15 * i);
  seeds->SetPoints(places);
  const auto traced = [&](vtkAbstractInterpolatedVelocityField* field)
  {
    vtkNew<vtkStreamTracer> tracer;
    tracer->SetInputData(grid);
    tracer->SetSourceData(seeds);
    tracer->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "U");
    tracer->SetIntegratorTypeToRungeKutta45();
    tracer->SetIntegrationDirectionToBoth();
    tracer->SetMaximumPropagation(9.0);
    if (field)
      tracer->SetInterpolatorPrototype(field);
    tracer->Update();
    return vtkSmartPointer<vtkPolyData>(tracer->GetOutput());
  };
  vtkNew<vtkMoteInterpolatedVelocityField> field;
  const auto ours = traced(field), theirs = traced(nullptr);
  ASSERT_EQ(ours->GetNumberOfPoints(), theirs->GetNumberOfPoints());
  ASSERT_GT(ours->GetNumberOfPoints(), 300);
  for (const char* name : {"IntegrationTime", "Vorticity", "Rotation", "same"})
    EXPECT_NE(ours->GetPointData()->GetArray(name), nullptr) << name;
  for (vtkIdType i = 0; i < ours->GetNumberOfPoints(); ++i)
  {
    double a[3], b[3];
    ours->GetPoint(i, a);
    theirs->GetPoint(i, b);
    for (int k = 0; k < 3; ++k)
      ASSERT_NEAR(a[k], b[k], 1e-5);
    double curl[3];
    ours->GetPointData()->GetArray("Vorticity")->GetTuple(i, curl);
    ASSERT_NEAR(curl[2], 2.0, 1e-5); // twice the angular velocity
    ASSERT_NEAR(ours->GetPointData()->GetArray("same")->GetTuple1(i), 7.0, 1e-9);
  }
}

TEST(Streamlines, GoOnThroughSeveralBlocks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, rotation(VTK_HEXAHEDRON, 0.0, 2.0));
  blocks->SetBlock(1, rotation(VTK_TETRA, 2.0, 4.0));
  vtkNew<vtkMoteStreamlines> lines;
  lines->SetInputDataObject(blocks);
  lines->SeedsOnLineOn();
  lines->SetPoint1(0.2, 0.0, 1.0);
  lines->SetPoint2(0.8, 0.0, 1.0);
  lines->SetNumberOfSeeds(4);
  lines->SetMaximumLength(20.0);
  lines->Update();
  EXPECT_EQ(lines->GetOutput(1)->GetNumberOfPoints(), 4);
  double bounds[6];
  lines->GetOutput()->GetBounds(bounds);
  EXPECT_LT(bounds[4], 0.1);
  EXPECT_GT(bounds[5], 3.9);
}

TEST(Streamlines, DoNotDependOnThreads)
{
  vtkSmartPointer<vtkPolyData> first;
  for (const std::size_t threads : {1, 4})
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    vtkNew<vtkMoteStreamlines> lines;
    lines->SetInputData(rotation(VTK_HEXAHEDRON));
    lines->SetNumberOfSeeds(64);
    lines->Update();
    if (!first)
      first = lines->GetOutput();
    ASSERT_EQ(lines->GetOutput()->GetNumberOfPoints(), first->GetNumberOfPoints());
    double all[2] = {0.0, 0.0};
    for (int k = 0; k < 2; ++k)
      for (vtkIdType i = 0; i < first->GetNumberOfPoints(); ++i)
        all[k] += (k == 0 ? first.Get() : lines->GetOutput())->GetPoint(i)[0];
    EXPECT_NEAR(all[0], all[1], 1e-9 * static_cast<double>(first->GetNumberOfPoints()));
  }
}

TEST(Streamlines, SeedsFillTheVolumeEvenly)
{
  // Cells are twice as thick in the upper half, so that there are as many seeds for each volume.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, rotation(VTK_HEXAHEDRON, 0.0, 1.0));
  blocks->SetBlock(1, rotation(VTK_HEXAHEDRON, 1.0, 4.0));
  vtkNew<vtkMoteStreamlines> lines;
  lines->SetInputDataObject(blocks);
  lines->SetNumberOfSeeds(4000);
  lines->ComputeLinesOff();
  lines->Update();
  EXPECT_EQ(lines->GetOutput()->GetNumberOfPoints(), 0);
  vtkPolyData* seeds = lines->GetOutput(1);
  ASSERT_EQ(seeds->GetNumberOfPoints(), 4000);
  int lower = 0, left = 0;
  for (vtkIdType i = 0; i < 4000; ++i)
  {
    lower += seeds->GetPoint(i)[2] < 1.0;
    left += seeds->GetPoint(i)[0] < 0.0;
    EXPECT_NEAR(
      seeds->GetPointData()->GetArray("height")->GetTuple1(i), seeds->GetPoint(i)[2], 1e-9);
  }
  EXPECT_NEAR(lower, 1000, 2);
  EXPECT_NEAR(left, 2000, 60);
}

TEST(Streamlines, VectorsOfCellsWillDo)
{
  const Grid grid = rotation(VTK_HEXAHEDRON);
  vtkNew<vtkDoubleArray> even;
  even->SetName("flow");
  even->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    even->InsertNextTuple3(1.0, 0.0, 0.0);
  grid->GetCellData()->AddArray(even);
  vtkNew<vtkMoteStreamlines> lines;
  lines->SetInputData(grid);
  lines->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "flow");
  lines->SetNumberOfSeeds(10);
  lines->Update();
  int steps = 0;
  alongLines(lines->GetOutput(),
    [&](const double* a, const double* b, vtkIdType)
    {
      ++steps;
      EXPECT_NEAR(a[1], b[1], 1e-12);
      EXPECT_NEAR(a[2], b[2], 1e-12);
    });
  EXPECT_GT(steps, 30);
}

TEST(Streamlines, WhatIsWrongIsASentence)
{
  const Grid grid = rotation(VTK_HEXAHEDRON);
  const auto said = [&](const char* name)
  {
    vtkNew<vtkMoteStreamlines> lines;
    vtkNew<vtkTest::ErrorObserver> errors;
    lines->AddObserver(vtkCommand::ErrorEvent, errors);
    lines->SetInputData(grid);
    lines->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
    lines->Update();
    EXPECT_TRUE(errors->GetError());
    EXPECT_EQ(lines->GetOutput()->GetNumberOfPoints(), 0);
    return lines->GetErrorMessage();
  };
  EXPECT_EQ(said("speed"), "Streamlines: there is no array 'speed'.");
  EXPECT_EQ(said("height"), "Streamlines need vectors of three components, and 'height' has 1.");
}
