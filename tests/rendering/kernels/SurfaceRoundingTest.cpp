// How far hits may lie from where they should.

#include <kernels/core/SurfaceRounding.h>

#include <gtest/gtest.h>

using namespace mote;

TEST(SurfaceRounding, TheLongestSideDecides)
{
  EXPECT_EQ(surfaceRounding({4.0, 2.0, 1.0}), 2e-6);
  EXPECT_EQ(surfaceRounding({1.0, 4.0, 2.0}), 2e-6);
  EXPECT_EQ(surfaceRounding({1.0, 2.0, 4.0}), 2e-6);
  EXPECT_EQ(surfaceRounding({1000.0, 0.0, 0.0}), 5e-4);
  EXPECT_EQ(surfaceRounding({0.0, 0.0, 0.0}), 0.0);
}
