// The time in a legacy VTK file's beginning.
#include "LegacyTime.h"

#include <gtest/gtest.h>
#include <string>

namespace
{

std::string file(const std::string& kind, const std::string& time)
{
  return "# vtk DataFile Version 5.1\ntitle\n" + kind +
         "\nDATASET POLYDATA\nFIELD FieldData 1\nTimeValue 1 1 " + time + "\nPOINTS 0 float\n";
}

TEST(LegacyTime, Text)
{
  EXPECT_EQ(mote::legacyTime(file("ASCII", "double\n2.5 ")), 2.5);
  EXPECT_EQ(mote::legacyTime(file("ASCII", "float\n-1e-3 ")), -1e-3);
}

TEST(LegacyTime, Binary)
{
  const std::string bits("\x40\x1e\0\0\0\0\0\0", 8); // 7.5
  EXPECT_EQ(mote::legacyTime(file("BINARY", "double\n" + bits)), 7.5);
  EXPECT_EQ(mote::legacyTime(file("BINARY", "float\n" + std::string("\xc0\xf0\0\0", 4))), -7.5);
}

TEST(LegacyTime, NothingElse)
{
  EXPECT_FALSE(mote::legacyTime(""));
  EXPECT_FALSE(mote::legacyTime("TimeValue 1 1 double\n2.5\n"));
  EXPECT_FALSE(mote::legacyTime(file("ASCII", "string\n2.5 ")));
  EXPECT_FALSE(mote::legacyTime(file("ASCII", "double\nsoon")));
  EXPECT_FALSE(mote::legacyTime(file("ASCII", "double\nnan ")));
  const std::string whole = file("ASCII", "double\n12.5");
  const std::size_t end = whole.find("12.5") + 4;
  EXPECT_EQ(mote::legacyTime(whole.substr(0, end + 1)), 12.5);
  for (std::size_t length = 0; length <= end; ++length)
    EXPECT_FALSE(mote::legacyTime(whole.substr(0, length))) << length;
  const std::string binary = file("BINARY", "double\n");
  EXPECT_FALSE(mote::legacyTime(binary.substr(0, binary.find("double\n") + 14)));
}

} // namespace
