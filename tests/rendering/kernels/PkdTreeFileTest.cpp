// A tree in a file is the tree that was written: its particles, its arrays, its pictures.

#include "PkdTreeFileParts.h"

#include <kernels/core/AtomicFile.h>
#include <kernels/core/Camera.h>
#include <kernels/scene/ColorMeans.h>
#include <kernels/scene/Surface.h>

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstring>

#include <sys/resource.h>

using namespace mote;
using namespace mote::testing;

namespace
{

/// Rays from outside and inside, in bundles; what they hit as indices of the input.
void expectSameAnswers(const PkdTree& before, const PkdTreeFile& file)
{
  const PkdTree after = file.tree();
  const ArrayView& index = arrayOf(file, "index").values;
  Random random(4);
  std::size_t hits = 0;
  for (int k = 0; k < 400; ++k)
  {
    RayPacket packet = emptyPacket();
    const bool inside = k % 2 == 0;
    for (int i = 0; i < RayPacket::capacity; ++i)
      addRay(packet, (inside ? random(0.0, 0.9) : 3.0) * random.direction(), random.direction(),
        0.0, 100.0);
    RayPacket other = packet;
    before.cast(packet, 1);
    after.cast(other, 1);
    for (int i = 0; i < packet.count; ++i)
    {
      ASSERT_EQ(packet.t[i], other.t[i]);
      ASSERT_EQ(packet.slot[i] == RayPacket::noHit, other.slot[i] == RayPacket::noHit);
      if (packet.slot[i] == RayPacket::noHit)
        continue;
      ++hits;
      ASSERT_EQ(
        before.inputIndex(packet.slot[i]), static_cast<std::uint64_t>(index.value(other.slot[i])));
      ASSERT_EQ(after.inputIndex(other.slot[i]), other.slot[i]);
    }
  }
  EXPECT_GT(hits, 1000u);
}

long pageFaults()
{
  rusage usage;
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt + usage.ru_majflt;
}

} // namespace

TEST(PkdTreeFile, HoldsTheTreeAndItsArrays)
{
  const Folder folder;
  const Example example(20000);
  ASSERT_TRUE(writePkdTreeFile(folder.file(), example.tree, example.contents()));
  const PkdTreeFile file(folder.file());
  const PkdTree &a = example.tree, b = file.tree();
  ASSERT_EQ(b.size(), a.size());
  EXPECT_EQ(b.levels(), a.levels());
  EXPECT_EQ(b.origin(), a.origin());
  EXPECT_EQ(b.unit(), a.unit());
  EXPECT_EQ(b.step(), a.step());
  EXPECT_EQ(b.statistics().bounds.lower, a.statistics().bounds.lower);
  EXPECT_EQ(b.statistics().bounds.upper, a.statistics().bounds.upper);
  EXPECT_EQ(b.statistics().centers.upper, a.statistics().centers.upper);
  EXPECT_EQ(b.statistics().largestRadius, a.statistics().largestRadius);
  EXPECT_EQ(file.time(), 12.5);
  EXPECT_EQ(file.spacing(), 0.25);
  EXPECT_EQ(file.bytes(), std::filesystem::file_size(folder.file()));
  EXPECT_LT(double(b.bytes()) / double(b.size()), 16.7); // no indices

  std::vector<std::size_t> slotOf(a.size());
  for (std::size_t slot = 0; slot < a.size(); ++slot)
    slotOf[a.inputIndex(slot)] = slot;
  const ArrayView energy = arrayOf(file, "energy").values, v = arrayOf(file, "v").values,
                  kind = arrayOf(file, "kind").values, index = arrayOf(file, "index").values;
  EXPECT_EQ(index.type(), ArrayView::Type::UInt32);
  ASSERT_EQ(v.components(), 3);
  for (std::size_t slot = 0; slot < b.size(); ++slot)
  {
    const auto i = static_cast<std::size_t>(index.value(slot));
    ASSERT_LT(i, a.size());
    ASSERT_EQ(b.center(slot), a.center(slotOf[i]));
    ASSERT_EQ(b.radius(slot), a.radius(slotOf[i]));
    ASSERT_EQ(energy.value(slot), example.energy[i]);
    ASSERT_EQ(kind.value(slot), example.kind[i]);
    for (int k = 0; k < 3; ++k)
      ASSERT_EQ(v.value(slot, k), example.velocity[3 * i + static_cast<std::size_t>(k)]);
  }
  EXPECT_EQ(arrayOf(file, "v").components, (std::vector<std::string>{"vx", "vy", "vz"}));
  ASSERT_EQ(file.facts().size(), 1u);
  EXPECT_EQ(file.facts()[0].values.value(1, 1), 2.0);
}

