// Baked occlusion: hard cases, and equalities that must hold.

#include "OcclusionParts.h"

#include <kernels/core/Error.h>

#include <support/Reference.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace mote;
using namespace mote::testing;

namespace
{

/// What differs between two sets of maps of the same levels.
struct Difference
{
  std::size_t texels = 0, different = 0;
  double rms = 0.0;
};

Difference differenceOf(const OcclusionMaps& a, const OcclusionMaps& b)
{
  Difference difference;
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    EXPECT_EQ(a.level(k), b.level(k)) << k;
    if (a.level(k) != b.level(k))
      continue;
    for (std::size_t i = 0; i < a.texels(k).size(); ++i)
    {
      const double off = double(a.decoded(a.texels(k)[i])) - double(b.decoded(b.texels(k)[i]));
      ++difference.texels;
      difference.different += off != 0.0;
      difference.rms += off * off;
    }
  }
  difference.rms = std::sqrt(difference.rms / double(std::max<std::size_t>(difference.texels, 1)));
  return difference;
}

/// The same bake with all rays cast one by one through the structure.
OcclusionMaps bakedRayByRay(const ParticleStructure& structure, OcclusionBakeOptions options)
{
  options.occlude = [&](RayPacket& rays)
  { withStructure(structure, [&](const auto& s) { s.occlude(rays, 0); }); };
  return bakeOcclusion(structure, options);
}

/// Radii over `decades` powers of ten.
Particles variedParticles(std::size_t count, std::uint64_t seed, double largest, double decades)
{
  Random random(seed);
  Particles particles;
  for (std::size_t k = 0; k < count; ++k)
    particles.add(
      random.inBox(Vec3d(-1.0), Vec3d(1.0)), largest * std::pow(10.0, random(-decades, 0.0)));
  return particles;
}

bool isInsideAnother(const Particles& particles, std::size_t k, const Vec3d& at)
{
  for (std::size_t j = 0; j < particles.size(); ++j)
    if (j != k && glm::distance(particles.center(j), at) < particles.radii[j])
      return true;
  return false;
}

} // namespace

TEST(OcclusionBake, AllWaysToAskRaysAgree)
{
  const Particles sets[] = {randomParticles(250, 801, 0.05, 0.1),
    randomParticles(80, 802, 0.2, 0.4), variedParticles(250, 803, 0.5, 4.0),
    variedParticles(120, 804, 0.3, 1.0)};
  for (const Particles& particles : sets)
    for (const auto kind : kinds)
      for (const double reach : {0.04, 0.5, infinity})
      {
        const auto structure = structureOf(particles, kind);
        OcclusionBakeOptions options = fullMaps(8, 12, reach);
        const OcclusionMaps maps = bakeOcclusion(*structure, options);
        const Difference difference = differenceOf(maps, bakedRayByRay(*structure, options));
        EXPECT_GT(difference.texels, 1000u);
        // Single rays that graze a sphere.
        EXPECT_LE(double(difference.different), 0.003 * double(difference.texels));
        EXPECT_LE(difference.rms, 6e-3);
      }
}

TEST(OcclusionBake, AgreesWithBruteForce)
{
  const Particles particles = randomParticles(200, 805, 0.1, 0.25);
  const std::vector<reference::Sphere> spheres = reference::validSpheres(particles.set());
  for (const double reach : {0.3, infinity})
  {
    const OcclusionMaps maps = baked(particles, fullMaps(8, 784, reach));
    double sum = 0.0;
    int count = 0;
    for (std::size_t k = 0; k < 40; ++k)
      for (int texel = 0; texel < 64 && maps.level(k) != OcclusionMaps::Dark; texel += 5)
      {
        const Vec3d normal = directionAt(texel / 8 + 0.5, texel % 8 + 0.5, 8);
        const Vec3d at = particles.center(k) + particles.radii[k] * normal;
        if (isInsideAnother(particles, k, at))
          continue;
        Vec3d u, v;
        acrossAxes(normal, u, v);
        constexpr int side = 32;
        int open = 0;
        for (int i = 0; i < side * side; ++i)
        {
          const double share = (i % side + 0.5) / side,
                       angle = 2.0 * M_PI * (i / side + 0.5) / side;
          const Vec3d way = std::sqrt(share) * (std::cos(angle) * u + std::sin(angle) * v) +
                            std::sqrt(1.0 - share) * normal;
          reference::Hit hit;
          for (const reference::Sphere& sphere : spheres)
            if (sphere.particle != k)
              reference::meet({at, way, 0.0, reach}, sphere, hit);
          open += !hit;
        }
        const double off = maps.decoded(maps.texels(k)[static_cast<std::size_t>(texel)]) -
                           double(open) / (side * side);
        sum += off * off;
        ++count;
      }
    ASSERT_GT(count, 100);
    EXPECT_LE(std::sqrt(sum / count), 5e-3) << reach;
  }
}

