// Rays through an RlodTree, judged by brute force.

#include "HardMeshes.h"

#include <kernels/core/BundlePackets.h>

#include <support/Targets.h>

#include <gtest/gtest.h>

#include <tbb/task_arena.h>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

/// Checks a mesh in [-1, 1]^3 with rays of all kinds.
void expectRight(const Triangles& triangles, int bundles, std::uint64_t seed, double hits = 0.05)
{
  const RlodTree tree = treeOver(triangles);
  const TriangleOracle oracle(triangles);
  const CastReport report = checkMesh(tree, oracle, meshQuestions(bundles, seed));
  EXPECT_EQ(report.wrong, 0u) << "of " << report.rays << " rays; " << report.complaint;
  EXPECT_GT(double(report.hits), hits * double(report.rays));
}

/// Checks that trees have the same clusters in the same order.
void expectSameTree(const RlodTree& a, const RlodTree& b)
{
  ASSERT_EQ(a.clusterCount(), b.clusterCount());
  EXPECT_EQ(a.nodeCount(), b.nodeCount());
  EXPECT_EQ(a.cost(), b.cost());
  for (std::uint64_t cluster = 0; cluster < a.clusterCount(); ++cluster)
    EXPECT_EQ(a.inputIndex(16 * cluster), b.inputIndex(16 * cluster));
}

} // namespace

TEST(RlodTree, AgreesWithTheReferenceOnTrianglesAnywhere)
{
  expectRight(randomTriangles(300, 1, 0.3), 60, 11);
  expectRight(randomTriangles(3000, 2, 0.05), 24, 12);
}

TEST(RlodTree, AgreesWithTheReferenceOnSharedPoints)
{
  expectRight(bumpySphere(24), 40, 13);
}

TEST(RlodTree, EveryInstructionSetAgreesWithTheReference)
{
  const Triangles sphere = bumpySphere(16);
  const Triangles loose = randomTriangles(200, 3, 0.4);
  for (const std::int64_t target : everyTarget())
  {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnlyTargets only(target);
    expectRight(sphere, 24, 14);
    expectRight(loose, 24, 15);
  }
}

TEST(RlodTree, TakesSliversAndHugeBesideTiny)
{
  expectRight(sliversHugeAndTiny(), 40, 16);
}

TEST(RlodTree, DegenerateTrianglesAreHeldAndNeverHit)
{
  Triangles all = bumpySphere(10);
  const std::size_t whole = all.size();
  addDegenerate(all, 300);
  const RlodTree tree = treeOver(all);
  EXPECT_EQ(tree.size(), all.size());
  for (RayBundle bundle : meshQuestions(30, 17))
  {
    tree.cast(bundle, 0);
    for (int i = 0; i < bundle.count; ++i)
      if (bundle.object[i] == 0)
      {
        EXPECT_LT(tree.inputIndex(bundle.slot[i]), whole);
      }
  }
  expectRight(all, 30, 18);
}

TEST(RlodTree, TakesDuplicatesStacksAndEdgesOfManyTriangles)
{
  Triangles all = duplicatesStacksAndFans();
  expectRight(all, 40, 19);
  for (int i = 0; i < 3000; ++i) // more than a treelet
    all.add({-0.9, -0.9, 0.1}, {0.1, -0.8, 0.2}, {-0.3, 0.1, -0.2});
  const RlodTree tree = treeOver(all);
  EXPECT_EQ(tree.size(), 3160u);
  RayPacket packet = emptyPacket();
  addRay(packet, {-0.35, -0.5, 3.0}, {0.0, 0.0, -1.0}, 2.6);
  tree.cast(packet, 0);
  ASSERT_EQ(packet.object[0], 0);
  EXPECT_GT(packet.t[0], 2.6);
}

TEST(RlodTree, AnswersInWhateverUnitsAndWhereverTheModelLies)
{
  const Triangles base = bumpySphere(12);
  const auto questions = meshQuestions(20, 20);
  for (const double size : {1e-9, 1.0, 1e9})
    for (const double away : {0.0, 1e6})
    {
      SCOPED_TRACE(std::to_string(size) + " " + std::to_string(away));
      const Elsewhere place{size, away * size * Vec3d(1.0, -1.0, 1.0)};
      const Triangles moved = place(base);
      const RlodTree tree = treeOver(moved);
      const TriangleOracle oracle(moved);
      CastReport report;
      for (const RayBundle& bundle : questions)
        report.add(checkMesh(tree, oracle, place(bundle)));
      EXPECT_EQ(report.wrong, 0u) << "of " << report.rays << " rays; " << report.complaint;
      EXPECT_GT(report.hits, report.rays / 20);
    }
}

