// The samples' variance, the noise of a picture, and when it is small enough.

#include "ShadowParts.h"

#include <kernels/tracing/Refinement.h>

#include <support/CastOracle.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

/// Random spheres under a noisy sky.
Scene noisyScene()
{
  Scene scene;
  addTo(scene, objectOf(randomParticles(200, 601, 0.05, 0.2)));
  scene.surfaces[0].material.ambient = 1.0f;
  scene.surfaces[0].material.diffuse = 0.0f;
  scene.lights.clear();
  scene.occlusion = {1, 0.5};
  return scene;
}

const Camera camera = lookAt({1.0, 2.0, 4.0}, Vec3d(0.0), 40.0);

void addSamples(const Scene& scene, Film& film, int count)
{
  for (int k = 0; k < count; ++k)
    ASSERT_TRUE(RayCaster(scene).addSample(camera, film));
}

} // namespace

TEST(Refinement, VarianceIsThatOfTheSamples)
{
  const Scene scene = noisyScene();
  Film film;
  film.resize(40, 30, Film::Variance);
  // Each sample alone: what the mean becomes tells what was added.
  std::vector<std::vector<double>> samples;
  std::vector<double> sum(4 * film.pixels(), 0.0);
  const int count = 9;
  for (int k = 0; k < count; ++k)
  {
    addSamples(scene, film, 1);
    samples.emplace_back();
    for (std::size_t i = 0; i < sum.size(); ++i)
    {
      const double total = double(film.color()[i]) * (k + 1);
      samples.back().push_back(total - sum[i]);
      sum[i] = total;
    }
  }
  int varying = 0;
  for (std::size_t i = 0; i < film.pixels(); ++i)
  {
    double variance = 0.0;
    for (std::size_t c = 4 * i; c < 4 * i + 4; ++c)
      for (const auto& sample : samples)
        variance += 0.25 * std::pow(sample[c] - sum[c] / count, 2.0) / (count - 1);
    varying += variance > 0.01;
    EXPECT_NEAR(film.variance(i), variance, 1e-5);
  }
  EXPECT_GT(varying, 100);
}

TEST(Refinement, PicturesDoNotDependOnWhetherVarianceIsKept)
{
  const Scene scene = noisyScene();
  Film with, without;
  with.resize(40, 30, Film::Variance);
  without.resize(40, 30);
  EXPECT_EQ(with.bytes(), without.bytes() + 40 * 30 * sizeof(float));
  addSamples(scene, with, 3);
  addSamples(scene, without, 3);
  EXPECT_TRUE(std::equal(with.color(), with.color() + 4 * with.pixels(), without.color()));
}

TEST(Refinement, StandardErrorIsThatOfPicturesOfIndependentSamples)
{
  // By hand: half of the pixels show something, of samples with known squares.
  Film film;
  film.resize(200, 100, Film::Variance);
  for (std::size_t i = 0; i < film.pixels(); ++i)
  {
    film.color()[4 * i + 3] = i % 2 == 0 ? 1.0f : 0.0f;
    film.squares()[i] = i % 2 == 0 ? (i % 4 == 0 ? 6.0f : 0.0f) : 100.0f;
  }
  film.setSamples(1);
  EXPECT_TRUE(std::isinf(standardError(film)));
  film.setSamples(7);
  EXPECT_NEAR(standardError(film), std::sqrt(0.5 / 7.0), 1e-6);
  for (std::size_t i = 0; i < film.pixels(); ++i)
    film.color()[4 * i + 1] = 3.0f;
  EXPECT_NEAR(standardError(film), std::sqrt(0.5 / 7.0) / 3.0, 1e-6);
  for (std::size_t i = 0; i < film.pixels(); ++i)
    film.color()[4 * i + 3] = 0.0f;
  EXPECT_EQ(standardError(film), 0.0);
}

TEST(Refinement, TheErrorIsNoLargerThanTheStandardError)
{
  const Scene scene = noisyScene();
  Film wanted;
  wanted.resize(64, 64, Film::Id);
  addSamples(scene, wanted, 1024);
  for (const int samples : {4, 16, 64})
  {
    Film film;
    film.resize(64, 64, Film::Id | Film::Variance);
    addSamples(scene, film, samples);
    const double error = rmsOf(film, wanted), estimate = standardError(film);
    std::printf("%4d samples: rms error %.4f, standard error %.4f\n", samples, error, estimate);
    EXPECT_LT(error, 1.3 * estimate); // of red, where the estimate has alpha, too
    EXPECT_GT(error, 0.2 * estimate);
  }
}

TEST(Refinement, StopsAtTheNoiseOrTheNumberOfSamples)
{
  const Scene scene = noisyScene();
  const Refinement rule{1000, 0.03};
  Film film;
  film.resize(64, 64, rule.channels());
  double before = 0.0;
  while (!rule.isDone(film))
  {
    ASSERT_TRUE(film.samples() < Refinement::fewestSamples || standardError(film) > 0.03);
    EXPECT_GE(rule.progress(film), 0.8 * before);
    before = rule.progress(film);
    addSamples(scene, film, 1);
  }
  EXPECT_LE(standardError(film), 0.03);
  EXPECT_GT(film.samples(), 8);
  EXPECT_LT(film.samples(), 400);
  EXPECT_EQ(rule.progress(film), 1.0);
  // Four times as many samples for half of the noise.
  const int samples = film.samples();
  const Refinement finer{1000, 0.015};
  while (!finer.isDone(film))
    addSamples(scene, film, 1);
  EXPECT_NEAR(film.samples(), 4 * samples, samples);

  EXPECT_TRUE((Refinement{samples, 1e-9}.isDone(film)));
  EXPECT_FALSE((Refinement{1000, 0.0}.isDone(film)));
  EXPECT_FALSE((Refinement{1000, 1e-9}.isDone(film)));
  EXPECT_EQ((Refinement{1000, 0.0}.channels()), 0u);
}

TEST(Refinement, AFewLuckySamplesAreNotBelieved)
{
  Film film;
  film.resize(4, 4, Film::Variance);
  std::fill_n(film.squares(), film.pixels(), 0.0f);
  const Refinement rule{1000, 0.1};
  for (int samples = 0; samples < Refinement::fewestSamples; ++samples)
  {
    film.setSamples(samples);
    EXPECT_FALSE(rule.isDone(film)) << samples;
  }
  film.setSamples(Refinement::fewestSamples);
  EXPECT_TRUE(rule.isDone(film));
}
