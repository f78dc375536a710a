#pragma once

#include "../FileArray.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace mote
{

/// A part of a file.
struct FileSection
{
  /// Sections begin at multiples of this: at pages.
  static constexpr std::uint64_t alignment = 4096;

  std::uint64_t offset = 0, bytes = 0;
};

/// What every header of a .mote file begins with (docs/mote-file.md). Every number has the byte
/// order of the machine that wrote it, which `byteOrder` shows.
///
/// A kind of file has a header that is derived from this, without padding, and sets magic and
/// version; with `theMagic`, `theVersion`, `what` it is in words and how many `roles` its arrays
/// have, and that ends with `arrays`, the number of entries of the table behind it.
struct FileBeginning
{
  static constexpr std::uint32_t theByteOrder = 0x01020304;

  std::array<char, 8> magic{};
  std::uint32_t version = 0;
  std::uint32_t byteOrder = theByteOrder;
  std::uint64_t checksum = 0;    ///< of the whole header with 0 here
  std::uint64_t headerBytes = 0; ///< with the table of arrays and the padding
  std::uint64_t fileBytes = 0;
};
static_assert(sizeof(FileBeginning) == 40);

/// An entry of the table, before its ranges, its name and the components' names.
struct FileEntry
{
  FileSection section;
  std::uint64_t tuples;
  std::uint32_t role, type, components, finite;
  std::uint32_t componentNames; ///< as many as components, or none
  std::uint32_t unused;
};
static_assert(sizeof(FileEntry) == 48);

static_assert(static_cast<int>(ArrayView::Type::UInt64) == 10, "types are numbers in files");

/// An entry as it is used.
struct FileTableRow
{
  FileEntry entry;
  FileArray array; ///< without values
};

/// What stands behind a kind's own part of the header.
struct FileTable
{
  std::vector<FileTableRow> rows;
  /// Parts that older files lack, in an order that the kind has; those without bytes are not there.
  std::vector<FileSection> more;
};

/// Size of a value in bytes; 0 for types that there are not.
std::size_t bytesOf(ArrayView::Type type);

/// A row for an array of `tuples`, without ranges and place.
FileTableRow rowFor(const NamedArray& array, std::uint32_t role, std::uint64_t tuples);

[[noreturn]] void failDamaged(const std::string& name, const std::string& how);

/// What tells kinds of files apart.
struct FileKind
{
  std::array<char, 8> magic;
  std::uint32_t version;
  const char* what; ///< in words
  std::size_t headerBytes;
  std::uint32_t roles; ///< of arrays

  template <typename Header>
  static constexpr FileKind of()
  {
    return {Header::theMagic, Header::theVersion, Header::what, sizeof(Header), Header::roles};
  }
};

/// Fills in what a beginning tells of the whole block.
std::vector<unsigned char> packHeaderBlock(
  const void* header, std::size_t headerBytes, const FileTable& table);
/// Throws Error where a file of `size` bytes at `data` does not begin as a file of the kind.
void checkBeginning(
  const std::string& name, const FileKind& kind, const unsigned char* data, std::uint64_t size);
/// Reads the table of `arrays` entries, and what follows it; after checkBeginning().
FileTable takeTable(const std::string& name, const FileKind& kind, const unsigned char* data,
  std::uint64_t headerBytes, std::uint64_t arrays);

/// The whole header block: header, table, padding, checksum.
template <typename Header>
std::vector<unsigned char> packHeader(Header header, const FileTable& table)
{
  header.arrays = table.rows.size();
  return packHeaderBlock(&header, sizeof(header), table);
}

/// Reads the header block of a file of `size` bytes at `data`, and checks all in it but what it
/// says of the kind's own parts. Throws Error with a sentence.
template <typename Header>
Header unpackHeader(
  const std::string& name, const unsigned char* data, std::uint64_t size, FileTable& table)
{
  constexpr FileKind kind = FileKind::of<Header>();
  checkBeginning(name, kind, data, size);
  Header header;
  std::memcpy(&header, data, sizeof(header));
  table = takeTable(name, kind, data, header.headerBytes, header.arrays);
  return header;
}

/// Throws Error where the sections, with all of the table, overlap, leave the file or begin
/// elsewhere than at pages.
void checkSections(const std::string& name, const FileBeginning& header,
  std::vector<FileSection> sections, const FileTable& table);

} // namespace mote
