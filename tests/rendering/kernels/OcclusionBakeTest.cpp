// Baked occlusion against closed forms, brute force, and what must be exactly equal.

#include "SceneParts.h"

#include <kernels/core/Error.h>
#include <kernels/shading/OcclusionBake.h>

#include <support/Reference.h>

#include <gtest/gtest.h>

#include <functional>
#include <iostream>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr ParticleStructureKind kinds[] = {ParticleStructureKind::CoherentGrid,
  ParticleStructureKind::PkdTree, ParticleStructureKind::PkdPaper};

std::shared_ptr<ParticleStructure> structureOf(
  const Particles& particles, ParticleStructureKind kind = ParticleStructureKind::Automatic)
{
  ParticleStructureOptions options;
  options.kind = kind;
  return makeParticleStructure(particles.set(), options);
}

/// Maps by input index.
OcclusionMaps baked(const Particles& particles, const OcclusionBakeOptions& options,
  ParticleStructureKind kind = ParticleStructureKind::Automatic,
  OcclusionBakeStatistics* statistics = nullptr)
{
  const auto structure = structureOf(particles, kind);
  return bakeOcclusion(*structure, options, {}, statistics)
    .inInputOrder(*structure, particles.size());
}

bool isSame(const OcclusionMaps& a, const OcclusionMaps& b)
{
  for (std::size_t k = 0; k < a.size(); ++k)
    if (a.level(k) != b.level(k))
      return false;
  return a.size() == b.size() &&
         std::equal(a.texels().begin(), a.texels().end(), b.texels().begin(), b.texels().end());
}

OcclusionBakeOptions fullMaps(int side, int samples, double reach = infinity)
{
  OcclusionBakeOptions options;
  options.side = side;
  options.samples = samples;
  options.reach = reach;
  options.adaptive = false;
  return options;
}

Vec3d directionAt(double row, double column, int side)
{
  const double theta = M_PI * row / side, phi = 2.0 * M_PI * column / side;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

double areaOf(int side, int row)
{
  return (std::cos(M_PI * row / side) - std::cos(M_PI * (row + 1) / side)) / (2.0 * side);
}

using Wanted = std::function<double(const Vec3d& normal)>;

/// Root mean square, over the sphere, of the difference of a map's texels from the means of what is
/// wanted over them. `outside` says which places count; a texel counts for the share of them.
double rmsOf(
  const OcclusionMaps& maps, std::size_t particle, const Wanted& wanted,
  const std::function<bool(const Vec3d&)>& outside = [](const Vec3d&) { return true; })
{
  constexpr int parts = 1;
  const int side = OcclusionMaps::side(maps.level(particle));
  double sum = 0.0, weights = 0.0;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column)
    {
      double mean = 0.0;
      int places = 0;
      for (int k = 0; k < parts * parts; ++k)
      {
        const Vec3d normal =
          directionAt(row + (k / parts + 0.5) / parts, column + (k % parts + 0.5) / parts, side);
        if (!outside(normal))
          continue;
        mean += wanted(normal);
        ++places;
      }
      if (places == 0)
        continue;
      const auto texel = static_cast<std::size_t>(row * side + column);
      const double off = maps.decoded(maps.texels(particle)[texel]) - mean / places;
      const double weight = areaOf(side, row) * places;
      sum += weight * off * off;
      weights += weight;
    }
  return std::sqrt(sum / weights);
}

/// A sphere about the origin and one that touches it on the side of `way`.
Particles touching(double radius, double otherRadius, const Vec3d& way)
{
  Particles particles;
  particles.add(Vec3d(0.0), radius);
  particles.add((radius + otherRadius) * way, otherRadius);
  return particles;
}

/// RMS error of the two maps' texels against the closed form.
double touchingError(const Particles& particles, const OcclusionMaps& maps)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < 2; ++k)
  {
    const double rms = rmsOf(maps, k,
      [&](const Vec3d& normal)
      {
        return 1.0 - occlusionBySphere(particles.center(k) + particles.radii[k] * normal, normal,
                       particles.center(1 - k), particles.radii[1 - k]);
      });
    sum += 0.5 * rms * rms;
  }
  return std::sqrt(sum);
}

} // namespace

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
      const OcclusionMaps maps = baked(particles, options, kinds[k % 3]);
      EXPECT_EQ(maps.level(0), adaptive ? OcclusionMaps::Open : OcclusionMaps::Side16);
      for (int i = 0; i < 200; ++i)
        ASSERT_EQ(maps.at(0, Vec3f(random.direction())), 1.0f);
    }
  }
}

TEST(OcclusionBake, TouchingSpheresAgreeWithTheClosedForm)
{
  Random random(702);
  for (const double other : {1.0, 40.0})
    for (int k = 0; k < 6; ++k)
    {
      const Particles particles = touching(1.0, other, random.direction());
      OcclusionBakeStatistics statistics;
      const OcclusionMaps maps = baked(particles, fullMaps(16, 49), kinds[k % 3], &statistics);
      EXPECT_LE(touchingError(particles, maps), 1e-2) << other;
      EXPECT_LE(statistics.rays, 2u * 256u * 51u);
      EXPECT_EQ(statistics.particles, 2u);
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