TEST(PkdTreeFile, GivesTheSameAnswers)
{
  const Folder folder;
  for (const bool ownRadii : {true, false})
  {
    const Example example(20000, 0.02, ownRadii ? 0.05 : 0.02);
    ASSERT_TRUE(writePkdTreeFile(folder.file(), example.tree, example.contents()));
    expectSameAnswers(example.tree, PkdTreeFile(folder.file()));
  }
}

namespace
{

/// Rays that may err hit the same in the file, and boxes stand for the same.
void expectSameLods(const PkdTree& before, const PkdTree& after)
{
  ASSERT_TRUE(after.hasLods());
  const std::vector<std::uint64_t> slots = before.lodSlots();
  EXPECT_EQ(slots, after.lodSlots());
  for (const std::uint64_t slot : slots)
  {
    ASSERT_EQ(before.lod(slot).coverage, after.lod(slot).coverage);
    ASSERT_EQ(before.lod(slot).error, after.lod(slot).error);
    ASSERT_EQ(before.lod(slot).half, after.lod(slot).half);
  }
  std::size_t onBoxes = 0;
  for (int k = 0; k < 20; ++k)
  {
    Random random(static_cast<std::uint64_t>(k));
    const CameraRays rays(lookAt(9.0 * random.direction(), Vec3d(0.0), 20.0), 32, 32);
    RayBundle a, b;
    rays.fillBundle(a, 16, 16 * (k % 2), 16, 0.0, 0.0);
    b = a;
    before.cast(a, 1, 8.0);
    after.cast(b, 1, 8.0);
    for (int i = 0; i < a.count; ++i)
    {
      ASSERT_EQ(a.t[i], b.t[i]);
      const bool hit = a.slot[i] != RayBundle::noHit, isLod = hit && PkdTree::isLod(a.slot[i]);
      ASSERT_EQ(hit && PkdTree::isLod(b.slot[i]), isLod);
      onBoxes += isLod;
    }
  }
  EXPECT_GT(onBoxes, 500u);
}

/// The means that a file holds of an array are those that are made of its particles.
void expectSameMeans(const PkdTree& tree, const ArrayView& values)
{
  for (int c = ArrayView::magnitude; c < values.components(); ++c)
  {
    const ArrayView stored = tree.storedMeans(values, c);
    if (values.components() == 1 && c == ArrayView::magnitude)
    {
      EXPECT_TRUE(stored.empty()); // would be that of absolute values
      continue;
    }
    const std::vector<float> made = tree.lodMeans(
      1, [&](std::uint64_t particle, double* value) { *value = values.value(particle, c); });
    ASSERT_EQ(stored.count(), made.size());
    for (std::size_t k = 0; k < made.size(); ++k)
      ASSERT_TRUE(
        stored.value(k) == double(made[k]) || (std::isnan(stored.value(k)) && std::isnan(made[k])))
        << "component " << c << ", place " << k;
  }
}

} // namespace

