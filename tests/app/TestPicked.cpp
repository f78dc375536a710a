// What is picked: ids as ranges, the set through time, the list of it.

#include <base/Failure.h>
#include <settings/IdRanges.h>
#include <settings/Values.h>
#include <stage/PickedTable.h>
#include <stage/Stage.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <sstream>

using namespace mote::app;

namespace
{

/// Particles at (id, 0, 0) with these ids, a float and a word each.
vtkSmartPointer<vtkPolyData> particles(const std::vector<vtkIdType>& ids)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkIdTypeArray> names;
  vtkNew<vtkFloatArray> values;
  vtkNew<vtkStringArray> words;
  names->SetName("id");
  values->SetName("v");
  words->SetName("said, \"so\"");
  for (const vtkIdType id : ids)
  {
    points->InsertNextPoint(static_cast<double>(id), 0.0, 0.25);
    names->InsertNextValue(id);
    values->InsertNextValue(0.1f);
    words->InsertNextValue(id % 2 ? "odd" : "even, yes");
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(names);
  data->GetPointData()->AddArray(values);
  data->GetPointData()->AddArray(words);
  return data;
}

struct PickedTest : testing::Test
{
  Settings settings;
  ProgressRelay progress;
  std::unique_ptr<Stage> stage;
  PickedSet set;

  void show(const std::vector<NamedData>& data)
  {
    if (!stage)
      stage = std::make_unique<Stage>(settings);
    stage->setData(data);
    stage->build(progress);
    stage->applyColors();
  }
  void pick(int part, vtkIdType particle) { set.toggle({part, Picked::Kind::Particle, particle}); }
};

Picked particle(int part, vtkIdType id)
{
  return {part, Picked::Kind::Particle, id};
}

} // namespace

TEST(IdRanges, AreThoseOfTheirIds)
{
  std::mt19937 random(7);
  for (int trial = 0; trial < 200; ++trial)
  {
    std::set<std::int64_t> truth;
    std::vector<IdRange> ranges;
    for (int i = 0; i < 12; ++i)
    {
      const auto low = static_cast<std::int64_t>(random() % 60) - 20;
      const auto high = low + static_cast<std::int64_t>(random() % 6);
      ranges.push_back({static_cast<int>(random() % 3), low, high});
      for (std::int64_t id = low; ranges.back().part != 1 && id <= high; ++id)
        truth.insert(id);
    }
    const IdRanges ids(ranges);
    const auto second = ids.of(2);
    for (std::int64_t id = -30; id < 60; ++id)
      EXPECT_EQ(holds(second, id), truth.contains(id)) << id;
    // None meet, and words give the same again.
    for (std::size_t i = 1; i < second.size(); ++i)
      EXPECT_GT(second[i].first, second[i - 1].second + 1);
    const auto words = ValuesOf<IdRanges>::words(ids);
    EXPECT_EQ(ValuesOf<IdRanges>::parse(words, {}), ids);
    EXPECT_EQ(ids.with(ids), ids);
  }
}

TEST(IdRanges, HoldTheGreatestIds)
{
  const auto ids = ValuesOf<IdRanges>::parse({"9223372036854775807", "-9223372036854775808:3"}, {});
  EXPECT_TRUE(holds(ids.of(1), 9223372036854775807));
  EXPECT_FALSE(holds(ids.of(1), 4));
  EXPECT_EQ(ids.count(), 9223372036854775807);
  for (const char* wrong : {"", "x", "1:", "3:1", "0/4", "1/", "1.5", "9223372036854775808"})
    EXPECT_THROW((void)ValuesOf<IdRanges>::parse({wrong}, {}), WrongValue) << wrong;
}

TEST_F(PickedTest, IsInTheOrderOfPickingAndOnce)
{
  this->show({{"a", particles({5, 6, 7}), "a"}});
  this->pick(0, 2);
  set.add({particle(0, 0), particle(0, 2)});
  EXPECT_EQ(set.items(), (std::vector<Picked>{particle(0, 2), particle(0, 0)}));
  this->pick(0, 2);
  EXPECT_EQ(set.items(), (std::vector<Picked>{particle(0, 0)}));
  EXPECT_FALSE(set.contains(particle(0, 2)));
}

TEST_F(PickedTest, StaysThroughTimeById)
{
  this->show({{"a", particles({5, 6, 7, 8}), "a"}});
  set.add({particle(0, 3), particle(0, 1), particle(0, 0)});
  const auto names = set.names(stage->parts());
  this->show({{"a", particles({7, 8, 9, 6}), "a"}}); // 5 is gone
  set.findAgain(stage->parts(), names);
  EXPECT_EQ(set.items(), (std::vector<Picked>{particle(0, 1), particle(0, 3)}));
}

