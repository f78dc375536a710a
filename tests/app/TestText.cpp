#include "base/Text.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace mote::app;

TEST(Text, Thousands)
{
  EXPECT_EQ(withThousands(0), "0");
  EXPECT_EQ(withThousands(999), "999");
  EXPECT_EQ(withThousands(84270), "84,270");
  EXPECT_EQ(withThousands(-1234567), "-1,234,567");
  EXPECT_EQ(counted(1, "particle"), "1 particle");
  EXPECT_EQ(counted(0, "particle"), "0 particles");
}

TEST(Text, Units)
{
  EXPECT_EQ(asBytes(0), "0 B");
  EXPECT_EQ(asBytes(999.6), "1.0 kB");
  EXPECT_EQ(asBytes(1.7e6), "1.7 MB");
  EXPECT_EQ(asBytes(48e6), "48 MB");
  EXPECT_EQ(asDuration(0.035), "35 ms");
  EXPECT_EQ(asDuration(2.414), "2.41 s");
  EXPECT_EQ(stepText(2, 7), "step 3/7, ");
  EXPECT_EQ(stepText(0, 1), "");
  EXPECT_EQ(asDuration(99.4), "99.4 s");
  EXPECT_EQ(asDuration(867.3), "14 min 27 s");
  EXPECT_EQ(asDuration(7380.0), "2 h 3 min");
}

TEST(Text, FoldersHaveNamesToo)
{
  EXPECT_EQ(baseName("run/a.xyz"), "a.xyz");
  EXPECT_EQ(baseName("pump:0.1"), "pump:0.1");
  EXPECT_EQ(baseName("run/rotor/"), "rotor");
  EXPECT_EQ(baseName("/run/rotor/."), "rotor");
  EXPECT_EQ(baseName("/run/rotor/.."), "run");
  EXPECT_EQ(baseName("."), std::filesystem::current_path().filename());
  EXPECT_EQ(baseName(""), "");
}

TEST(Text, NumbersAreReadWhole)
{
  double value = 0.0;
  EXPECT_TRUE(parseNumber("-1.5e3", value));
  EXPECT_EQ(value, -1500.0);
  for (const char* text : {"", " 1", "1x", "nan", "inf", "radius", "--"})
    EXPECT_FALSE(parseNumber(text, value)) << text;
}

TEST(Text, ShortestEndsTellPathsApart)
{
  EXPECT_EQ(shortestEnds({{"a", "b"}, {"c", "d"}}), (std::vector<std::string>{"b", "d"}));
  EXPECT_EQ(shortestEnds({{"x", "a", "p"}, {"x", "b", "p"}, {"x", "q"}}),
    (std::vector<std::string>{"a/p", "b/p", "q"}));
  EXPECT_EQ(
    shortestEnds({{"p"}, {"a", "p"}, {"a", "p"}}), (std::vector<std::string>{"p", "a/p", "a/p"}));
}
