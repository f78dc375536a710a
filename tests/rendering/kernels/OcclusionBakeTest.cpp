// Baked occlusion against closed forms, brute force, and what must be exactly equal.

#include "OcclusionParts.h"

#include <kernels/core/Error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

using namespace mote;
using namespace mote::testing;

TEST(OcclusionBake, ALoneSphereIsOpenEverywhere)
{
  Random random(701);
  for (int k = 0; k < 12; ++k)
  {
    Particles particles;
    particles.add(random.inBox(Vec3d(-5.0), Vec3d(5.0)), std::pow(10.0, random(-6.0, 6.0)));
    for (const bool adaptive : {true, false})
    {
      OcclusionBakeOptions options;
      options.adaptive = adaptive;
      OcclusionBakeStatistics statistics;
      const OcclusionMaps maps = baked(particles, options, kinds[k % kinds.size()], &statistics);
      EXPECT_EQ(statistics.levels[maps.level(0)], 1u);
      EXPECT_EQ(maps.level(0), adaptive ? OcclusionMaps::Open : OcclusionMaps::Side16);
      for (int i = 0; i < 200; ++i)
        ASSERT_EQ(maps.at(0, Vec3f(random.direction())), 1.0f);
    }
  }
}

TEST(OcclusionBake, TouchingSpheresAgreeWithTheClosedForm)
{
  // RadiiOfVeryDifferentSize has more directions and other sizes.
  Random random(702);
  for (const double other : {1.0, 40.0})
  {
    double square = 0.0;
    for (int k = 0; k < 6; ++k)
    {
      const Particles particles = touching(1.0, other, random.direction());
      OcclusionBakeStatistics statistics;
      const OcclusionMaps maps =
        baked(particles, fullMaps(16, 49), kinds[k % kinds.size()], &statistics);
      square += std::pow(touchingError(particles, maps), 2) / 6;
      EXPECT_LE(statistics.rays, 2u * 256u * 52u);
      EXPECT_EQ(statistics.particles, 2u);
    }
    EXPECT_LE(std::sqrt(square), 1e-2) << other;
  }
}

TEST(OcclusionBake, ErrorFallsAtLeastAsTheRootOfTheRays)
{
  Random random(703);
  std::vector<Particles> pairs;
  for (int k = 0; k < 4; ++k)
    pairs.push_back(touching(1.0, 1.0 + k, random.direction()));
  double before = infinity;
  for (const int samples : {12, 49, 196, 784})
  {
    double square = 0.0;
    for (const Particles& particles : pairs)
      square += std::pow(touchingError(particles, baked(particles, fullMaps(16, samples))), 2) / 4;
    const double error = std::sqrt(square);
    std::cout << samples << " samples a texel: RMS error " << error << "\n";
    // Bytes alone err by 0.0012.
    EXPECT_LE(std::sqrt(std::max(0.0, error * error - 2e-6)), 0.5 * before);
    before = error;
  }
}

TEST(OcclusionBake, AfterAChangeOnlyWhatItReachesIsBakedAnew)
{
  const Particles particles = randomParticles(800, 704, 0.02, 0.06);
  for (const auto kind : kinds)
    for (const double reach : {0.15, 5.0, infinity})
    {
      const auto structure = structureOf(particles, kind);
      const auto show = [&](double most)
      {
        ParticleRanges ranges;
        ranges.upper[0] = most;
        std::visit([&](auto& s) { s.setRanges(ranges); }, *structure);
      };
      OcclusionBakeOptions options = fullMaps(4, 20, reach);
      show(0.5);
      const OcclusionMaps before = bakeOcclusion(*structure, options);
      const auto shownBefore = shownBits(*structure);
      EXPECT_TRUE(isSame(before, stillValid(before, *structure, shownBefore, reach)));
      show(0.7);
      const OcclusionMaps kept = stillValid(before, *structure, shownBefore, reach);
      OcclusionBakeStatistics statistics;
      const OcclusionMaps after = bakeOcclusion(*structure, options, {}, &statistics, &kept);
      EXPECT_TRUE(isSame(after, bakeOcclusion(*structure, options)));
      if (reach < 1.0)
        EXPECT_LT(statistics.particles, 350u); // of 680, 160 of them within reach of the change
      else
        EXPECT_GT(statistics.particles, 600u);
      EXPECT_THROW(stillValid(before, *structure, {}, reach), Error);
    }
}
