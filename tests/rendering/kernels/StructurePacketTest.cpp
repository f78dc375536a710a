// Packets that are not 64 rays of a camera: fewer, incoherent, bounded, odd.

#include <support/Structure.h>

#include <support/CastOracle.h>
#include <support/Particles.h>

#include <gtest/gtest.h>

using namespace mote;
using namespace mote::testing;

namespace
{

template <typename Structure>
class StructurePacket : public ::testing::Test
{
protected:
  void SetUp() override { grid.build(particles.set()); }

  void expectRight(const RayPacket& packet) { report.add(checkPacket(grid, oracle, packet)); }
  void TearDown() override
  {
    EXPECT_EQ(report.wrong, 0u) << "of " << report.rays << " rays; " << report.complaint;
  }

  Particles particles = randomParticles(2000, 51, 0.01, 0.08);
  CastOracle oracle = CastOracle::forFloat(particles.set());
  Structure grid;
  CastReport report;
  Random random{52};
};

} // namespace

TYPED_TEST_SUITE(StructurePacket, ParticleStructures, StructureName);

TYPED_TEST(StructurePacket, AnyNumberOfRays)
{
  for (int count = 1; count <= RayPacket::capacity; ++count)
  {
    RayPacket packet = emptyPacket();
    for (int i = 0; i < count; ++i)
      addRay(packet, {0.0, 0.0, 4.0}, {this->random(-0.2, 0.2), this->random(-0.2, 0.2), -1.0});
    this->expectRight(packet);
  }
  EXPECT_GT(this->report.hits, this->report.rays / 2);
}

TYPED_TEST(StructurePacket, NoRayIsNoWork)
{
  RayPacket packet = emptyPacket();
  this->grid.cast(packet, 1);
  EXPECT_EQ(packet.count, 0);
}

TYPED_TEST(StructurePacket, RaysBeyondTheCountAreNotTouched)
{
  RayPacket packet = emptyPacket();
  for (int i = 0; i < RayPacket::capacity; ++i)
    addRay(packet, {0.0, 0.0, 4.0}, {0.0, 0.0, -1.0});
  packet.count = 13;
  this->grid.cast(packet, 1);
  EXPECT_EQ(packet.object[12], 1);
  for (int i = 13; i < RayPacket::capacity; ++i)
    EXPECT_EQ(packet.object[i], -1);
}

TYPED_TEST(StructurePacket, IncoherentRays)
{
  for (int k = 0; k < 100; ++k)
  {
    RayPacket packet = emptyPacket();
    for (int i = 0; i < RayPacket::capacity; ++i)
      addRay(packet, this->random.inBox(Vec3d(-1.5), Vec3d(1.5)),
        this->random(0.01, 100.0) * this->random.direction());
    this->expectRight(packet);
  }
  EXPECT_GT(this->report.hits, this->report.rays / 4);
}

TYPED_TEST(StructurePacket, ParallelAndOppositeRays)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    RayPacket packet = emptyPacket();
    for (int i = 0; i < RayPacket::capacity; ++i)
    {
      Vec3d direction(0.0);
      direction[axis] = i % 2 == 0 ? 1.0 : -1.0;
      addRay(packet, this->random.inBox(Vec3d(-1.2), Vec3d(1.2)), direction);
    }
    this->expectRight(packet);
  }
}

TYPED_TEST(StructurePacket, IntervalsAreRespected)
{
  for (int k = 0; k < 100; ++k)
  {
    RayPacket packet = emptyPacket();
    for (int i = 0; i < RayPacket::capacity; ++i)
    {
      const double tMin = this->random(-1.0, 5.0);
      addRay(packet, {0.1, 0.2, 3.0}, {this->random(-0.3, 0.3), this->random(-0.3, 0.3), -1.0},
        tMin, tMin + this->random(0.0, 2.0));
    }
    this->expectRight(packet);
  }
  EXPECT_GT(this->report.hits, this->report.rays / 4);
  EXPECT_LT(this->report.hits, 3 * this->report.rays / 4);
}

TYPED_TEST(StructurePacket, EmptyIntervalsHitNothing)
{
  RayPacket packet = emptyPacket();
  for (int i = 0; i < 20; ++i)
    addRay(packet, {0.0, 0.0, 4.0}, {0.01 * i, 0.0, -1.0}, 3.0, i % 2 == 0 ? 3.0 : 2.0);
  this->expectRight(packet);
  EXPECT_EQ(this->report.hits, 0u);
}

TYPED_TEST(StructurePacket, RaysThatStartBeyondOrPointAway)
{
  for (int k = 0; k < 50; ++k)
  {
    RayPacket packet = emptyPacket();
    for (int i = 0; i < 32; ++i)
    {
      const Vec3d out = this->random.direction();
      addRay(packet, 3.0 * out, out + 0.2 * this->random.direction());
    }
    this->expectRight(packet);
  }
  EXPECT_EQ(this->report.hits, 0u);
}

