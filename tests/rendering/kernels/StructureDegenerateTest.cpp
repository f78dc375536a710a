// Few particles, flat and linear sets, bad numbers, and sizes far from one.

#include <support/Structure.h>

#include <support/CastOracle.h>
#include <support/Particles.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

/// From all around, near and far, in both projections.
template <typename Structure>
void expectRightFromAllAround(const Particles& particles)
{
  Structure grid;
  grid.build(particles.set());
  const CastOracle oracle = CastOracle::forFloat(particles.set());
  const Box bounds = grid.statistics().bounds;
  const double size = std::max(glm::length(bounds.size()), 1e-30);
  Random random(1);
  CastReport all;
  for (int k = 0; k < 24; ++k)
  {
    Vec3d direction = random.direction();
    if (k < 6)
    {
      direction = Vec3d(0.0);
      direction[k % 3] = k < 3 ? 1.0 : -1.0;
    }
    Camera camera = lookAt(bounds.center() + random(0.8, 3.0) * size * direction, bounds.center());
    camera.parallelScale = 0.5 * size;
    if (k % 2 == 1)
      camera.projection = Camera::Projection::Orthographic;
    all.add(checkImage(grid, oracle, camera, 24, 24));
  }
  EXPECT_EQ(all.wrong, 0u) << "of " << all.rays << " rays; " << all.complaint;
  EXPECT_GT(all.hits, 0u);
}

} // namespace

template <typename Structure>
using StructureDegenerate = StructureTest<Structure>;
TYPED_TEST_SUITE(StructureDegenerate, ParticleStructures, StructureName);

TYPED_TEST(StructureDegenerate, NoParticleHitsNothing)
{
  TypeParam grid;
  RayPacket packet = emptyPacket();
  addRay(packet, {0.0, 0.0, -5.0}, {0.0, 0.0, 1.0});
  grid.cast(packet, 0); // never built
  EXPECT_EQ(packet.slot[0], RayPacket::noHit);
  grid.build(ParticleSet{});
  grid.cast(packet, 0);
  EXPECT_EQ(packet.slot[0], RayPacket::noHit);
  EXPECT_EQ(packet.object[0], -1);
  EXPECT_EQ(grid.size(), 0u);
  EXPECT_TRUE(grid.statistics().bounds.empty());
  grid.setVisibility([](std::size_t) { return false; });
  grid.setVisibility({});
}

TYPED_TEST(StructureDegenerate, OneTwoAndThreeParticles)
{
  Random random(2);
  for (int round = 0; round < 10; ++round)
  {
    Particles particles;
    for (int i = 0; i < 3; ++i)
    {
      particles.add(random.inBox(Vec3d(-1.0), Vec3d(1.0)), random(0.05, 0.8));
      expectRightFromAllAround<TypeParam>(particles);
    }
  }
}

TYPED_TEST(StructureDegenerate, OneParticleOfAnySize)
{
  for (const double radius : {1e-12, 1e-6, 1.0, 1e6, 1e12})
  {
    SCOPED_TRACE(radius);
    Particles particles;
    particles.add(radius * Vec3d(3.0, -2.0, 1.0), radius);
    expectRightFromAllAround<TypeParam>(particles);
  }
}

TYPED_TEST(StructureDegenerate, SetsOfAnySize)
{
  for (const double scale : {1e-12, 1e-9, 1e-3, 1e3, 1e9, 1e12})
  {
    SCOPED_TRACE(scale);
    Particles particles = randomParticles(500, 3, 0.01, 0.1);
    for (double& x : particles.positions)
      x *= scale;
    for (double& r : particles.radii)
      r *= scale;
    expectRightFromAllAround<TypeParam>(particles);
  }
}

TYPED_TEST(StructureDegenerate, FlatSets)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    Particles particles = randomParticles(800, 4, 0.01, 0.05);
    for (std::size_t i = 0; i < particles.size(); ++i)
      particles.positions[3 * i + static_cast<std::size_t>(axis)] = 0.25;
    expectRightFromAllAround<TypeParam>(particles);
  }
}

TYPED_TEST(StructureDegenerate, LinearSets)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    Particles particles = randomParticles(800, 5, 0.001, 0.05);
    for (std::size_t i = 0; i < particles.size(); ++i)
      for (std::size_t other = 0; other < 3; ++other)
        if (static_cast<int>(other) != axis)
          particles.positions[3 * i + other] = -0.5;
    expectRightFromAllAround<TypeParam>(particles);
  }
}

