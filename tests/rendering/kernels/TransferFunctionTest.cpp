// Colour and opacity as functions of a scalar.

#include <kernels/core/Error.h>
#include <kernels/shading/TransferFunction.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace mote;

namespace
{

TransferFunction stepped()
{
  TransferFunction f;
  f.knots = {{0.0, Vec4f(1, 0, 0, 0)}, {1.0, Vec4f(1, 0, 0, 0.5F)}, {1.0, Vec4f(0, 1, 0, 0)},
    {2.0, Vec4f(0, 1, 0, 0)}, {3.0, Vec4f(0, 0, 1, 1)}};
  f.unitDistance = 2.0;
  return f;
}

} // namespace

TEST(TransferFunction, IsLinearBetweenKnotsAndStepsAtDoubleOnes)
{
  const TransferTable t(stepped(), 10.0);
  const auto at = [&](double v) { return t(v - 10.0); };
  EXPECT_EQ(at(-5.0).extinction, 0.0);
  EXPECT_NEAR(at(0.5).extinction, -std::log(0.75) / 2.0, 1e-12);
  EXPECT_NEAR(at(1.0 - 1e-9).extinction, -std::log(0.5) / 2.0, 1e-8);
  EXPECT_EQ(at(1.0).extinction, 0.0);
  EXPECT_EQ(at(1.0).color, Vec3d(0, 1, 0));
  EXPECT_NEAR(at(2.5).extinction, -std::log(0.5) / 2.0, 1e-12);
  EXPECT_NEAR(at(2.5).color.z, 0.5, 1e-12);
  EXPECT_EQ(at(4.0).extinction, INFINITY);
}

TEST(TransferFunction, KnowsWhatIsVisible)
{
  const TransferTable t(stepped());
  EXPECT_FALSE(t.isVisible(-2.0, 0.0));
  EXPECT_TRUE(t.isVisible(-2.0, 0.1));
  EXPECT_TRUE(t.isVisible(0.9, 1.0)); // up to the step
  EXPECT_FALSE(t.isVisible(1.0, 2.0));
  EXPECT_TRUE(t.isVisible(-1.0, 1.5)); // what lies between the ends
  EXPECT_TRUE(t.isVisible(2.0, 2.001));
  EXPECT_TRUE(t.isVisible(-INFINITY, INFINITY));
  TransferFunction none = stepped();
  for (auto& knot : none.knots)
    knot.color.w = 0.0F;
  EXPECT_FALSE(TransferTable(none).isVisible(-INFINITY, INFINITY));
  none.nan = Vec4f(1, 0, 0, 0.1F);
  EXPECT_TRUE(TransferTable(none).isVisible(-INFINITY, INFINITY));
  EXPECT_FALSE(TransferTable(none).isVisible(-1.0, 5.0));
}

TEST(TransferFunction, BoundsHowFastItChanges)
{
  TransferFunction f = stepped();
  f.knots.back().color.w = 0.9F;
  const TransferTable t(f);
  for (double v = 2.01; v < 2.99; v += 0.01)
  {
    const auto a = t(v), b = t(v + 0.001);
    const Vec3d change = b.extinction * b.color - a.extinction * a.color;
    EXPECT_LE(glm::length(change) / 0.001, 1.8 * t.steepest(2.0, 3.0)) << v;
  }
  EXPECT_EQ(t.steepest(1.2, 1.8), 0.0);
  EXPECT_GT(t.steepest(0.9, 1.8), t.steepest(0.9, 0.95)); // the step counts
}

TEST(TransferFunction, RefusesWhatIsNone)
{
  TransferFunction f = stepped();
  std::swap(f.knots[0], f.knots[4]);
  EXPECT_THROW(TransferTable{f}, Error);
  f.knots.clear();
  EXPECT_THROW(TransferTable{f}, Error);
  f = stepped();
  f.unitDistance = 0.0;
  EXPECT_THROW(TransferTable{f}, Error);
  f = stepped();
  f.knots[2].value = NAN;
  EXPECT_THROW(TransferTable{f}, Error);
}
