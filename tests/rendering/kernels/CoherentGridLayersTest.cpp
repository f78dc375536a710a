// Radii over decades: grids of their own for groups of similar radii, and the same answers.

#include <kernels/particles/CoherentGrid.h>

#include <support/CastOracle.h>
#include <support/Particles.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

/// Radii log-uniform over four decades.
Particles varied(std::size_t count, double largest, std::uint64_t seed)
{
  Particles particles;
  Random random(seed);
  for (std::size_t i = 0; i < count; ++i)
    particles.add(
      random.inBox(Vec3d(-1.0), Vec3d(1.0)), largest * std::pow(10.0, -random(0.0, 4.0)));
  return particles;
}

} // namespace

TEST(CoherentGridLayers, OneForEqualRadiiSeveralForMixed)
{
  CoherentGrid grid;
  grid.build(randomParticles(5000, 141, 0.02, 0.02).set());
  EXPECT_EQ(grid.layers(), 1);
  const Particles mixed = varied(20000, 0.2, 142);
  grid.build(mixed.set());
  EXPECT_GT(grid.layers(), 1);
  std::size_t sum = 0, slot = 0;
  double smallestSoFar = std::numeric_limits<double>::infinity();
  for (int layer = 0; layer < grid.layers(); ++layer)
  {
    sum += grid.layerSize(layer);
    double least = smallestSoFar, most = 0.0;
    for (; slot < sum; ++slot)
    {
      least = std::min(least, grid.radius(slot));
      most = std::max(most, grid.radius(slot));
    }
    EXPECT_LE(most, smallestSoFar); // the largest first, and no overlap
    smallestSoFar = least;
  }
  EXPECT_EQ(sum, mixed.size());
}

TEST(CoherentGridLayers, AgreeWithTheReference)
{
  for (const double largest : {0.05, 0.5, 5.0})
  {
    const Particles particles = varied(3000, largest, 143);
    CoherentGrid grid;
    grid.build(particles.set());
    const CastOracle oracle = CastOracle::forFloat(particles.set());
    for (const Vec3d& eye : {Vec3d(4.0, 1.0, 2.0), Vec3d(0.1, -0.2, 0.3), Vec3d(-30.0, 20.0, 4.0)})
      for (const int side : {2, 16})
      {
        const CastReport report =
          checkImage(grid, oracle, lookAt(eye, Vec3d(0.0), 40.0), 48, 48, side);
        EXPECT_EQ(report.wrong, 0u) << "of " << report.rays << " rays; " << report.complaint;
      }
  }
}

TEST(CoherentGridLayers, AFewGiantsLeaveTheOthersTheirGrid)
{
  Particles particles = randomParticles(20000, 144, 0.005, 0.008);
  for (int i = 0; i < 3; ++i)
    particles.add(Vec3d(0.3 * i, 0.5, -0.2 * i), 0.4);
  CoherentGrid grid;
  grid.build(particles.set());
  // Whoever shares the giants' grid, most particles do not.
  ASSERT_EQ(grid.layers(), 2);
  EXPECT_GE(grid.layerSize(0), 3u);
  EXPECT_LT(grid.layerSize(0), 2000u);
  EXPECT_LT(grid.cellSize(1), 0.1);
}

TEST(CoherentGridLayers, ARebuildReusesMemoryAndForgetsTheOld)
{
  const Particles mixed = varied(20000, 0.2, 145), plain = randomParticles(4000, 146, 0.02, 0.02);
  CoherentGrid reused, fresh;
  reused.build(mixed.set());
  const std::size_t bytes = reused.bytes();
  reused.setVisibility([](std::size_t slot) { return slot % 2 == 0; });
  reused.build(plain.set());
  EXPECT_GE(reused.bytes(), bytes - 100000);
  fresh.build(plain.set());
  ASSERT_EQ(reused.size(), fresh.size());
  ASSERT_EQ(reused.layers(), fresh.layers());
  for (std::size_t slot = 0; slot < fresh.size(); ++slot)
    ASSERT_EQ(reused.inputIndex(slot), fresh.inputIndex(slot));
  const CastOracle oracle = CastOracle::forFloat(plain.set());
  const CastReport report =
    checkImage(reused, oracle, lookAt(Vec3d(3.0, 1.0, 2.0), Vec3d(0.0), 40.0), 48, 48);
  EXPECT_EQ(report.wrong, 0u) << report.complaint;
}

TEST(CoherentGridLayers, BundlesGrowWithTheCellsThatAreSeen)
{
  CoherentGrid grid;
  grid.build(randomParticles(50000, 147, 0.01, 0.01).set());
  int last = 2;
  for (const double distance : {1000.0, 200.0, 50.0, 15.0, 5.0, 2.5})
  {
    const CameraRays rays(lookAt(Vec3d(0.0, 0.0, distance), Vec3d(0.0), 30.0), 512, 512);
    const int side = grid.bundleSide(rays, 240, 240, 32);
    EXPECT_GE(side, last);
    last = side;
  }
  EXPECT_EQ(last, 16);
}

TEST(CoherentGridMemory, TakesTwentyBytesAParticleWithoutIndices)
{
  const Particles particles = randomParticles(100000, 76, 0.001, 0.01);
  CoherentGrid with, without;
  with.build(particles.set());
  without.build(particles.set(), {1.0, false});
  EXPECT_LT(double(without.bytes()) / 100000, 21.0);
  EXPECT_EQ(with.bytes() - without.bytes(), 4u * 100000);
  EXPECT_EQ(without.inputIndex(1234), 1234u); // the slot stands in
}

TEST(CoherentGridLambda, LambdaOnlyChangesTheCells)
{
  const Particles particles = randomParticles(2000, 8, 0.01, 0.06);
  CoherentGrid least, most, grid;
  least.build(particles.set(), {0.2, true});
  most.build(particles.set(), {5.0, true});
  EXPECT_NEAR(std::cbrt(5.0 / 0.2), least.cellSize() / most.cellSize(), 1e-4);
  grid.build(particles.set(), {0.0001, true}); // clamped
  EXPECT_EQ(grid.cellSize(), least.cellSize());
  grid.build(particles.set(), {1e9, true});
  EXPECT_EQ(grid.cellSize(), most.cellSize());
  for (const double lambda : {0.2, 0.5, 2.0, 5.0})
  {
    grid.build(particles.set(), {lambda, true});
    const CastReport report = checkImage(grid, CastOracle::forFloat(particles.set()),
      lookAt({3.0, 2.0, 2.5}, Vec3d(0.0), 40.0), 64, 64);
    EXPECT_EQ(report.wrong, 0u) << report.complaint;
    EXPECT_GT(report.hits, 500u);
  }
}
