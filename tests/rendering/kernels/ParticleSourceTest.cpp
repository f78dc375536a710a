// Particles that are worked out when they are looked at: the same as those in memory.

#include <kernels/core/Error.h>
#include <kernels/particles/GeneratedParticles.h>
#include <kernels/particles/PkdTree.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace mote;

namespace
{

/// The source's particles, and a view of them.
struct Copied
{
  std::vector<Vec3d> positions;
  std::vector<double> radii;
  ParticleSet set;

  explicit Copied(const ParticleSource& source)
    : positions(source.count())
    , radii(source.count())
  {
    source.positions(0, positions.size(), positions.data());
    source.radii(0, radii.size(), radii.data());
    set.positions = ArrayView(&positions[0].x, positions.size(), 3);
    set.radii = ArrayView(radii.data(), radii.size(), 1);
    set.radiusScale = source.radius();
  }
};

void expectSameTree(const ParticleSet& a, const ParticleSet& b)
{
  PkdTree first, second;
  first.build(a);
  second.build(b);
  ASSERT_EQ(first.size(), second.size());
  EXPECT_EQ(first.bytes(), second.bytes());
  for (std::size_t slot = 0; slot < first.size(); ++slot)
  {
    ASSERT_EQ(first.center(slot), second.center(slot));
    ASSERT_EQ(first.radius(slot), second.radius(slot));
    ASSERT_EQ(first.inputIndex(slot), second.inputIndex(slot));
  }
}

std::string sentenceAbout(const std::string& specification)
{
  try
  {
    makeParticles(specification);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "";
}

} // namespace

TEST(ParticleSource, GivesTheSameInPieces)
{
  for (const char* specification : {"lattice:5832", "random:5000:0.01", "varied:5000"})
  {
    const auto source = makeParticles(specification);
    const Copied all(*source);
    for (const std::size_t piece : {1, 7, 1000})
      for (std::size_t first = 0; first < source->count(); first += 997)
      {
        const std::size_t last = std::min(source->count(), first + piece);
        std::vector<Vec3d> positions(last - first);
        std::vector<double> radii(last - first);
        source->positions(first, last, positions.data());
        source->radii(first, last, radii.data());
        for (std::size_t i = first; i < last; ++i)
        {
          ASSERT_EQ(positions[i - first], all.positions[i]);
          ASSERT_EQ(radii[i - first], all.radii[i]);
        }
      }
  }
}

TEST(ParticleSource, BuildsWhatArraysBuild)
{
  for (const char* specification : {"lattice:27000", "random:30000:0.01", "varied:30000"})
  {
    const auto source = makeParticles(specification);
    const ParticleSet set = ParticleSet::of(source);
    const Copied copied(*source);
    const ParticleStatistics a = examine(set), b = examine(copied.set);
    EXPECT_EQ(a.valid, b.valid);
    EXPECT_EQ(a.bounds.lower, b.bounds.lower);
    EXPECT_EQ(a.smallestRadius, b.smallestRadius);
    EXPECT_EQ(a.largestRadius, b.largestRadius);
    EXPECT_EQ(estimateSpacing(set), estimateSpacing(copied.set));
    for (const std::size_t i : {0, 1, 12345, 26999})
    {
      EXPECT_EQ(set.position(i), copied.set.position(i));
      EXPECT_EQ(set.radiusOf(i), copied.set.radiusOf(i));
    }
    expectSameTree(set, copied.set);
  }
}

TEST(ParticleSource, TakesOtherRadiiThanItsOwn)
{
  const auto source = makeParticles("varied:1000");
  ParticleSet set;
  set.source = source;
  set.radius = 0.25;
  EXPECT_EQ(examine(set).smallestRadius, 0.25);
  const std::vector<float> radii(1000, 0.5f);
  set.radii = ArrayView(radii.data(), radii.size(), 1);
  EXPECT_EQ(examine(set).largestRadius, 0.5);
  set.radii = ArrayView(radii.data(), 999, 1);
  EXPECT_THROW(examine(set), Error);
}

TEST(GeneratedParticles, AreThoseOfEveryVersion)
{
  // The first numbers that splitmix64 gives for the seed 0.
  const std::uint64_t known[] = {0xe220a8397b1dcdafu, 0x6e789e6aa1b965f4u, 0x06c45d188009454fu};
  for (std::uint64_t k = 0; k < 3; ++k)
    EXPECT_EQ(uniformNumber(0, k), static_cast<double>(known[k] >> 11) * 0x1p-53);
}

TEST(GeneratedParticles, LieWhereTheyShould)
{
  const auto lattice = makeParticles("lattice:1000");
  ASSERT_EQ(lattice->count(), 1000u);
  EXPECT_EQ(lattice->radius(), 0.05);
  const Copied particles(*lattice);
  for (std::size_t i = 0; i < 1000; ++i)
  {
    const Vec3d place(double(i % 10) + 0.5, double(i / 10 % 10) + 0.5, double(i / 100) + 0.5);
    for (int k = 0; k < 3; ++k)
      ASSERT_NEAR(10.0 * particles.positions[i][k], place[k], 0.2000001);
  }
  EXPECT_EQ(makeParticles("lattice:999")->count(), 1000u);
  EXPECT_EQ(makeParticles("lattice:850")->count(), 729u);
  EXPECT_EQ(makeParticles("lattice:1000000000")->count(), 1000000000u);
  EXPECT_EQ(makeParticles("random:5:0.5")->radius(), 0.5);
  EXPECT_GT(glm::distance(Copied(*makeParticles("random:2:1")).positions[0],
              Copied(*makeParticles("random:2:1")).positions[1]),
    0.0);
}

TEST(GeneratedParticles, VariedCoverAsMuchAsEqualOnes)
{
  const Copied varied(*makeParticles("varied:20000"));
  double covered = 0.0;
  for (std::size_t i = 0; i < varied.radii.size(); ++i)
    covered += std::pow(varied.set.radiusOf(i), 2);
  EXPECT_NEAR(covered / (20000 * std::pow(equalRadius(20000), 2)), 1.0, 1e-12);
}

TEST(GeneratedParticles, WrongSpecificationsGetASentence)
{
  EXPECT_EQ(sentenceAbout("lattice:1000"), "");
  EXPECT_EQ(sentenceAbout("lattice:x"), "lattice:x: \"x\" is not a number above zero");
  for (const char* wrong : {"lattice:0", "lattice:-8", "lattice:", "lattice:1e3", "lattice:8:8",
         "random:10", "random:10:0", "random:10:nan", "random:10:inf", "random:10:0.1x",
         "varied:", "cube:8", "lattice", "lattice:99999999999999999999", "lattice:99999999999999"})
    EXPECT_NE(sentenceAbout(wrong), "") << wrong;
  EXPECT_TRUE(namesGeneratedParticles("lattice:nonsense"));
  EXPECT_FALSE(namesGeneratedParticles("lattice"));
  EXPECT_FALSE(namesGeneratedParticles("data/random:1"));
}