TEST(OcclusionBake, SpheresFarApartInALayerAreNotInTheirOwnWay)
{
  // Floats of this size are 0.008 radii apart, along two of three axes.
  Particles particles;
  Random random(812);
  for (int k = 0; k < 40; ++k)
    particles.add(random.inBox({-1e5, -1e5, 0.0}, {1e5, 1e5, 0.0}), 1.0);
  for (const auto kind : kinds)
  {
    const OcclusionMaps maps = baked(particles, fullMaps(8, 49, 10.0), kind);
    for (std::size_t k = 0; k < maps.size(); ++k)
      for (const std::uint8_t texel : maps.texels(k))
        ASSERT_EQ(maps.decoded(texel), 1.0f) << k;
  }
}

TEST(OcclusionBake, NestedAndCoincidentSpheres)
{
  for (const auto kind : kinds)
  {
    Particles particles;
    particles.add({1.0, 2.0, 3.0}, 1.0);
    particles.add({1.3, 2.1, 3.0}, 0.5); // all inside of the first
    particles.add({9.0, 2.0, 3.0}, 0.7);
    particles.add({9.0, 2.0, 3.0}, 0.7); // twice the same
    particles.add({9.0, 2.0, 3.0}, 0.7);
    for (const bool adaptive : {true, false})
    {
      OcclusionBakeOptions options = fullMaps(8, 49, 2.0);
      options.adaptive = adaptive;
      const OcclusionMaps maps = baked(particles, options, kind);
      EXPECT_EQ(maps.level(1), OcclusionMaps::Dark);
      Random random(806);
      for (const std::size_t k : {0, 2, 3, 4})
        for (int i = 0; i < 50; ++i)
          ASSERT_EQ(maps.at(k, Vec3f(random.direction())), 1.0f) << k;
    }
  }
}

TEST(OcclusionBake, OverlappingSpheres)
{
  Particles particles;
  particles.add(Vec3d(0.0), 1.0);
  particles.add({0.5, 0.3, 0.9}, 0.8);
  const Wanted wanted = [&](const Vec3d& normal)
  { return 1.0 - occlusionBySphere(normal, normal, particles.center(1), 0.8); };
  const auto outside = [&](const Vec3d& normal)
  { return glm::distance(normal, particles.center(1)) > 0.8; };
  OcclusionBakeOptions options = fullMaps(16, 196);
  const OcclusionMaps filled = baked(particles, options);
  options.dilate = false;
  const OcclusionMaps dark = baked(particles, options);
  EXPECT_LE(rmsOf(filled, 0, wanted, outside), 2e-2); // a texel's places, where it is cut
  int inside = 0;
  for (int row = 0; row < 16; ++row)
    for (int column = 0; column < 16; ++column)
    {
      int places = 0;
      for (int k = 0; k < 64; ++k)
        places += outside(directionAt(row + (k / 8 + 0.5) / 8, column + (k % 8 + 0.5) / 8, 16));
      const auto texel = static_cast<std::size_t>(16 * row + column);
      if (places == 0)
      {
        ++inside;
        EXPECT_EQ(dark.texels(0)[texel], 0);
        EXPECT_GT(filled.texels(0)[texel], 0);
      }
      else if (places == 64)
      {
        EXPECT_EQ(dark.texels(0)[texel], filled.texels(0)[texel]);
      }
    }
  EXPECT_GT(inside, 10);
}

