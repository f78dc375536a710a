// Films: which settings each frame has.

#include <base/Failure.h>
#include <commands/Film.h>
#include <commands/FilmPlan.h>
#include <commands/KeyFrames.h>
#include <table/Row.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace mote::app;

namespace
{

Settings keyAt(const std::vector<double>& camera)
{
  Settings key;
  key.camera.camera = camera;
  return key;
}

const std::vector<double> front = {0, -10, 0, 0, 0, 0, 0, 0, 1, 30};
const std::vector<double> right = {10, 0, 0, 0, 0, 0, 0, 0, 1, 30};

double distance(const std::vector<double>& camera)
{
  return std::hypot(camera[0] - camera[3], camera[1] - camera[4], camera[2] - camera[5]);
}

void expectNear(const std::vector<double>& a, const std::vector<double>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a[i], b[i], 1e-9) << i;
}

FilmScene sceneOf(int steps)
{
  FilmScene scene;
  scene.keys = {keyAt(front)};
  scene.keySteps = {steps - 1};
  scene.steps = steps;
  scene.bounds = {-1, 1, -1, 1, -1, 1};
  scene.name = "data";
  return scene;
}

} // namespace

TEST(Film, CamerasGoAroundWhatTheyLookAt)
{
  const std::vector<Settings> keys = {keyAt(front), keyAt(right)};
  expectNear(between(keys, 0.0).camera.camera, front);
  expectNear(between(keys, 1.0).camera.camera, right);
  const double s = 10.0 / std::sqrt(2.0);
  expectNear(between(keys, 0.5).camera.camera, {s, -s, 0, 0, 0, 0, 0, 0, 1, 30});
  for (double share = 0.0; share <= 1.0; share += 0.1)
    EXPECT_NEAR(distance(between(keys, share).camera.camera), 10.0, 1e-9) << share;
}

TEST(Film, PathsAreSmoothAtTheirKeys)
{
  std::vector<double> near = right;
  near[0] = 2.0;
  const std::vector<Settings> keys = {keyAt(front), keyAt(right), keyAt(near), keyAt(front)};
  for (const int key : {1, 2})
  {
    const double at = key / 3.0, step = 1e-5;
    for (int i = 0; i < 10; ++i)
    {
      const double before =
        (between(keys, at).camera.camera[i] - between(keys, at - step).camera.camera[i]) / step;
      const double after =
        (between(keys, at + step).camera.camera[i] - between(keys, at).camera.camera[i]) / step;
      EXPECT_NEAR(before, after, 1e-2 * (1.0 + std::abs(before))) << key << " " << i;
    }
  }
}

TEST(Film, NumbersGoFromKeyToKeyAndOthersChangeThere)
{
  Settings a = keyAt(front), b = keyAt(front);
  a.light.size = 10.0, b.light.size = 20.0;
  a.picture.samples = 4, b.picture.samples = 7;
  a.selection.ranges = {{"x", {{0.0, INFINITY}}}}, b.selection.ranges = {{"x", {{8.0, INFINITY}}}};
  a.volume.opacity = {{10.0, true, 0.2}}, b.volume.opacity = {{30.0, true, 0.4}};
  a.picture.background = {{0.0, 0.0, 0.0}}, b.picture.background = {{1.0, 0.5, 0.0}};
  a.light.shadows = "none", b.light.shadows = "soft";
  a.color.range = {}, b.color.range = {1.0, 2.0}; // not as many
  const Settings half = between({a, b}, 0.5);
  EXPECT_DOUBLE_EQ(half.light.size, 15.0);
  EXPECT_TRUE(half.picture.samples == 5 || half.picture.samples == 6);
  EXPECT_DOUBLE_EQ(half.selection.ranges[0].intervals[0].low, 4.0);
  EXPECT_TRUE(std::isinf(half.selection.ranges[0].intervals[0].high));
  EXPECT_DOUBLE_EQ(half.volume.opacity[0].value, 20.0);
  EXPECT_DOUBLE_EQ(half.volume.opacity[0].opacity, 0.3);
  EXPECT_EQ(half.picture.background, (std::vector<Color>{{0.5, 0.25, 0.0}}));
  EXPECT_EQ(half.light.shadows, "none");
  EXPECT_TRUE(half.color.range.empty());
  EXPECT_EQ(between({a, b}, 1.0), b);
}

