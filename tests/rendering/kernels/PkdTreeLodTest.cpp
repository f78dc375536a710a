// Levels of detail of the P-k-d tree: boxes that stand for particles.

#include "PkdTreeLodParts.h"

#include <support/Targets.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace mote;
using namespace mote::testing;

namespace
{

/// How far aside a ray passes from the nearest sphere that its hit stands for, in footprints.
double displacementOf(const PkdTree& tree, const RayBundle& rays, int i)
{
  const Vec3d way = glm::normalize(rays.directionOf(i));
  const SlotRun below = tree.slotsBelow(rays.slot[i]);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t slot = below.first; slot < below.last; ++slot)
    nearest = std::min(nearest,
      glm::length(glm::cross(tree.center(slot) - rays.originOf(i), way)) - tree.radius(slot));
  return nearest / (rays.footprint + rays.t[i] * rays.footprintPerT);
}

struct Displacements
{
  int hits = 0, lods = 0, beyond = 0; ///< beyond: by more than the pixels of error
  double most = 0.0;
};

Displacements displacementsOf(
  const PkdTree& tree, const std::vector<RayBundle>& bundles, double poe)
{
  Displacements found;
  for (RayBundle rays : bundles)
  {
    tree.cast(rays, 7, poe);
    for (int i = 0; i < rays.count; ++i)
    {
      if (rays.object[i] != 7)
        continue;
      ++found.hits;
      if (!PkdTree::isLod(rays.slot[i]))
        continue;
      ++found.lods;
      const double displaced = displacementOf(tree, rays, i);
      found.beyond += displaced > poe;
      found.most = std::max(found.most, displaced);
    }
  }
  return found;
}

} // namespace

TEST(PkdTreeLod, IsExactWithoutPixelsOfErrorOrWithoutLods)
{
  const Particles particles = randomParticles(20000, 4, 0.002, 0.02);
  const auto plain = treeOver(particles, false), lods = treeOver(particles, true);
  for (const RayBundle& question : farBundles(24, 5))
  {
    RayBundle exact = question, zero = question, none = question;
    treeOf(plain).cast(exact, 0);
    treeOf(lods).cast(zero, 0, 0.0);
    treeOf(plain).cast(none, 0, 8.0);
    for (int i = 0; i < question.count; ++i)
    {
      EXPECT_EQ(exact.slot[i], zero.slot[i]);
      EXPECT_EQ(exact.t[i], zero.t[i]);
      EXPECT_EQ(exact.slot[i], none.slot[i]);
      EXPECT_EQ(exact.t[i], none.t[i]);
    }
  }
}

TEST(PkdTreeLod, HitsAreAsNearToParticlesAsAllowed)
{
  for (const auto& particles : {denseParticles(40, 1), randomParticles(60000, 2, 0.004, 0.012),
         randomParticles(3000, 3, 0.001, 0.1)})
  {
    const auto structure = treeOver(particles, true);
    for (const double poe : {0.5, 1.0, 3.0})
    {
      SCOPED_TRACE(poe);
      const Displacements found = displacementsOf(treeOf(structure), farBundles(60, 6), poe);
      EXPECT_LE(found.beyond, found.lods / 20);
      EXPECT_LT(found.most, 2.1 * poe);
      EXPECT_GT(found.hits, 1000);
    }
  }
  const auto dense = treeOver(denseParticles(40, 1), true);
  const Displacements found = displacementsOf(treeOf(dense), farBundles(60, 6), 3.0);
  EXPECT_GT(found.lods, 0.85 * found.hits);
}

TEST(PkdTreeLod, EveryInstructionSetAgrees)
{
  const Particles particles = denseParticles(30, 8);
  std::vector<RayBundle> first;
  for (const std::int64_t target : everyTarget())
  {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnlyTargets only(target);
    const auto structure = treeOver(particles, true);
    std::vector<RayBundle> answers = farBundles(24, 9);
    int differing = 0, lods = 0, rays = 0;
    for (std::size_t k = 0; k < answers.size(); ++k)
    {
      treeOf(structure).cast(answers[k], 0, 2.0);
      for (int i = 0; i < answers[k].count; ++i, ++rays)
      {
        lods += PkdTree::isLod(answers[k].slot[i]);
        differing += !first.empty() && (answers[k].slot[i] != first[k].slot[i] ||
                                         std::abs(answers[k].t[i] - first[k].t[i]) > 1e-4);
      }
    }
    EXPECT_GT(lods, rays / 4);
    // Fused and separate multiply-add round differently: an edge may fall to either side.
    EXPECT_LE(differing, rays / 200);
    if (first.empty())
      first = answers;
  }
}

