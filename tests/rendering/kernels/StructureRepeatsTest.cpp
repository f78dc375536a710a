// Thousands of particles that are one and the same sphere: rays meet one of them, the first that is
// shown, and whatever asks for all particles still finds all.

#include "PkdTreeFileParts.h"

#include <support/CastOracle.h>
#include <support/Particles.h>
#include <support/Structure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <type_traits>

using namespace mote;
using namespace mote::testing;

namespace
{

/// Spheres at random, and among them, in a shuffled order, 6,000 at one place, of two radii, and
/// 2,000 at another; and values, of which those at one place differ.
struct Repeated
{
  Particles particles;
  std::vector<float> values;

  Repeated()
  {
    Particles some = randomParticles(700, 91, 0.02, 0.1);
    for (int i = 0; i < 6000; ++i)
      some.add({0.25, -0.5, 0.75}, i % 3 == 0 ? 0.3 : 0.2);
    for (int i = 0; i < 2000; ++i)
      some.add({-0.4, 0.3, 0.1}, 0.25);
    std::vector<std::size_t> order(some.size());
    std::iota(order.begin(), order.end(), 0);
    Random random(92);
    for (std::size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[static_cast<std::size_t>(random(0.0, double(i)))]);
    for (const std::size_t i : order)
    {
      particles.add(some.center(i), some.radii[i]);
      values.push_back(static_cast<float>(random(0.0, 1.0)));
    }
  }

  /// The first of each different sphere among the `kept`.
  template <typename Kept>
  std::vector<std::size_t> firsts(const Kept& kept) const
  {
    std::map<std::array<double, 4>, std::size_t> first;
    for (std::size_t i = 0; i < particles.size(); ++i)
      if (const Vec3d c = particles.center(i); kept(i))
        first.insert({{c.x, c.y, c.z, particles.radii[i]}, i});
    std::vector<std::size_t> indices;
    for (const auto& [sphere, i] : first)
      indices.push_back(i);
    std::sort(indices.begin(), indices.end());
    return indices;
  }

  /// Expects that rays through `structure` meet what they meet in one over each different sphere
  /// once, and that all the `kept` are shown.
  template <typename Structure, typename Kept>
  void expectOnly(const Structure& structure, const Kept& kept) const
  {
    std::size_t shown = 0;
    for (std::size_t slot = 0; slot < structure.size(); ++slot)
    {
      ASSERT_EQ(structure.isShown(slot), kept(structure.inputIndex(slot)));
      shown += structure.isShown(slot);
    }
    EXPECT_EQ(structure.shownCount(), shown);
    const std::vector<std::size_t> indices = firsts(kept);
    Particles once;
    for (const std::size_t i : indices)
      once.add(particles.center(i), particles.radii[i]);
    Structure alone;
    alone.build(once.set());
    std::size_t hits = 0, stopped = 0;
    for (const Vec3d& eye : {Vec3d(3.0, 1.0, 2.0), Vec3d(-1.0, -2.0, -3.0), Vec3d(0.2, -0.4, 0.8)})
      forBundles(lookAt(eye, Vec3d(0.0), 45.0), 64, 64, 16,
        [&](const RayBundle& rays)
        {
          RayBundle bundle = rays, wanted = rays, stops = rays, wantedStops = rays;
          structure.cast(bundle, 0);
          alone.cast(wanted, 0);
          structure.occlude(stops, 0);
          alone.occlude(wantedStops, 0);
          for (int i = 0; i < bundle.count; ++i)
          {
            ASSERT_EQ(stops.t[i] < 0.0, wantedStops.t[i] < 0.0);
            stopped += stops.t[i] < 0.0;
            ASSERT_EQ(bundle.object[i], wanted.object[i]);
            if (bundle.object[i] < 0)
              continue;
            ++hits;
            ASSERT_EQ(
              structure.inputIndex(bundle.slot[i]), indices[alone.inputIndex(wanted.slot[i])]);
          }
        });
    EXPECT_GT(hits, 100u);
    EXPECT_EQ(stopped, hits);
  }
};

/// Of the 8,700 particles; the ends of groups in a tree are no repeats.
constexpr std::size_t mostLookedAt = 2500;

const auto all = [](std::size_t) { return true; };

} // namespace

template <typename Structure>
using StructureRepeats = StructureTest<Structure>;
TYPED_TEST_SUITE(StructureRepeats, ParticleStructures, StructureName);

TYPED_TEST(StructureRepeats, TheFirstThatIsShownIsHit)
{
  const Repeated r;
  TypeParam structure;
  structure.build(r.particles.set());
  r.expectOnly(structure, all);
  // The first of each group go, and then all of one group.
  const std::vector<std::size_t> firsts = r.firsts(all);
  const auto isNoFirst = [&](std::size_t i)
  { return !std::binary_search(firsts.begin(), firsts.end(), i) || i % 2 == 0; };
  structure.setVisibility([&](std::size_t slot) { return isNoFirst(structure.inputIndex(slot)); });
  r.expectOnly(structure, isNoFirst);
  const auto isNoLarge = [&](std::size_t i) { return r.particles.radii[i] != 0.3; };
  structure.setVisibility([&](std::size_t slot) { return isNoLarge(structure.inputIndex(slot)); });
  r.expectOnly(structure, isNoLarge);
  structure.setVisibility({});
  r.expectOnly(structure, all);
}