TEST(Film, OrbitsTurnAboutTheMiddleAndComeRound)
{
  FilmSettings film;
  film.orbit = 360.0;
  film.frames = 4;
  const auto frames = planFilm(sceneOf(1), film);
  ASSERT_EQ(frames.size(), 4u);
  expectNear(frames[0].camera.camera, front);
  expectNear(frames[1].camera.camera, right);
  expectNear(frames[2].camera.camera, {0, 10, 0, 0, 0, 0, 0, 0, 1, 30});
  // About what a camera looks at, where that is elsewhere.
  const std::vector<double> aside = {50, -10, 0, 50, 0, 0, 0, 0, 1, 30};
  expectNear(turned(aside, {-1, 1, -1, 1, -1, 1}, 90.0), {60, 0, 0, 50, 0, 0, 0, 0, 1, 30});
}

TEST(Film, StepsAreSpreadOverTheFrames)
{
  FilmSettings film;
  film.framesPerStep = 2;
  auto stepsOf = [&](int steps)
  {
    std::vector<std::string> all;
    for (const Settings& frame : planFilm(sceneOf(steps), film))
      all.push_back(frame.data.step);
    return all;
  };
  EXPECT_EQ(stepsOf(3), (std::vector<std::string>{"1", "1", "2", "2", "3", "3"}));
  film.steps = "2:6:2";
  film.frames = 3;
  EXPECT_EQ(stepsOf(7), (std::vector<std::string>{"2", "4", "6"}));
  film.steps = "4:";
  film.frames = 4;
  EXPECT_EQ(stepsOf(7), (std::vector<std::string>{"4", "5", "6", "7"}));
  EXPECT_THROW(stepsOf(3), Failure);
  // A video of few steps is long enough to be looked at; pictures are one a step.
  film = {};
  EXPECT_EQ(stepsOf(7).size(), 56u);
  EXPECT_EQ(stepsOf(80).size(), 80u);
  film.steps = "all";
  film.orbit = 360.0;
  EXPECT_EQ(stepsOf(80).size(), 320u) << "ten seconds for the turn, at least";
  FilmScene pictures = sceneOf(7);
  pictures.isVideo = false;
  EXPECT_EQ(planFilm(pictures, film).size(), 7u);
  film = {};
  EXPECT_THROW(stepsOf(1), Failure) << "nothing moves";
  film.orbit = 36.0;
  EXPECT_EQ(planFilm(sceneOf(7), film).size(), 25u);
  EXPECT_EQ(planFilm(sceneOf(7), film).front().data.step, "7") << "stays where it is";
}

TEST(Film, WhatItWillBeIsTold)
{
  FilmSettings film;
  EXPECT_EQ(forecast({}, 80, film).length, "80 frames, 3.20 s");
  EXPECT_EQ(forecast({}, 80, film).steps, "");
  EXPECT_EQ(forecast({}, 12, film).length, "60 frames, 2.40 s");
  EXPECT_EQ(forecast({}, 12, film, false).length, "12 frames, 0.48 s");
  EXPECT_EQ(forecast({}, 1, film).length, "nothing moves in this film");
  film.steps = "90:100";
  EXPECT_EQ(
    forecast({}, 80, film).length, "the series has 80 time steps, so there is no --steps 90:100");
  film.steps = "";
  std::vector<Settings> keys = {keyAt(front), keyAt(right)};
  EXPECT_EQ(forecast(keys, 80, film).length, "50 frames, 2.00 s");
  EXPECT_EQ(forecast(keys, 80, film).steps,
    "all frames show one of 80 time steps; --steps all plays them, or 'all' at time steps");
  EXPECT_EQ(forecast(keys, 1, film).steps, "");
  film.steps = "all";
  EXPECT_EQ(forecast(keys, 80, film).steps, "");
  film.steps = "";
  keys.front().data.step = "1";
  EXPECT_EQ(forecast(keys, 80, film).steps, "") << "it goes from step to step";
}

TEST(Film, NamesOfFramesHaveTheirNumber)
{
  EXPECT_EQ(frameName("f-%04d.png", 12), "f-0012.png");
  EXPECT_EQ(frameName("f%d.png", 12345), "f12345.png");
  EXPECT_EQ(frameName("f-%02d.png", 12345), "f-12345.png");
  EXPECT_FALSE(stepRange("2:1"));
  EXPECT_EQ(stepRange("5")->last, 5);
  EXPECT_EQ(stepRange(":9")->first, 1);
}