TEST(OcclusionBake, RadiiOfVeryDifferentSize)
{
  Random random(807);
  for (const double other : {1.0, 40.0, 1e2, 1e3, 1e4})
  {
    double square = 0.0, greatest = 0.0;
    constexpr int repeats = 60;
    for (int k = 0; k < repeats; ++k)
    {
      const Particles particles = touching(1.0, other, random.direction());
      const double error =
        touchingError(particles, baked(particles, fullMaps(16, 49), kinds[k % kinds.size()]));
      square += error * error / repeats;
      greatest = std::max(greatest, error);
    }
    std::cout << "radii 1 and " << other << ": RMS error " << std::sqrt(square) << ", greatest of "
              << repeats << " directions " << greatest << "\n";
    EXPECT_LE(std::sqrt(square), 1e-2) << other;
    EXPECT_LE(greatest, other == 1.0 ? 1e-2 : 1.6e-2) << other;
  }
}

TEST(OcclusionBake, SelectionAndNothing)
{
  const Particles particles = randomParticles(300, 808, 0.02, 0.1);
  const auto structure = structureOf(particles);
  OcclusionBakeOptions options = fullMaps(4, 12, 0.5);
  const OcclusionMaps all = bakeOcclusion(*structure, options);
  OcclusionBakeStatistics statistics;
  options.selected = [](std::size_t) { return false; };
  const OcclusionMaps none = bakeOcclusion(*structure, options, {}, &statistics);
  EXPECT_EQ(statistics.particles, 0u);
  EXPECT_EQ(none.size(), 300u);
  EXPECT_TRUE(none.texels().empty());
  options.selected = [](std::size_t slot) { return slot % 3 == 1; };
  const OcclusionMaps some = bakeOcclusion(*structure, options, {}, nullptr, &none);
  for (std::size_t slot = 0; slot < 300; ++slot)
    EXPECT_EQ(some.level(slot), slot % 3 == 1 ? all.level(slot) : OcclusionMaps::NotBaked);
  options.selected = {};
  EXPECT_TRUE(isSame(all, bakeOcclusion(*structure, options, {}, &statistics, &some)));
  EXPECT_EQ(statistics.particles, 200u);
  EXPECT_EQ(bakeOcclusion(*structureOf(Particles()), options).size(), 0u);
  options.side = 5;
  EXPECT_THROW(bakeOcclusion(*structure, options), Error);
  options = fullMaps(4, 12, -1.0);
  EXPECT_THROW(bakeOcclusion(*structure, options), Error);
  options = fullMaps(4, 12);
  const OcclusionMaps others(7);
  EXPECT_THROW(bakeOcclusion(*structure, options, {}, nullptr, &others), Error);
}

TEST(OcclusionBake, AnInterruptedBakeGoesOnWhereItStopped)
{
  const Particles particles = randomParticles(3000, 809, 0.02, 0.05);
  const auto structure = structureOf(particles);
  OcclusionBakeOptions options = fullMaps(4, 12, 0.2);
  OcclusionBakeStatistics statistics;
  double last = 0.0;
  const OcclusionMaps all = bakeOcclusion(
    *structure, options,
    [&](double share)
    {
      EXPECT_GE(share, 0.0);
      last = std::max(last, share);
      return true;
    },
    &statistics);
  EXPECT_EQ(last, 1.0);
  EXPECT_TRUE(statistics.finished);
  const OcclusionMaps half = bakeOcclusion(
    *structure, options, [](double share) { return share < 0.4; }, &statistics);
  EXPECT_FALSE(statistics.finished);
  EXPECT_GT(statistics.particles, 500u);
  EXPECT_LT(statistics.particles, 2900u);
  std::size_t baked = 0;
  for (std::size_t slot = 0; slot < 3000; ++slot)
    baked += half.isBaked(slot);
  EXPECT_EQ(baked, statistics.particles);
  EXPECT_TRUE(isSame(all, bakeOcclusion(*structure, options, {}, nullptr, &half)));
}

TEST(OcclusionBake, ThreadsChangeNothing)
{
  const Particles particles = randomParticles(2000, 810, 0.02, 0.08);
  const auto structure = structureOf(particles);
  OcclusionBakeOptions options;
  options.samples = 12;
  options.threads = 1;
  const OcclusionMaps one = bakeOcclusion(*structure, options);
  options.threads = 3;
  EXPECT_TRUE(isSame(one, bakeOcclusion(*structure, options)));
}