TEST(RlodTree, SeesFromFarAwayWhatItSeesFromNear)
{
  const Triangles sphere = bumpySphere(12);
  const RlodTree tree = treeOver(sphere);
  const TriangleOracle oracle(sphere);
  for (const double distance : {10.0, 1e3, 1e6, 1e9})
  {
    const Vec3d eye = distance * glm::normalize(Vec3d(1.0, 2.0, 3.0));
    const CastReport report =
      checkImage(tree, oracle, lookAt(eye, Vec3d(0.0), 130.0 / distance), 48, 48);
    EXPECT_EQ(report.wrong, 0u) << distance << ": " << report.complaint;
    EXPECT_GT(report.hits, 1000u);
  }
}

TEST(RlodTree, HoldsNothingOrOneTriangle)
{
  RlodTree none = treeOver({});
  EXPECT_EQ(none.size(), 0u);
  EXPECT_TRUE(none.bounds().empty());
  for (RayBundle bundle : meshQuestions(4, 21))
  {
    none.cast(bundle, 0);
    none.occlude(bundle, 0);
    for (int i = 0; i < bundle.count; ++i)
      EXPECT_EQ(bundle.object[i], -1);
  }
  Triangles one;
  one.add({-1, -1, 0.3}, {1, -1, 0.1}, {0, 1, -0.2});
  expectRight(one, 40, 22, 0.02);
}

TEST(RlodTree, LeavesOutTrianglesThatAreNotFinite)
{
  Triangles all = bumpySphere(8);
  const std::size_t whole = all.size();
  addNotFinite(all);
  const RlodTree tree = treeOver(all);
  EXPECT_EQ(tree.size(), whole);
  expectRight(all, 20, 23);
}

TEST(RlodTree, BoundsAreThoseOfTheTriangles)
{
  const Triangles sphere = bumpySphere(9, {5.0, 6.0, 7.0}, 2.0);
  Box box;
  for (std::size_t i = 0; i < sphere.pointCount(); ++i)
    box.add(sphere.point(i));
  const Box bounds = treeOver(sphere).bounds();
  EXPECT_LT(glm::length(bounds.lower - box.lower) + glm::length(bounds.upper - box.upper), 1e-6);
}

TEST(RlodTree, DoesNotDependOnTheNumberOfThreads)
{
  const Triangles sphere = bumpySphere(90);
  const TriangleMesh mesh = sphere.mesh();
  RlodTree alone, together;
  tbb::task_arena(1).execute([&] { alone.build(mesh); });
  tbb::task_arena(4).execute([&] { together.build(mesh); });
  expectSameTree(alone, together);
}

TEST(RlodTree, DoesNotDependOnTheInstructionSet)
{
  const Triangles sphere = bumpySphere(90), loose = randomTriangles(3000, 5, 0.1);
  const RlodTree ofSphere = treeOver(sphere), ofLoose = treeOver(loose);
  for (const std::int64_t target : everyTarget())
  {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnlyTargets only(target);
    expectSameTree(ofSphere, treeOver(sphere));
    expectSameTree(ofLoose, treeOver(loose));
  }
}

TEST(RlodTree, TakesNoMoreThan26BytesATriangle)
{
  const Triangles sphere = bumpySphere(150);
  const RlodTree tree = treeOver(sphere);
  EXPECT_LT(double(tree.bytes()) / double(sphere.size()), 26.0);
}

TEST(RlodTree, FollowsPointsThatMove)
{
  Triangles sphere = bumpySphere(20);
  TriangleMesh mesh = sphere.mesh();
  RlodTree tree;
  tree.build(mesh);
  sphere.move([](const Vec3d& p)
    { return Vec3d(p.x + 0.3 * std::sin(3.0 * p.z), 0.8 * p.y, p.z + 0.2 * p.x * p.y); });
  mesh.movePoints(sphere.pointView());
  ASSERT_TRUE(tree.refit(mesh));
  const CastReport report = checkMesh(tree, TriangleOracle(sphere), meshQuestions(30, 24));
  EXPECT_EQ(report.wrong, 0u) << report.complaint;
  EXPECT_GT(report.hits, report.rays / 20);
  // Where other triangles are valid the tree says so and stays.
  const Box before = tree.bounds();
  sphere.points[30] = std::numeric_limits<double>::quiet_NaN();
  mesh.movePoints(sphere.pointView());
  EXPECT_FALSE(tree.refit(mesh));
  EXPECT_EQ(tree.bounds().lower, before.lower);
}