TEST(PkdTreeFile, HoldsLevelsOfDetailAndMeans)
{
  const Folder folder;
  for (const std::size_t count : {20000u, 6000u})
  {
    Example example(count, 0.02, count == 6000 ? 0.02 : 0.05);
    example.tree.makeLods();
    PkdTreeFileContents contents = example.contents();
    // A tensor has more numbers than are summed at once; 8-bit colours are used as they are.
    std::vector<double> stress(7 * example.particles.size());
    std::vector<std::uint8_t> colors(3 * example.particles.size(), 9);
    for (std::size_t k = 0; k < stress.size(); ++k)
      stress[k] = k % 50 == 0 ? std::nan("") : std::sin(double(k));
    contents.arrays.push_back(
      {"stress", ArrayView(stress.data(), example.particles.size(), 7), {}});
    contents.arrays.push_back({"colors",
      ArrayView(colors.data(), ArrayView::Type::UInt8, example.particles.size(), 3), {}});
    ASSERT_TRUE(writePkdTreeFile(folder.file(), example.tree, contents));
    {
      const PkdTreeFile file(folder.file());
      const PkdTree tree = file.tree();
      expectSameLods(example.tree, tree);
      for (const char* name : {"energy", "v", "kind", "stress"})
        expectSameMeans(tree, arrayOf(file, name).values);
      EXPECT_TRUE(tree.storedMeans(arrayOf(file, "index").values, 0).empty());
      EXPECT_TRUE(tree.storedMeans(arrayOf(file, "colors").values, 0).empty());
      EXPECT_TRUE(tree.storedMeans(contents.arrays[0].values, 0).empty()); // not the file's
      SurfaceColoring coloring;
      coloring.values = arrayOf(file, "v").values;
      coloring.component = 1;
      EXPECT_EQ(meansOf(tree, coloring).view(), tree.storedMeans(coloring.values, 1));
      coloring.values = contents.arrays[1].values; // the same numbers, but somewhere else
      EXPECT_EQ(meansOf(tree, coloring).numbers.size(),
        tree.storedMeans(arrayOf(file, "v").values, 1).count());
      // Also where the arrays are put in order a little at a time.
      contents.workBytes = 3000;
      ASSERT_TRUE(writePkdTreeFile(folder.file("little"), example.tree, contents));
      EXPECT_TRUE(readBytes(folder.file("little")) == readBytes(folder.file()));
    }
    // The tree may be built anew, and knows nothing of the file then.
    PkdTree other = PkdTreeFile(folder.file()).tree();
    other.build(example.particles.set());
    EXPECT_FALSE(other.hasLods());
    EXPECT_EQ(PkdTree(other).bytes(), other.bytes());
  }
}

TEST(PkdTreeFile, FilesWithoutLevelsOfDetailGetThemInMemory)
{
  const Folder folder;
  const Example example(5000);
  ASSERT_TRUE(writePkdTreeFile(folder.file(), example.tree, example.contents()));
  PkdTree tree = PkdTreeFile(folder.file()).tree();
  EXPECT_FALSE(tree.hasLods());
  EXPECT_TRUE(tree.storedMeans(arrayOf(PkdTreeFile(folder.file()), "energy").values, 0).empty());
  tree.makeLods();
  EXPECT_GT(tree.lodSlots().size(), 300u);
  EXPECT_FALSE(PkdTreeFile(folder.file()).tree().hasLods());
}

TEST(PkdTreeFile, AnyNumberOfParticles)
{
  const Folder folder;
  for (const std::size_t count :
    {0u, 1u, 2u, 15u, 16u, 17u, 255u, 256u, 257u, 4096u, 4097u, 65537u})
  {
    const Particles particles = randomParticles(count, count + 1, 0.02, 0.08);
    PkdTree tree;
    tree.build(particles.set());
    tree.makeLods();
    ASSERT_TRUE(writePkdTreeFile(folder.file(), tree, {}));
    const PkdTreeFile file(folder.file());
    ASSERT_EQ(file.size(), count);
    EXPECT_EQ(file.tree().lodSlots(), tree.lodSlots());
    EXPECT_FALSE(file.time().has_value());
    RayPacket packet = emptyPacket(), other = emptyPacket();
    for (RayPacket* p : {&packet, &other})
      addRay(*p, {0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}, 0.0, 100.0);
    tree.cast(packet, 0);
    file.tree().cast(other, 0);
    EXPECT_EQ(packet.t[0], other.t[0]);
  }
}

TEST(PkdTreeFile, AnyShape)
{
  const Folder folder;
  Random random(10);
  Particles shapes[6];
  for (int i = 0; i < 3000; ++i)
  {
    const Vec3d p = random.inBox(Vec3d(-1.0), Vec3d(1.0));
    shapes[0].add({0.5, 0.25, 8.0}, 0.1);                                 // one place
    shapes[1].add({1e6 * p.x, 0.0, 0.0}, 1e-3);                           // a line
    shapes[2].add(i == 0 ? Vec3d(1e12, -1e9, 0.0) : p, 1e-3);             // one far away
    shapes[3].add(p, std::pow(10.0, random(-6.0, 3.0)));                  // giants
    shapes[4].add(p + Vec3d(1e9, 0.0, -1e12), 1e-2);                      // far from the origin
    shapes[5].add(1e-20 * p + Vec3d(i % 2, 0.0, 0.0), 1e-25 + 1e-30 * i); // two specks
  }
  for (const Particles& particles : shapes)
  {
    PkdTree tree;
    tree.build(particles.set());
    ASSERT_TRUE(writePkdTreeFile(folder.file(), tree, {}));
    EXPECT_EQ(PkdTreeFile(folder.file()).size(), 3000u) << "shape " << &particles - shapes;
  }
}

