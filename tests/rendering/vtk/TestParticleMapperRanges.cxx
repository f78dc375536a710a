// Ranges of several values at a time: arrays, centres, radii.
#include "VTKTestSupport.h"

#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <sstream>

using namespace mote::testing;

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Ranges : ::testing::Test
{
  static constexpr int count = 400;
  std::vector<Ball> balls = someBalls(count);
  vtkSmartPointer<vtkPolyData> data = makeParticles(balls);
  Stage stage{data};
  std::mt19937 engine{7};

  double random(double from, double to) { return from + (to - from) * (engine() / 4294967296.0); }

  template <typename Array, typename Value>
  std::vector<double> add(const char* name, const Value& value)
  {
    vtkNew<Array> array;
    array->SetName(name);
    array->SetNumberOfValues(count);
    std::vector<double> values(count);
    for (int i = 0; i < count; ++i)
    {
      array->SetValue(i, value(i));
      values[i] = static_cast<double>(array->GetValue(i));
    }
    data->GetPointData()->AddArray(array);
    return values;
  }

  /// The picture must be that of a mapper which was never given the hidden particles.
  void expectOnly(const std::function<bool(int)>& shown)
  {
    int wanted = 0;
    std::vector<Ball> some;
    std::vector<long long> ids;
    for (int i = 0; i < count; ++i)
      if (shown(i))
      {
        some.push_back(balls[i]);
        ids.push_back(i);
        ++wanted;
      }
    Stage subset(makeParticles(some));
    std::vector<long long> expected = subset.trace(96, 96).particles();
    for (long long& id : expected)
      id = id < 0 ? id : ids[id];
    const std::vector<long long> got = stage.trace(96, 96).particles();
    int wrong = 0;
    for (std::size_t i = 0; i < got.size(); ++i)
      wrong += got[i] != expected[i] ? 1 : 0;
    EXPECT_LE(wrong, 1) << "pixels"; // float coordinates about another origin
    EXPECT_EQ(stage.mapper->GetNumberOfVisibleParticles(), wanted);
  }
};

/// Particles in a row along x that do not touch, seen from the z axis, and which of them show.
struct Row
{
  Stage stage;

  Row(const std::vector<double>& x, double radius, vtkDataArray* values = nullptr)
  {
    std::vector<Ball> row;
    for (const double at : x)
      row.push_back({at, 0, 0, radius});
    auto data = makeParticles(row);
    if (values)
      data->GetPointData()->AddArray(values);
    stage.mapper->SetInputData(data);
  }
  std::vector<int> shown(double middle = 0.0)
  {
    stage.renderer->GetActiveCamera()->SetFocalPoint(middle, 0, 0);
    stage.renderer->GetActiveCamera()->SetPosition(middle, 0, 10);
    std::vector<int> ids;
    for (const long long id : stage.trace(256, 256).particles())
      if (id >= 0 && std::find(ids.begin(), ids.end(), id) == ids.end())
        ids.push_back(static_cast<int>(id));
    std::sort(ids.begin(), ids.end());
    return ids;
  }
};

} // namespace