TEST(RlodTree, CostsMoreWhereItsTrianglesHaveWandered)
{
  Triangles soup = randomTriangles(5000, 9, 0.05);
  TriangleMesh mesh = soup.mesh();
  RlodTree tree;
  EXPECT_EQ(tree.cost(), 0.0);
  tree.build(mesh);
  const double built = tree.cost();
  EXPECT_GT(built, 1.0);
  soup.move([](const Vec3d& p) { return 5.0 * p + Vec3d(3.0); }); // all alike
  mesh.movePoints(soup.pointView());
  ASSERT_TRUE(tree.refit(mesh));
  EXPECT_NEAR(tree.cost() / built, 1.0, 1e-3);
  // Every other triangle elsewhere: boxes of both places.
  for (std::size_t i = 0; i < soup.points.size(); i += 18)
    for (std::size_t k = 0; k < 9; k += 3)
      soup.points[i + k] += 20.0;
  mesh.movePoints(soup.pointView());
  ASSERT_TRUE(tree.refit(mesh));
  RlodTree anew;
  anew.build(mesh);
  EXPECT_GT(tree.cost(), 2.0 * anew.cost());
}

TEST(RlodTree, StopsWhenItIsTold)
{
  const Triangles sphere = bumpySphere(40);
  double last = -1.0;
  int calls = 0;
  RlodTree tree;
  tree.build(sphere.mesh(),
    [&](double share)
    {
      EXPECT_GE(share, last);
      last = share;
      return ++calls < 100;
    });
  EXPECT_EQ(last, 1.0);
  EXPECT_EQ(tree.size(), sphere.size());
  tree.build(sphere.mesh(), [](double share) { return share < 0.1; });
  EXPECT_EQ(tree.size(), 0u);
}

namespace
{

/// The same triangles seen from the other side.
Triangles turnedOver(Triangles triangles)
{
  for (std::size_t i = 0; i < triangles.size(); ++i)
    std::swap(triangles.corners[3 * i + 1], triangles.corners[3 * i + 2]);
  return triangles;
}

/// How each ray of a bundle is answered by castInner(), as a bundle or one by one.
RayBundle inner(const RlodTree& tree, RayBundle bundle, bool oneByOne)
{
  if (!oneByOne)
  {
    tree.castInner(bundle, 0);
    return bundle;
  }
  askInPackets(
    bundle, OnSurface::Neither, [&](RayPacket& packet, int) { tree.castInner(packet, 0); });
  return bundle;
}

} // namespace

TEST(RlodTree, InnerSidesAndOuterOnesTogetherAreAll)
{
  for (const Triangles& triangles : {bumpySphere(20), randomTriangles(600, 31, 0.3)})
    for (const std::int64_t target : everyTarget())
    {
      SCOPED_TRACE(hwy::TargetName(target));
      const OnlyTargets only(target);
      const RlodTree tree = treeOver(triangles), turned = treeOver(turnedOver(triangles));
      std::size_t hits = 0, fromWithin = 0, unlike = 0;
      for (const RayBundle& asked : meshQuestions(40, 32))
        for (const bool oneByOne : {false, true})
        {
          RayBundle all = asked;
          tree.cast(all, 0);
          const RayBundle in = inner(tree, asked, oneByOne), out = inner(turned, asked, oneByOne);
          for (int i = 0; i < asked.count; ++i)
          {
            for (const auto& [found, held] : {std::pair(&in, &tree), std::pair(&out, &turned)})
              if (found->object[i] == 0)
              {
                const Vec3d normal(held->normal(found->slot[i]));
                // Of triangles that are seen from their edge the side is rounded.
                const double cosine = glm::dot(normal, asked.directionOf(i)) /
                                      (glm::length(normal) * glm::length(asked.directionOf(i)));
                EXPECT_GT(cosine, -1e-4);
              }
            hits += all.object[i] == 0;
            fromWithin += in.object[i] == 0;
            const double nearest = std::min(
              in.object[i] == 0 ? in.t[i] : asked.t[i], out.object[i] == 0 ? out.t[i] : asked.t[i]);
            const double wanted = all.object[i] == 0 ? all.t[i] : asked.t[i];
            unlike += nearest != wanted && !(std::abs(nearest - wanted) <= 1e-5 * std::abs(wanted));
          }
        }
      EXPECT_GT(hits, 1000u);
      EXPECT_GT(fromWithin, hits / 4);
      EXPECT_LE(unlike, hits / 1000) << "of " << hits;
    }
}

TEST(RlodTree, FromOutsideTheInnerSideOfWhatIsClosedLiesBehind)
{
  const RlodTree tree = treeOver(bumpySphere(24));
  std::size_t hits = 0, lost = 0;
  for (const RayBundle& asked : meshQuestions(40, 33))
    if (glm::length(asked.origin) > 1.5 && asked.tMin == 0.0)
    {
      RayBundle all = asked;
      tree.cast(all, 0);
      const RayBundle in = inner(tree, asked, false);
      for (int i = 0; i < asked.count; ++i)
        if (all.object[i] == 0 && !(asked.t[i] < 1e9))
        {
          ++hits;
          lost += in.object[i] != 0;
          EXPECT_TRUE(in.object[i] != 0 || in.t[i] >= all.t[i]);
        }
    }
  EXPECT_GT(hits, 500u);
  EXPECT_LE(lost, hits / 500); // that touch the outline
}
