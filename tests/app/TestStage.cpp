// The stage follows settings by value: what does not change is not touched.

#include <stage/Advice.h>
#include <stage/SideBySide.h>
#include <stage/Stage.h>

#include <gtest/gtest.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkLookupTable.h>
#include <vtkMath.h>
#include <vtkMoteParticleMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <array>
#include <set>

using namespace mote::app;

namespace
{

vtkSmartPointer<vtkPolyData> typedParticles(int count)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkIntArray> types;
  types->SetName("type");
  for (int i = 0; i < count; ++i)
  {
    points->InsertNextPoint(vtkMath::Random(), vtkMath::Random(), 10.0 + i);
    types->InsertNextValue(1 + i % 3);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(types);
  return data;
}

class StageTest : public testing::Test
{
protected:
  StageTest()
  {
    settings.data.files = {"particles"};
    settings.particles.typeRadius = {{1, 0.1}, {2, 0.2}};
  }

  /// A stage of `data` with these settings, built.
  Stage& show(vtkPolyData* data)
  {
    stage = std::make_unique<Stage>(settings);
    stage->setData({{"particles", data, "particles"}});
    stage->build(progress);
    stage->applyColors();
    return *stage;
  }
  std::vector<double> range() const
  {
    const double* ends = stage->coloring().table()->GetTableRange();
    return {ends[0], ends[1]};
  }
  vtkMoteParticleMapper* mapper() const { return stage->parts().front()->particles(); }

  Settings settings;
  ProgressRelay progress;
  std::unique_ptr<Stage> stage;
};

} // namespace

TEST_F(StageTest, CameraAndPictureLeaveTheMapperAlone)
{
  this->show(typedParticles(100));
  const vtkMTimeType before = mapper()->GetMTime();
  settings.camera.camera = {0, 0, 10, 0, 0, 0, 0, 1, 0, 30};
  EXPECT_FALSE(stage->apply(settings));
  settings.picture.legend = false;
  settings.picture.background = {{1.0, 1.0, 1.0}};
  EXPECT_FALSE(stage->apply(settings));
  settings.light.shadows = "soft";
  settings.silhouettes.lines = "on";
  EXPECT_FALSE(stage->apply(settings));
  EXPECT_EQ(mapper()->GetMTime(), before);
  settings.particles.radiusScale = 2.0;
  EXPECT_TRUE(stage->apply(settings));
  EXPECT_GT(mapper()->GetMTime(), before);
}

TEST_F(StageTest, CoordinatesColourWithoutAnotherStructure)
{
  const auto data = typedParticles(100);
  settings.color.array = "none";
  this->show(data);
  EXPECT_EQ(mapper()->GetNumberOfBuilds(), 1);
  settings.color.array = "z";
  stage->apply(settings);
  mapper()->Update();
  EXPECT_EQ(mapper()->GetNumberOfBuilds(), 1);
  EXPECT_EQ(stage->settingsInForce().color.array, "z");
  EXPECT_EQ(range(), (std::vector<double>{10.0, 109.0}));
  vtkDataArray* array = data->GetPointData()->GetArray("z");
  ASSERT_NE(array, nullptr);
  EXPECT_EQ(array->GetTuple1(7), 17.0);
}

TEST_F(StageTest, ExpressionsLeaveTheStructureWhereRadiiAreOfTheSpacing)
{
  settings.particles = {};
  this->show(typedParticles(100));
  EXPECT_EQ(mapper()->GetNumberOfBuilds(), 1);
  const double radius = mapper()->GetRadiusInUse();
  settings.selection.where = "z > 50";
  stage->apply(settings);
  stage->build(progress);
  stage->applyColors();
  EXPECT_EQ(stage->numberShown(), 59);
  settings.data.calculations = {{"double", "2*z"}};
  stage->apply(settings);
  stage->build(progress);
  EXPECT_EQ(mapper()->GetNumberOfBuilds(), 1);
  // At another time they keep their size.
  const auto later = typedParticles(100);
  later->GetPoints()->SetPoint(0, -100.0, 0.0, 0.0);
  stage->setData({{"particles", later, "particles"}});
  stage->build(progress);
  EXPECT_EQ(mapper()->GetNumberOfBuilds(), 2);
  EXPECT_EQ(mapper()->GetRadiusInUse(), radius);
}