TEST_F(Ranges, OfArraysOfEveryKind)
{
  const auto floats = add<vtkFloatArray>("f", [&](int) { return float(random(-1, 1)); });
  const auto doubles = add<vtkDoubleArray>("d", [&](int) { return random(-1, 1); });
  const auto words = add<vtkUnsignedShortArray>("u", [](int i) { return (i * 37) % 100; });
  const auto ids =
    add<vtkTypeInt64Array>("i", [](int i) { return (1LL << 40) + (i * 101) % count; });
  const auto in = [](double v, double low, double high) { return v >= low && v <= high; };
  EXPECT_TRUE(stage.mapper->AddRange("f", -0.5, 0.7));
  expectOnly([&](int i) { return in(floats[i], -0.5, 0.7); });
  EXPECT_TRUE(stage.mapper->AddRange("d", -0.8, 0.8));
  expectOnly([&](int i) { return in(floats[i], -0.5, 0.7) && in(doubles[i], -0.8, 0.8); });
  EXPECT_TRUE(stage.mapper->AddRange("u", 10, infinity));
  EXPECT_TRUE(stage.mapper->AddRange("i", (1LL << 40) + 50.0, (1LL << 40) + 350.0));
  const auto all = [&](int i)
  {
    return in(floats[i], -0.5, 0.7) && in(doubles[i], -0.8, 0.8) && words[i] >= 10 &&
           in(ids[i] - double(1LL << 40), 50, 350);
  };
  expectOnly(all);
  EXPECT_TRUE(stage.mapper->SetCenterRange(0, -0.6, 0.9));
  EXPECT_TRUE(stage.mapper->SetCenterRange(2, -infinity, 0.75));
  EXPECT_TRUE(stage.mapper->SetRadiusRange(0.06, 0.18));
  expectOnly(
    [&](int i)
    {
      return all(i) && in(balls[i].x, -0.6, 0.9) && balls[i].z <= 0.75 &&
             in(balls[i].r, 0.06, 0.18);
    });
  EXPECT_EQ(stage.mapper->GetNumberOfRanges(), 4);
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 1) << "no range builds a structure";
  stage.mapper->RemoveAllRanges();
  expectOnly([](int) { return true; });
}

TEST_F(Ranges, HoldTogetherWithTheVisibilityRange)
{
  const auto floats = add<vtkFloatArray>("f", [](int i) { return float(i % 10); });
  const auto other = add<vtkDoubleArray>("g", [](int i) { return i % 7; });
  stage.mapper->AddRange("f", 2, 7);
  stage.mapper->UseVisibilityRangeOn();
  stage.mapper->SetVisibilityArrayName("g");
  stage.mapper->SetVisibilityRange(1, 4);
  expectOnly(
    [&](int i) { return floats[i] >= 2 && floats[i] <= 7 && other[i] >= 1 && other[i] <= 4; });
  stage.mapper->RemoveAllRanges();
  expectOnly([&](int i) { return other[i] >= 1 && other[i] <= 4; });
}

TEST_F(Ranges, FifthArrayBesideTheVisibilityRange)
{
  for (const char* name : {"a", "b", "c", "d"})
  {
    add<vtkDoubleArray>(name, [&](int i) { return (i * (name[0] - 'a' + 3)) % 11; });
    stage.mapper->AddRange(name, 1, 9);
  }
  const auto last = add<vtkDoubleArray>("e", [](int i) { return i % 3; });
  stage.mapper->UseVisibilityRangeOn();
  stage.mapper->SetVisibilityArrayName("e");
  stage.mapper->SetVisibilityRange(1, 2);
  expectOnly(
    [&](int i)
    {
      bool in = last[i] >= 1;
      for (int k = 3; k < 7; ++k)
        in = in && (i * k) % 11 >= 1 && (i * k) % 11 <= 9;
      return in;
    });
}

TEST_F(Ranges, SecondRangeOfAnArrayTakesThePlaceOfTheFirst)
{
  const auto values = add<vtkFloatArray>("f", [](int i) { return float(i % 10); });
  stage.mapper->AddRange("f", 0, 3);
  stage.mapper->AddRange("f", 5, 8);
  EXPECT_EQ(stage.mapper->GetNumberOfRanges(), 1);
  expectOnly([&](int i) { return values[i] >= 5 && values[i] <= 8; });
  stage.mapper->RemoveRange("f");
  EXPECT_EQ(stage.mapper->GetNumberOfRanges(), 0);
  expectOnly([](int) { return true; });
}

