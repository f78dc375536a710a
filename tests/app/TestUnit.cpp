#include "base/Unit.h"

#include <gtest/gtest.h>

using namespace mote::app;

TEST(Unit, IsReadInManyForms)
{
  const auto pascal = Unit::parse("kg m^-1 s^-2");
  ASSERT_TRUE(pascal);
  for (const char* text : {"kg/m/s^2", "kg/(m s2)", "kg/(m*s^2)", "kg·m⁻¹·s⁻²", "kg.m-1.s-2"})
    EXPECT_EQ(Unit::parse(text), pascal) << text;
  EXPECT_EQ(Unit::parse("Pa")->inBaseUnits(), *pascal);
  EXPECT_EQ(Unit::parse("m³/s"), Unit::parse("m^3 s^-1"));
  EXPECT_EQ(Unit::parse("1"), Unit());
  EXPECT_EQ(Unit::parse("m/m"), Unit());
  for (const char* text : {"", "m^", "m/(s", "m)", "m-", "10 m", "[m]", "m^1/2"})
    EXPECT_FALSE(Unit::parse(text)) << text;
}

TEST(Unit, IsWrittenForPictures)
{
  EXPECT_EQ(unitText("m^2 s^-2"), "m²/s²");
  EXPECT_EQ(unitText("kg m^-1 s^-2"), "Pa");
  EXPECT_EQ(unitText("s^-1"), "1/s");
  EXPECT_EQ(unitText("kg m^-3"), "kg/m³");
  EXPECT_EQ(unitText("W m^-2 K^-1"), "W/(K m²)");
  EXPECT_EQ(unitText("J"), "J");
  EXPECT_EQ(unitText("1"), "");
  EXPECT_EQ(unitText("furlongs [old]"), "furlongs [old]"); // as it stands
}

TEST(Unit, ProductsAreThoseOfMechanics)
{
  const Unit pascal = *Unit::parse("Pa"), metre = *Unit::parse("m"), second = *Unit::parse("s");
  EXPECT_EQ((pascal * metre.toThe(3)).text(), "N m");
  EXPECT_EQ((pascal * metre.toThe(3) / second).text(), "W");
  EXPECT_EQ((pascal * metre.toThe(2)).text(), "N");
  EXPECT_EQ((*Unit::parse("m/s") * metre.toThe(2)).text(), "m³/s");
  EXPECT_EQ((metre / metre).text(), "");
}
