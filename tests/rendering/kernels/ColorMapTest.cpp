// Colour maps against the formulas that define them.

#include <kernels/shading/ColorMap.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace mote;

namespace
{

ColorMap ramp(ColorMap::Interpolation interpolation)
{
  ColorMap map;
  map.table = {{0.0f, 0.0f, 0.0f, 1.0f}, {0.2f, 0.4f, 0.6f, 0.5f}, {1.0f, 0.0f, 0.5f, 0.0f}};
  map.interpolation = interpolation;
  map.lower = -2.0;
  map.upper = 4.0;
  return map;
}

void expectColor(const Vec4f& found, const Vec4f& wanted)
{
  for (int c = 0; c < 4; ++c)
    EXPECT_NEAR(found[c], wanted[c], 1e-6f);
}

} // namespace

TEST(ColorMap, LinearIsExactAtEntriesAndStraightBetween)
{
  const ColorMap map = ramp(ColorMap::Interpolation::Linear);
  for (int i = 0; i < 3; ++i)
    expectColor(map(-2.0 + 3.0 * i), map.table[static_cast<std::size_t>(i)]);
  for (double share = 0.0; share <= 1.0; share += 0.03125)
  {
    expectColor(map(-2.0 + 3.0 * share), glm::mix(map.table[0], map.table[1], float(share)));
    expectColor(map(1.0 + 3.0 * share), glm::mix(map.table[1], map.table[2], float(share)));
  }
}

TEST(ColorMap, NearestCutsTheRangeIntoEqualParts)
{
  const ColorMap map = ramp(ColorMap::Interpolation::Nearest);
  expectColor(map(-2.0), map.table[0]);
  expectColor(map(-0.001), map.table[0]);
  expectColor(map(0.001), map.table[1]);
  expectColor(map(1.999), map.table[1]);
  expectColor(map(2.001), map.table[2]);
  expectColor(map(4.0), map.table[2]); // the upper end belongs to the last part
}

TEST(ColorMap, ValuesOutsideTakeTheEndsOrTheirOwnColours)
{
  for (const auto interpolation :
    {ColorMap::Interpolation::Linear, ColorMap::Interpolation::Nearest})
  {
    ColorMap map = ramp(interpolation);
    expectColor(map(-2.001), map.table.front());
    expectColor(map(-INFINITY), map.table.front());
    expectColor(map(1e300), map.table.back());
    map.useBelow = map.useAbove = true;
    map.below = {0.1f, 0.2f, 0.3f, 0.4f};
    map.above = {0.5f, 0.6f, 0.7f, 0.8f};
    expectColor(map(-2.001), map.below);
    expectColor(map(INFINITY), map.above);
    expectColor(map(-2.0), map.table.front()); // the ends are inside
    expectColor(map(4.0), map.table.back());
  }
}

TEST(ColorMap, NanHasItsColour)
{
  ColorMap map = ramp(ColorMap::Interpolation::Linear);
  map.nan = {0.9f, 0.8f, 0.7f, 0.6f};
  expectColor(map(std::nan("")), map.nan);
  map.logarithmic = true;
  expectColor(map(std::nan("")), map.nan);
}

TEST(ColorMap, LogarithmicLooksUpTheExponent)
{
  ColorMap map = ramp(ColorMap::Interpolation::Linear), plain = map;
  map.logarithmic = true;
  for (double exponent = -2.0; exponent <= 4.0; exponent += 0.25)
    expectColor(map(std::pow(10.0, exponent)), plain(exponent));
  map.useBelow = true;
  map.below = {0.1f, 0.2f, 0.3f, 0.4f};
  expectColor(map(0.0), map.below); // has no logarithm
  expectColor(map(-5.0), map.below);
}

TEST(ColorMap, OneEntryAndARangeOfNoWidth)
{
  ColorMap map;
  map.table = {{0.1f, 0.2f, 0.3f, 0.4f}};
  for (const auto interpolation :
    {ColorMap::Interpolation::Linear, ColorMap::Interpolation::Nearest})
  {
    map.interpolation = interpolation;
    for (const double value : {-1.0, 0.0, 0.5, 1.0, 2.0})
      expectColor(map(value), map.table[0]);
  }
  map = ramp(ColorMap::Interpolation::Linear);
  map.lower = map.upper = 3.0;
  expectColor(map(3.0), map.table[1]);
  expectColor(map(2.0), map.table[0]);
  expectColor(map(4.0), map.table[2]);
}

TEST(ColorMap, ValuesOnABoundaryBelongToTheUpperPart)
{
  ColorMap map;
  map.interpolation = ColorMap::Interpolation::Nearest;
  map.table.clear();
  for (int i = 0; i < 10; ++i)
    map.table.push_back(Vec4f(0.1f * float(i)));
  for (const double upper : {10.0, 0.625, 30.0})
  {
    map.upper = upper;
    for (int i = 0; i < 10; ++i)
      expectColor(map(upper / 10.0 * i), map.table[std::size_t(i)]);
  }
}

TEST(ColorMap, RangesWithoutAUsableWidthAreHarmless)
{
  for (const auto interpolation :
    {ColorMap::Interpolation::Linear, ColorMap::Interpolation::Nearest})
  {
    ColorMap map = ramp(interpolation);
    for (const double width : {1e-310, 0.0})
    {
      map.lower = 0.0;
      map.upper = width;
      for (const double value : {0.0, 5e-311, 1e-310})
        EXPECT_TRUE(map(value).x >= 0.0f && map(value).x <= 1.0f);
    }
    map.lower = -INFINITY;
    map.upper = INFINITY;
    for (const double value : {-double(INFINITY), -1e300, 0.0, 1e300, double(INFINITY)})
      EXPECT_TRUE(map(value).x >= 0.0f && map(value).x <= 1.0f);
  }
}

TEST(ColorMap, ManyAtOnceAreTheSameAsOneByOne)
{
  const double values[] = {-3.0, -2.0, -0.5, 0.0, 0.7, 3.9, 4.0, 5.0, std::nan("")};
  constexpr int count = 9;
  for (const bool logarithmic : {false, true})
  {
    ColorMap map = ramp(ColorMap::Interpolation::Linear);
    map.logarithmic = logarithmic;
    map.useBelow = true;
    float colors[count][4];
    map.map(values, count, colors);
    for (int k = 0; k < count; ++k)
      for (int c = 0; c < 4; ++c)
        EXPECT_EQ(colors[k][c], map(values[k])[c]);
  }
}
