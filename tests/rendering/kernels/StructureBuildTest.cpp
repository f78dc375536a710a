// What a built grid holds: every particle once, in an order that threads do not change.

#include <kernels/core/Error.h>
#include <support/Structure.h>

#include <support/CastOracle.h>
#include <support/Particles.h>

#include <gtest/gtest.h>

#include <tbb/task_arena.h>

#include <algorithm>

using namespace mote;
using namespace mote::testing;

namespace
{

struct Contents
{
  std::vector<std::uint64_t> indices;
  std::vector<Vec3d> centers;
  std::vector<double> radii;
  std::size_t bytes;
  bool operator==(const Contents&) const = default;
};

template <typename Structure>
Contents contentsOf(const Structure& grid)
{
  Contents contents{{}, {}, {}, grid.bytes()};
  for (std::size_t slot = 0; slot < grid.size(); ++slot)
  {
    contents.indices.push_back(grid.inputIndex(slot));
    contents.centers.push_back(grid.center(slot));
    contents.radii.push_back(grid.radius(slot));
  }
  return contents;
}

} // namespace

template <typename Structure>
using StructureBuild = StructureTest<Structure>;
TYPED_TEST_SUITE(StructureBuild, ParticleStructures, StructureName);

template <typename Structure>
using StructureVisibility = StructureTest<Structure>;
TYPED_TEST_SUITE(StructureVisibility, ParticleStructures, StructureName);

TYPED_TEST(StructureBuild, HoldsEveryParticleOnceWithItsNumbers)
{
  const Particles particles = randomParticles(20000, 71, 0.001, 0.01);
  TypeParam grid;
  grid.build(particles.set());
  ASSERT_EQ(grid.size(), particles.size());
  std::vector<bool> seen(particles.size(), false);
  for (std::size_t slot = 0; slot < grid.size(); ++slot)
  {
    const std::size_t i = grid.inputIndex(slot);
    ASSERT_LT(i, particles.size());
    ASSERT_FALSE(seen[i]);
    seen[i] = true;
    // Rounded to float relative to the origin: half the size times 2^-24.
    ASSERT_LE(glm::length(grid.center(slot) - particles.center(i)), 1.8 * 0x1p-24);
    ASSERT_NEAR(grid.radius(slot), particles.radii[i], 0.01 * 0x1p-24);
  }
}

TYPED_TEST(StructureBuild, StatisticsAreThoseOfTheInput)
{
  const Particles particles = randomParticles(30000, 72, 0.001, 0.01);
  TypeParam grid;
  grid.build(particles.set());
  Box centers, bounds;
  double least = 1.0, most = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const double r = particles.radii[i];
    centers.add(particles.center(i));
    bounds.add(particles.center(i) - Vec3d(r));
    bounds.add(particles.center(i) + Vec3d(r));
    least = std::min(least, r);
    most = std::max(most, r);
  }
  const ParticleStatistics& s = grid.statistics();
  EXPECT_EQ(s.centers.lower, centers.lower);
  EXPECT_EQ(s.centers.upper, centers.upper);
  EXPECT_EQ(s.bounds.lower, bounds.lower);
  EXPECT_EQ(s.bounds.upper, bounds.upper);
  EXPECT_EQ(s.smallestRadius, least);
  EXPECT_EQ(s.largestRadius, most);
}

TYPED_TEST(StructureBuild, ThreadsDoNotChangeTheResult)
{
  Particles particles = randomParticles(50000, 73, 0.001, 0.01);
  for (std::size_t i = 0; i < 20000; ++i) // many in one cell
    particles.add(particles.center(i % 10), 0.005);
  std::vector<Contents> results;
  for (const int threads : {1, 2, 4})
  {
    TypeParam grid;
    tbb::task_arena(threads).execute([&] { grid.build(particles.set()); });
    results.push_back(contentsOf(grid));
  }
  EXPECT_TRUE(results[0] == results[1]);
  EXPECT_TRUE(results[0] == results[2]);
}

TYPED_TEST(StructureBuild, RebuildForgetsWhatWasThere)
{
  const Particles many = randomParticles(5000, 74, 0.01, 0.02);
  const Particles few = randomParticles(50, 75, 0.1, 0.2);
  TypeParam used, fresh;
  used.build(many.set());
  used.setVisibility([](std::size_t) { return false; });
  used.build(few.set());
  fresh.build(few.set());
  EXPECT_EQ(contentsOf(used).indices, contentsOf(fresh).indices);
  const CastReport report = checkImage(
    used, CastOracle::forFloat(few.set()), lookAt({3.0, 1.0, 2.0}, Vec3d(0.0), 40.0), 32, 32);
  EXPECT_EQ(report.wrong, 0u) << report.complaint;
  EXPECT_GT(report.hits, 100u);
}