TEST(OcclusionBake, AdaptiveMapsAreSmallAndNearTheFullOnes)
{
  // A dense block: what is inside sees nothing.
  Particles particles;
  Random random(811);
  constexpr int side = 14;
  for (int k = 0; k < side * side * side; ++k)
    particles.add(
      Vec3d(k % side, k / side % side, k / side / side) + random.inBox(Vec3d(-0.15), Vec3d(0.15)),
      0.55);
  OcclusionBakeOptions options = fullMaps(16, 49, infinity);
  const OcclusionMaps full = baked(particles, options);
  options.adaptive = true;
  const OcclusionMaps maps = baked(particles, options);
  EXPECT_EQ(full.bytes(), 257u * particles.size() + 8u); // half a block of 16 more
  EXPECT_LT(maps.bytes(), full.bytes() / 2);
  // Each place counts by its chance to be seen, as in OcclusionBakeOptions::tolerance.
  double sum = 0.0;
  int dark = 0;
  for (std::size_t k = 0; k < particles.size(); ++k)
  {
    double square = 0.0;
    for (int i = 0; i < 100; ++i)
    {
      const Vec3f normal(random.direction());
      const double seen = full.at(k, normal), off = maps.at(k, normal) - seen;
      square += seen * off * off / 100;
    }
    EXPECT_LE(std::sqrt(square), 0.06) << k;
    sum += square / double(particles.size());
    dark += maps.level(k) == OcclusionMaps::Dark;
  }
  EXPECT_LE(std::sqrt(sum), 0.012);
  EXPECT_GT(dark, 8 * 8 * 8);
}

TEST(OcclusionBake, UnevenSky)
{
  Particles particles;
  particles.add(Vec3d(0.0), 2.0);
  OcclusionBakeOptions options = fullMaps(16, 49);
  options.sky = {1.0f, 0.2f, {0.0f, 0.6f, 0.8f}};
  const Wanted open = [&](const Vec3d& normal) { return options.sky.onOpen(Vec3f(normal)); };
  EXPECT_LE(rmsOf(baked(particles, options), 0, open), 3e-3);
  // The ground, nearly: what faces sideways sees the upper half of the sky alone. The mean of
  // (1 + z) / 2 over it, cosine-weighted about the horizon, is half of 1 / 2 and of the mean
  // height, 2 / (3 pi) x 2.
  options.sky = {1.0f, 0.0f, {0.0f, 0.0f, 1.0f}};
  particles.add({0.0, 0.0, -100002.0}, 100000.0);
  const OcclusionMaps maps = baked(particles, options);
  double sum = 0.0;
  for (int i = 0; i < 64; ++i)
    sum += maps.at(0, Vec3f(directionAt(8.0, i / 4.0, 16))) / 64.0;
  EXPECT_NEAR(sum, 0.25 + 1.0 / (3.0 * M_PI), 0.02);
}

TEST(NearParticles, AreThoseOfBruteForce)
{
  const Particles particles = variedParticles(2000, 812, 0.3, 3.0);
  Random random(813);
  for (const auto kind : kinds)
  {
    const auto structure = structureOf(particles, kind);
    for (int k = 0; k < 60; ++k)
    {
      // Of all, of some by visibility, and of so few that a tree has one of those alone.
      const std::size_t every = k < 20 ? 1 : k < 40 ? 3 : 40;
      const Vec3d at = random.inBox(Vec3d(-1.2), Vec3d(1.2));
      const double distance = random(0.0, 0.4);
      std::visit(
        [&](auto& s)
        {
          s.setVisibility([&](std::size_t slot) { return slot % every == 0; });
          std::vector<NearParticle> found;
          s.findNear(at, distance, found);
          std::vector<std::uint64_t> slots, wanted;
          for (const NearParticle& one : found)
          {
            slots.push_back(one.slot);
            EXPECT_EQ(one.center, s.center(one.slot));
            EXPECT_EQ(one.radius, s.radius(one.slot));
          }
          for (std::size_t slot = 0; slot < s.size(); ++slot)
          {
            EXPECT_EQ(s.isShown(slot), slot % every == 0);
            if (slot % every == 0 && glm::distance(s.center(slot), at) < distance + s.radius(slot))
              wanted.push_back(slot);
          }
          std::sort(slots.begin(), slots.end());
          EXPECT_EQ(slots, wanted);
        },
        *structure);
    }
  }
}