TYPED_TEST(StructurePacket, OneRayOfManyMeetsTheSet)
{
  RayPacket packet = emptyPacket();
  for (int i = 0; i < RayPacket::capacity; ++i)
    addRay(packet, {i == 37 ? 0.0 : 5.0 + i, 0.0, 4.0}, {0.0, 0.0, -1.0});
  this->expectRight(packet);
  EXPECT_EQ(this->report.hits, 1u);
}

TYPED_TEST(StructurePacket, DirectionsWithoutLengthHitNothing)
{
  RayPacket packet = emptyPacket();
  for (int i = 0; i < 16; ++i)
    addRay(packet, {0.0, 0.0, 4.0}, i % 2 == 0 ? Vec3d(0.0) : Vec3d(0.0, 0.0, -1.0));
  this->grid.cast(packet, 1);
  for (int i = 0; i < 16; ++i)
    EXPECT_EQ(packet.object[i], i % 2 == 0 ? -1 : 1);
}

TYPED_TEST(StructurePacket, CastingAgainChangesNothing)
{
  // What was found becomes the farthest t that counts, and the same hit is not nearer than that.
  for (int k = 0; k < 50; ++k)
  {
    RayPacket packet = emptyPacket();
    for (int i = 0; i < RayPacket::capacity; ++i)
      addRay(packet, {0.1, 0.2, 3.0},
        {this->random(-0.3, 0.3), this->random(-0.3, 0.3), -this->random(0.5, 1.5)});
    this->grid.cast(packet, 1);
    const RayPacket once = packet;
    this->grid.cast(packet, 2);
    for (int i = 0; i < RayPacket::capacity; ++i)
    {
      EXPECT_EQ(packet.object[i], once.object[i]);
      EXPECT_EQ(packet.t[i], once.t[i]);
      EXPECT_EQ(packet.slot[i], once.slot[i]);
    }
  }
}

TYPED_TEST(StructurePacket, TCountsInLengthsOfTheDirection)
{
  for (const double length : {1e-6, 0.5, 1.0, 3.0, 1e6})
  {
    RayPacket packet = emptyPacket();
    addRay(packet, {0.0, 0.0, 4.0}, {0.0, 0.0, -length});
    const RayPacket question = packet;
    this->expectRight(question);
    this->grid.cast(packet, 1);
    EXPECT_NEAR(packet.t[0] * length, this->oracle.nearest(rayOf(question, 0)).t * length, 1e-5);
  }
}

TYPED_TEST(StructurePacket, ASecondStructureOnlyTakesWhatIsNearer)
{
  Particles front, back;
  front.add({0.0, 0.0, 2.0}, 0.5);
  back.add({0.0, 0.0, -2.0}, 0.5);
  TypeParam first, second;
  first.build(front.set());
  second.build(back.set());
  for (const bool frontFirst : {true, false})
  {
    RayPacket packet = emptyPacket();
    addRay(packet, {0.0, 0.0, 9.0}, {0.0, 0.0, -1.0});
    (frontFirst ? first : second).cast(packet, frontFirst ? 0 : 1);
    (frontFirst ? second : first).cast(packet, frontFirst ? 1 : 0);
    EXPECT_EQ(packet.object[0], 0);
    EXPECT_NEAR(packet.t[0], 6.5, 1e-6);
  }
}

TYPED_TEST(StructurePacket, OccludedRaysAreThoseThatHitSomething)
{
  int occluded = 0;
  for (int k = 0; k < 40; ++k)
  {
    RayPacket packet = emptyPacket();
    for (int i = 0; i < RayPacket::capacity; ++i)
      addRay(packet, this->random.inBox(Vec3d(-1.5), Vec3d(1.5)), this->random.direction(),
        this->random(0.0, 0.3), this->random(0.1, 2.0));
    RayPacket nearest = packet;
    this->grid.cast(nearest, 1);
    RayPacket any = packet;
    this->grid.occlude(any, 1);
    for (int i = 0; i < packet.count; ++i)
    {
      const bool hit = nearest.object[i] == 1;
      occluded += hit;
      EXPECT_EQ(any.t[i], hit ? -INFINITY : packet.t[i]);
      EXPECT_EQ(any.slot[i], packet.slot[i]);
      EXPECT_EQ(any.object[i], -1);
    }
    // The particle that a ray names does not occlude it.
    RayPacket own = packet;
    for (int i = 0; i < packet.count; ++i)
    {
      own.slot[i] = nearest.slot[i];
      own.object[i] = nearest.object[i];
      if (nearest.object[i] == 1) // up to just behind it
        own.t[i] = nearest.t[i] * (1.0 + 1e-9) + 1e-9;
    }
    const RayPacket question = own;
    this->grid.occlude(own, 1);
    for (int i = 0; i < packet.count; ++i)
      EXPECT_EQ(own.t[i], question.t[i]);
  }
  EXPECT_GT(occluded, 40 * RayPacket::capacity / 8);
}
