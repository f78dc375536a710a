#include <kernels/shading/SampleSequence.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace mote;

TEST(SampleSequence, RunsOfPowersOfTwoFillEveryElementaryInterval)
{
  for (const std::uint32_t seed : {0u, 1u, 77u, 0xffffffffu})
    for (const unsigned bits : {1u, 3u, 6u, 8u})
      for (const std::uint32_t run : {0u, 1u, 5u, 1000u})
        for (unsigned wide = 0; wide <= bits; ++wide)
        {
          std::set<std::pair<int, int>> cells;
          for (std::uint32_t i = 0; i < 1u << bits; ++i)
          {
            const glm::dvec2 p = samplePoint((run << bits) + i, seed);
            ASSERT_TRUE(p.x >= 0.0 && p.x < 1.0 && p.y >= 0.0 && p.y < 1.0);
            cells.insert({int(std::ldexp(p.x, int(wide))), int(std::ldexp(p.y, int(bits - wide)))});
          }
          EXPECT_EQ(cells.size(), std::size_t(1) << bits) << seed << ' ' << run << ' ' << wide;
        }
}

TEST(SampleSequence, SeedsGiveIndependentPoints)
{
  // Over many seeds, a point of a sequence is anywhere, and tells nothing of the next seed's.
  const int count = 20000;
  double sum = 0.0, product = 0.0, across = 0.0;
  for (int seed = 0; seed < count; ++seed)
  {
    const glm::dvec2 p = samplePoint(3, mixedBits(std::uint32_t(seed), 9));
    const glm::dvec2 q = samplePoint(3, mixedBits(std::uint32_t(seed + 1), 9));
    sum += p.x;
    product += (p.x - 0.5) * (q.x - 0.5);
    across += (p.x - 0.5) * (p.y - 0.5);
  }
  const double error =
    1.0 / std::sqrt(12.0 * count); // of the mean; that of products is 1/12 / root
  EXPECT_NEAR(sum / count, 0.5, 4.0 * error);
  EXPECT_NEAR(product / count, 0.0, 4.0 / 12.0 / std::sqrt(double(count)));
  EXPECT_NEAR(across / count, 0.0, 4.0 / 12.0 / std::sqrt(double(count)));
}

TEST(SampleSequence, MeansConvergeFasterThanRandomOnes)
{
  // The share of the square under a parabola; the rms over seeds, at 16 times as many points.
  const auto rms = [](std::uint32_t points)
  {
    double squares = 0.0;
    for (std::uint32_t seed = 0; seed < 200; ++seed)
    {
      int under = 0;
      for (std::uint32_t i = 0; i < points; ++i)
      {
        const glm::dvec2 p = samplePoint(i, seed);
        under += p.y < p.x * p.x;
      }
      squares += std::pow(double(under) / points - 1.0 / 3.0, 2.0);
    }
    return std::sqrt(squares / 200.0);
  };
  EXPECT_LT(rms(256), 0.15 * rms(16)); // random points: 0.25
}