TYPED_TEST(StructureRepeats, RangesLeaveTheFirstInRange)
{
  const Repeated r;
  TypeParam structure;
  structure.build(r.particles.set());
  structure.setAttributes({{ArrayView(r.values.data(), r.values.size(), 1)}});
  ParticleRanges ranges;
  ranges.lower[4] = 0.2;
  ranges.upper[4] = 0.9;
  structure.setRanges(ranges);
  const auto isIn = [&](std::size_t i) { return r.values[i] >= 0.2f && r.values[i] <= 0.9f; };
  r.expectOnly(structure, isIn);
  structure.setVisibility([&](std::size_t slot) { return structure.inputIndex(slot) % 2 == 1; });
  r.expectOnly(structure, [&](std::size_t i) { return isIn(i) && i % 2 == 1; });
  structure.setVisibility({});
  ranges.upper[4] = 0.21; // few of them
  structure.setRanges(ranges);
  r.expectOnly(
    structure, [&](std::size_t i) { return r.values[i] >= 0.2f && r.values[i] <= 0.21f; });
  structure.setRanges({});
  r.expectOnly(structure, all);
}

TYPED_TEST(StructureRepeats, SlotsAndNeighboursAreWhole)
{
  const Repeated r;
  TypeParam structure;
  structure.build(r.particles.set());
  const auto isThere = [](const Vec3d& at)
  { return glm::distance(at, Vec3d(0.25, -0.5, 0.75)) < 1e-6; };
  std::size_t inRuns = 0;
  for (const SlotRun& run : structure.slotsBetween(0, 0.2499, 0.2501))
    for (std::size_t slot = run.first; slot < run.last; ++slot)
      inRuns += isThere(structure.center(slot));
  EXPECT_EQ(inRuns, 6000u);
  std::vector<NearParticle> found;
  structure.findNear({0.25, -0.5, 0.75}, 0.01, found);
  std::map<double, std::size_t> radii;
  for (const NearParticle& near : found)
    if (isThere(near.center))
      ++radii[near.radius];
  EXPECT_EQ(radii.size(), 2u);
  if constexpr (!std::is_same_v<TypeParam, PkdPaperTree>)
  {
    EXPECT_LT(found.size(), mostLookedAt);
  }
}

TYPED_TEST(StructureRepeats, NothingButOneSphere)
{
  Particles particles;
  for (int i = 0; i < 5000; ++i)
    particles.add({1.0, 2.0, 3.0}, 0.5);
  TypeParam structure;
  structure.build(particles.set());
  EXPECT_EQ(structure.shownCount(), 5000u);
  for (const std::uint64_t first : {0u, 4321u})
  {
    structure.setVisibility([&](std::size_t slot) { return structure.inputIndex(slot) >= first; });
    RayPacket packet = emptyPacket();
    addRay(packet, {1.0, 2.0, 9.0}, {0.0, 0.0, -1.0});
    structure.cast(packet, 0);
    ASSERT_EQ(packet.object[0], 0);
    EXPECT_EQ(structure.inputIndex(packet.slot[0]), first);
    EXPECT_NEAR(packet.t[0], 5.5, 1e-6);
  }
  structure.setVisibility([](std::size_t) { return false; });
  RayPacket packet = emptyPacket();
  addRay(packet, {1.0, 2.0, 9.0}, {0.0, 0.0, -1.0});
  structure.cast(packet, 0);
  EXPECT_EQ(packet.object[0], -1);
}

TEST(StructureRepeatsOfTrees, AllForms)
{
  const Repeated r;
  for (const auto form :
    {PkdTreeOptions::Form::Exact, PkdTreeOptions::Form::Bytes8, PkdTreeOptions::Form::Bytes4})
    for (const std::size_t share : {0, 8})
    {
      PkdTreeOptions options;
      options.form = form;
      options.mostError = 1.0;
      options.sparseShare = share;
      PkdTree tree;
      tree.build(r.particles.set(), options);
      std::vector<NearParticle> found;
      tree.findNear({0.25, -0.5, 0.75}, 0.01, found);
      EXPECT_LT(found.size(), mostLookedAt);
      EXPECT_EQ(tree.shownCount(), r.particles.size());
      const std::vector<std::size_t> firsts = r.firsts(all);
      std::size_t hits = 0;
      forBundles(lookAt(Vec3d(3.0, 1.0, 2.0), Vec3d(0.0), 45.0), 64, 64, 16,
        [&](RayBundle bundle)
        {
          tree.cast(bundle, 0);
          for (int i = 0; i < bundle.count; ++i)
          {
            if (bundle.object[i] != 0)
              continue;
            ++hits;
            ASSERT_TRUE(
              std::binary_search(firsts.begin(), firsts.end(), tree.inputIndex(bundle.slot[i])));
          }
        });
      EXPECT_GT(hits, 100u);
    }
}

TEST(StructureRepeatsOfTrees, OfAFile)
{
  const Repeated r;
  PkdTree tree;
  tree.build(r.particles.set());
  const Folder folder;
  ASSERT_TRUE(writePkdTreeFile(folder.file(), tree, {}));
  const PkdTreeFile file(folder.file());
  std::vector<NearParticle> found;
  file.tree().findNear({0.25, -0.5, 0.75}, 0.01, found);
  EXPECT_LT(found.size(), mostLookedAt);
  EXPECT_EQ(file.tree().shownCount(), r.particles.size());
}
