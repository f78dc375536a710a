// Numbers must be what strtod makes of them, to the last bit.
#include "ParseNumber.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>
#include <random>

namespace
{

using mote::parseDouble;
using mote::parseInteger;

void expectLikeStrtod(const std::string& token)
{
  const std::string text = token + " 1\n";
  double value = -1;
  const char* const end = parseDouble(text.c_str(), value);
  ASSERT_EQ(end, text.c_str() + token.size()) << token;
  const double expected = std::strtod(token.c_str(), nullptr);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected)) << token;
}

TEST(ParseNumber, RandomDecimalsOfAllForms)
{
  std::mt19937_64 random(7);
  char text[64];
  for (int i = 0; i < 200000; ++i)
  {
    const double any = std::bit_cast<double>(random());
    if (std::abs(any) < 1e308) // beyond, rounding to few digits may leave the range
    {
      std::snprintf(text, sizeof text, "%.*g", 1 + i % 18, any);
      expectLikeStrtod(text);
    }
    const double plain = std::ldexp(static_cast<double>(random()), -static_cast<int>(40 + i % 40));
    std::snprintf(text, sizeof text, i % 2 ? "%.*f" : "-%.*g", i % 12, plain);
    expectLikeStrtod(text);
  }
}

TEST(ParseNumber, EdgesOfTheShortcut)
{
  for (const char* token :
    {"0", "-0", "+3.5", ".5", "5.", "1e22", "1e23", "1e-22", "1e-23", "9007199254740992",
      "9007199254740993", "9007199254740992.5", "123456789012345678901234567890", "1E5", "1e+05",
      "0000000000000000000000001", "0.000000000000000000000000001", "4.9e-324", "2.2250738585e-308",
      "1.7976931348623157e308", "1e-400", "1e0005", "1e00000000005"})
    expectLikeStrtod(token);
}

TEST(ParseNumber, NotANumberAndInfinityAreValues)
{
  double value = 0;
  for (const auto& [text, number] : {std::pair("1.5D3\n", 1500.0), {"-25d-1\n", -2.5},
         {"0.12345678901234567890D+01\n", 1.2345678901234567890}, {"1D-310\n", 1e-310}})
  {
    EXPECT_TRUE(parseDouble(text, value)) << text;
    EXPECT_EQ(value, number) << text;
  }
  for (const char* text : {"1D\n", "1D2D3\n", "d1\n", "1.2345678901234567890D1D\n"})
    EXPECT_FALSE(parseDouble(text, value)) << text;
  EXPECT_TRUE(parseDouble("nan\n", value));
  EXPECT_TRUE(std::isnan(value));
  EXPECT_TRUE(parseDouble("-nan\n", value));
  EXPECT_TRUE(std::isnan(value));
  EXPECT_TRUE(parseDouble("inf\n", value));
  EXPECT_EQ(value, HUGE_VAL);
  EXPECT_TRUE(parseDouble("-inf\n", value));
  EXPECT_EQ(value, -HUGE_VAL);
}

TEST(ParseNumber, RefusesWhatIsNoNumber)
{
  for (const char* token : {"abc\n", "\n", "-\n", ".\n", "e5\n", "1e\n", "1e+\n", "1.2.3\n",
         "0x10\n", "1,5\n", "--1\n", "+-1\n", "12a\n", "1e999\n", "-1e999\n", "ITEM:\n"})
  {
    double value = 0;
    EXPECT_FALSE(parseDouble(token, value)) << token;
  }
}

TEST(ParseNumber, Integers)
{
  std::int64_t big = 0;
  std::int32_t small = 0;
  EXPECT_TRUE(parseInteger("-9223372036854775808\n", big));
  EXPECT_EQ(big, INT64_MIN);
  EXPECT_TRUE(parseInteger("+9223372036854775807 \n", big));
  EXPECT_EQ(big, INT64_MAX);
  EXPECT_FALSE(parseInteger("9223372036854775808\n", big));
  EXPECT_TRUE(parseInteger("-2147483648\n", small));
  EXPECT_EQ(small, INT32_MIN);
  EXPECT_FALSE(parseInteger("2147483648\n", small));
  EXPECT_FALSE(parseInteger("1.0\n", small));
  EXPECT_FALSE(parseInteger("-\n", small));
  EXPECT_FALSE(parseInteger("\n", small));
}

} // namespace