TEST(PkdTreeFile, KeepsTheForm)
{
  using Form = PkdTreeOptions::Form;
  const Folder folder;
  for (const bool mixed : {false, true})
    for (const Form form : {Form::Exact, Form::Bytes8, Form::Bytes4})
    {
      PkdTreeOptions options;
      options.form = form;
      Example example(20001, 0.04, mixed ? 0.05 : 0.04);
      example.tree.build(example.particles.set(), options);
      ASSERT_TRUE(writePkdTreeFile(folder.file(), example.tree, example.contents()));
      const PkdTreeFile file(folder.file());
      EXPECT_EQ(file.tree().form(), form);
      EXPECT_EQ(file.tree().step(), example.tree.step());
      EXPECT_EQ(file.tree().positionError(), example.tree.positionError());
      expectSameAnswers(example.tree, file);
    }
}

TEST(PkdTreeFile, WrittenAgainIsTheSameFile)
{
  const Folder folder;
  const Example example(5000);
  ASSERT_TRUE(writePkdTreeFile(folder.file("a"), example.tree, example.contents()));
  const PkdTreeFile file(folder.file("a"));
  PkdTreeFileContents contents;
  contents.arrays.assign(file.arrays().begin(), file.arrays().end());
  contents.facts.assign(file.facts().begin(), file.facts().end());
  contents.time = file.time();
  contents.spacing = file.spacing();
  ASSERT_TRUE(writePkdTreeFile(folder.file("b"), file.tree(), contents));
  EXPECT_EQ(readBytes(folder.file("a")), readBytes(folder.file("b")));
}

TEST(PkdTreeFile, KnowsTheRangesOfItsArrays)
{
  const Folder folder;
  Example example(5000);
  example.energy[17] = 5.5f;
  example.energy[18] = std::numeric_limits<float>::quiet_NaN();
  example.energy[19] = -std::numeric_limits<float>::infinity();
  std::fill(example.kind.begin(), example.kind.end(), std::int8_t{-3});
  ASSERT_TRUE(writePkdTreeFile(folder.file(), example.tree, example.contents()));
  const PkdTreeFile file(folder.file());
  const auto extremes = [](const ArrayView& values, int component)
  {
    FileArray::Range range = {HUGE_VAL, -HUGE_VAL};
    for (std::size_t i = 0; i < values.count(); ++i)
      if (const double v = values.value(i, component); std::isfinite(v))
        range = {std::min(range[0], v), std::max(range[1], v)};
    return range;
  };
  for (const FileArray& array : file.arrays())
  {
    const int n = array.values.components();
    ASSERT_EQ(array.ranges.size(), static_cast<std::size_t>(n) + 1);
    for (int k = 0; k < n; ++k)
      EXPECT_EQ(array.ranges[static_cast<std::size_t>(k)], extremes(array.values, k));
    EXPECT_EQ(array.ranges.back(), extremes(array.values, ArrayView::magnitude));
    EXPECT_EQ(array.finite, array.name != "energy");
  }
}

