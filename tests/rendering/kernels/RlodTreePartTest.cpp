// Trees of some of a tree's triangles: rays through them beside rays through a tree that has no
// others.

#include "MeshParts.h"

#include <support/Targets.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

/// Whether a triangle is visible, by its number: all of some runs, and some of others.
bool isShown(std::uint64_t triangle)
{
  const std::uint64_t run = triangle / 90;
  return run % 3 == 0 || (run % 3 == 1 && triangle * 2654435761U % 7 < 3);
}

/// The visible ones, with the numbers that they have; the others have no place.
Triangles shownOf(const Triangles& all)
{
  Triangles some = all;
  const std::int32_t nowhere = some.addPoint(Vec3d(NAN));
  for (std::size_t k = 0; k < some.corners.size(); ++k)
    if (!isShown(k / 3))
      some.corners[k] = nowhere;
  return some;
}

std::shared_ptr<RlodTree> wholeOf(const Triangles& triangles)
{
  return std::make_shared<RlodTree>(treeWithLods(triangles));
}

/// Checks a part by brute force over the triangles that it has.
void expectPart(const RlodTree& part, const Triangles& all, int bundles, std::uint64_t seed)
{
  const TriangleOracle oracle(shownOf(all));
  const CastReport report = checkMesh(part, oracle, meshQuestions(bundles, seed));
  EXPECT_EQ(report.wrong, 0u) << "of " << report.rays << " rays; " << report.complaint;
  EXPECT_GT(report.hits, report.rays / 50);
}

} // namespace

TEST(RlodTreePart, RaysMeetVisibleTrianglesAlone)
{
  for (const Triangles& all : {bumpySphere(18), randomTriangles(1000, 2, 0.1)})
  {
    const auto whole = wholeOf(all);
    const auto part = RlodTree::partOf(whole, isShown);
    expectPart(*part, all, 30, 1);
    EXPECT_EQ(part->size(), shownOf(all).mesh().validCount());
    EXPECT_EQ(whole->size(), all.size()) << "which stays as it is";
    const CastReport report = checkMesh(*whole, TriangleOracle(all), meshQuestions(6, 2));
    EXPECT_EQ(report.wrong, 0u) << report.complaint;
    const RlodTree alone = treeOver(shownOf(all));
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(part->bounds().lower[axis], alone.bounds().lower[axis], 1e-6);
      EXPECT_NEAR(part->bounds().upper[axis], alone.bounds().upper[axis], 1e-6);
    }
  }
}

TEST(RlodTreePart, EveryInstructionSetAgrees)
{
  const Triangles all = bumpySphere(14);
  const auto part = RlodTree::partOf(wholeOf(all), isShown);
  for (const std::int64_t target : everyTarget())
  {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnlyTargets only(target);
    expectPart(*part, all, 12, 3);
  }
}

TEST(RlodTreePart, SlotsAreThoseOfTheWhole)
{
  const Triangles all = bumpySphere(40);
  const auto whole = wholeOf(all);
  const auto part = RlodTree::partOf(whole, isShown);
  std::size_t hits = 0;
  for (RayBundle& question : meshQuestions(20, 4))
  {
    part->cast(question, 5);
    for (int i = 0; i < question.count; ++i)
      if (question.object[i] == 5)
      {
        ++hits;
        EXPECT_TRUE(isShown(part->inputIndex(question.slot[i])));
        EXPECT_EQ(part->inputIndex(question.slot[i]), whole->inputIndex(question.slot[i]));
        EXPECT_EQ(part->normal(question.slot[i]), whole->normal(question.slot[i]));
      }
  }
  EXPECT_GT(hits, 500u);
}

TEST(RlodTreePart, LodsStandForVisibleTrianglesAlone)
{
  const Triangles all = bumpySphere(60);
  const auto inLongRuns = [](std::uint64_t triangle) { return triangle / 700 % 3 != 1; };
  const auto part = RlodTree::partOf(wholeOf(all), inLongRuns);
  std::size_t lods = 0, rays = 0, holes = 0;
  for (RayBundle question : meshQuestions(60, 5))
  {
    std::fill_n(question.t, question.count, std::numeric_limits<double>::infinity());
    RayBundle exact = question, rough = question;
    part->cast(exact, 0);
    part->cast(rough, 0, 30.0);
    for (int i = 0; i < question.count; ++i)
    {
      rays += 1;
      holes += exact.object[i] == 0 && rough.object[i] != 0;
      if (rough.object[i] != 0 || !RlodTree::isLod(rough.slot[i]))
        continue;
      ++lods;
      for (const std::uint64_t below : part->slotsBelow(rough.slot[i]))
        EXPECT_TRUE(inLongRuns(part->inputIndex(below)));
    }
  }
  EXPECT_EQ(holes, 0u);
  EXPECT_GT(lods, rays / 100);
}

TEST(RlodTreePart, LodsMayBeMadeLater)
{
  const Triangles all = bumpySphere(60);
  auto whole = std::make_shared<RlodTree>(treeOver(all));
  whole->setSparesMemory(true);
  const auto part = RlodTree::partOf(whole, isShown);
  EXPECT_FALSE(part->hasLods());
  whole->makeLods();
  part->takeLodsOfWhole();
  EXPECT_TRUE(part->hasLods());
  const auto late = RlodTree::partOf(whole, isShown);
  for (RayBundle question : meshQuestions(10, 6))
  {
    RayBundle other = question;
    part->cast(question, 0, 8.0);
    late->cast(other, 0, 8.0);
    for (int i = 0; i < question.count; ++i)
      EXPECT_EQ(question.t[i], other.t[i]);
  }
}

TEST(RlodTreePart, TheNextTakesTheMemoryOfTheLast)
{
  const Triangles all = bumpySphere(16);
  const auto whole = wholeOf(all);
  auto part = RlodTree::partOf(whole, [](std::uint64_t t) { return t % 2 == 0; });
  const RlodTree* const before = part.get();
  part = RlodTree::partOf(whole, isShown, std::move(part));
  EXPECT_EQ(part.get(), before);
  expectPart(*part, all, 12, 7);
  // Not where somebody holds it.
  const auto held = part;
  part = RlodTree::partOf(
    whole, [](std::uint64_t) { return true; }, std::move(part));
  EXPECT_NE(part.get(), before);
  EXPECT_EQ(part->size(), whole->size());
  expectPart(*held, all, 6, 8);
}

TEST(RlodTreePart, NothingMayBeVisible)
{
  const Triangles all = bumpySphere(20);
  const auto part = RlodTree::partOf(wholeOf(all), [](std::uint64_t) { return false; });
  EXPECT_EQ(part->size(), 0u);
  EXPECT_TRUE(part->bounds().empty());
  for (RayBundle question : meshQuestions(8, 9))
  {
    part->cast(question, 0);
    part->occlude(question, 0);
    for (int i = 0; i < question.count; ++i)
      EXPECT_EQ(question.object[i], -1);
  }
}
