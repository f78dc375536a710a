// What is shown as data of its own: cuts by the middles of particles and cells.

#include <settings/Settings.h>
#include <stage/Cuts.h>
#include <stage/ShownData.h>

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>

#include <cmath>
#include <random>

using namespace mote::app;

namespace
{

constexpr double open = HUGE_VAL;

ShowRange cut(const std::string& name, double low, double high)
{
  ShowRange range;
  range.name = name;
  range.intervals = {{low, high}};
  return range;
}

TEST(TestShownData, PlacesInCuts)
{
  CutSettings settings;
  settings.axis = {1.0, -2.0, 0.5, 0.0, 0.0, 3.0}; // along z through (1, -2, 0.5)
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-4.0, 4.0);
  const std::vector<std::pair<double, double>> turns = {
    {0.0, 90.0}, {350.0, 10.0}, {-30.0, 200.0}, {90.0, open}, {-open, 45.0}, {0.0, 360.0}};
  for (const auto& [from, to] : turns)
  {
    settings.ranges = {
      cut("r", 0.5, 3.0), cut("h", -open, 2.0), cut("angle", from, to), cut("1,1,0", -1.0, open)};
    Cuts cuts;
    cuts.follow(settings);
    int within = 0;
    for (int i = 0; i < 5000; ++i)
    {
      const Vec at = {place(random), place(random), place(random)};
      const double x = at[0] - 1.0, y = at[1] + 2.0;
      const double low = std::isfinite(from) ? from : 0.0, high = std::isfinite(to) ? to : 360.0;
      // Every name of an angle counts.
      bool isInTurn = false;
      const double angle = vtkMath::DegreesFromRadians(std::atan2(y, x));
      for (int k = -2; k <= 2; ++k)
        isInTurn = isInTurn || (angle + 360.0 * k >= low &&
                                 angle + 360.0 * k <= (high < low ? high + 360.0 : high));
      const bool expected = std::hypot(x, y) >= 0.5 && std::hypot(x, y) <= 3.0 &&
                            at[2] - 0.5 <= 2.0 && isInTurn &&
                            (at[0] + at[1]) / std::sqrt(2.0) >= -1.0;
      ASSERT_EQ(cuts.contains(at), expected) << at[0] << ' ' << at[1] << ' ' << at[2] << ", angle "
                                             << angle << " in " << from << ':' << to;
      within += expected ? 1 : 0;
    }
    EXPECT_GT(within, 20) << from;
    EXPECT_LT(within, 4000) << from;
  }
}

TEST(TestShownData, SurfacesKeepPolygonsAndArrays)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(2.0);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(20);
  sphere->Update();
  vtkNew<vtkPolyData> data;
  data->ShallowCopy(sphere->GetOutput());
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("number");
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
    numbers->InsertNextValue(static_cast<double>(c));
  data->GetCellData()->AddArray(numbers);

  Settings settings;
  settings.cuts.ranges = {cut("x", 0.0, open)};
  Part part("sphere", data, settings, 0.0);
  const auto marks = shownMarks(part, settings);
  const auto half = markedData(part, marks, false);
  auto* polygons = vtkPolyData::SafeDownCast(half);
  ASSERT_TRUE(polygons);
  const auto count = static_cast<vtkIdType>(std::count(marks.begin(), marks.end(), 1));
  EXPECT_EQ(polygons->GetNumberOfCells(), count);
  EXPECT_GT(3 * count, data->GetNumberOfCells());
  EXPECT_LT(3 * count, 2 * data->GetNumberOfCells());
  EXPECT_TRUE(polygons->GetPointData()->HasArray("Normals"));
  ASSERT_TRUE(polygons->GetCellData()->HasArray("number"));
  for (vtkIdType c = 0; c < count; ++c)
  {
    const auto number =
      static_cast<std::size_t>(polygons->GetCellData()->GetArray("number")->GetComponent(c, 0));
    EXPECT_EQ(marks[number], 1);
  }
  // Nothing is hidden: the data themselves.
  settings.cuts.ranges.clear();
  const auto all = markedData(part, shownMarks(part, settings), false);
  EXPECT_EQ(all->GetNumberOfCells(), data->GetNumberOfCells());
  EXPECT_EQ(all->GetNumberOfPoints(), data->GetNumberOfPoints());
}

} // namespace
