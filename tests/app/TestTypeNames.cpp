// Names of types, and the colours that elements have.

#include <settings/Values.h>
#include <stage/ColorMaps.h>
#include <stage/TypeNames.h>

#include <gtest/gtest.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>

using namespace mote::app;

namespace
{

/// Particles of types 1 to 3, whose names a reader has noted.
vtkSmartPointer<vtkPolyData> notedParticles()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkIntArray> types;
  types->SetName("type");
  for (int i = 0; i < 9; ++i)
  {
    points->InsertNextPoint(i, 0.0, 0.0);
    types->InsertNextValue(1 + i % 3);
  }
  vtkNew<vtkStringArray> noted;
  noted->SetName("type_names");
  for (const char* text : {"1=Cu", "2=O", "3=a=b", "no number nor sign"})
    noted->InsertNextValue(text);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(types);
  data->GetFieldData()->AddArray(noted);
  return data;
}

} // namespace

TEST(TypeNames, WhatReadersNoteNamesTheArrayOfTypes)
{
  const auto data = notedParticles();
  const TypeNames names = typeNamesOf(data, findArray(data, "type"));
  EXPECT_EQ(names, (TypeNames{{1, "Cu"}, {2, "O"}, {3, "a=b"}}));
  data->GetPointData()->GetArray("type")->SetName("kind");
  EXPECT_TRUE(typeNamesOf(data, findArray(data, "kind")).empty()) << "they are of the array type";
}

TEST(TypeNames, OnlyUnknownElementsHaveOtherColours)
{
  const std::vector<int> types = {1, 2, 3, 4};
  const TypeNames known = {{1, "C"}, {2, "O"}, {3, "Cu"}, {4, "Si"}};
  TypeNames partly = known;
  partly[2] = "wall";
  partly.erase(4);
  const auto all = elementColors(types, known), some = elementColors(types, partly);
  ASSERT_EQ(all.size(), 4u);
  ASSERT_EQ(some.size(), 4u);
  EXPECT_EQ(some[0], all[0]);
  EXPECT_EQ(some[2], all[2]);
  EXPECT_EQ(some[1], typeColors(2)[0]);
  EXPECT_EQ(some[3], typeColors(2)[1]);
  EXPECT_TRUE(elementColors(types, {{1, "lowest"}}).empty()) << "no element: the ordinary map";
  EXPECT_TRUE(elementColors(types, {}).empty());
}

TEST(TypeNames, ManyUnknownOnesHaveColoursOfTheirOwn)
{
  std::vector<int> types;
  for (int i = 0; i < 100; ++i)
    types.push_back(i);
  const auto colors = elementColors(types, {{0, "H"}});
  ASSERT_EQ(colors.size(), types.size());
  for (std::size_t i = 1; i < colors.size(); ++i)
    EXPECT_EQ(std::count(colors.begin(), colors.end(), colors[i]), 1) << "colour " << i;
}

TEST(TypeNames, ColoursOfTypesAreWellApart)
{
  const auto all = typeColors(mostTypeColors);
  ASSERT_EQ(all.size(), mostTypeColors);
  EXPECT_EQ(typeColors(5), std::vector<Color>(all.begin(), all.begin() + 5));
  // In CIELAB a difference of 2.3 is just seen, side by side.
  const auto leastOf = [&](std::size_t count)
  {
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < i; ++k)
      {
        double a[3], b[3];
        vtkMath::RGBToLab(all[i].data(), a);
        vtkMath::RGBToLab(all[k].data(), b);
        least = std::min(least, std::sqrt(vtkMath::Distance2BetweenPoints(a, b)));
      }
    return least;
  };
  EXPECT_GT(leastOf(14), 25.0);
  EXPECT_GT(leastOf(24), 20.0);
  EXPECT_GT(leastOf(mostTypeColors), 8.0);
}
