// Hard meshes at R-LODs: whatever hits exactly hits, within the error.

#include "HardMeshes.h"
#include "LodParts.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Rays that have nothing in common, as wide as mirrored ones: they begin anywhere, with a width.
std::vector<RayPacket> scatteredRays(int packets, const Elsewhere& place)
{
  Random random(71);
  std::vector<RayPacket> all;
  for (int k = 0; k < packets; ++k)
  {
    all.push_back(emptyPacket());
    all.back().footprint = place.unit * random(0.0, 0.03);
    all.back().footprintPerT = random(0.0, 0.03);
    for (int i = 0; i < RayPacket::capacity; ++i)
    {
      const Vec3d from = random.inBox(Vec3d(-1.2), Vec3d(1.2));
      const Vec3d way = i % 2 == 0 ? random.direction() : 0.3 * random.direction() - from;
      addRay(all.back(), place.middle + place.unit * from, glm::normalize(way));
    }
  }
  return all;
}

/// Casts rays of all kinds with errors; answers at how many R-LODs they ended.
std::size_t expectRightWithLods(const Triangles& base, const Elsewhere& place, int bundles)
{
  const RlodTree tree = treeWithLods(place(base));
  std::size_t lods = 0;
  for (const double poe : {1.0, 4.0, 8.0})
  {
    SCOPED_TRACE(poe);
    LodErrors errors;
    for (const RayBundle& question : endlessQuestions(bundles, 61))
      judgeLods(tree, place(question), poe, errors);
    for (const RayPacket& packet : scatteredRays(bundles, place))
      judgeLods(tree, packet, poe, errors);
    EXPECT_EQ(errors.holes, 0u) << "of " << errors.rays << " rays";
    EXPECT_LT(errors.worst, 2.0);
    EXPECT_LT(errors.tooCoarse, 2.001);
    lods += errors.lods;
  }
  return lods;
}

} // namespace

TEST(RlodTreeHard, LeavesNoHolesAndErrsByLessThanItSays)
{
  for (const HardMesh& hard : hardMeshes())
  {
    SCOPED_TRACE(hard.name);
    const std::size_t lods = expectRightWithLods(hard.triangles, {}, 60);
    // Walls that reach far beyond make boxes that no pixel is as large as.
    if (hard.triangles.size() > 300 && hard.name != "slivers, huge and tiny")
    {
      EXPECT_GT(lods, 100u);
    }
  }
}

TEST(RlodTreeHard, InWhateverUnitsAndWhereverTheModelLies)
{
  for (const double unit : {1e-9, 1.0, 1e9})
    for (const double away : {0.0, 1e6})
    {
      if (unit == 1.0 && away == 0.0)
        continue;
      for (const HardMesh& hard : hardMeshes())
      {
        SCOPED_TRACE(hard.name + ", in " + std::to_string(unit) + ", away " + std::to_string(away));
        expectRightWithLods(hard.triangles, {unit, away * unit * Vec3d(1.0, -1.0, 1.0)}, 12);
      }
    }
}

TEST(RlodTreeHard, RaysThatLeaveSurfacesHaveSoundAnswers)
{
  for (const HardMesh& hard : hardMeshes())
  {
    SCOPED_TRACE(hard.name);
    const RlodTree tree = treeWithLods(hard.triangles);
    Random random(81);
    for (const double poe : {1.0, 4.0, 8.0})
      for (RayPacket packet : scatteredRays(12, {}))
      {
        tree.cast(packet, 0, poe);
        RayPacket leaving = emptyPacket();
        leaving.onSurface = OnSurface::Start;
        leaving.footprint = packet.footprint;
        leaving.footprintPerT = packet.footprintPerT;
        for (int i = 0; i < packet.count; ++i)
          if (packet.object[i] == 0)
          {
            const reference::Ray ray = rayOf(packet, i);
            addRay(leaving, ray.origin + packet.t[i] * ray.direction, random.direction(), 1e-5);
          }
        RayPacket dark = leaving;
        tree.cast(leaving, 0, poe);
        tree.occlude(dark, 0, poe);
        for (int i = 0; i < leaving.count; ++i)
        {
          ASSERT_TRUE(dark.t[i] == -infinity || dark.t[i] == infinity);
          // What is met is met by both.
          ASSERT_EQ(leaving.object[i] == 0, dark.t[i] < 0.0);
          if (leaving.object[i] != 0)
            continue;
          ASSERT_TRUE(leaving.t[i] > 1e-5 && leaving.t[i] < 100.0);
          ASSERT_LT(tree.inputIndex(leaving.slot[i]), hard.triangles.size());
          const Vec3f normal = tree.normal(leaving.slot[i]);
          ASSERT_TRUE(
            std::isfinite(normal.x) && std::isfinite(normal.y) && std::isfinite(normal.z));
        }
      }
  }
}

TEST(RlodTreeHard, ClosedMeshesAreClosedFromWithin)
{
  // Degenerate triangles and such that are not finite do not open them.
  for (const HardMesh& hard : hardMeshes())
  {
    if (hard.name != "sphere" && hard.name != "not finite" && hard.name != "degenerate")
      continue;
    SCOPED_TRACE(hard.name);
    const RlodTree tree = treeWithLods(hard.triangles);
    Random random(91);
    for (const double poe : {1.0, 4.0, 8.0})
      for (int k = 0; k < 300; ++k)
      {
        RayPacket packet = emptyPacket();
        packet.footprint = random(0.0, 0.05);
        for (int i = 0; i < RayPacket::capacity; ++i)
          addRay(packet, random.inBox(Vec3d(-0.3), Vec3d(0.3)), random.direction());
        RayPacket dark = packet;
        tree.cast(packet, 0, poe);
        tree.occlude(dark, 0, poe);
        for (int i = 0; i < packet.count; ++i)
        {
          ASSERT_EQ(packet.object[i], 0);
          ASSERT_EQ(dark.t[i], -infinity);
        }
      }
  }
}
