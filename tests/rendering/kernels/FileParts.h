#pragma once

// What the tests of .mote files of all kinds share.

#include <kernels/core/Error.h>
#include <kernels/core/detail/FileHeader.h>

#include <support/Particles.h>

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

namespace mote::testing
{

/// A folder of its own that goes with the test.
class Folder
{
public:
  Folder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "mote-file-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string file(const std::string& name = "a.mote") const { return (path_ / name).string(); }
  bool empty() const { return std::filesystem::is_empty(path_); }

private:
  std::filesystem::path path_;
};

using Bytes = std::vector<unsigned char>;

inline Bytes readBytes(const std::string& name)
{
  std::ifstream stream(name, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(stream), {});
}

inline void writeBytes(const std::string& name, const Bytes& bytes)
{
  std::ofstream stream(name, std::ios::binary);
  stream.write(
    reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// A file in memory that can be changed, its header in the form that is easy to change.
template <typename File, typename Header>
struct FilePatient
{
  Folder folder;
  Bytes bytes;
  Header header;
  FileTable table;

  /// Reads what was written as folder.file().
  void take()
  {
    bytes = readBytes(folder.file());
    header = unpackHeader<Header>("a", bytes.data(), bytes.size(), table);
  }

  /// What opening the file says with this header, which has a right checksum.
  template <typename Change>
  std::string with(const Change& change) const
  {
    Header h = header;
    FileTable t = table;
    change(h, t);
    Bytes changed = bytes;
    const Bytes block = packHeader(h, t);
    std::copy(block.begin(), block.end(), changed.begin());
    return this->complaint(changed);
  }

  /// The sentence of the error, or nothing.
  std::string complaint(const Bytes& changed) const
  {
    writeBytes(folder.file("b.mote"), changed);
    try
    {
      const File file(folder.file("b.mote"));
      return {};
    }
    catch (const Error& error)
    {
      EXPECT_NE(std::strstr(error.what(), "b.mote: "), nullptr) << error.what();
      return error.what();
    }
  }

  template <typename Change>
  void expect(const char* what, const Change& change) const
  {
    const std::string said = this->with(change);
    EXPECT_NE(said.find(what), said.npos) << "'" << said << "' and not '" << what << "'";
  }

  /// Cuts it at the ends of the header, of these sections and of all arrays, and beside them.
  void expectCutShort(std::vector<FileSection> sections) const
  {
    std::vector<std::uint64_t> lengths = {0, 1, 7, 8, 9, 16, 100, sizeof(Header) - 1,
      sizeof(Header), header.headerBytes - 1, header.headerBytes, bytes.size() - 1};
    for (const FileTableRow& row : table.rows)
      sections.push_back(row.entry.section);
    sections.insert(sections.end(), table.more.begin(), table.more.end());
    for (const FileSection& s : sections)
      for (const std::uint64_t at : {s.offset, s.offset + s.bytes})
        lengths.insert(lengths.end(), {at - 1, at, at + 1});
    for (const std::uint64_t length : lengths)
    {
      if (length >= bytes.size())
        continue;
      const std::string said =
        this->complaint(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)));
      EXPECT_TRUE(said.find("cut short") != said.npos || (length == 0 && !said.empty()))
        << "at " << length << ": " << said;
    }
  }

  void expectEveryByteOfTheHeaderCounts() const
  {
    Random random(7);
    for (std::size_t k = 0; k < header.headerBytes; ++k)
    {
      Bytes changed = bytes;
      changed[k] ^= static_cast<unsigned char>(random(1.0, 256.0));
      ASSERT_NE(this->complaint(changed), "") << "byte " << k;
    }
  }
};

/// Opens what is no file of the kind, or none at all.
template <typename File>
void expectNoFilesOf(const std::string& what)
{
  const Folder folder;
  const auto expect = [&](const std::string& name, const std::string& why)
  {
    try
    {
      const File file(name);
      ADD_FAILURE() << name << " was opened";
    }
    catch (const Error& error)
    {
      EXPECT_NE(std::strstr(error.what(), why.c_str()), nullptr) << error.what();
    }
  };
  writeBytes(folder.file("text"), Bytes(10000, 'x'));
  writeBytes(folder.file("short"), Bytes(3, 'x'));
  writeBytes(folder.file("empty"), {});
  ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
  expect(folder.file("text"), "no file of " + what);
  expect(folder.file("short"), "no file of " + what);
  expect(folder.file("empty"), "empty");
  expect(folder.file("none"), "no such file");
  expect(folder.file("."), "folder");
  expect(folder.file("pipe"), "not a regular file");
}

} // namespace mote::testing
