// Cubics along pieces of rays.

#include <kernels/hexahedra/CubicPiece.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace mote;

TEST(CubicPiece, GoesThroughItsFourValues)
{
  std::mt19937 bits(3);
  std::uniform_real_distribution<double> any(-2.0, 2.0);
  for (int i = 0; i < 1000; ++i)
  {
    const double v[4] = {any(bits), any(bits), any(bits), any(bits)};
    const CubicPiece c = CubicPiece::through(v[0], v[1], v[2], v[3]);
    EXPECT_NEAR(c(0.0), v[0], 1e-12);
    EXPECT_NEAR(c(0.25), v[1], 1e-12);
    EXPECT_NEAR(c(0.75), v[2], 1e-12);
    EXPECT_NEAR(c(1.0), v[3], 1e-12);
  }
}

TEST(CubicPiece, IsMonotonicBetweenItsTurns)
{
  std::mt19937 bits(4);
  std::uniform_real_distribution<double> any(-2.0, 2.0);
  for (int i = 0; i < 1000; ++i)
  {
    // Lines and parabolas are among them.
    CubicPiece c{{any(bits), any(bits), i % 3 ? any(bits) : 0.0, i % 2 ? any(bits) : 0.0}};
    double x[2];
    const int turns = c.turns(x);
    double from = 0.0;
    for (int k = 0; k <= turns; ++k)
    {
      const double to = k < turns ? x[k] : 1.0;
      ASSERT_GT(to, from);
      const bool rises = c(to) > c(from);
      for (int s = 0; s < 50; ++s)
      {
        const double a = from + (to - from) * s / 50.0, b = from + (to - from) * (s + 1) / 50.0;
        EXPECT_GE((c(b) - c(a)) * (rises ? 1.0 : -1.0), -1e-12);
      }
      const double value = c(from + 0.37 * (to - from));
      EXPECT_NEAR(c(rootIn(c, value, from, to)), value, 1e-11);
      EXPECT_NEAR(rootIn(c, value, from, to), from + 0.37 * (to - from), 1e-4);
      from = to;
    }
  }
}

TEST(CubicPiece, ARootAtAnEndIsTheEndWhicheverSideRoundingPutsIt)
{
  const CubicPiece c{{0.1, 0.7, 0.3, -0.2}};
  for (double x = 0.01; x < 0.9; x += 0.0137)
  {
    const double from = rootIn(c, c(0.5 * x), 0.0, 1.0), value = c(from);
    for (const double v : {value, std::nextafter(value, -1.0), std::nextafter(value, 2.0)})
      EXPECT_NEAR(rootIn(c, v, from, 1.0), from, 1e-12);
    const double to = from;
    for (const double v : {value, std::nextafter(value, -1.0), std::nextafter(value, 2.0)})
      EXPECT_NEAR(rootIn(c, v, 0.0, to), to, 1e-12);
  }
}
