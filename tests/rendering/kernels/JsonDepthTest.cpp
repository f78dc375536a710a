// How deeply lists of JSON lie in one another.

#include <kernels/core/JsonDepth.h>

#include <gtest/gtest.h>

#include <string>

using namespace mote;

TEST(JsonDepth, ListsAndObjectsCount)
{
  const auto nested = [](std::size_t depth)
  { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_FALSE(isDeepJson(""));
  EXPECT_FALSE(isDeepJson(nested(100)));
  EXPECT_TRUE(isDeepJson(nested(101)));
  EXPECT_TRUE(isDeepJson("{\"a\\\"[\": " + nested(100) + "}"));
  EXPECT_FALSE(isDeepJson("{\"" + nested(1000) + "\\\"[\": 1}"));
  std::string wide = "[";
  for (int i = 0; i < 1000; ++i)
    wide += "[{}],";
  EXPECT_FALSE(isDeepJson(wide + "1]"));
}