TEST_F(PickedTest, ComesBackWithDataThatHaveIt)
{
  this->show({{"a", particles({5, 6, 7, 8}), "a"}});
  set.add({particle(0, 3), particle(0, 1), particle(0, 0)}); // 8, 6, 5
  const auto next = [&](const std::vector<vtkIdType>& ids)
  {
    const auto names = set.names(stage->parts());
    this->show({{"a", particles(ids), "a"}});
    set.findAgain(stage->parts(), names);
  };
  next({8, 5, 9});
  EXPECT_EQ(set.items(), (std::vector<Picked>{particle(0, 0), particle(0, 1)}));
  EXPECT_EQ(set.numberAway(), 1u);
  EXPECT_EQ(ValuesOf<IdRanges>::words(set.ids(stage->parts())),
    (std::vector<std::string>{"5:6", "8"})); // whose paths are shown
  next({});
  EXPECT_TRUE(set.empty());
  EXPECT_TRUE(set.hasParticles());
  EXPECT_EQ(set.last(), nullptr);
  next({4, 5, 6, 7, 8});
  EXPECT_EQ(set.items(), (std::vector<Picked>{particle(0, 4), particle(0, 2), particle(0, 1)}));
  EXPECT_EQ(set.numberAway(), 0u);
  EXPECT_EQ(*set.last(), particle(0, 1));
  next({});
  set.clear();
  next({5, 6, 8});
  EXPECT_TRUE(set.empty());
}

TEST_F(PickedTest, KeepsCellsOfTheSameMeshAlone)
{
  const auto mesh = [](int cells)
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> triangles;
    for (int i = 0; i < cells + 2; ++i)
      points->InsertNextPoint(i, i % 2, 0.0);
    for (vtkIdType i = 0; i < cells; ++i)
      triangles->InsertNextCell({i, i + 1, i + 2});
    data->SetPoints(points);
    data->SetPolys(triangles);
    return data;
  };
  this->show({{"a", mesh(8), "a"}});
  set.toggle({0, Picked::Kind::Cell, 5});
  auto names = set.names(stage->parts());
  this->show({{"a", mesh(8), "a"}});
  set.findAgain(stage->parts(), names);
  EXPECT_EQ(set.items().size(), 1u);
  names = set.names(stage->parts());
  this->show({{"a", mesh(9), "a"}});
  set.findAgain(stage->parts(), names);
  EXPECT_TRUE(set.empty()); // cell 5 is another one
  EXPECT_FALSE(set.hasParticles());
}

TEST_F(PickedTest, NamesIdsOfTheirDataSets)
{
  this->show({{"a", particles({5, 6, 7, 8}), "a"}});
  set.add({particle(0, 3), particle(0, 2), particle(0, 0)});
  EXPECT_EQ(
    ValuesOf<IdRanges>::words(set.ids(stage->parts())), (std::vector<std::string>{"5", "7:8"}));
  stage.reset();
  set.clear();
  this->show({{"a", particles({5, 6}), "a"}, {"b", particles({5, 6}), "b"}});
  this->pick(1, 0);
  EXPECT_EQ(ValuesOf<IdRanges>::words(set.ids(stage->parts())), (std::vector<std::string>{"2/5"}));
}

TEST_F(PickedTest, HiddenIdsAreNotShown)
{
  settings.selection.hidden = IdRanges({{2, 5, 5}, {0, 7, 7}});
  this->show({{"a", particles({5, 6, 7}), "a"}, {"b", particles({5, 6, 7}), "b"}});
  EXPECT_EQ(stage->parts()[0]->numberShown(), 2);
  EXPECT_EQ(stage->parts()[1]->numberShown(), 1);
  settings.selection.hidden = {};
  settings.selection.only = IdRanges({{0, 6, 9}});
  settings.selection.where = "id < 7";
  stage->apply(settings);
  EXPECT_EQ(stage->numberShown(), 2);
  settings.selection = {};
  stage->apply(settings);
  EXPECT_EQ(stage->numberShown(), 6);
}