TYPED_TEST(StructureBuild, ConstantRadiusAndScale)
{
  const Particles particles = randomParticles(10, 77, 0.01, 0.01);
  ParticleSet set = particles.set();
  set.radii = {};
  set.radius = 0.25;
  set.radiusScale = 2.0;
  TypeParam grid;
  grid.build(set);
  EXPECT_EQ(grid.radius(3), 0.5);
  set = particles.set();
  set.radiusScale = 0.5;
  grid.build(set);
  EXPECT_FLOAT_EQ(static_cast<float>(grid.radius(3)), 0.005f);
}

TYPED_TEST(StructureBuild, TakesEveryTypeOfPosition)
{
  const std::vector<std::int16_t> positions = {0, 0, 0, 10, 0, 0, 0, -20, 5};
  ParticleSet set;
  set.positions = ArrayView(positions.data(), ArrayView::Type::Int16, 3, 3);
  const CastOracle oracle = CastOracle::forFloat(set);
  TypeParam grid;
  grid.build(set);
  const CastReport report =
    checkImage(grid, oracle, lookAt({30.0, 10.0, 50.0}, {5.0, -10.0, 0.0}, 40.0), 64, 64);
  EXPECT_EQ(report.wrong, 0u) << report.complaint;
  EXPECT_GT(report.hits, 5u);
}

TYPED_TEST(StructureBuild, MalformedSetsAreRefused)
{
  const Particles particles = randomParticles(10, 78, 0.01, 0.01);
  TypeParam grid;
  grid.build(particles.set());
  ParticleSet set = particles.set();
  set.radii = ArrayView(particles.radii.data(), 9, 1);
  EXPECT_THROW(grid.build(set), Error);
  EXPECT_EQ(grid.size(), 0u);
  set = particles.set();
  set.positions = ArrayView(particles.positions.data(), 10, 2);
  EXPECT_THROW(grid.build(set), Error);
}

TYPED_TEST(StructureBuild, ProgressRisesAndStops)
{
  const Particles particles = randomParticles(10000, 79, 0.01, 0.01);
  TypeParam grid;
  std::vector<double> told;
  grid.build(particles.set(), {},
    [&](double done)
    {
      told.push_back(done);
      return true;
    });
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1.0);
  // How often it is told depends on the threads, but it always comes to the end.
  for (const double stopAt : {0.0, 0.15, 0.25, 0.5, 0.8, 0.95, 1.0})
  {
    bool stopped = false;
    grid.build(particles.set(), {},
      [&](double done)
      {
        EXPECT_FALSE(stopped);
        stopped = done >= stopAt;
        return !stopped;
      });
    EXPECT_TRUE(stopped);
    EXPECT_EQ(grid.size(), 0u);
  }
}

TYPED_TEST(StructureVisibility, EqualsAGridOfTheSubset)
{
  const Particles particles = randomParticles(3000, 80, 0.01, 0.06);
  TypeParam grid;
  grid.build(particles.set());
  for (const int every : {2, 7, 500, 100000})
  {
    const auto isShown = [&](std::size_t i) { return i % static_cast<std::size_t>(every) == 1; };
    Particles subset = particles;
    for (std::size_t i = 0; i < subset.size(); ++i)
      if (!isShown(i))
        subset.radii[i] = -1.0; // keeps the indices and leaves the particle out
    grid.setVisibility([&](std::size_t slot) { return isShown(grid.inputIndex(slot)); });
    const CastOracle oracle(subset.set(), 1e-6);
    CastReport report;
    Random random(81);
    for (int k = 0; k < 6; ++k)
      report.add(
        checkImage(grid, oracle, lookAt(2.5 * random.direction(), Vec3d(0.0), 60.0), 32, 32));
    EXPECT_EQ(report.wrong, 0u) << report.complaint;
  }
  grid.setVisibility({});
  const CastReport all = checkImage(
    grid, CastOracle::forFloat(particles.set()), lookAt({2.0, 1.0, 2.0}, Vec3d(0.0), 60.0), 32, 32);
  EXPECT_EQ(all.wrong, 0u) << all.complaint;
}

TYPED_TEST(StructureVisibility, NoneShownHitsNothing)
{
  const Particles particles = randomParticles(1000, 82, 0.05, 0.1);
  TypeParam grid;
  grid.build(particles.set());
  grid.setVisibility([](std::size_t) { return false; });
  RayPacket packet = emptyPacket();
  for (int i = 0; i < 64; ++i)
    addRay(packet, {0.0, 0.0, 4.0}, {0.005 * (i - 32), 0.0, -1.0});
  grid.cast(packet, 0);
  for (int i = 0; i < 64; ++i)
    EXPECT_EQ(packet.object[i], -1);
}
