// The depth of what stands in a window, as coarser pictures take it.

#include "WindowDepth.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

constexpr float nothing = std::numeric_limits<float>::infinity();

mote::WindowDepth empty(int width, int height)
{
  mote::WindowDepth depth;
  depth.width = width;
  depth.height = height;
  depth.distances.assign(static_cast<std::size_t>(width) * height, nothing);
  return depth;
}

} // namespace

TEST(WindowDepth, AThinLineEndsNoCoarsePixel)
{
  // One pixel wide, across and along, over every place in a coarse pixel.
  for (const int factor : {2, 3, 4, 5})
    for (int at = 0; at < 60; ++at)
    {
      mote::WindowDepth depth = empty(60, 60);
      for (int i = 0; i < 60; ++i)
      {
        depth.distances[static_cast<std::size_t>(at) * 60 + i] = 1.0f;
        if (factor > 3) // where two lines cross they cover less than half, too
          depth.distances[static_cast<std::size_t>(i) * 60 + at] = 1.0f;
      }
      for (const float d : depth.resampled(60 / factor, 60 / factor))
        ASSERT_EQ(d, nothing) << factor << " " << at;
    }
}

TEST(WindowDepth, ASlopingLineEndsNoPixelThatIsALittleCoarser)
{
  for (const int coarse : {59, 50, 40, 31})
  {
    mote::WindowDepth depth = empty(60, 60);
    for (int i = 0; i < 60; ++i)
      depth.distances[static_cast<std::size_t>(i) * 60 + (i * 7) / 10] = 1.0f;
    for (const float d : depth.resampled(coarse, coarse))
      ASSERT_EQ(d, nothing) << coarse;
  }
}

TEST(WindowDepth, WhatCoversMostOfACoarsePixelEndsIt)
{
  mote::WindowDepth depth = empty(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 35; ++x)
      depth.distances[static_cast<std::size_t>(y) * 64 + x] = 5.0f;
  const auto coarse = depth.resampled(16, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      ASSERT_EQ(coarse[static_cast<std::size_t>(y) * 16 + x], x < 9 ? 5.0f : nothing) << x;
}

TEST(WindowDepth, OfOtherSizesIsTakenAtTheMiddle)
{
  mote::WindowDepth depth = empty(3, 2);
  for (std::size_t i = 0; i < 6; ++i)
    depth.distances[i] = static_cast<float>(i);
  EXPECT_EQ(depth.resampled(3, 2), depth.distances);
  EXPECT_EQ(depth.resampled(6, 2), (std::vector<float>{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5}));
}
