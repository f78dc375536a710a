// Rays at the R-LODs of an RlodTree: what they may miss, and by how much they err.

#include "LodParts.h"

#include <support/Targets.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

void expectNoHoles(const Triangles& triangles, int bundles, std::uint64_t seed)
{
  const RlodTree tree = treeWithLods(triangles);
  for (const double poe : {0.3, 1.0, 4.0, 16.0, 100.0})
  {
    SCOPED_TRACE(poe);
    LodErrors errors;
    for (const RayBundle& question : endlessQuestions(bundles, seed))
      judgeLods(tree, question, poe, errors);
    EXPECT_EQ(errors.holes, 0u) << "of " << errors.rays << " rays";
    EXPECT_LT(errors.worst, 2.0);
    EXPECT_LT(errors.tooCoarse, 2.001);
    if (poe >= 16.0)
    {
      EXPECT_GT(errors.lods, errors.rays / 50);
    }
  }
}

} // namespace

TEST(RlodTreeLodCast, LeavesNoHolesAndErrsByLessThanItSays)
{
  expectNoHoles(bumpySphere(60), 30, 1);
  expectNoHoles(bumpySphere(12), 20, 2);
  expectNoHoles(randomTriangles(2000, 3, 0.1), 20, 4);
}

TEST(RlodTreeLodCast, EveryInstructionSetLeavesNoHoles)
{
  const Triangles sphere = bumpySphere(24);
  for (const std::int64_t target : everyTarget())
  {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnlyTargets only(target);
    expectNoHoles(sphere, 12, 5);
  }
}

TEST(RlodTreeLodCast, IsExactWithoutPixelsOfErrorOrWithoutLods)
{
  const Triangles sphere = bumpySphere(30);
  const RlodTree plain = treeOver(sphere), lods = treeWithLods(sphere);
  for (const RayBundle& question : meshQuestions(20, 6))
  {
    RayBundle exact = question, zero = question, none = question;
    plain.cast(exact, 0);
    lods.cast(zero, 0, 0.0);
    plain.cast(none, 0, 8.0);
    for (int i = 0; i < question.count; ++i)
    {
      EXPECT_EQ(exact.slot[i], zero.slot[i]);
      EXPECT_EQ(exact.t[i], zero.t[i]);
      EXPECT_EQ(exact.slot[i], none.slot[i]);
      EXPECT_EQ(exact.t[i], none.t[i]);
    }
  }
}

TEST(RlodTreeLodCast, LooksAtFewerNodesTheMoreErrorItMay)
{
  const RlodTree tree = treeWithLods(bumpySphere(120));
  const CameraRays rays(lookAt({3.0, 1.0, 2.0}, Vec3d(0.0), 40.0), 64, 64);
  std::uint64_t before = ~std::uint64_t{0};
  for (const double poe : {0.0, 1.0, 2.0, 4.0, 8.0})
  {
    RlodTree::Counts counts;
    for (int y = 0; y < 64; y += 16)
      for (int x = 0; x < 64; x += 16)
      {
        RayBundle bundle;
        rays.fillBundle(bundle, 16, x, y, 0.0, 0.0);
        tree.cast(bundle, 0, poe, counts);
      }
    EXPECT_EQ(counts.lods > 0, poe > 0.0);
    EXPECT_LT(counts.nodes + counts.clusters, before);
    before = counts.nodes + counts.clusters;
  }
}

TEST(RlodTreeLodCast, TakesThoseOfClustersOnlyToSpareMemory)
{
  RlodTree tree = treeWithLods(bumpySphere(60));
  for (const bool spares : {true, false})
  {
    tree.setSparesMemory(spares);
    std::size_t ofClusters = 0, ofNodes = 0;
    const auto judgeSlot = [&](std::uint64_t slot)
    {
      // A cluster holds 16 triangles at most.
      if (RlodTree::isLod(slot))
        ++(tree.slotsBelow(slot).size() <= 16 ? ofClusters : ofNodes);
    };
    for (const RayBundle& question : endlessQuestions(30, 9))
    {
      RayBundle bundle = question;
      tree.cast(bundle, 0, 4.0);
      RayPacket packet = packetsOf(question)[0];
      tree.cast(packet, 0, 4.0);
      for (int i = 0; i < bundle.count; ++i)
        if (bundle.object[i] == 0)
          judgeSlot(bundle.slot[i]);
      for (int i = 0; i < packet.count; ++i)
        if (packet.object[i] == 0)
          judgeSlot(packet.slot[i]);
    }
    EXPECT_EQ(ofClusters > 100, spares);
    EXPECT_EQ(ofClusters == 0, !spares);
    EXPECT_GT(ofNodes, 100u);
  }
}

TEST(RlodTreeLodCast, SeesFlatWallsWhereTheyAre)
{
  Triangles wall;
  constexpr int side = 100;
  for (int j = 0; j <= side; ++j)
    for (int i = 0; i <= side; ++i)
      wall.addPoint({0.02 * i - 1.0, 0.02 * j - 1.0, 0.1 + 0.004 * i});
  addGrid(wall, side);
  const RlodTree tree = treeWithLods(wall);
  const Vec3d normal = glm::normalize(Vec3d(-0.2, 0.0, 1.0));
  for (const auto projection : {Camera::Projection::Perspective, Camera::Projection::Orthographic})
  {
    Camera camera = lookAt({0.5, -0.8, 4.0}, {0.0, 0.0, 0.3}, 40.0);
    camera.projection = projection;
    camera.parallelScale = 1.2;
    const CameraRays rays(camera, 48, 48);
    std::size_t lods = 0;
    for (int y = 0; y < 48; y += 16)
      for (int x = 0; x < 48; x += 16)
      {
        RayBundle exact;
        rays.fillBundle(exact, 16, x, y, 0.0, 0.0);
        RayBundle rough = exact;
        tree.cast(exact, 0);
        tree.cast(rough, 0, 8.0);
        for (int i = 0; i < exact.count; ++i)
        {
          if (exact.object[i] != 0)
            continue;
          ASSERT_EQ(rough.object[i], 0);
          lods += RlodTree::isLod(rough.slot[i]);
          EXPECT_NEAR(rough.t[i], exact.t[i], 2e-5);
          EXPECT_GT(
            std::abs(glm::dot(glm::normalize(Vec3d(tree.normal(rough.slot[i]))), normal)), 0.9999);
        }
      }
    EXPECT_GT(lods, 300u);
  }
}
