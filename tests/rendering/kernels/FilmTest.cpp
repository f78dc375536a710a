#include <kernels/core/Film.h>

#include <gtest/gtest.h>

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
