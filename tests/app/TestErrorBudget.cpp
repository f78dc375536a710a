// What a budget of error gives to rays, to levels of detail and to views that move.

#include <settings/ErrorBudget.h>

#include <gtest/gtest.h>

#include <string>

using namespace mote::app;

TEST(ErrorBudget, IsSharedBetweenRaysAndLevelsOfDetail)
{
  Settings settings;
  EXPECT_EQ(errorShares(settings).lodError, 0.0);
  for (const double budget : {0.5, 0.75, 1.0, 3.0, 10.0})
  {
    settings.picture.error = std::to_string(budget) + "px";
    const double lods = errorShares(settings).lodError;
    const double distance = mostDistance(settings.picture, 1e9, lods);
    EXPECT_NEAR(lods + 0.5 * distance, budget, 1e-6);
    EXPECT_GE(distance, 1.0);
    EXPECT_GE(lods, budget < 1.0 ? 0.0 : 0.5 * budget);
  }
  settings.picture.lodError = 2.5; // as it was asked for
  EXPECT_EQ(errorShares(settings).lodError, 2.5);
  for (const double percent : {0.1, 1.0, 5.0, 50.0})
  {
    settings.picture.lodError = 0.0;
    settings.picture.error = std::to_string(percent) + "%";
    const ErrorShares shares = errorShares(settings);
    for (const bool volumes : {false, true})
    {
      const double all =
        expectedError(shares, *shares.noise, volumes, volumes ? 0.0 : shares.lodError);
      EXPECT_LE(all, 0.01 * percent);
      EXPECT_GE(all, 0.005 * percent);
    }
  }
}

TEST(ErrorBudget, ViewsThatMoveShowWhatThereIs)
{
  PictureSettings picture;
  EXPECT_EQ(mostDistance(picture, 4.0 * 4096.0), 2.0) << "4,096 rays";
  EXPECT_EQ(mostDistance(picture, 100.0), 1.0);
  EXPECT_EQ(mostDistance(picture, 1e9), 32.0);
  picture.error = "3px";
  EXPECT_EQ(mostDistance(picture, 4.0 * 4096.0), 2.0);
  EXPECT_EQ(mostDistance(picture, 1e9), 6.0);
  picture.fps = 30.0;
  EXPECT_EQ(mostDistance(picture, 4.0 * 4096.0), 6.0);
  picture.error.clear();
  EXPECT_EQ(mostDistance(picture, 4.0 * 4096.0), 32.0) << "so many frames a second";
}
