// The letters that keys write, by their names in X11.

#include <panels/TypedLetter.h>

#include <gtest/gtest.h>

using mote::app::letterOf;

TEST(TypedLetter, LatinGreekAndUnicodeAreWritten)
{
  EXPECT_EQ(letterOf("a"), unsigned{'a'});
  EXPECT_EQ(letterOf("mu"), 0xb5u); // of micrometres
  EXPECT_EQ(letterOf("Aring"), 0xc5u);
  EXPECT_EQ(letterOf("degree"), 0xb0u);
  EXPECT_EQ(letterOf("Greek_SIGMA"), 0x3a3u);
  EXPECT_EQ(letterOf("Greek_OMEGA"), 0x3a9u);
  EXPECT_EQ(letterOf("Greek_rho"), 0x3c1u);
  EXPECT_EQ(letterOf("Greek_sigma"), 0x3c3u);
  EXPECT_EQ(letterOf("Greek_finalsmallsigma"), 0x3c2u);
  EXPECT_EQ(letterOf("Greek_tau"), 0x3c4u);
  EXPECT_EQ(letterOf("EuroSign"), 0x20acu);
  EXPECT_EQ(letterOf("U2103"), 0x2103u);
}

TEST(TypedLetter, OtherKeysWriteNothing)
{
  for (const char* key : {"Return", "Delete", "BackSpace", "Shift_L", "F1", "KP_Enter", "Tab", "?"})
    EXPECT_EQ(letterOf(key), 0u) << key;
}
