// What ranges of values show: exactly the particles in range, whatever the traversal skips.

#include <kernels/core/Error.h>
#include <support/Structure.h>

#include <support/CastOracle.h>
#include <support/Particles.h>

#include <gtest/gtest.h>

using namespace mote;
using namespace mote::testing;

namespace
{

/// A set with two attributes, one a clear function of the place and one of none.
template <typename Structure>
struct Attributed
{
  Particles particles = randomParticles(3000, 131, 0.01, 0.06);
  std::vector<float> smooth, noise;
  Structure grid;

  Attributed()
  {
    Random random(132);
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
      smooth.push_back(static_cast<float>(particles.center(i).x + particles.center(i).y));
      noise.push_back(static_cast<float>(random(0.0, 1.0)));
    }
    grid.build(particles.set());
    grid.setAttributes(
      {{ArrayView(smooth.data(), smooth.size(), 1)}, {ArrayView(noise.data(), noise.size(), 1)}});
  }

  /// Casts two views and expects what a set of the `kept` particles alone would answer.
  template <typename Kept>
  void expectOnly(const Kept& kept) const
  {
    Particles left;
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < particles.size(); ++i)
      if (kept(i))
      {
        left.add(particles.center(i), particles.radii[i]);
        indices.push_back(i);
      }
    EXPECT_EQ(grid.shownCount(), indices.size());
    Structure alone;
    alone.build(left.set());
    std::size_t hits = 0;
    for (const Vec3d& eye : {Vec3d(3.0, 1.0, 2.0), Vec3d(-1.0, -2.0, -3.0)})
      forBundles(lookAt(eye, Vec3d(0.0), 45.0), 64, 64, 16,
        [&](const RayBundle& rays)
        {
          RayBundle bundle = rays, wanted = rays;
          grid.cast(bundle, 0);
          alone.cast(wanted, 0);
          for (int i = 0; i < bundle.count; ++i)
          {
            ASSERT_EQ(bundle.object[i], wanted.object[i]);
            if (bundle.object[i] < 0)
              continue;
            ++hits;
            ASSERT_EQ(grid.inputIndex(bundle.slot[i]), indices[alone.inputIndex(wanted.slot[i])]);
          }
        });
    EXPECT_EQ(hits > 0, !indices.empty());
  }
};

} // namespace

template <typename Structure>
using StructureRanges = StructureTest<Structure>;
TYPED_TEST_SUITE(StructureRanges, ParticleStructures, StructureName);

TYPED_TEST(StructureRanges, EachOfTheEightValuesSelects)
{
  Attributed<TypeParam> a;
  const auto center = [&](std::size_t i) { return a.particles.center(i); };
  ParticleRanges ranges;
  a.expectOnly([](std::size_t) { return true; });
  for (int axis = 0; axis < 3; ++axis)
  {
    ranges = {};
    ranges.lower[axis] = -0.25;
    ranges.upper[axis] = 0.5;
    a.grid.setRanges(ranges);
    a.expectOnly([&](std::size_t i) { return center(i)[axis] >= -0.25 && center(i)[axis] <= 0.5; });
  }
  ranges = {};
  ranges.lower[3] = 0.05;
  a.grid.setRanges(ranges);
  a.expectOnly([&](std::size_t i) { return a.particles.radii[i] >= 0.05; });
  ranges = {};
  ranges.lower[4] = 0.25;
  ranges.upper[4] = 0.75;
  a.grid.setRanges(ranges);
  a.expectOnly([&](std::size_t i) { return a.smooth[i] >= 0.25f && a.smooth[i] <= 0.75f; });
  ranges.upper[5] = 0.1;
  a.grid.setRanges(ranges);
  a.expectOnly([&](std::size_t i)
    { return a.smooth[i] >= 0.25f && a.smooth[i] <= 0.75f && a.noise[i] <= 0.1; });
  a.grid.setRanges({});
  a.expectOnly([](std::size_t) { return true; });
}

