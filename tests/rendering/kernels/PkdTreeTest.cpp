// What is the P-k-d tree's own: its shape, its numbers, its memory.

#include <kernels/core/Error.h>
#include <kernels/particles/PkdTree.h>
#include <kernels/particles/detail/MedianSplit.h>

#include <support/CastOracle.h>
#include <support/Particles.h>
#include <support/Structure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

using Form = PkdTreeOptions::Form;

template <int WORDS>
std::vector<KdRecord<WORDS>> randomRecords(
  std::size_t count, std::uint32_t values, std::uint64_t seed)
{
  Random random(seed);
  std::vector<KdRecord<WORDS>> records(count);
  for (auto& record : records)
    for (auto& word : record.words)
      word = static_cast<std::uint32_t>(random(0.0, double(values)));
  return records;
}

void expectRight(const Particles& particles, const PkdTreeOptions& options = {})
{
  expectRightViews<PkdTree>(particles, options);
}

/// Every particle is where the input says, within the error that the tree tells.
void expectPlaces(const PkdTree& tree, const Particles& particles)
{
  ASSERT_EQ(tree.size(), particles.size());
  for (std::size_t slot = 0; slot < tree.size(); ++slot)
  {
    const std::size_t i = tree.inputIndex(slot);
    const Vec3d error = glm::abs(tree.center(slot) - particles.center(i));
    ASSERT_LE(std::max({error.x, error.y, error.z}), tree.positionError() + 1e-15) << slot;
    ASSERT_NEAR(tree.radius(slot), particles.radii[i], 1e-7 * particles.radii[i]);
  }
}

} // namespace

TEST(MedianSplit, PartsAnyRangeAsSortingWould)
{
  for (const std::size_t count : {2u, 3u, 33u, 700u, 5000u, 600000u})
    for (const std::uint32_t values : {1u, 2u, 50u, 4000000000u})
    {
      auto records = randomRecords<4>(count, values, count + values);
      auto sorted = records;
      const int axis = static_cast<int>(count % 3);
      std::sort(sorted.begin(), sorted.end(), KdLess{axis});
      const std::size_t middle = count / 2;
      MedianSplit<4>::run(records.data(), records.data() + middle, records.data() + count, axis, 0,
        values == 1 ? 0 : values - 1);
      // Who splits the upper part next takes its first record for the least.
      ASSERT_EQ(records[middle].words, sorted[middle].words) << count << ", " << values;
      std::sort(
        records.begin(), records.begin() + static_cast<std::ptrdiff_t>(middle), KdLess{axis});
      std::sort(records.begin() + static_cast<std::ptrdiff_t>(middle), records.end(), KdLess{axis});
      for (std::size_t i = 0; i < count; ++i)
        ASSERT_EQ(records[i].words, sorted[i].words) << i << " of " << count;
    }
}

TEST(MedianSplit, PutsTheLeastOfTheUpperPartFirst)
{
  // The upper half begins where a bin of the histogram does.
  auto records = randomRecords<3>(1000, 1000, 21);
  for (std::size_t i = 0; i < 500; ++i)
    records[2 * i].words[0] += 1u << 31;
  MedianSplit<3>::run(
    records.data(), records.data() + 500, records.data() + 1000, 0, 0, (1u << 31) + 999);
  for (std::size_t i = 0; i < 1000; ++i)
    ASSERT_EQ(records[i].words[0] >= records[500].words[0], i >= 500) << i;
}

TEST(PkdTree, AnyNumberOfParticles)
{
  for (const std::size_t count : {1u, 2u, 3u, 15u, 16u, 17u, 31u, 32u, 33u, 255u, 256u, 257u, 4095u,
         4096u, 4097u, 65535u, 65536u, 65537u})
    expectRight(randomParticles(count, count, 0.02, 0.08));
}

TEST(PkdTree, EitherRuleOfSplitting)
{
  PkdTreeOptions options;
  options.split = PkdTreeOptions::Split::RoundRobin;
  expectRight(randomParticles(5000, 11, 0.01, 0.05), options);
  Particles flat = randomParticles(5000, 12, 0.01, 0.05);
  for (std::size_t i = 0; i < flat.size(); ++i)
    flat.positions[3 * i + 1] = 0.0;
  expectRight(flat, options);
}

TEST(PkdTree, DuplicatesByTheThousand)
{
  Particles particles = randomParticles(200, 13, 0.02, 0.06);
  for (int copy = 0; copy < 20; ++copy)
    for (std::size_t i = 0; i < 100; ++i)
      particles.add(particles.center(i), particles.radii[i]);
  for (int copy = 0; copy < 3000; ++copy)
    particles.add({0.5, 0.5, 0.5}, 0.1);
  expectRight(particles);
}

