// Which array a user sees without asking, and which one is meant by a name.

#include "base/Failure.h"
#include "stage/Arrays.h"

#include <gtest/gtest.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>

using namespace mote::app;

namespace
{

template <class Array>
void add(vtkPolyData* data, const char* name, int components, double slope, double offset = 0.0)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    for (int c = 0; c < components; ++c)
      array->SetComponent(i, c, offset + slope * i);
  data->GetPointData()->AddArray(array);
}

class Arrays : public testing::Test
{
protected:
  void SetUp() override
  {
    vtkNew<vtkPoints> points;
    for (int i = 0; i < 4; ++i)
      points->InsertNextPoint(i, 0, 0);
    data->SetPoints(points);
    add<vtkIdTypeArray>(data, "id", 1, 1.0);
    add<vtkDoubleArray>(data, "radius", 1, 0.1, 1.0);
    add<vtkIntArray>(data, "type", 1, 1.0, 1.0);
  }
  std::string best() { return rankedArrays(data).front().name; }
  vtkNew<vtkPolyData> data;
};

} // namespace

TEST_F(Arrays, TheMostTellingComesFirst)
{
  EXPECT_EQ(best(), "type");
  add<vtkDoubleArray>(data, "v", 3, 1.0);
  EXPECT_EQ(best(), "v");
  EXPECT_EQ(rankedArrays(data).front().component, ArrayChoice::magnitude);
  add<vtkDoubleArray>(data, "constant", 1, 0.0, 7.0);
  EXPECT_EQ(best(), "v");
  add<vtkDoubleArray>(data, "damage", 1, 0.25);
  EXPECT_EQ(best(), "damage");
  for (const ArrayChoice& choice : rankedArrays(data))
    EXPECT_TRUE(choice.name != "id" && choice.name != "radius") << choice.name;
}

TEST_F(Arrays, WhatAScannerSaysOfItselfColorsNothing)
{
  add<vtkDoubleArray>(data, "intensity", 1, 0.25);
  EXPECT_EQ(best(), "intensity");
  add<vtkDoubleArray>(data, "confidence", 1, 0.25);
  for (const ArrayChoice& choice : rankedArrays(data))
    EXPECT_TRUE(choice.name != "intensity" && choice.name != "confidence") << choice.name;
  const auto others = otherArrays(data);
  EXPECT_EQ(
    std::count_if(others.begin(), others.end(),
      [](const ArrayChoice& one) { return one.name == "intensity" || one.name == "confidence"; }),
    2);
}

TEST_F(Arrays, NamesAreFound)
{
  add<vtkDoubleArray>(data, "v", 2, 1.0);
  add<vtkDoubleArray>(data, "odd:name", 1, 1.0);
  data->GetPointData()->GetArray("v")->SetComponentName(1, "vy");
  EXPECT_EQ(findArray(data, "v").component, ArrayChoice::magnitude);
  EXPECT_EQ(findArray(data, "v:0").component, 0);
  EXPECT_EQ(findArray(data, "v:vy").component, 1);
  EXPECT_EQ(findArray(data, "vy"), findArray(data, "v:vy"));
  EXPECT_EQ(findArray(data, "v:magnitude").component, ArrayChoice::magnitude);
  EXPECT_EQ(findArray(data, "odd:name").name, "odd:name");
  EXPECT_FALSE(findArray(data, "w"));
  EXPECT_THROW(findArray(data, "v:2"), Failure);
  EXPECT_EQ(describe(data, findArray(data, "v:vy")), "v: vy");
  EXPECT_EQ(describe(data, findArray(data, "type")), "type");
  // Of three without names.
  add<vtkDoubleArray>(data, "u", 3, 1.0);
  EXPECT_EQ(describe(data, findArray(data, "u:2")), "u: z");
  EXPECT_EQ(findArray(data, "u:z"), findArray(data, "u:2"));
  EXPECT_EQ(asText(data, findArray(data, "u:z")), "u:2");
  EXPECT_EQ(describe(data, findArray(data, "v:0")), "v: 0");
}