TEST_F(StageTest, AnArrayOfThatNameComesFirst)
{
  const auto data = typedParticles(10);
  vtkNew<vtkFloatArray> own;
  own->SetName("x");
  for (int i = 0; i < 10; ++i)
    own->InsertNextValue(static_cast<float>(100 * i));
  data->GetPointData()->AddArray(own);
  settings.color.array = "x";
  this->show(data);
  EXPECT_EQ(range(), (std::vector<double>{0.0, 900.0}));
}

TEST_F(StageTest, TypesKeepTheirColoursOverTimeSteps)
{
  const auto first = typedParticles(9), second = typedParticles(9);
  for (int i = 0; i < 9; ++i)
    second->GetPointData()->GetArray("type")->SetTuple1(i, i % 2 == 0 ? 3 : 7);
  this->show(first);
  EXPECT_TRUE(stage->settingsInForce().color.types.empty()) << "what a fresh look finds, too";
  stage->setData({{"particles", second, "particles"}});
  stage->build(progress);
  stage->applyColors();
  EXPECT_EQ(stage->settingsInForce().color.types, (std::vector<int>{1, 2, 3, 7}));
  // Who opens the session at that step sees the same colours.
  const Settings kept = stage->settingsInForce();
  settings = kept;
  this->show(second);
  EXPECT_EQ(stage->settingsInForce().color.types, kept.color.types);
  settings.color.types = {7, 3};
  this->show(first);
  EXPECT_EQ(stage->settingsInForce().color.types, (std::vector<int>{7, 3}));
}

TEST_F(StageTest, ManyTypesHaveColoursOfTheirOwn)
{
  const auto data = typedParticles(84);
  for (int i = 0; i < 84; ++i)
    data->GetPointData()->GetArray("type")->SetTuple1(i, 1 + i % 14);
  settings.color.array = "type";
  settings.color.typeColors = {{3, {1.0, 0.0, 0.0}}, {99, {0.0, 0.0, 0.0}}};
  this->show(data);
  ASSERT_TRUE(stage->coloring().isTyped());
  vtkLookupTable* table = stage->coloring().legendTable();
  ASSERT_EQ(table->GetNumberOfTableValues(), 14);
  std::set<std::array<double, 3>> colors;
  for (int i = 0; i < 14; ++i)
  {
    const double* c = table->GetTableValue(i);
    colors.insert({c[0], c[1], c[2]});
  }
  EXPECT_EQ(colors.size(), 14u);
  EXPECT_TRUE(colors.count({1.0, 0.0, 0.0}));
}

TEST_F(StageTest, RangesAreSaidWhereOtherTimeStepsHaveWidenedThem)
{
  settings.color.array = "z";
  this->show(typedParticles(100));
  EXPECT_TRUE(stage->settingsInForce().color.range.empty()) << "what a fresh look finds, too";
  stage->setData({{"particles", typedParticles(10), "particles"}});
  stage->build(progress);
  stage->applyColors();
  EXPECT_EQ(stage->settingsInForce().color.range, (std::vector<double>{10.0, 109.0}));
}

TEST_F(StageTest, PercentilesLeaveOutliersOutAndTheLegendSaysSo)
{
  const auto data = typedParticles(1001);
  data->GetPoints()->SetPoint(7, 0.0, 0.0, 1e6);
  settings.color.array = "z";
  this->show(data);
  vtkLookupTable* table = stage->coloring().table();
  EXPECT_EQ(this->range(), (std::vector<double>{10.0, 1e6}));
  EXPECT_EQ(table->GetUseAboveRangeColor(), 0);
  double most[2];
  ASSERT_TRUE(stage->coloring().rangeOfMost(stage->parts(), most));
  EXPECT_NEAR(most[0], 20.0, 1.5);
  EXPECT_NEAR(most[1], 1000.0, 1.5);

  settings.color.percentiles = {0.0, 99.0};
  stage->apply(settings);
  stage->applyColors();
  table = stage->coloring().table();
  EXPECT_EQ(table->GetRange()[0], 10.0);
  EXPECT_NEAR(table->GetRange()[1], 1000.0, 1.5);
  EXPECT_EQ(table->GetUseBelowRangeColor(), 0) << "there is nothing below";
  ASSERT_EQ(table->GetUseAboveRangeColor(), 1);
  double last[3];
  table->GetColor(table->GetRange()[1], last);
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(table->GetAboveRangeColor()[c], last[c], 0.01);
  EXPECT_EQ(stage->settingsInForce().color.percentiles, settings.color.percentiles);

  settings.color.percentiles.clear();
  stage->apply(settings);
  stage->applyColors();
  EXPECT_EQ(this->range(), (std::vector<double>{10.0, 1e6})) << "back to all";
}