TEST(PkdTreeLod, BoxesHoldTheirParticlesAndKnowHowMuchTheseCover)
{
  const Particles particles = randomParticles(30000, 12, 0.005, 0.03);
  const auto structure = treeOver(particles, true);
  const PkdTree& tree = treeOf(structure);
  Random random(13);
  Vec3d known(0.0), covered(0.0), worst(0.0);
  int count = 0;
  for (const std::uint64_t slot : tree.lodSlots())
  {
    const PkdTree::Lod lod = tree.lod(slot);
    const SlotRun below = tree.slotsBelow(slot);
    ASSERT_LT(below.first, below.last);
    ASSERT_GE(tree.speaker(slot), below.first);
    ASSERT_LT(tree.speaker(slot), below.last);
    for (std::size_t k = below.first; k < below.last; ++k)
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_LE(std::abs(tree.center(k)[axis] - lod.center[axis]) + tree.radius(k),
          lod.half[axis] * (1.0 + 1e-6));
    if (below.last - below.first > 300)
      continue; // long to look at
    ++count;
    for (int axis = 0; axis < 3; ++axis)
    {
      constexpr int rays = 64;
      double share = 0.0;
      for (int ray = 0; ray < rays; ++ray)
      {
        const Vec3d at = lod.center + lod.half * random.inBox(Vec3d(-1.0), Vec3d(1.0));
        bool hit = false;
        for (std::size_t k = below.first; k < below.last && !hit; ++k)
        {
          Vec3d across = tree.center(k) - at;
          across[axis] = 0.0;
          hit = glm::length(across) <= tree.radius(k);
        }
        share += hit ? 1.0 / rays : 0.0;
      }
      known[axis] += lod.coverage[axis];
      covered[axis] += share;
      worst[axis] = std::max(worst[axis], std::abs(lod.coverage[axis] - share));
    }
  }
  EXPECT_GT(count, 1500);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(known[axis] / count, covered[axis] / count, 0.015);
    EXPECT_LT(worst[axis], 0.4);
  }
}

TEST(PkdTreeLod, SetsAreAsDenseAsTheyLook)
{
  // From specks in the void to what nothing is seen through.
  for (const double radius : {0.0012, 0.0025, 0.005, 0.01})
  {
    SCOPED_TRACE(radius);
    const auto structure = treeOver(randomParticles(60000, 14, radius, radius), true);
    const Tracing many{24, 0, 0};
    const Film exact = pictureOf(structure, 0.0, many), rough = pictureOf(structure, 2.5, many);
    EXPECT_NEAR(meanOf(rough, 3) / meanOf(exact, 3), 1.0, 0.1);
    EXPECT_NEAR(meanOf(rough, 0) / meanOf(exact, 0), 1.0, 0.1);
  }
}

TEST(PkdTreeLod, BoxesAreLitTheSameInBundlesAndAlone)
{
  const ParticleSurface surface(treeOver(denseParticles(40, 1), true), 3.0);
  int lods = 0;
  for (RayBundle rays : farBundles(30, 6))
  {
    surface.cast(rays, 0);
    HitBlock block = hitsOf(rays);
    surface.fetch(block);
    surface.place(block, {rays, rays, Vec3d(0.0), nullptr, true});
    for (int k = 0; k < block.count; ++k)
    {
      const Vec3d way = rays.directionOf(block.ray[k]);
      const Vec3d point = rays.originOf(block.ray[k]) + block.t[k] * way;
      const bool isLod = PkdTree::isLod(block.slot[k]);
      const Vec3d alone = isLod ? surface.seenNormalAt(block.slot[k], point, way)
                                : surface.normalAt(block.slot[k], point);
      const Vec3d normal(block.normal.x[k], block.normal.y[k], block.normal.z[k]);
      ASSERT_LT(glm::length(normal - glm::normalize(alone)), 1e-4) << isLod;
      lods += isLod;
    }
  }
  EXPECT_GT(lods, 1000);
}

