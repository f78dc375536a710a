// Files appear under their name complete or not at all, and what stands against that is said.

#include <kernels/core/AtomicFile.h>

#include <gtest/gtest.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace mote;
namespace fs = std::filesystem;

namespace
{

class AtomicFileTest : public testing::Test
{
protected:
  void SetUp() override { fs::create_directories(m_folder); }
  void TearDown() override { fs::remove_all(m_folder); }

  std::string path(const std::string& name) const { return (m_folder / name).string(); }

  std::string write(const std::string& name, const std::string& text) const
  {
    std::ofstream(path(name)) << text;
    return path(name);
  }

  static std::string textOf(const std::string& name)
  {
    std::ifstream file(name);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(m_folder), {}); }

  template <class Act>
  static void expectError(WriteError::Kind kind, const std::string& words, const Act& act)
  {
    try
    {
      act();
      ADD_FAILURE() << "no error: " << words;
    }
    catch (const WriteError& error)
    {
      EXPECT_EQ(error.kind(), kind) << words;
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }

  fs::path m_folder = fs::temp_directory_path() / ("mote-atomic-" + std::to_string(::getpid()));
};

using Kind = WriteError::Kind;

TEST_F(AtomicFileTest, OldFilesStayUntilTheNewOneIsWhole)
{
  const std::string name = write("a", "old");
  ::chmod(name.c_str(), 0640);
  {
    AtomicFile file(name);
    file.write("left", 4);
    EXPECT_EQ(textOf(name), "old");
  }
  EXPECT_EQ(textOf(name), "old");
  AtomicFile file(name);
  file.write("new text", 8);
  file.rewrite(0, "N", 1);
  file.commit();
  EXPECT_EQ(textOf(name), "New text");
  struct stat facts = {};
  ASSERT_EQ(::stat(name.c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777, 0640u);
  EXPECT_EQ(this->files(), 1);
}

TEST_F(AtomicFileTest, LinksStayAndTheirTargetsAreReplaced)
{
  const std::string target = write("target", "old"), link = path("link");
  fs::create_symlink("target", link);
  AtomicFile file(link);
  file.write("new", 3);
  file.commit();
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(textOf(target), "new");
  // A link to nothing names what is written.
  fs::create_symlink("nothing yet", path("open"));
  AtomicFile other(path("open"));
  other.write("new", 3);
  other.commit();
  EXPECT_TRUE(fs::is_symlink(path("open")));
  EXPECT_EQ(textOf(path("nothing yet")), "new");
}

TEST_F(AtomicFileTest, NamesThatCannotBeWritten)
{
  write("file", "");
  fs::create_directory(path("folder"));
  expectError(Kind::CannotOpen, "needs a name", [] { checkWritable(""); });
  expectError(Kind::CannotOpen, "it is a folder", [&] { checkWritable(path("folder")); });
  expectError(Kind::CannotOpen, "folder does not exist", [&] { checkWritable(path("no/a")); });
  expectError(
    Kind::CannotOpen, "should be its folder is a file", [&] { checkWritable(path("file/a")); });
  expectError(Kind::CannotOpen, "not a regular file", [] { checkWritable("/dev/null"); });
  expectError(
    Kind::CannotOpen, "the name is too long", [&] { AtomicFile(path(std::string(300, 'a'))); });
  // A link to itself leads nowhere.
  fs::create_symlink("loop", path("loop"));
  expectError(Kind::CannotOpen, std::strerror(ELOOP), [&] { checkWritable(path("loop")); });
  if (::geteuid() == 0)
    return; // whom no permission stops
  ::chmod(path("file").c_str(), 0400);
  expectError(Kind::CannotOpen, "write-protected", [&] { checkWritable(path("file")); });
  ::chmod(path("folder").c_str(), 0500);
  expectError(Kind::CannotOpen, "no permission", [&] { checkWritable(path("folder/a")); });
  ::chmod(path("folder").c_str(), 0700);
}

TEST_F(AtomicFileTest, ErrorsOfTheSystemInWords)
{
  const std::pair<int, const char*> cases[] = {{ENOSPC, "the disk is full"},
    {EDQUOT, "the disk quota is used up"}, {EFBIG, "larger than the limit on files"},
    {EROFS, "the file system is read-only"}, {EACCES, "no permission to write in its folder"},
    {ENAMETOOLONG, "the name is too long"}, {EIO, std::strerror(EIO)}};
  for (const auto& [error, words] : cases)
  {
    const bool isSpace = error == ENOSPC || error == EDQUOT || error == EFBIG;
    expectError(isSpace ? Kind::NoSpace : Kind::CannotOpen, words,
      [error = error] { throwWriteError("a", error); });
  }
}

TEST_F(AtomicFileTest, NamelessFilesLeaveNothing)
{
  const int file = openNameless(path("beside"));
  ASSERT_GE(file, 0);
  EXPECT_EQ(::write(file, "text", 4), 4);
  EXPECT_EQ(this->files(), 0);
  ::close(file);
  expectError(Kind::CannotOpen, std::strerror(ENOENT), [&] { openNameless(path("no/beside")); });
}

TEST_F(AtomicFileTest, FilesThatOthersHaveWrittenGetTheirName)
{
  const std::string written = write("written", "new"), name = write("name", "old");
  moveIntoPlace(written, name);
  EXPECT_EQ(textOf(name), "new");
  EXPECT_EQ(this->files(), 1);
  expectError(Kind::CannotOpen, std::strerror(ENOENT), [&] { moveIntoPlace(written, name); });
  fs::create_directory(path("folder"));
  write("folder/a", "");
  expectError(Kind::CannotOpen, "", [&] { moveIntoPlace(name, path("folder")); });
  EXPECT_EQ(textOf(name), "new");
}

} // namespace