TEST_F(Ranges, WithGapsShowWhatLiesInAnyOfTheirParts)
{
  const auto types = add<vtkUnsignedShortArray>("type", [](int i) { return i % 10; });
  const auto doubles = add<vtkDoubleArray>("d", [&](int) { return random(-1, 1); });
  EXPECT_TRUE(stage.mapper->AddToRange("type", 0, 7, 7));
  expectOnly([&](int i) { return types[i] == 7; });
  EXPECT_TRUE(stage.mapper->AddToRange("type", 0, 1, 3));
  const auto typed = [&](int i) { return types[i] == 7 || (types[i] >= 1 && types[i] <= 3); };
  expectOnly(typed);
  EXPECT_TRUE(stage.mapper->AddToRange("d", 0, -0.7, -0.2));
  EXPECT_TRUE(stage.mapper->AddToRange("d", 0, 0.1, infinity));
  const auto both = [&](int i)
  { return typed(i) && ((doubles[i] >= -0.7 && doubles[i] <= -0.2) || doubles[i] >= 0.1); };
  expectOnly(both);
  EXPECT_TRUE(stage.mapper->SetCenterRange(0, -0.6, 0.9));
  expectOnly([&](int i) { return both(i) && balls[i].x >= -0.6 && balls[i].x <= 0.9; });
  EXPECT_EQ(stage.mapper->GetNumberOfRanges(), 2);
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 1) << "no range builds a structure";
  // What closes the gaps, and what overlaps, leaves one range; another takes its place.
  stage.mapper->SetCenterRange(0, -infinity, infinity);
  stage.mapper->RemoveRange("d");
  EXPECT_TRUE(stage.mapper->AddToRange("type", 0, 2, 8));
  expectOnly([&](int i) { return types[i] >= 1 && types[i] <= 8; });
  EXPECT_TRUE(stage.mapper->AddToRange("type", 0, 9.5, 10));
  EXPECT_TRUE(stage.mapper->AddRange("type", 0, 4, 5));
  expectOnly([&](int i) { return types[i] == 4 || types[i] == 5; });
  Complaints complaints(stage.mapper);
  EXPECT_FALSE(stage.mapper->AddToRange("type", 0, 2, 1));
  EXPECT_FALSE(stage.mapper->AddToRange("", 0, 1, 2));
  EXPECT_EQ(complaints.errors, 2);
}

TEST_F(Ranges, ComponentsAndMagnitude)
{
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("v");
  vectors->SetNumberOfComponents(3);
  for (int i = 0; i < count; ++i)
    vectors->InsertNextTuple3(i % 3, i % 5, i % 4);
  data->GetPointData()->AddArray(vectors);
  stage.mapper->AddRange("v", 1, 2, 4);
  expectOnly([](int i) { return i % 5 >= 2; });
  stage.mapper->AddRange("v", 2, 1, 1);
  expectOnly([](int i) { return i % 5 >= 2 && i % 4 == 1; });
  stage.mapper->RemoveAllRanges();
  const auto length = [](int i)
  { return std::sqrt(i % 3 * (i % 3) + i % 5 * (i % 5) + i % 4 * (i % 4)); };
  stage.mapper->AddRange("v", -1, 2, std::sqrt(14.0));
  expectOnly([&](int i) { return length(i) >= 2 && length(i) <= std::sqrt(14.0); });
}

TEST_F(Ranges, NaNIsInNone)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  add<vtkFloatArray>("f", [&](int i) { return i == 3 ? float(nan) : float(i); });
  add<vtkDoubleArray>("d", [&](int i) { return i == 4 ? nan : i * 0.1; });
  stage.mapper->AddRange("f", -infinity, infinity);
  expectOnly([](int i) { return i != 3; });
  stage.mapper->AddRange("d", -infinity, 1000);
  expectOnly([](int i) { return i != 3 && i != 4; });
}

TEST_F(Ranges, FollowValuesChangedInPlaceAndRebuilds)
{
  auto values = add<vtkFloatArray>("f", [](int i) { return float(i % 10); });
  stage.mapper->AddRange("f", 3, 6);
  const auto in = [&](int i) { return values[i] >= 3 && values[i] <= 6; };
  expectOnly(in);
  vtkDataArray* array = data->GetPointData()->GetArray("f");
  array->SetTuple1(0, values[0] = 4);
  array->Modified();
  expectOnly(in);
  data->GetPoints()->Modified();
  expectOnly(in);
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 2);
}