TYPED_TEST(StructureRanges, SlotsBetweenHoldAllThatLieThereOnce)
{
  Attributed<TypeParam> a;
  const auto placeOf = [&](std::size_t slot, int k)
  { return k < 3 ? a.grid.center(slot)[k] : a.grid.radius(slot); };
  for (const bool isLimited : {false, true}) // which has structures look values over
  {
    ParticleRanges ranges;
    if (isLimited)
      ranges.lower[0] = 0.1;
    a.grid.setRanges(ranges);
    for (int k = 0; k < 4; ++k)
      for (const auto& [low, high] : {std::pair(-0.3, 0.2), std::pair(0.05, 0.06),
             std::pair(placeOf(70, k), placeOf(70, k)), std::pair(5.0, 6.0)})
      {
        std::vector<int> met(a.grid.size(), 0);
        for (const SlotRun& run : a.grid.slotsBetween(k, low, high))
        {
          EXPECT_GT(run.last, run.first);
          EXPECT_LE(run.last - run.first, SlotRun::longest);
          for (std::size_t slot = run.first; slot < run.last; ++slot)
            ++met.at(slot);
        }
        for (std::size_t slot = 0; slot < met.size(); ++slot)
        {
          const double place = placeOf(slot, k);
          ASSERT_LE(met[slot], 1) << k;
          ASSERT_GE(met[slot], place >= low && place <= high ? 1 : 0) << k;
        }
      }
  }
}

TYPED_TEST(StructureRanges, LimitsBelongToTheRangeAndFloatRoundsInwards)
{
  Attributed<TypeParam> a;
  ParticleRanges ranges;
  ranges.lower[4] = ranges.upper[4] = a.smooth[7];
  a.grid.setRanges(ranges);
  a.expectOnly([&](std::size_t i) { return a.smooth[i] == a.smooth[7]; });
  ranges.lower[4] = std::nextafter(double(a.smooth[7]), 10.0); // above it by less than float tells
  ranges.upper[4] = ParticleRanges::infinity;
  a.grid.setRanges(ranges);
  a.expectOnly([&](std::size_t i) { return a.smooth[i] > a.smooth[7]; });
}

TYPED_TEST(StructureRanges, NaNIsInTheUnlimitedRangeAlone)
{
  Attributed<TypeParam> a;
  for (std::size_t i = 0; i < a.noise.size(); i += 2)
    a.noise[i] = std::numeric_limits<float>::quiet_NaN();
  a.grid.setAttributes({{ArrayView(a.smooth.data(), a.smooth.size(), 1)},
    {ArrayView(a.noise.data(), a.noise.size(), 1)}});
  a.expectOnly([](std::size_t) { return true; });
  ParticleRanges ranges;
  ranges.lower[5] = -1.0;
  a.grid.setRanges(ranges);
  a.expectOnly([](std::size_t i) { return i % 2 == 1; });
}

TYPED_TEST(StructureRanges, CombineWithTheVisibilityInAnyOrder)
{
  Attributed<TypeParam> a;
  ParticleRanges ranges;
  ranges.lower[4] = 0.0;
  const auto third = [&](std::size_t slot) { return a.grid.inputIndex(slot) % 3 == 0; };
  const auto kept = [&](std::size_t i) { return i % 3 == 0 && a.smooth[i] >= 0.0f; };
  a.grid.setRanges(ranges);
  a.grid.setVisibility(third);
  a.expectOnly(kept);
  a.grid.setRanges({});
  a.grid.setVisibility({});
  a.grid.setVisibility(third);
  a.grid.setRanges(ranges);
  a.expectOnly(kept);
  ranges.lower[4] = 100.0; // nothing at all
  a.grid.setRanges(ranges);
  a.expectOnly([](std::size_t) { return false; });
}

TYPED_TEST(StructureRanges, RefusesWhatIsNoAttribute)
{
  Attributed<TypeParam> a;
  const ArrayView noise(a.noise.data(), a.noise.size(), 1);
  const ArrayView few(a.noise.data(), 5, 1);
  EXPECT_THROW(a.grid.setAttributes({{few}}), Error);
  EXPECT_THROW(a.grid.setAttributes({{noise, 1}}), Error);
  EXPECT_THROW(a.grid.setAttributes({{noise}, {noise}, {noise}, {noise}, {noise}}), Error);
  a.grid.setAttributes({});
  ParticleRanges ranges;
  ranges.lower[6] = 0.0;
  EXPECT_THROW(a.grid.setRanges(ranges), Error);
}

TYPED_TEST(StructureRanges, AttributesTakeMemoryOnlyWhereTheyAreKept)
{
  Attributed<TypeParam> a;
  const std::size_t with = a.grid.bytes();
  a.grid.setAttributes({});
  EXPECT_GE(with - a.grid.bytes(), 16 * a.particles.size());
}