TEST(PkdTree, TakesLittleMoreThanTheCoordinates)
{
  Particles particles = randomParticles(200000, 14, 0.002, 0.002);
  ParticleSet set = particles.set();
  set.radii = {};
  set.radius = 0.002;
  PkdTreeOptions options;
  options.keepIndices = false;
  PkdTree tree;
  tree.build(set, options);
  EXPECT_LT(double(tree.bytes()) / 200000.0, 12.6);
  EXPECT_EQ(tree.inputIndex(4321), 4321u); // the slot stands in
  options.keepIndices = true;
  tree.build(set, options);
  EXPECT_LT(double(tree.bytes()) / 200000.0, 16.6);
  tree.build(particles.set(), options); // radii of their own that are all the same
  EXPECT_LT(double(tree.bytes()) / 200000.0, 16.6);
}

TEST(PkdTree, CoordinatesAreAtLeastAsFineAsFloat)
{
  const Particles particles = randomParticles(100000, 15, 0.002, 0.004);
  PkdTree tree;
  tree.build(particles.set());
  EXPECT_LE(tree.step(), 2.0 * 0x1p-24);
  double largest = 0.0;
  for (std::size_t slot = 0; slot < tree.size(); ++slot)
  {
    const Vec3d error = glm::abs(tree.center(slot) - particles.center(tree.inputIndex(slot)));
    largest = std::max({largest, error.x, error.y, error.z});
  }
  EXPECT_LE(largest, tree.positionError());
  EXPECT_LE(largest, 0.6 * 0x1p-25); // float would be wrong by up to 2^-25 here
}

TEST(PkdTree, ShortFormsTakeTheirBytesAndMoveNoParticleFarther)
{
  for (const Form form : {Form::Exact, Form::Bytes8, Form::Bytes4})
    for (const bool mixed : {false, true})
      for (const bool indices : {false, true})
      {
        const Particles particles = randomParticles(50003, 19, 0.03, mixed ? 0.06 : 0.03);
        PkdTreeOptions options;
        options.form = form;
        options.keepIndices = indices;
        PkdTree tree;
        tree.build(particles.set(), options);
        ASSERT_EQ(tree.form(), form);
        const double bytes = form == Form::Exact ? 12.0 : form == Form::Bytes8 ? 8.0 : 4.0;
        EXPECT_LT(double(tree.bytes()) / 50003.0,
          bytes + 0.6 + (mixed ? 4.0 : 0.0) + (indices ? 4.0 : 0.0));
        EXPECT_LT(tree.positionError(), form == Form::Exact    ? 1e-7
                                        : form == Form::Bytes8 ? 1e-6
                                                               : 3e-4);
        EXPECT_GT(tree.positionError(), 0.49 * tree.step());
        EXPECT_LE(tree.positionError(), tree.step());
        if (indices)
          expectPlaces(tree, particles);
      }
}

TEST(PkdTree, ShortFormsAreCastAsWhatTheyStore)
{
  // Mixed radii, and a dense cluster in a sparse set: there steps are longer than what bounds tell.
  Random random(31);
  std::vector<Particles> sets = {randomParticles(20000, 32, 0.01, 0.02), {}, {}};
  for (int i = 0; i < 5000; ++i)
  {
    const Vec3d p = random.inBox(Vec3d(-1.0), Vec3d(1.0));
    sets[1].add(p, std::pow(10.0, random(-4.0, -0.7)));
    sets[2].add(i % 2 == 0 ? p : 1e-3 * p, 0.02);
  }
  for (Particles& particles : sets)
    for (const Form form : {Form::Bytes8, Form::Bytes4})
    {
      for (std::size_t i = 0; i < 100; ++i) // some coincide
        particles.add(particles.center(17 * i), particles.radii[17 * i]);
      PkdTreeOptions options;
      options.form = form;
      options.mostError = 1e3;
      PkdTree tree;
      tree.build(particles.set(), options);
      expectPlaces(tree, particles);
      Particles stored = particles;
      for (std::size_t slot = 0; slot < tree.size(); ++slot)
        for (int k = 0; k < 3; ++k)
          stored.positions[3 * tree.inputIndex(slot) + static_cast<std::size_t>(k)] =
            tree.center(slot)[k];
      for (std::size_t i = 0; i < 100; ++i)
        EXPECT_EQ(stored.center(stored.size() - 100 + i), stored.center(17 * i));
      const CastOracle oracle = CastOracle::forFloat(stored.set());
      CastReport report;
      for (int k = 0; k < 4; ++k)
        report.add(checkImage(
          tree, oracle, lookAt(random(0.5, 4.0) * random.direction(), Vec3d(0.0), 50.0), 48, 48));
      for (int k = 0; k < 20; ++k)
      {
        RayPacket packet = emptyPacket();
        for (int i = 0; i < RayPacket::capacity; ++i)
          addRay(packet, random.inBox(Vec3d(-1.5), Vec3d(1.5)), random.direction());
        RayPacket any = packet;
        report.add(checkPacket(tree, oracle, packet));
        tree.cast(packet, 3);
        tree.occlude(any, 3);
        for (int i = 0; i < packet.count; ++i)
          EXPECT_EQ(any.t[i] < 0.0, packet.object[i] == 3);
      }
      EXPECT_EQ(report.wrong, 0u) << report.complaint;
      EXPECT_GT(report.hits, 1000u);
    }
}