TEST_F(StageTest, UnionsOfValuesAreShown)
{
  settings.selection.ranges = {{"type", {{1, 1}, {3, 3}}}};
  this->show(typedParticles(99));
  EXPECT_EQ(stage->numberShown(), 66);
  settings.selection.ranges = {{"type", {{2, 2}}}};
  stage->apply(settings);
  EXPECT_EQ(stage->numberShown(), 33);
}

TEST_F(StageTest, ViewsComeNearestToSquares)
{
  EXPECT_EQ(rowsOf(1, 100, 900), 1);
  EXPECT_EQ(rowsOf(2, 1000, 600), 1);
  EXPECT_EQ(rowsOf(2, 400, 900), 2);
  EXPECT_EQ(rowsOf(3, 1800, 600), 1);
  EXPECT_EQ(rowsOf(3, 600, 1800), 3);
  EXPECT_EQ(rowsOf(4, 1280, 860), 2);
  EXPECT_EQ(rowsOf(4, 1600, 300), 1);
}

TEST_F(StageTest, FilesOfUnlikeSizeAreTold)
{
  stage = std::make_unique<Stage>(settings);
  const auto small = typedParticles(3), large = typedParticles(2000);
  const auto with = [&](vtkPolyData* one, vtkPolyData* other, const std::string& file)
  {
    stage->setData({{"one", one, "one.dump"}, {"other", other, file}});
    stage->build(progress);
    stage->applyColors();
    return unlikeSizes(*stage);
  };
  EXPECT_EQ(with(small, small, "other.dump"), "");
  const std::string told = with(small, large, "other.dump");
  EXPECT_NE(told.find("other.dump is 2e+03 across"), std::string::npos) << told;
  EXPECT_NE(told.find("--hide-data 2"), std::string::npos) << told;
  EXPECT_EQ(with(small, large, "one.dump"), "") << "parts of one file belong together";
}

TEST_F(StageTest, WhatLeavesNothingIsNamed)
{
  const auto said = [&] { return whatLeavesNothing(*stage); };
  settings.selection.ranges = {{"type", {{1.0, 2.0}}}};
  this->show(typedParticles(9));
  EXPECT_EQ(said(), "");
  settings.selection.ranges = {{"z", {{10.0, 12.0}}}, {"type", {{5.0, 6.0}}}};
  this->show(typedParticles(9));
  EXPECT_NE(said().find("type goes from 1 to 3"), std::string::npos) << said();
  settings.selection.ranges = {{"type", {{1.0, 1.0}}}};
  settings.selection.where = "type > 1";
  this->show(typedParticles(9));
  EXPECT_NE(said().find("together none"), std::string::npos) << said();
  settings.selection.where = "type > 7";
  this->show(typedParticles(9));
  EXPECT_NE(said().find("--where 'type > 7' leaves no particle"), std::string::npos) << said();
}

TEST_F(StageTest, ViewsOfFilesWithOtherTimesTellTheirSteps)
{
  stage = std::make_unique<Stage>(settings);
  NamedData one{"one", typedParticles(3), "one.dump", 2, 7, true};
  stage->setData({one, {"other", typedParticles(3), "other.dump", 4, 9, false}});
  EXPECT_EQ(stage->viewName({0}), "one, step 3/7");
  EXPECT_EQ(stage->viewName({1}), "other");
}
