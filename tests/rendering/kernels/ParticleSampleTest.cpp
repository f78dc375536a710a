// The part of a large set that a preview draws.

#include <kernels/core/Error.h>
#include <kernels/particles/ParticleSample.h>

#include <support/Particles.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

using namespace mote;
using namespace mote::testing;

namespace
{

/// A cube of n^3 particles, x fastest, as simulations write them.
Particles cube(int n)
{
  Particles particles;
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        particles.add(Vec3d(x, y, z) / double(n), 0.5 / n);
  return particles;
}

/// How many particles of the sample lie in each of k^3 boxes of the unit cube.
std::map<std::array<int, 3>, int> countsIn(const ParticleSample& sample, int k)
{
  std::map<std::array<int, 3>, int> counts;
  for (std::size_t i = 0; i < sample.size(); ++i)
  {
    const Vec3d p = sample.set().position(i) * double(k);
    ++counts[{int(p.x), int(p.y), int(p.z)}];
  }
  return counts;
}

void expectEven(const ParticleSample& sample, int k, double spread)
{
  const auto counts = countsIn(sample, k);
  EXPECT_EQ(counts.size(), static_cast<std::size_t>(k) * k * k) << "boxes stay empty";
  const double mean = double(sample.size()) / (k * k * k);
  double squares = 0.0;
  for (const auto& [box, count] : counts)
    squares += (count - mean) * (count - mean);
  // Drawn by lot, counts would scatter by the root of their mean.
  EXPECT_LT(std::sqrt(squares / double(counts.size())), spread * std::sqrt(mean));
}

} // namespace

TEST(ParticleSample, TakesOneOfEachStretchOfTheInput)
{
  const Particles particles = randomParticles(1003, 1, 0.1, 0.2);
  for (const std::size_t wanted : {1, 7, 100, 1002, 1003})
  {
    const ParticleSample sample(particles.set(), wanted);
    ASSERT_EQ(sample.size(), wanted);
    EXPECT_EQ(sample.inputs(), 1003u);
    for (std::size_t k = 0; k < wanted; ++k)
    {
      const double at = double(sample.indices()[k]) * double(wanted) / 1003.0;
      EXPECT_GT(at, double(k) - 1.0) << wanted;
      EXPECT_LT(at, double(k) + 2.0) << wanted;
      if (k > 0)
      {
        EXPECT_GT(sample.indices()[k], sample.indices()[k - 1]);
      }
    }
    EXPECT_LT(sample.indices().back(), 1003u);
  }
}

TEST(ParticleSample, IsEvenInSpaceWhereTheInputIsSorted)
{
  // 64^3 of which one in 64: a plain stride would take a column of the lattice, or a plane.
  const Particles sorted = cube(64);
  expectEven(ParticleSample(sorted.set(), 4096), 4, 1.1);
  expectEven(ParticleSample(sorted.set(), 4096), 8, 1.1);
  // z is slowest: layers of it are taken alike, to one particle.
  std::map<int, int> layers;
  const ParticleSample sample(sorted.set(), 4096);
  for (std::size_t i = 0; i < sample.size(); ++i)
    ++layers[int(std::lround(sample.set().position(i).z * 64))];
  for (const auto& [z, count] : layers)
    EXPECT_EQ(count, 64) << z;
  EXPECT_EQ(layers.size(), 64u);
}

TEST(ParticleSample, IsEvenInSpaceWhereTheInputIsNot)
{
  const Particles particles = randomParticles(300000, 2, 0.01, 0.01, Vec3d(0.0), Vec3d(1.0));
  expectEven(ParticleSample(particles.set(), 5000), 6, 1.1);
}

TEST(ParticleSample, EnlargesRadiiByTheCubeRoot)
{
  const Particles particles = randomParticles(8000, 3, 0.1, 0.2);
  ParticleSet set = particles.set();
  set.radiusScale = 0.5;
  const ParticleSample sample(set, 1000);
  EXPECT_DOUBLE_EQ(sample.enlargement(), 2.0);
  for (std::size_t k = 0; k < sample.size(); ++k)
  {
    EXPECT_DOUBLE_EQ(sample.set().radiusOf(k), 2.0 * set.radiusOf(sample.indices()[k]));
    EXPECT_EQ(sample.set().position(k), set.position(sample.indices()[k]));
  }
  set.radii = ArrayView();
  set.radius = 3.0;
  EXPECT_DOUBLE_EQ(ParticleSample(set, 1000).set().radiusOf(7), 3.0);
}

TEST(ParticleSample, OfFewIsAllOfThem)
{
  const Particles particles = randomParticles(50, 4, 0.1, 0.2);
  const ParticleSample sample(particles.set(), 1000);
  ASSERT_EQ(sample.size(), 50u);
  EXPECT_EQ(sample.enlargement(), 1.0);
  for (std::size_t k = 0; k < 50; ++k)
    EXPECT_EQ(sample.indices()[k], k);
  EXPECT_EQ(ParticleSample(ParticleSet{}, 10).size(), 0u);
  EXPECT_EQ(ParticleSample(particles.set(), 0).size(), 0u);
}

TEST(ParticleSample, RefusesMalformedSets)
{
  const double numbers[] = {0.0, 1.0, 2.0, 3.0};
  ParticleSet set;
  set.positions = ArrayView(numbers, 2, 2);
  EXPECT_THROW(ParticleSample(set, 1), Error);
  const Particles particles = randomParticles(50, 5, 0.1, 0.2);
  set = particles.set();
  set.radii = ArrayView(numbers, 4, 1);
  EXPECT_THROW(ParticleSample(set, 1), Error);
}

TEST(ParticleSample, GridSpeaksOfTheInput)
{
  Particles particles = randomParticles(5000, 6, 0.01, 0.02);
  particles.positions[3 * 17] = std::numeric_limits<double>::quiet_NaN();
  const ParticleSample sample(particles.set(), 600);
  CoherentGrid grid;
  grid.build(sample.set(), sample.gridOptions());
  std::vector<std::uint64_t> found;
  for (std::size_t slot = 0; slot < grid.size(); ++slot)
  {
    const std::uint64_t i = grid.inputIndex(slot);
    found.push_back(i);
    EXPECT_LT(glm::length(grid.center(slot) - particles.center(i)), 1e-6);
    EXPECT_NEAR(grid.radius(slot), sample.enlargement() * particles.radii[i], 1e-6);
  }
  std::sort(found.begin(), found.end());
  std::vector<std::uint64_t> wanted = sample.indices();
  std::erase(wanted, 17u);
  EXPECT_EQ(found, wanted);

  // Attributes are the input's, one value for each of its particles.
  std::vector<float> values(5000);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = float(i);
  grid.setAttributes({{ArrayView(values.data(), values.size(), 1), 0}});
  EXPECT_THROW(grid.setAttributes({{ArrayView(values.data(), sample.size(), 1), 0}}), Error);
}