TEST_F(Ranges, StructureKeepsValuesOnlyWhileARangeUsesThem)
{
  add<vtkFloatArray>("f", [](int i) { return float(i); });
  stage.mapper->Update();
  const auto bytes = stage.mapper->GetStructureBytes();
  stage.mapper->AddRange("f", 3, 6);
  stage.mapper->Update();
  stage.mapper->RemoveAllRanges();
  stage.mapper->Update();
  EXPECT_LE(stage.mapper->GetStructureBytes(), bytes + 4 * count);
}

TEST_F(Ranges, WhatIsNoRangeIsAnErrorAndChangesNothing)
{
  add<vtkFloatArray>("f", [](int i) { return float(i); });
  Complaints complaints(stage.mapper);
  EXPECT_FALSE(stage.mapper->AddRange("f", 2, 1));
  EXPECT_FALSE(stage.mapper->AddRange("f", std::nan(""), 1));
  EXPECT_FALSE(stage.mapper->AddRange(nullptr, 0, 1));
  EXPECT_FALSE(stage.mapper->AddRange("", 0, 1));
  EXPECT_FALSE(stage.mapper->SetCenterRange(3, 0, 1));
  EXPECT_FALSE(stage.mapper->SetCenterRange(0, 1, 0));
  EXPECT_FALSE(stage.mapper->SetRadiusRange(1, 0));
  EXPECT_EQ(complaints.errors, 7);
  for (const char* name : {"a", "b", "c", "d"})
    EXPECT_TRUE(stage.mapper->AddRange(name, 0, 1));
  EXPECT_FALSE(stage.mapper->AddRange("e", 0, 1));
  EXPECT_NE(complaints.text.find("4 arrays"), std::string::npos) << complaints.text;
  EXPECT_EQ(stage.mapper->GetNumberOfRanges(), 4);
  stage.mapper->RemoveAllRanges();
  expectOnly([](int) { return true; });
}

TEST_F(Ranges, MissingArrayIsAnErrorOnceAndTheOthersHold)
{
  const auto values = add<vtkFloatArray>("f", [](int i) { return float(i % 10); });
  Complaints complaints(stage.mapper);
  stage.mapper->AddRange("f", 3, 6);
  stage.mapper->AddRange("nothing", 3, 6);
  expectOnly([&](int i) { return values[i] >= 3 && values[i] <= 6; });
  stage.trace();
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_NE(complaints.text.find("\"nothing\""), std::string::npos) << complaints.text;
  EXPECT_NE(complaints.text.find("radius, f"), std::string::npos) << complaints.text;
}

TEST_F(Ranges, PrintSelfTellsThem)
{
  stage.mapper->AddRange("pe", 1, -3, 4);
  stage.mapper->SetCenterRange(1, -infinity, 5);
  std::ostringstream text;
  stage.mapper->Print(text);
  EXPECT_NE(text.str().find("Range of pe, component 1: -3 4"), std::string::npos);
  EXPECT_NE(text.str().find("Range of Center y: -inf 5"), std::string::npos);
}

TEST(RangeLimits, PlanesOfALatticeLieOnTheirSide)
{
  // Float cannot tell such coordinates from their neighbours; the ranges must.
  for (const double offset : {0.0, 1.0 / 3.0, 1e4 + 0.1, -1e6 / 7.0})
  {
    std::vector<double> x;
    for (int i = 0; i < 11; ++i)
      x.push_back(offset + 0.1 * i);
    Row row(x, 0.02);
    const auto expect = [&](double from, int first)
    {
      row.stage.mapper->SetCenterRange(0, from, infinity);
      std::vector<int> wanted;
      for (int i = first; i < 11; ++i)
        wanted.push_back(i);
      EXPECT_EQ(row.shown(offset + 0.5), wanted) << offset;
      EXPECT_EQ(row.stage.mapper->GetNumberOfVisibleParticles(), 11 - first) << offset;
    };
    for (int i = 0; i < 11; ++i)
    {
      expect(x[i], i);
      expect(std::nextafter(x[i], infinity), i + 1);
    }
  }
}