TEST(PkdTreeLod, HiddenParticlesStayHidden)
{
  const Particles particles = denseParticles(40, 15);
  const auto structure = treeOver(particles, true);
  auto& tree = std::get<PkdTree>(*structure);
  const auto expectShown = [&](double poe)
  {
    int lods = 0;
    for (RayBundle rays : farBundles(30, 16))
    {
      tree.cast(rays, 0, poe);
      for (int i = 0; i < rays.count; ++i)
      {
        if (rays.object[i] != 0)
          continue;
        const bool isLod = PkdTree::isLod(rays.slot[i]);
        const SlotRun below =
          isLod ? tree.slotsBelow(rays.slot[i]) : SlotRun{rays.slot[i], rays.slot[i] + 1};
        for (std::size_t slot = below.first; slot < below.last; ++slot)
          EXPECT_TRUE(tree.isShown(slot));
        lods += isLod;
      }
    }
    return lods;
  };
  tree.setVisibility([&](std::size_t slot) { return tree.center(slot).x < 0.2; });
  EXPECT_GT(expectShown(3.0), 500);
  tree.setVisibility([](std::size_t slot) { return slot % 16 != 5; });
  EXPECT_EQ(expectShown(3.0), 0) << "nothing is shown as a whole";
  tree.setVisibility([](std::size_t slot) { return slot % 100 == 0; });
  EXPECT_EQ(expectShown(3.0), 0) << "a tree of few has none";
  tree.setVisibility({});
  ParticleRanges ranges;
  ranges.lower[1] = -0.3;
  tree.setRanges(ranges);
  EXPECT_GT(expectShown(3.0), 500);
  tree.dropLods();
  EXPECT_EQ(expectShown(3.0), 0);
  tree.makeLods();
  EXPECT_GT(expectShown(3.0), 500) << "made where something is hidden";
  // They are of all particles: with these shown again they are as if nothing had been hidden.
  tree.setVisibility([](std::size_t slot) { return slot % 3 == 0; });
  tree.dropLods();
  tree.makeLods();
  tree.setVisibility({});
  tree.setRanges({});
  const auto fresh = treeOver(particles, true);
  for (RayBundle rays : farBundles(10, 17))
  {
    RayBundle same = rays;
    tree.cast(rays, 0, 3.0);
    treeOf(fresh).cast(same, 0, 3.0);
    for (int i = 0; i < rays.count; ++i)
      ASSERT_EQ(rays.t[i], same.t[i]);
  }
}

TEST(PkdTreeLod, MeansAreWeightedByTheSquaresOfRadii)
{
  const Particles particles = randomParticles(5000, 17, 0.001, 0.05);
  const auto structure = treeOver(particles, true);
  const PkdTree& tree = treeOf(structure);
  const auto valuesOf = [](std::uint64_t particle, double* values)
  {
    values[0] = particle % 5 == 0 ? std::nan("") : static_cast<double>(particle);
    values[1] = std::nan("");
  };
  const std::vector<float> means = tree.lodMeans(2, valuesOf);
  for (const std::uint64_t slot : tree.lodSlots())
  {
    double sum = 0.0, weight = 0.0;
    const SlotRun below = tree.slotsBelow(slot);
    for (std::size_t k = below.first; k < below.last; ++k)
    {
      const std::uint64_t particle = tree.inputIndex(k);
      const double by = particle % 5 == 0 ? 0.0 : tree.radius(k) * tree.radius(k);
      sum += by * static_cast<double>(particle);
      weight += by;
    }
    const std::size_t place = 2 * PkdTree::lodPlace(slot);
    ASSERT_NEAR(means[place], sum / weight, 1e-5 * sum / weight);
    ASSERT_TRUE(std::isnan(means[place + 1]));
  }
}

TEST(PkdTreeLod, MemoryIsAsSmallAsSaid)
{
  const Particles particles = denseParticles(60, 18);
  const auto structure = treeOver(particles, false);
  auto& tree = std::get<PkdTree>(*structure);
  const std::size_t before = tree.bytes();
  tree.makeLods();
  EXPECT_LT(static_cast<double>(tree.bytes() - before), 0.28 * static_cast<double>(tree.size()));
  tree.dropLods();
  EXPECT_EQ(tree.bytes(), before);
}