TEST(PkdTree, ShortFormsOfFewParticles)
{
  for (const Form form : {Form::Bytes8, Form::Bytes4})
    for (const std::size_t count : {1u, 2u, 15u, 16u, 17u, 255u, 256u, 257u, 4097u})
    {
      PkdTreeOptions options;
      options.form = form;
      PkdTree tree;
      const Particles particles = randomParticles(count, count, 0.3, 0.3);
      tree.build(particles.set(), options);
      expectPlaces(tree, particles);
    }
}

TEST(PkdTree, AFormThatMovesParticlesTooFarIsRefused)
{
  const Particles particles = randomParticles(5000, 33, 0.002, 0.004);
  PkdTreeOptions options;
  options.form = Form::Bytes8;
  PkdTree tree;
  tree.build(particles.set(), options);
  EXPECT_EQ(tree.size(), 5000u);
  options.form = Form::Bytes4;
  try
  {
    tree.build(particles.set(), options);
    FAIL() << "not refused, and off by " << tree.positionError();
  }
  catch (const Error& error)
  {
    const std::string text = error.what();
    EXPECT_EQ(text.find("The form 4-byte of a P-k-d tree would move particles by up to 0.000"), 0u)
      << text;
    EXPECT_NE(text.find("more than 5 % of the smallest radius, 0.002."), std::string::npos) << text;
  }
  EXPECT_EQ(tree.size(), 0u);
  options.mostError = 0.5;
  tree.build(particles.set(), options);
  EXPECT_EQ(tree.size(), 5000u);
  EXPECT_GT(tree.positionError(), 0.05 * tree.statistics().smallestRadius);
  expectPlaces(tree, particles);
}

TEST(PkdTree, PlacesBehindTheLastParticleHoldNoSphere)
{
  // Equal particles whose radius is large beside the places that the numbers there would mean.
  for (const Form form : {Form::Exact, Form::Bytes8, Form::Bytes4})
    for (std::size_t count = 1; count <= 40; ++count)
    {
      Particles particles;
      for (std::size_t i = 0; i < count; ++i)
        particles.add({0.5 + 0.01 * double(i), 0.5, 0.5}, 0.5);
      PkdTreeOptions options;
      options.form = form;
      PkdTree tree;
      tree.build(particles.set(), options);
      const CastOracle oracle(particles.set(), 2.0 * tree.step() + 1e-6);
      const CameraRays rays(lookAt({2.0, 1.5, 2.5}, Vec3d(0.5), 60.0), 16, 16);
      RayBundle bundle;
      rays.fillBundle(bundle, 16, 0, 0, 0.0, 0.0);
      const CastReport report = checkBundle(tree, oracle, bundle);
      EXPECT_EQ(report.wrong, 0u) << report.complaint;
      EXPECT_GT(report.hits, 10u);
      tree.cast(bundle, 0);
      for (int i = 0; i < bundle.count; ++i)
        EXPECT_TRUE(bundle.object[i] < 0 || bundle.slot[i] < count);
    }
}

TEST(PkdTree, GiantsAmongDwarfs)
{
  Random random(16);
  Particles particles;
  for (int i = 0; i < 20000; ++i)
    particles.add(random.inBox(Vec3d(-1.0), Vec3d(1.0)), std::pow(10.0, random(-5.0, -1.0)));
  expectRight(particles);
}

TEST(PkdTree, OcclusionFromTheParticleThatTheRayLeaves)
{
  // What is asked from the particle upwards is what is asked from the top.
  const Particles particles = randomParticles(20000, 17, 0.005, 0.03);
  PkdTree tree;
  tree.build(particles.set());
  Random random(18);
  int occluded = 0, rays = 0;
  for (int k = 0; k < 200; ++k)
  {
    RayPacket packet = emptyPacket();
    for (int i = 0; i < RayPacket::capacity; ++i)
    {
      const auto slot = static_cast<std::size_t>(random(0.0, double(tree.size())));
      const Vec3d normal = random.direction();
      addRay(packet, tree.center(slot) + 1.0001 * tree.radius(slot) * normal,
        normal + random.direction(), 0.0, random(0.05, 0.5));
      packet.slot[i] = slot;
      packet.object[i] = 2;
    }
    RayPacket stranger = packet;
    std::fill_n(stranger.object, packet.count, 1);
    tree.occlude(packet, 2);
    tree.occlude(stranger, 2);
    for (int i = 0; i < packet.count; ++i, ++rays)
    {
      ASSERT_EQ(packet.t[i], stranger.t[i]);
      occluded += packet.t[i] < 0.0;
    }
  }
  EXPECT_GT(occluded, rays / 10);
  EXPECT_LT(occluded, rays);
}
