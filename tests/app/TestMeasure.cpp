// Distances, in periodic boxes too, against all images one by one.

#include <stage/Measure.h>
#include <stage/Stage.h>

#include <gtest/gtest.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkMath.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <cmath>
#include <random>

using namespace mote::app;

namespace
{

double apart(const Place& a, const Place& b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
}

} // namespace

TEST(Measure, FindsTheNearestOfAllImages)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int across = 0;
  for (int trial = 0; trial < 400; ++trial)
  {
    SimulationBox box{};
    for (int i = 0; i < 3; ++i)
    {
      box.vectors[i][i] = 3.0 + any(random);
      for (int axis = 0; axis < i; ++axis) // tilted up to half a period, as simulations are
        box.vectors[i][axis] = any(random);
    }
    const std::array<bool, 3> isPeriodic = {trial % 2 == 0, trial % 3 == 0, trial % 5 != 0};
    Place from{}, to{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      from[axis] = 5.0 * any(random);
      to[axis] = 5.0 * any(random);
    }
    double least = apart(from, to);
    for (int a = -6; a <= 6; ++a)
      for (int b = -6; b <= 6; ++b)
        for (int c = -6; c <= 6; ++c)
        {
          if ((a != 0 && !isPeriodic[0]) || (b != 0 && !isPeriodic[1]) ||
              (c != 0 && !isPeriodic[2]))
            continue;
          Place image = to;
          for (std::size_t axis = 0; axis < 3; ++axis)
            image[axis] +=
              a * box.vectors[0][axis] + b * box.vectors[1][axis] + c * box.vectors[2][axis];
          least = std::min(least, apart(from, image));
        }
    const Distance found = distanceBetween(from, to, box, isPeriodic);
    EXPECT_NEAR(found.length, least, 1e-9);
    EXPECT_NEAR(found.length, vtkMath::Norm(found.step.data()), 1e-12);
    EXPECT_NEAR(found.direct, apart(from, to), 1e-12);
    EXPECT_EQ(found.isAcross, found.length < found.direct * (1.0 - 1e-9));
    across += found.isAcross;
  }
  EXPECT_GT(across, 50);
}

TEST(Measure, KnowsNoImagesWhereTheBoxSaysNone)
{
  SimulationBox flat{};
  flat.vectors[0][0] = flat.vectors[1][1] = 2.0; // no depth: no period can be told
  const Place from = {0.1, 0.0, 0.0}, to = {1.9, 0.0, 0.0};
  EXPECT_NEAR(distanceBetween(from, to, flat, {true, true, true}).length, 1.8, 1e-12);
  flat.vectors[2][2] = 1.0;
  EXPECT_NEAR(distanceBetween(from, to, flat, {true, true, true}).length, 0.2, 1e-12);
  EXPECT_NEAR(distanceBetween(from, to, flat, {false, true, true}).length, 1.8, 1e-12);
  EXPECT_NEAR(distanceBetween(from, to, {}, {true, true, true}).length, 1.8, 1e-12);
}

TEST(Measure, TellsDistancesAndTheAngleOfThePicked)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.5, 0.0, 0.0);
  points->InsertNextPoint(9.5, 0.0, 0.0); // one from the first, through the side of the box
  points->InsertNextPoint(9.5, 2.0, 0.0);
  points->InsertNextPoint(5.0, 5.0, 5.0);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkNew<vtkDoubleArray> box;
  box->SetName("box");
  for (int i = 0; i < 9; ++i)
    box->InsertNextValue(i % 4 == 0 ? 10.0 : 0.0);
  data->GetFieldData()->AddArray(box);
  vtkNew<vtkStringArray> boundary;
  boundary->SetName("boundary");
  boundary->InsertNextValue("pp ff pp");
  data->GetFieldData()->AddArray(boundary);
  EXPECT_EQ(periodsOf(data), (std::array<bool, 3>{true, false, true}));

  Settings settings;
  ProgressRelay progress;
  Stage stage(settings);
  stage.setData({{"a", data, "a"}});
  stage.build(progress);
  PickedSet picked;
  const auto pick = [&](vtkIdType id) { picked.toggle({0, Picked::Kind::Particle, id}); };
  EXPECT_FALSE(measure(stage.parts(), picked));
  pick(0);
  EXPECT_FALSE(measure(stage.parts(), picked));
  pick(1);
  auto measured = measure(stage.parts(), picked);
  ASSERT_TRUE(measured && measured->distances.size() == 1);
  EXPECT_NEAR(measured->distances[0].length, 1.0, 1e-6);
  EXPECT_TRUE(measured->distances[0].isAcross);
  EXPECT_EQ(asText(measured->distances[0]), "1 to the nearest image");
  EXPECT_FALSE(measured->angle);
  pick(2);
  measured = measure(stage.parts(), picked);
  ASSERT_TRUE(measured && measured->distances.size() == 2 && measured->angle);
  EXPECT_NEAR(*measured->angle, 90.0, 1e-6);
  EXPECT_NEAR(measured->distances[1].length, 2.0, 1e-6);
  pick(3);
  EXPECT_FALSE(measure(stage.parts(), picked));
}