TEST(PkdTreeFile, EachTreeIsShownForItself)
{
  const Folder folder;
  const Example example(5000);
  ASSERT_TRUE(writePkdTreeFile(folder.file(), example.tree, example.contents()));
  auto file = std::make_unique<PkdTreeFile>(folder.file());
  PkdTree some = file->tree();
  const PkdTree all = file->tree();
  some.setAttributes({{arrayOf(*file, "energy").values, 0}});
  ParticleRanges ranges;
  ranges.lower[4] = 0.0;
  some.setRanges(ranges);
  const std::vector<float> energy = [&]
  {
    const auto* data = static_cast<const float*>(arrayOf(*file, "energy").values.data());
    return std::vector<float>(data, data + file->size());
  }();
  file.reset(); // the trees keep it
  Random random(5);
  std::size_t fewer = 0;
  for (int k = 0; k < 200; ++k)
  {
    RayPacket a = emptyPacket();
    for (int i = 0; i < RayPacket::capacity; ++i)
      addRay(a, 3.0 * random.direction(), random.direction(), 0.0, 100.0);
    RayPacket b = a;
    some.cast(a, 0);
    all.cast(b, 0);
    for (int i = 0; i < a.count; ++i)
    {
      ASSERT_TRUE(a.slot[i] == RayPacket::noHit || energy[a.slot[i]] >= 0.0f);
      fewer += b.slot[i] != RayPacket::noHit && energy[b.slot[i]] < 0.0f;
    }
  }
  EXPECT_GT(fewer, 100u);
  some.build(example.particles.set()); // and forget it where they are built anew
  EXPECT_EQ(some.inputIndex(0), example.tree.inputIndex(0));
}

TEST(PkdTreeFile, OpeningDoesNotReadItThrough)
{
  const Folder folder;
  const Example small(1000), large(700000, 0.001, 0.003);
  std::array<long, 2> faults{};
  for (const int k : {0, 1, 0, 1}) // the first round brings in code
  {
    const Example& example = k == 0 ? small : large;
    const std::string name = folder.file(std::to_string(k));
    ASSERT_TRUE(writePkdTreeFile(name, example.tree, example.contents()));
    const long before = pageFaults();
    const PkdTreeFile file(name);
    double range[2] = {file.arrays()[0].ranges[0][0], file.arrays()[0].ranges[0][1]};
    EXPECT_LT(range[0], range[1]);
    faults[static_cast<std::size_t>(k)] = pageFaults() - before;
  }
  // Touching all of the large file would be one fault for every 16 pages at best: 500 or more.
  ASSERT_GT(std::filesystem::file_size(folder.file("1")), std::size_t{500} * 16 * 4096);
  EXPECT_LE(faults[1], faults[0] + 20);
}

TEST(PkdTreeFile, LeavesNothingWhereItCannotBeWritten)
{
  const Folder folder;
  const Example example(5000);
  EXPECT_FALSE(writePkdTreeFile(
    folder.file(), example.tree, example.contents(), [](double done) { return done < 0.5; }));
  EXPECT_TRUE(folder.empty());

  // The limit on files does here what a full disk does.
  rlimit before;
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit tight = {100000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
  try
  {
    writePkdTreeFile(folder.file(), example.tree, example.contents());
    ADD_FAILURE() << "a full disk went unnoticed";
  }
  catch (const WriteError& error)
  {
    EXPECT_EQ(error.kind(), WriteError::Kind::NoSpace);
    EXPECT_NE(std::strstr(error.what(), "a.mote"), nullptr);
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_TRUE(folder.empty());

  EXPECT_THROW(writePkdTreeFile("/dev/full", example.tree, {}), WriteError);
  EXPECT_THROW(writePkdTreeFile(folder.file("no/folder"), example.tree, {}), WriteError);
  EXPECT_THROW(writePkdTreeFile("", example.tree, {}), WriteError);
}

TEST(PkdTreeFile, TakesOnlyArraysThatFit)
{
  const Folder folder;
  const Example example(500);
  const auto write = [&](const auto& change)
  {
    PkdTreeFileContents contents = example.contents();
    change(contents);
    writePkdTreeFile(folder.file(), example.tree, contents);
  };
  write([](PkdTreeFileContents&) {});
  EXPECT_THROW(write([](auto& c) { c.arrays[0].name = "v"; }), Error);
  EXPECT_THROW(write([](auto& c) { c.indexArray = "v"; }), Error);
  EXPECT_THROW(write([](auto& c) { c.arrays[0].name = ""; }), Error);
  EXPECT_THROW(
    write([&](auto& c) { c.arrays[0].values = ArrayView(example.energy.data(), 10, 1); }), Error);
  PkdTree unnamed;
  PkdTreeOptions options;
  options.keepIndices = false;
  unnamed.build(example.particles.set(), options);
  EXPECT_THROW(writePkdTreeFile(folder.file(), unnamed, example.contents()), Error);
  EXPECT_TRUE(writePkdTreeFile(folder.file(), unnamed, {}));
}