TYPED_TEST(StructureDegenerate, AllAtOnePoint)
{
  Particles particles;
  for (int i = 0; i < 300; ++i)
    particles.add({1.0, 2.0, 3.0}, 0.1 + 0.001 * i);
  expectRightFromAllAround<TypeParam>(particles);
}

TYPED_TEST(StructureDegenerate, AMillionAtOnePoint)
{
  // Cells cannot tell them apart, and every ray meets them all: slow, never wrong or unbounded. The
  // reference need not look at all of them.
  Particles particles, one;
  for (int i = 0; i < 1000000; ++i)
    particles.add({1.0, 2.0, 3.0}, 0.25);
  one.add({1.0, 2.0, 3.0}, 0.25);
  TypeParam grid;
  grid.build(particles.set());
  EXPECT_EQ(grid.size(), 1000000u);
  EXPECT_LT(grid.bytes(), 50u * 1000000u);
  const CastReport report = checkImage(
    grid, CastOracle::forFloat(one.set()), lookAt({4.0, 3.0, 5.0}, {1.0, 2.0, 3.0}, 10.0), 32, 32);
  EXPECT_EQ(report.wrong, 0u) << report.complaint; // and of all, the first is named
  EXPECT_GT(report.hits, report.rays / 4);
}

TYPED_TEST(StructureDegenerate, OneParticleFarFromTheOthers)
{
  Particles particles = randomParticles(500, 6, 0.01, 0.05);
  particles.add({3000.0, -10.0, 20.0}, 0.5);
  TypeParam grid;
  grid.build(particles.set());
  const CastOracle oracle = CastOracle::forFloat(particles.set());
  const CastReport report =
    checkImage(grid, oracle, lookAt({3.0, 2.0, 4.0}, Vec3d(0.0), 30.0), 64, 64);
  EXPECT_EQ(report.wrong, 0u) << report.complaint;
  EXPECT_GT(report.hits, 100u);
}

TYPED_TEST(StructureDegenerate, RadiiManyTimesTheCells)
{
  const Particles particles = randomParticles(1000, 7, 0.5, 1.5);
  expectRightFromAllAround<TypeParam>(particles);
}

TYPED_TEST(StructureDegenerate, BadNumbersAreCountedAndLeftOut)
{
  const double nan = std::nan(""), infinity = INFINITY;
  Particles particles = randomParticles(500, 9, 0.01, 0.1);
  particles.add({nan, 0.0, 0.0}, 0.1);
  particles.add({0.0, infinity, 0.0}, 0.1);
  particles.add({0.0, 0.0, -infinity}, nan); // counts once, as a bad position
  particles.add({0.0, 0.0, 0.0}, 0.0);
  particles.add({0.0, 0.0, 0.0}, -3.0);
  particles.add({0.0, 0.0, 0.0}, nan);
  particles.add({0.0, 0.0, 0.0}, infinity);
  particles.add({0.0, 0.0, 0.0}, 0.1);
  TypeParam grid;
  grid.build(particles.set());
  EXPECT_EQ(grid.size(), 501u);
  EXPECT_EQ(grid.statistics().valid, 501u);
  EXPECT_EQ(grid.statistics().badPositions, 3u);
  EXPECT_EQ(grid.statistics().badRadii, 4u);
  expectRightFromAllAround<TypeParam>(particles);
}

TEST(ParticleStatistics, OfOneRadiusAreThoseOfRadiiOneByOne)
{
  Particles particles = randomParticles(3000, 5, 0.1, 0.1);
  for (int i = 0; i < 40; ++i)
    particles.add({std::nan(""), i, 0.0}, 0.1);
  const ParticleSet set = particles.set();
  ParticleSet even = set;
  even.radii = {};
  even.radius = 0.1;
  ASSERT_TRUE(even.hasOneRadius() && !set.hasOneRadius());
  const ParticleStatistics each = examine(set), one = examine(even);
  EXPECT_EQ(each.valid, 3000u);
  EXPECT_EQ(one.valid, each.valid);
  EXPECT_EQ(one.badPositions, 40u);
  EXPECT_EQ(each.badPositions, 40u);
  EXPECT_EQ(one.largestRadius, 0.1);
}

TYPED_TEST(StructureDegenerate, OnlyBadParticlesHitNothing)
{
  Particles particles;
  particles.add({0.0, 0.0, 0.0}, -1.0);
  TypeParam grid;
  grid.build(particles.set());
  EXPECT_EQ(grid.size(), 0u);
  RayPacket packet = emptyPacket();
  addRay(packet, {0.0, 0.0, -5.0}, {0.0, 0.0, 1.0});
  grid.cast(packet, 0);
  EXPECT_EQ(packet.object[0], -1);
}
