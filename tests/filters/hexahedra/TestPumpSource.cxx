// The pump as a source of VTK: blocks, time, shared geometry, and a flow that keeps its promises.

#include "PumpTools.h"

#include <vtkCellArray.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{

constexpr double omega = 2.0 * 3.14159265358979323846 * 25.0, impeller = 0.1;

std::vector<double> values(vtkUnstructuredGrid* grid, const char* name)
{
  vtkDataArray* array = grid->GetPointData()->GetArray(name);
  std::vector<double> all;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      all.push_back(array->GetComponent(i, k));
  return all;
}

TEST(PumpSource, BlocksHaveNamesAndAxis)
{
  vtkNew<vtkMotePumpSource> source;
  source->SetScale(0.0005);
  source->SetAxis(0, 3, 0);
  source->SetOrigin(1, 2, 3);
  source->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(source->GetOutputDataObject(0));
  ASSERT_TRUE(blocks);
  ASSERT_EQ(blocks->GetNumberOfBlocks(), 3u);
  const char* names[3] = {"inlet", "rotor", "diffuser"};
  for (unsigned int i = 0; i < 3; ++i)
  {
    EXPECT_STREQ(blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()), names[i]);
    auto* grid = vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(i));
    ASSERT_TRUE(grid);
    EXPECT_STREQ(grid->GetPointData()->GetScalars()->GetName(), "pressure");
    EXPECT_STREQ(grid->GetPointData()->GetVectors()->GetName(), "velocity");
    EXPECT_EQ(grid->GetFieldData()->GetArray("AxisDirection")->GetComponent(0, 1), 1.0);
    EXPECT_EQ(grid->GetFieldData()->GetArray("AxisOrigin")->GetComponent(0, 2), 3.0);
  }
  source->SetPartToRotor();
  source->Update();
  EXPECT_TRUE(vtkUnstructuredGrid::SafeDownCast(source->GetOutputDataObject(0)));
  source->SetPartToAll();
  source->Update();
  EXPECT_TRUE(vtkMultiBlockDataSet::SafeDownCast(source->GetOutputDataObject(0)));
}

TEST(PumpSource, TimesShareTheirGeometry)
{
  vtkNew<vtkMotePumpSource> source;
  source->SetScale(0.0005);
  source->UpdateInformation();
  vtkInformation* info = source->GetOutputInformation(0);
  auto* key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  ASSERT_EQ(info->Length(key), 80);
  EXPECT_EQ(info->Get(key, 0), 0.0);
  EXPECT_NEAR(info->Get(key, 40), 0.02, 1e-12);
  vtkPoints* points[3] = {};
  vtkCellArray* cells[3] = {};
  vtkMTimeType pointTimes[3] = {}, cellTimes[3] = {};
  std::vector<double> before[3];
  for (int step = 0; step < 5; ++step)
  {
    source->UpdateTimeStep(info->Get(key, step));
    auto* blocks = vtkMultiBlockDataSet::SafeDownCast(source->GetOutputDataObject(0));
    for (unsigned int i = 0; i < 3; ++i)
    {
      auto* grid = vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(i));
      grid->GetBounds();
      if (step > 0)
      {
        EXPECT_EQ(grid->GetPoints(), points[i]);
        EXPECT_EQ(grid->GetCells(), cells[i]);
        EXPECT_EQ(grid->GetPoints()->GetMTime(), pointTimes[i]);
        EXPECT_EQ(grid->GetCells()->GetMTime(), cellTimes[i]);
        EXPECT_NE(values(grid, "pressure"), before[i]);
      }
      points[i] = grid->GetPoints();
      cells[i] = grid->GetCells();
      pointTimes[i] = points[i]->GetMTime();
      cellTimes[i] = cells[i]->GetMTime();
      before[i] = values(grid, "pressure");
    }
    EXPECT_EQ(blocks->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), info->Get(key, step));
  }
  source->SetScale(0.001);
  source->UpdateTimeStep(0.0);
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(source->GetOutputDataObject(0));
  EXPECT_NE(vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(0))->GetPoints(), points[0]);
}

TEST(PumpSource, ARevolutionEndsWhereItBegan)
{
  vtkNew<vtkMotePumpSource> source;
  source->SetScale(0.001);
  for (int part = 1; part <= 3; ++part)
  {
    source->SetPart(part);
    const auto at = [&](double time)
    {
      source->UpdateTimeStep(time);
      return values(vtkUnstructuredGrid::SafeDownCast(source->GetOutputDataObject(0)), "pressure");
    };
    const auto first = at(0.0), half = at(0.021), last = at(0.04);
    double change = 0.0;
    for (std::size_t i = 0; i < first.size(); ++i)
    {
      EXPECT_NEAR(first[i], last[i], 1.0); // Pa, of some 10,000
      change = std::max(change, std::abs(first[i] - half[i]));
    }
    EXPECT_GT(change, 1000.0);
  }
}

