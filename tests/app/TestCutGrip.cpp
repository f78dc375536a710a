// Slices and faces of cuts that are taken hold of where they are seen.

#include "stage/CutGrip.h"
#include "stage/CutHandles.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace mote::app;

namespace
{

constexpr double bounds[6] = {-2.0, 2.0, -2.0, 2.0, 0.0, 4.0};

Settings with(std::vector<ShowRange> cuts, std::vector<ShowRange> slices)
{
  Settings settings;
  settings.cuts.ranges = std::move(cuts);
  settings.volume.slices = std::move(slices);
  return settings;
}

/// A ray to a point, from aside.
GripRay to(const std::array<double, 3>& point)
{
  return {{point[0] + 3.0, point[1] - 7.0, point[2] + 5.0}, {-3.0, 7.0, -5.0}};
}

} // namespace

TEST(CutGrip, ASliceComesToWhereTheMouseIs)
{
  const Settings settings = with({}, {{"z", {{1.0, 1.0}, {3.0, 3.0}}}, {"x", {{0.5, 0.5}}}});
  auto grip = CutGrip::at(settings, {0.7, -0.2, 3.0}, 6.0);
  ASSERT_TRUE(grip);
  EXPECT_EQ(grip->name(), "slice z");
  const auto value = grip->valueAt(to({0.7, -0.2, 2.25}), bounds);
  ASSERT_TRUE(value);
  EXPECT_NEAR(*value, 2.25, 1e-12);
  const Settings moved = grip->moved(settings, settings, *value);
  EXPECT_EQ(moved.volume.slices->at(0).intervals.at(0).low, 1.0);
  EXPECT_NEAR(moved.volume.slices->at(0).intervals.at(1).low, 2.25, 1e-12);
  EXPECT_EQ(moved.cuts, settings.cuts);
  EXPECT_EQ(*grip->valueAt(to({0.7, -0.2, 99.0}), bounds), 4.0); // no farther than the data
  EXPECT_FALSE(CutGrip::at(settings, {0.7, -0.2, 2.0}, 6.0));
  // Who looks along the way cannot say where to.
  EXPECT_FALSE(grip->valueAt({{0.0, 0.0, 9.0}, {0.0, 0.0, -1.0}}, bounds));
}

TEST(CutGrip, WhoLooksAlongItsWayMovesItUpAndDown)
{
  const Settings settings = with({}, {{"z", {{1.0, 1.0}}}});
  const auto down = [](double x, double y) {
    return GripRay{{x, y, 90.0}, {0.0, 0.0, -9.0}, {0.0, 1.0, 0.0}};
  };
  auto grip = CutGrip::at(settings, {0.5, 0.5, 1.0}, 6.0);
  ASSERT_TRUE(grip);
  EXPECT_NEAR(*grip->valueAt(down(0.5, 0.5), bounds), 1.0, 1e-12);
  EXPECT_NEAR(*grip->valueAt(down(0.5, 1.0), bounds), 0.5, 1e-12) << "up is away";
  EXPECT_NEAR(*grip->valueAt(down(1.5, -0.5), bounds), 2.0, 1e-12);
  // From below, nearly along: up is away still, and no small step goes far.
  grip = CutGrip::at(settings, {0.5, 0.5, 1.0}, 6.0);
  const auto up = [](double y) {
    return GripRay{{0.5, y - 1.0, -9.0}, {0.0, 0.1, 1.0}, {0.0, 1.0, 0.0}};
  };
  const double before = *grip->valueAt(up(0.5), bounds);
  const double after = *grip->valueAt(up(0.6), bounds);
  EXPECT_GT(after, before);
  EXPECT_LT(after - before, 0.11);
  // Who began aside goes on so, as steep as it becomes.
  grip = CutGrip::at(settings, {0.5, 0.5, 1.0}, 6.0);
  ASSERT_TRUE(grip->valueAt(to({0.5, 0.5, 1.5}), bounds));
  EXPECT_FALSE(grip->valueAt({{0.0, 0.0, 9.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}}, bounds));
}

