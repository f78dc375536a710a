#include <kernels/core/Film.h>
#include <kernels/core/FilmFill.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using mote::Film;

TEST(Film, TakesMemoryForTheChannelsAskedFor)
{
  Film film;
  film.resize(100, 50);
  EXPECT_EQ(film.pixels(), 5000u);
  EXPECT_FALSE(film.has(Film::Id));
  EXPECT_FALSE(film.has(Film::Normal));
  const std::size_t plain = film.bytes();
  EXPECT_EQ(plain, 5000u * 5 * sizeof(float));
  Film full;
  full.resize(100, 50, Film::Id | Film::Normal);
  EXPECT_TRUE(full.has(Film::Id));
  EXPECT_TRUE(full.has(Film::Normal));
  EXPECT_EQ(full.bytes(), plain + 5000u * (8 + 4 + 12));
}

TEST(Film, ForgetsSamplesOnResize)
{
  Film film;
  film.resize(4, 4);
  film.setSamples(3);
  film.splitNearestDepth();
  EXPECT_NE(film.nearestDepth(), film.depth());
  film.resize(4, 4);
  EXPECT_EQ(film.samples(), 0);
  EXPECT_EQ(film.nearestDepth(), film.depth());
}

TEST(Film, SplitsNearestDepthOnce)
{
  Film film;
  film.resize(2, 1);
  film.depth()[0] = 5.0f;
  film.depth()[1] = 6.0f;
  EXPECT_EQ(film.nearestDepth()[1], 6.0f);
  film.splitNearestDepth();
  film.nearestDepth()[0] = 1.0f;
  film.splitNearestDepth(); // must not copy the depth again
  EXPECT_EQ(film.nearestDepth()[0], 1.0f);
  EXPECT_EQ(film.depth()[0], 5.0f);
}

TEST(FilmFill, InterpolatesColoursAndTakesTheNearestDepth)
{
  Film coarse, fine;
  coarse.resize(5, 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 5; ++x)
    {
      for (int c = 0; c < 4; ++c)
        coarse.color()[4 * (5 * y + x) + c] = 0.1f * float(x) + 0.2f * float(y) + 0.05f * float(c);
      coarse.depth()[5 * y + x] = float(10 * y + x);
    }
  fine.resize(20, 12);
  fillFrom(coarse, fine);
  EXPECT_EQ(fine.samples(), 0);
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 20; ++x)
    {
      // A plane stays one, but beyond the middles of the outermost pixels.
      const float u = std::clamp((float(x) + 0.5f) / 4 - 0.5f, 0.0f, 4.0f);
      const float v = std::clamp((float(y) + 0.5f) / 4 - 0.5f, 0.0f, 2.0f);
      for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(
          fine.color()[4 * (20 * y + x) + c], 0.1f * u + 0.2f * v + 0.05f * float(c), 1e-5f);
      EXPECT_EQ(fine.depth()[20 * y + x], float(10 * (y / 4) + x / 4));
    }
  Film same;
  same.resize(5, 3);
  fillFrom(coarse, same);
  EXPECT_TRUE(std::equal(same.color(), same.color() + 60, coarse.color()));
}

TEST(FilmFill, TakesTheNearestIdsWhereBothFilmsHaveThem)
{
  Film coarse, fine, without;
  coarse.resize(2, 1, Film::Id);
  fillWithNothing(coarse);
  coarse.id()[1] = 7;
  coarse.object()[1] = 3;
  fine.resize(4, 1, Film::Id);
  fillFrom(coarse, fine);
  EXPECT_EQ(fine.id()[1], Film::noId);
  EXPECT_EQ(fine.object()[1], -1);
  EXPECT_EQ(fine.id()[2], 7u);
  EXPECT_EQ(fine.object()[3], 3);
  without.resize(4, 1);
  fillFrom(coarse, without); // writes no channel that is not there
  EXPECT_FALSE(without.has(Film::Id));
}

TEST(FilmFill, NothingIsInfinitelyFar)
{
  Film film;
  film.resize(3, 2, Film::Id | Film::Normal | Film::Variance);
  fillWithNothing(film);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(film.color()[4 * i + 3], 0.0f);
    EXPECT_EQ(film.depth()[i], std::numeric_limits<float>::infinity());
    EXPECT_EQ(film.id()[i], Film::noId);
    EXPECT_EQ(film.object()[i], -1);
    EXPECT_EQ(film.normal()[3 * i], 0.0f);
  }
}