TEST_F(PickedTest, IsListedExactly)
{
  this->show({{"a", particles({5, 1234567890123}), "a"}});
  set.add({particle(0, 1), particle(0, 0)});
  const auto folder = std::filesystem::path(testing::TempDir()) / "picked";
  std::filesystem::create_directories(folder);
  const std::string file = (folder / "list.csv").string();
  writePicked(PickedTable(stage->parts(), set), file);
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  EXPECT_NE(text.str().find(",1234567890123,0.1,odd\n"), std::string::npos) << text.str();
  EXPECT_NE(text.str().find("\n0,5,0,0.25,5,0.1,odd\n"), std::string::npos) << text.str();
  EXPECT_EQ(text.str().find("index,x,y,z,id,v,\"said, \"\"so\"\"\"\n"), 0u) << text.str();
  // What cannot be written is told, and leaves what was there.
  EXPECT_THROW(
    writePicked(PickedTable(stage->parts(), set), (folder / "no" / "x.csv").string()), Failure);
  EXPECT_THROW(writePicked(PickedTable(stage->parts(), set), folder.string()), Failure);
  std::filesystem::remove_all(folder);
}

// A click in a cell asks for the values there, as long as the cell is there.
TEST_F(PickedTest, ValuesOfPointsAreThoseOfThePlace)
{
  const auto block = [](double shift)
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkDoubleArray> ofPoints, ofCells;
    for (int i = 0; i < 8; ++i)
    {
      const double x = (i ^ i >> 1) & 1, y = i >> 1 & 1, z = i >> 2;
      points->InsertNextPoint(x + shift, y, z);
      ofPoints->InsertNextValue(x + 2.0 * y);
    }
    ofCells->InsertNextValue(7.0);
    ofPoints->SetName("p");
    ofCells->SetName("p");
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetPoints(points);
    const vtkIdType corners[] = {0, 1, 2, 3, 4, 5, 6, 7};
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
    grid->GetPointData()->AddArray(ofPoints);
    grid->GetCellData()->AddArray(ofCells);
    return grid;
  };
  const auto line = [&]
  {
    std::string text;
    PickedTable(stage->parts(), set).appendLine(text, 0, ',');
    return text;
  };
  this->show({{"a", block(0.0), "a"}});
  const Picked cell{0, Picked::Kind::Cell, 0};
  set.toggle(cell);
  const std::string points = "0 (0 0 0); 1 (1 0 0); 2 (1 1 0); 3 (0 1 0); 4 (0 0 1); 5 (1 0 1); "
                             "6 (1 1 1); 7 (0 1 1)\n";
  EXPECT_EQ(line(), "0,0.5,0.5,0.5,0,1.5,7," + points) << "the middle, and the mean";
  set.setPlace(cell, {0.25, 0.5, 0.75});
  EXPECT_EQ(line(), "0,0.25,0.5,0.75,4,1.25,7," + points);
  const std::string json = asJson(PickedTable(stage->parts(), set));
  const auto rows = nlohmann::json::parse(json);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0]["cell"], 0);
  EXPECT_EQ(rows[0]["point:p"], 1.25);
  ASSERT_EQ(rows[0]["points"].size(), 8u);
  EXPECT_EQ(rows[0]["points"][6]["point"], 6);
  EXPECT_EQ(rows[0]["points"][6]["place"], (std::vector<double>{1.0, 1.0, 1.0}));
  std::string names;
  PickedTable(stage->parts(), set).appendNames(names, ',');
  EXPECT_EQ(names, "cell,x,y,z,nearest point,point:p,cell:p,points\n");
  for (const double shift : {0.0, 3.0})
  {
    const auto before = set.names(stage->parts());
    this->show({{"a", block(shift), "a"}});
    set.findAgain(stage->parts(), before);
    EXPECT_EQ(
      line().find(shift == 0.0 ? "0,0.25,0.5,0.75,4,1.25,7," : "0,3.5,0.5,0.5,0,1.5,7,"), 0u);
  }
}

// What is told under the cursor and in the list: ids beyond six digits are not rounded.
TEST(Picked, WholeNumbersHaveAllTheirDigits)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->InsertNextValue(2112481);
  ids->InsertNextValue(9007199254740993); // no double is this number
  vtkNew<vtkDoubleArray> values;
  values->InsertNextValue(2112481.5);
  vtkNew<vtkStringArray> words;
  words->InsertNextValue("copper");
  EXPECT_EQ(valueText(ids, 0, 0, 6), "2112481");
  EXPECT_EQ(valueText(ids, 0, 1, 6), "9007199254740993");
  EXPECT_EQ(valueText(values, 0, 0, 6), "2.11248e+06");
  EXPECT_EQ(valueText(values, 0, 0, 0), "2112481.5");
  EXPECT_EQ(valueText(words, 0, 0, 6), "copper");
}