TEST(CutGrip, EndsOfCutsComeBeforeSlices)
{
  const Settings settings = with({{"y", {{-HUGE_VAL, 0.5}}}}, {{"y", {{0.5, 0.5}}}});
  const auto grip = CutGrip::at(settings, {1.0, 0.5 - 1e-7, 1.0}, 6.0);
  ASSERT_TRUE(grip);
  EXPECT_EQ(grip->name(), "cut y");
  const Settings moved = grip->moved(settings, settings, -1.0);
  EXPECT_EQ(moved.cuts.ranges.at(0).intervals.at(0).high, -1.0);
  EXPECT_EQ(moved.cuts.ranges.at(0).intervals.at(0).low, -HUGE_VAL);
  EXPECT_EQ(moved.volume, settings.volume);
  // One end does not pass the other.
  const Settings two = with({{"y", {{0.0, 0.5}}}}, {});
  EXPECT_EQ(
    CutGrip::at(two, {1.0, 0.5, 1.0}, 6.0)->moved(two, two, -1.0).cuts.ranges.at(0).intervals.at(0),
    (Interval{0.0, 0.0}));
}

TEST(CutGrip, CylindersAndHalfPlanesMoveAboutTheirAxis)
{
  Settings settings = with({{"r", {{0.0, 1.0}}}}, {{"angle", {{90.0, 90.0}}}, {"h", {{0.5, 0.5}}}});
  settings.cuts.axis = {0.5, 0.0, 1.0, 0.0, 0.0, 1.0};
  auto cylinder = CutGrip::at(settings, {1.5, 0.0, 2.0}, 6.0);
  ASSERT_TRUE(cylinder);
  EXPECT_EQ(cylinder->name(), "cut r");
  EXPECT_NEAR(*cylinder->valueAt(to({1.75, 0.0, 2.0}), bounds), 1.25, 1e-12);
  auto plane = CutGrip::at(settings, {0.5, 0.5, 2.0}, 6.0);
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->name(), "slice angle");
  // A small step around: the way is straight.
  EXPECT_NEAR(
    *plane->valueAt(to({0.49, 0.5, 2.0}), bounds), 90.0 + 0.01 / 0.5 * 180.0 / M_PI, 1e-9);
  const auto height = CutGrip::at(settings, {-1.0, -1.0, 1.5}, 6.0);
  ASSERT_TRUE(height);
  EXPECT_EQ(height->name(), "slice h");
  settings.volume.slices = {{{"r", {{0.25, 0.25}}}}};
  settings.volume.unroll = true;
  EXPECT_FALSE(CutGrip::at(settings, {0.75, 0.0, 2.0}, 6.0)); // it lies elsewhere
}

TEST(CutHandles, LieOnWhatTheyHold)
{
  const double box[6] = {-2.0, 2.0, -2.0, 2.0, 0.0, 4.0};
  const Settings settings = with({{"y", {{-HUGE_VAL, 0.5}}}, {"angle", {{90.0, 360.0}}}},
    {{"z", {{1.0, 1.0}, {3.0, 3.0}}}, {"1,1,0", {{0.5, 0.5}}}, {"r", {{1.5, 1.5}}},
      {"x", {{9.0, 9.0}}}});
  const std::vector<CutHandle> handles = cutHandles(settings, box);
  std::vector<std::string> names;
  for (const CutHandle& handle : handles)
  {
    names.push_back(handle.name);
    ASSERT_FALSE(handle.outlines.empty());
    std::vector<CutHandle::Place> places = {handle.middle};
    for (const auto& outline : handle.outlines)
      places.insert(places.end(), outline.begin(), outline.end());
    for (const CutHandle::Place& place : places)
    {
      auto grip = handle.heldAt(settings, place);
      ASSERT_TRUE(grip);
      // Not moved it stays where it is; an axis has no angle.
      const auto value = grip->valueAt(to(place), box);
      if (handle.name == "angle" && std::hypot(place[0], place[1]) <= 0.1)
        continue;
      EXPECT_NEAR(std::remainder(*value - handle.value, 360.0), 0.0, 1e-9) << handle.name;
    }
  }
  EXPECT_EQ(names,
    (std::vector<std::string>{"y", "angle", "angle", "z", "z", "1,1,0", "r"})); // no x in the box
  const auto second = handles[4].heldAt(settings, handles[4].middle);
  EXPECT_EQ(second->moved(settings, settings, 2.0).volume.slices->at(0).intervals.at(1).low, 2.0);
}