TEST(RangeLimits, AreExactWhereFloatIsNot)
{
  // Seven particles, values a double apart around one float.
  std::vector<double> x, values;
  double v = std::nextafter(0.1, 0.0);
  v = std::nextafter(v, 0.0);
  v = std::nextafter(v, 0.0);
  vtkNew<vtkDoubleArray> array;
  array->SetName("d");
  for (int i = 0; i < 7; ++i)
  {
    x.push_back(-1.2 + 0.4 * i);
    values.push_back(v);
    array->InsertNextValue(v);
    v = std::nextafter(v, 1.0);
  }
  Row row(x, 0.15, array);
  const auto ids = [](int from, int to)
  {
    std::vector<int> list;
    for (int i = from; i <= to; ++i)
      list.push_back(i);
    return list;
  };
  for (int from = 0; from < 7; ++from)
    for (int to = from; to < 7; ++to)
    {
      row.stage.mapper->AddRange("d", values[from], values[to]);
      EXPECT_EQ(row.shown(), ids(from, to));
    }
  // With another range at the same time, and then without the first.
  row.stage.mapper->SetCenterRange(0, x[2], x[4]);
  row.stage.mapper->AddRange("d", values[3], values[6]);
  EXPECT_EQ(row.shown(), ids(3, 4));
  row.stage.mapper->RemoveRange("d");
  EXPECT_EQ(row.shown(), ids(2, 4));
}

TEST(RangeLimits, OfCentresAreThoseOfTheInput)
{
  std::vector<double> x;
  for (int i = 0; i < 7; ++i)
    x.push_back(-1.2 + 0.4 * i);
  // Two at places that float takes for one.
  x.push_back(std::nextafter(x[3], 1.0));
  Row row(x, 0.15);
  row.stage.mapper->SetCenterRange(0, x[7], infinity);
  EXPECT_EQ(row.shown(), (std::vector<int>{4, 5, 6, 7}));
  row.stage.mapper->SetCenterRange(0, -infinity, x[3]);
  EXPECT_EQ(row.shown(), (std::vector<int>{0, 1, 2, 3}));
}

TEST(RangeLimits, OfRadiiAreThoseDrawn)
{
  Stage stage(makeParticles({{-1, 0, 0, 0.1}, {0, 0, 0, 0.2}, {1, 0, 0, 0.3}}));
  stage.mapper->SetRadiusScale(2.0);
  stage.mapper->SetRadiusRange(0.2, 0.4);
  stage.mapper->Update();
  EXPECT_EQ(stage.mapper->GetNumberOfVisibleParticles(), 2);
  stage.mapper->SetRadiusRange(0.2 * 2.0, infinity);
  stage.mapper->Update();
  EXPECT_EQ(stage.mapper->GetNumberOfVisibleParticles(), 2);
  stage.mapper->SetRadiusRange(std::nextafter(0.4, 1.0), infinity);
  stage.mapper->Update();
  EXPECT_EQ(stage.mapper->GetNumberOfVisibleParticles(), 1);
  double range[2];
  stage.mapper->GetRadiusRange(range);
  EXPECT_EQ(range[1], infinity);
  // One radius for all, from the spacing.
  stage.mapper->RemoveAllRanges();
  stage.mapper->SetRadiusModeToSpacing();
  stage.mapper->Update();
  const double radius = stage.mapper->GetRadiusInUse();
  stage.mapper->SetRadiusRange(radius, radius);
  EXPECT_GT(stage.trace().covered(), 0);
  EXPECT_EQ(stage.mapper->GetNumberOfVisibleParticles(), 3);
}