TEST(PumpSource, WaterClingsToWalls)
{
  // Every vertex of the boundary but where water enters or leaves: blades, hub and shroud move with
  // the impeller, vanes, pipe and volute not at all.
  vtkNew<vtkMotePumpSource> source;
  source->SetScale(0.004);
  const auto isOpen = [](int part, const Vec& p)
  {
    const double r = std::hypot(p[0], p[1]) / impeller, z = p[2] / impeller;
    const auto at = [](double a, double b) { return std::abs(a - b) < 1e-9; };
    return part == 1   ? at(z, 0.0) || at(z, -1.6)
           : part == 2 ? at(z, 0.0) || at(r, 1.0)
                       : at(r, 1.0) || at(p[1] / impeller, 1.5);
  };
  for (int part = 1; part <= 3; ++part)
  {
    vtkUnstructuredGrid* grid = partOf(source, part);
    const auto velocity = values(grid, "velocity");
    int atWall = 0;
    for (const auto& [corners, entry] : facesOf(grid))
      for (const vtkIdType i : corners)
      {
        const Vec p = pointOf(grid, i);
        if (entry.first > 1 || isOpen(part, p))
          continue;
        Vec v = {velocity[3 * i], velocity[3 * i + 1], velocity[3 * i + 2]};
        if (part == 2)
          v = v - Vec{-omega * p[1], omega * p[0], 0.0};
        ++atWall;
        ASSERT_LT(length(v), 2e-5) << part << ": " << p[0] << " " << p[1] << " " << p[2];
      }
    EXPECT_GT(atWall, 1000);
    EXPECT_GT(*std::max_element(velocity.begin(), velocity.end()), 1.5);
  }
}

TEST(PumpSource, PressureRises)
{
  vtkNew<vtkMotePumpSource> source;
  source->SetScale(0.005);
  double mean[3];
  for (int part = 1; part <= 3; ++part)
  {
    const auto p = values(partOf(source, part), "pressure");
    mean[part - 1] = 0.0;
    for (const double x : p)
      mean[part - 1] += x / static_cast<double>(p.size());
  }
  EXPECT_GT(mean[1], mean[0] + 2e4);
  EXPECT_GT(mean[2], mean[1] + 2e4);
}

TEST(PumpSource, PartsMeetWithOnePressure)
{
  // Averages over the circles where parts meet.
  vtkNew<vtkMotePumpSource> source;
  source->SetScale(0.02);
  const auto average = [&](int part, const auto& chosen)
  {
    vtkUnstructuredGrid* grid = partOf(source, part);
    const auto p = values(grid, "pressure");
    double sum = 0.0;
    int count = 0;
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      const Vec at = pointOf(grid, i);
      if (chosen(std::hypot(at[0], at[1]) / impeller, at[2] / impeller))
      {
        sum += p[i];
        ++count;
      }
    }
    EXPECT_GT(count, 50);
    return sum / count;
  };
  const auto eye = [](double r, double z) { return std::abs(z) < 1e-9 && r > 0.25 && r < 0.45; };
  const double pressure = 1000.0 * std::pow(omega * impeller, 2.0);
  EXPECT_NEAR(average(1, eye), average(2, eye), 0.03 * pressure);
  const auto outlet = [](double r, double) { return std::abs(r - 1.0) < 1e-9; };
  EXPECT_NEAR(average(2, outlet), average(3, outlet), 0.03 * pressure);
}

TEST(PumpSource, WrongSettingsAreRefused)
{
  const double nan = std::nan("");
  const auto messageOf = [&](const auto& set)
  {
    vtkNew<vtkMotePumpSource> source;
    vtkNew<vtkTest::ErrorObserver> errors, executive;
    source->AddObserver(vtkCommand::ErrorEvent, errors);
    source->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executive);
    source->SetScale(0.0005);
    set(source.Get());
    source->Update();
    return errors->GetErrorMessage();
  };
  EXPECT_NE(
    messageOf([](auto* s) { s->SetAxis(0, 0, 0); }).find("axis must have"), std::string::npos);
  EXPECT_NE(
    messageOf([&](auto* s) { s->SetOrigin(nan, 0, 0); }).find("origin must"), std::string::npos);
  EXPECT_NE(messageOf([&](auto* s) { s->SetRadius(-1); }).find("radius must"), std::string::npos);
  EXPECT_NE(
    messageOf([&](auto* s) { s->SetRotationRate(nan); }).find("rotation rate"), std::string::npos);
}

} // namespace
