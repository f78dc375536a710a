// Memory beyond a budget lies in files that have no names, and so do files while they are written.

#include <kernels/core/AtomicFile.h>
#include <kernels/core/ScratchSpace.h>
#include <kernels/core/StoredArray.h>
#include <kernels/particles/GeneratedParticles.h>
#include <kernels/particles/PkdTree.h>

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include <unistd.h>

using namespace mote;

namespace
{

/// A folder of its own, removed afterwards.
struct Folder
{
  std::filesystem::path path =
    std::filesystem::temp_directory_path() / ("mote-scratch-" + std::to_string(::getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string name(const char* file) const { return (path / file).string(); }
  std::size_t files() const
  {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path), {}));
  }
};

} // namespace

TEST(ScratchSpace, GoesToFilesBeyondItsBudget)
{
  const Folder folder;
  ScratchSpace space(folder.name("a.mote"), 100000);
  EXPECT_TRUE(space.hasRoomFor(100000));
  EXPECT_FALSE(space.hasRoomFor(100001));
  auto first = space.allocate(60000);
  EXPECT_FALSE(space.usesFiles());
  EXPECT_FALSE(space.hasRoomFor(60000));
  auto second = space.allocate(60000);
  EXPECT_TRUE(space.usesFiles());
  EXPECT_TRUE(space.hasRoomFor(40000));
  std::memset(first.get(), 1, 60000);
  std::memset(second.get(), 2, 60000);
  EXPECT_EQ(static_cast<char*>(first.get())[59999], 1);
  EXPECT_EQ(static_cast<char*>(second.get())[59999], 2);
  first.reset(); // makes room
  EXPECT_TRUE(space.hasRoomFor(100000));
  EXPECT_EQ(folder.files(), 0u);
}

TEST(ScratchSpace, SaysThatTheDiskIsFull)
{
  const Folder folder;
  ScratchSpace space(folder.name("a.mote"), 0);
  try
  {
    space.allocate(std::uint64_t{1} << 52);
    FAIL() << "so much disk is there not";
  }
  catch (const WriteError& error)
  {
    EXPECT_EQ(error.kind(), WriteError::Kind::NoSpace) << error.what();
    EXPECT_NE(std::string(error.what()).find("a.mote"), std::string::npos) << error.what();
  }
  EXPECT_EQ(folder.files(), 0u);
  ScratchSpace nowhere("/no/such/folder/a.mote", 0);
  EXPECT_THROW(nowhere.allocate(1), WriteError);
}

TEST(ScratchSpace, CopiesOfArraysInItOnlyRead)
{
  const Folder folder;
  ScratchSpace space(folder.name("a.mote"), 0);
  StoredArray<int> array;
  array.resize(3, space.allocate(3 * sizeof(int)));
  array.own()[2] = 7;
  StoredArray<int> copy = array;
  EXPECT_EQ(copy.own(), nullptr);
  StoredArray<int> moved = std::move(array);
  EXPECT_EQ(moved.own(), copy.data());
  moved.clear();
  EXPECT_EQ(copy[2], 7);
}

TEST(ScratchSpace, HoldsTheSameTree)
{
  const Folder folder;
  for (const bool compact : {false, true})
    for (const char* specification : {"lattice:20000", "varied:20000"})
    {
      PkdTree inMemory, inFiles;
      PkdTreeOptions options;
      options.form = compact ? PkdTreeOptions::Form::Bytes8 : PkdTreeOptions::Form::Exact;
      options.mostError = 1e3;
      inMemory.build(ParticleSet::of(makeParticles(specification)), options);
      options.space = std::make_shared<ScratchSpace>(folder.name("a.mote"), 0);
      inFiles.build(ParticleSet::of(makeParticles(specification)), options);
      EXPECT_TRUE(options.space->usesFiles());
      ASSERT_EQ(inFiles.size(), inMemory.size());
      for (std::size_t slot = 0; slot < inMemory.size(); ++slot)
      {
        ASSERT_EQ(inFiles.center(slot), inMemory.center(slot));
        ASSERT_EQ(inFiles.radius(slot), inMemory.radius(slot));
        ASSERT_EQ(inFiles.inputIndex(slot), inMemory.inputIndex(slot));
      }
      inFiles.build(ParticleSet::of(makeParticles("lattice:1000"))); // back to the heap
      EXPECT_EQ(inFiles.size(), 1000u);
    }
}

TEST(AtomicFile, HasNoNameUntilItIsWhole)
{
  const Folder folder;
  {
    AtomicFile given(folder.name("a"));
    given.write("12345", 5);
  }
  EXPECT_EQ(folder.files(), 0u);
  for (const char* text : {"first", "other"}) // a new file, and one that is replaced
  {
    AtomicFile file(folder.name("a"));
    file.write("?????", 5);
    file.rewrite(0, text, 5);
    file.commit();
    EXPECT_EQ(folder.files(), 1u);
    std::ifstream read(folder.name("a"));
    std::string found;
    read >> found;
    EXPECT_EQ(found, text);
  }
}
