#include "window/FrameTime.h"

#include <gtest/gtest.h>

using namespace mote::app;

namespace
{

constexpr double wanted = 0.080, least = 0.024;
constexpr bool steady = true;

} // namespace

TEST(FrameTime, RaysHaveWhatTheRestLeaves)
{
  FrameTime time;
  EXPECT_DOUBLE_EQ(time.forRays(wanted, least, !steady), 0.080);
  time.traced(0.090, 0.080);
  EXPECT_DOUBLE_EQ(time.forRays(wanted, least, !steady), 0.070);
  time.traced(0.150, 0.070); // the rest alone took all of it
  EXPECT_DOUBLE_EQ(time.forRays(wanted, least, !steady), least);
}

TEST(FrameTime, TheFirstFrameOfAStepLeavesOffWhatTheStepTook)
{
  FrameTime time;
  time.traced(0.090, 0.080);
  time.loaded(0.015);
  EXPECT_DOUBLE_EQ(time.forRays(wanted, least, !steady), 0.055);
  time.traced(0.065, 0.055);
  EXPECT_DOUBLE_EQ(time.forRays(wanted, least, !steady), 0.070) << "the second has its time";
  // A step from a slow disk still has half of a frame less the rest.
  time.loaded(3.0);
  EXPECT_DOUBLE_EQ(time.forRays(wanted, least, !steady), 0.030);
  // Who asked for a rate has it, and the step is forgotten all the same.
  time.traced(0.040, 0.030);
  time.loaded(0.015);
  EXPECT_DOUBLE_EQ(time.forRays(wanted, least, steady), 0.070);
}

TEST(FrameTime, FramesOfStepsHaveARestOfTheirOwn)
{
  FrameTime time;
  time.traced(0.090, 0.080); // 10 ms beside
  time.loaded(0.001);
  time.forRays(wanted, least, !steady);
  time.traced(0.100, 0.075); // 25 ms: histograms, too
  EXPECT_DOUBLE_EQ(time.forRays(wanted, least, !steady), 0.070) << "while the view turns";
  time.traced(0.080, 0.070);
  time.loaded(0.001);
  EXPECT_DOUBLE_EQ(time.forRays(wanted, least, !steady), 0.054);
  // A frame without rays, of the panel alone, leaves it the first of its step.
  EXPECT_DOUBLE_EQ(time.forRays(wanted, least, !steady), 0.055);
}