TEST_F(Arrays, ThoseWithoutANameAreNotMeant)
{
  for (const char* name : {static_cast<const char*>(nullptr), ""})
  {
    add<vtkDoubleArray>(data, name, 1, 1.0);
    vtkDataArray* array =
      data->GetPointData()->GetArray(data->GetPointData()->GetNumberOfArrays() - 1);
    EXPECT_EQ(nameOf(array), "");
    EXPECT_EQ(best(), "type");
    for (const ArrayChoice& choice : rankedArrays(data))
      EXPECT_TRUE(choice);
    EXPECT_EQ(listArrays(data), "id, radius, type");
    EXPECT_FALSE(findArray(data, ""));
  }
  EXPECT_EQ(nameOf(nullptr), "");
}

TEST_F(Arrays, RangesLeaveOutWhatIsNotFinite)
{
  add<vtkDoubleArray>(data, "t", 1, 1.0, -1.0);
  vtkDataArray* t = data->GetPointData()->GetArray("t");
  t->SetComponent(3, 0, 0.0 / 0.0);
  double range[2];
  ASSERT_TRUE(finiteRange(t, 0, range));
  EXPECT_EQ(range[0], -1.0);
  EXPECT_EQ(range[1], 1.0);
  EXPECT_EQ(leastPositive(t, 0), 1.0);
}

TEST(Percentiles, AreThoseOfTheSortedValues)
{
  vtkNew<vtkDoubleArray> array;
  array->SetNumberOfTuples(1002);
  for (vtkIdType i = 0; i < 1001; ++i)
    array->SetValue(i, static_cast<double>(i * 10 % 1001)); // 0 to 1000, each once
  array->SetValue(1001, NAN);
  double range[2];
  ASSERT_TRUE(percentileRange(array, 0, {1.0, 99.0}, range));
  EXPECT_EQ(range[0], 10.0);
  EXPECT_EQ(range[1], 990.0);
  array->SetValue(5, 1e6);
  array->Modified();
  ASSERT_TRUE(percentileRange(array, 0, {0.0, 100.0}, range));
  EXPECT_EQ(range[1], 1e6);
  // Nearly all have one value: the range is that of all.
  array->Fill(3.0);
  array->SetValue(0, 5.0);
  array->Modified();
  ASSERT_TRUE(percentileRange(array, 0, {1.0, 99.0}, range));
  EXPECT_EQ(range[0], 3.0);
  EXPECT_EQ(range[1], 5.0);
  array->Fill(NAN);
  array->Modified();
  EXPECT_FALSE(percentileRange(array, 0, {1.0, 99.0}, range));
}

TEST(Percentiles, OfManyValuesAreNearTheirs)
{
  vtkNew<vtkDoubleArray> array;
  constexpr vtkIdType count = 1'000'003;
  array->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
    array->SetValue(i, static_cast<double>(i * 999'979 % count));
  double range[2];
  ASSERT_TRUE(percentileRange(array, 0, {1.0, 99.0}, range));
  EXPECT_NEAR(range[0], 0.01 * count, 0.001 * count);
  EXPECT_NEAR(range[1], 0.99 * count, 0.001 * count);
}

TEST_F(Arrays, TypesAreFewIntegersThatNameKinds)
{
  EXPECT_TRUE(isTypes(data, findArray(data, "type")));
  EXPECT_FALSE(isTypes(data, findArray(data, "id")));
  EXPECT_FALSE(isTypes(data, findArray(data, "radius")));
}

TEST_F(Arrays, TypesAreCollectedOnce)
{
  std::vector<int> types = {4, 9};
  EXPECT_TRUE(collectTypes(data->GetPointData()->GetArray("type"), 0, 8, 100, types));
  EXPECT_EQ(types, (std::vector<int>{4, 9, 1, 2, 3}));
  types.clear();
  EXPECT_FALSE(collectTypes(data->GetPointData()->GetArray("type"), 0, 3, 100, types));
  types.clear();
  EXPECT_FALSE(collectTypes(data->GetPointData()->GetArray("type"), 0, 8, 3, types));
  types.clear();
  EXPECT_FALSE(collectTypes(data->GetPointData()->GetArray("radius"), 0, 8, 100, types));
}
