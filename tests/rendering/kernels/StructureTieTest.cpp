// Spheres hit at exactly the same distance: the smallest input index is taken, from every side, on
// any number of threads.

#include <support/Structure.h>

#include <support/CastOracle.h>
#include <support/Particles.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace mote;
using namespace mote::testing;

namespace
{

/// Every particle of a random set several times, in a shuffled order.
Particles repeated(int times, std::uint64_t seed)
{
  const Particles once = randomParticles(400, seed, 0.02, 0.1);
  std::vector<std::size_t> order;
  for (int k = 0; k < times; ++k)
    for (std::size_t i = 0; i < once.size(); ++i)
      order.push_back(i);
  Random random(seed);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(random(0.0, double(i)))]);
  Particles out;
  for (const std::size_t i : order)
    out.add(once.center(i), once.radii[i]);
  return out;
}

std::size_t firstTwin(const Particles& particles, std::size_t i)
{
  for (std::size_t k = 0; k < i; ++k)
    if (particles.center(k) == particles.center(i) && particles.radii[k] == particles.radii[i])
      return k;
  return i;
}

} // namespace

template <typename Structure>
using StructureTie = StructureTest<Structure>;
TYPED_TEST_SUITE(StructureTie, ParticleStructures, StructureName);

TYPED_TEST(StructureTie, CoincidentParticlesGiveTheSmallestIndex)
{
  const Particles particles = repeated(5, 61);
  TypeParam grid;
  grid.build(particles.set());
  Random random(62);
  int hits = 0;
  for (int k = 0; k < 100; ++k)
  {
    const CameraRays rays(lookAt(3.0 * random.direction(), Vec3d(0.0), 40.0), 24, 24);
    RayBundle packet;
    rays.fillBundle(packet, 8, 8, 8, 0.0, 0.0);
    grid.cast(packet, 0);
    for (int i = 0; i < packet.count; ++i)
    {
      if (packet.slot[i] == RayPacket::noHit)
        continue;
      ++hits;
      const std::size_t index = grid.inputIndex(packet.slot[i]);
      ASSERT_EQ(index, firstTwin(particles, index));
    }
  }
  EXPECT_GT(hits, 1000);
}

TYPED_TEST(StructureTie, HiddenTwinsLeaveTheNextOne)
{
  Particles particles;
  for (int i = 0; i < 6; ++i)
    particles.add({0.0, 0.0, 0.0}, 1.0);
  TypeParam grid;
  grid.build(particles.set());
  grid.setVisibility([&](std::size_t slot) { return grid.inputIndex(slot) >= 4; });
  RayPacket packet = emptyPacket();
  addRay(packet, {0.0, 0.0, 4.0}, {0.0, 0.0, -1.0});
  grid.cast(packet, 0);
  ASSERT_EQ(packet.object[0], 0);
  EXPECT_EQ(grid.inputIndex(packet.slot[0]), 4u);
}
