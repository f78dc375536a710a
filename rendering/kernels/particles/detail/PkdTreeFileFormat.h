#pragma once

#include "../PkdTreeFile.h"

#include <cstdint>
#include <string>
#include <vector>

namespace mote
{

/// The layout of a file of particles: docs/mote-file.md. Every number has the byte order of the
/// machine that wrote it, which `byteOrder` shows.
struct PkdTreeFileHeader
{
  static constexpr std::array<char, 8> theMagic = {'M', 'O', 'T', 'E', 'P', 'K', 'D', '\n'};
  static constexpr std::uint32_t theVersion = 1;
  static constexpr std::uint32_t theByteOrder = 0x01020304;
  /// Sections begin at multiples of this: at pages.
  static constexpr std::uint64_t alignment = 4096;

  struct Section
  {
    std::uint64_t offset, bytes;
  };

  std::array<char, 8> magic = theMagic;
  std::uint32_t version = theVersion;
  std::uint32_t byteOrder = theByteOrder;
  std::uint64_t checksum = 0;    ///< of the whole header with 0 here
  std::uint64_t headerBytes = 0; ///< with the table of arrays and the padding
  std::uint64_t fileBytes = 0;
  std::uint32_t nodeBytes = 0, rowBytes = 0, fanout = 0, bucketSize = 0;
  std::uint64_t count = 0; ///< particles
  std::uint32_t levels = 0, rowsABucket = 0;
  std::uint32_t ownRadii = 0, hasTime = 0;
  double time = 0.0, spacing = 0.0;
  double origin[3] = {}, unit = 1.0, step = 1.0, coarse = 1.0, radius = 0.0;
  double centers[6] = {}, bounds[6] = {}; ///< least x y z, greatest x y z
  double smallestRadius = 0.0, largestRadius = 0.0;
  Section nodes{}, rows{};
  std::uint64_t arrays = 0; ///< entries of the table behind this
};
static_assert(sizeof(PkdTreeFileHeader) == 304);

/// An entry of the table, before its ranges, its name and the components' names.
struct PkdTreeFileEntry
{
  enum Role : std::uint32_t
  {
    ofParticles = 0,
    ofWhole = 1
  };
  PkdTreeFileHeader::Section section;
  std::uint64_t tuples;
  std::uint32_t role, type, components, finite;
  std::uint32_t componentNames; ///< as many as components, or none
  std::uint32_t unused;
};
static_assert(sizeof(PkdTreeFileEntry) == 48);

static_assert(static_cast<int>(ArrayView::Type::UInt64) == 10, "types are numbers in files");

/// An entry as it is used.
struct PkdTreeFileTableRow
{
  PkdTreeFileEntry entry;
  PkdTreeFile::Array array; ///< without values
};

/// Size of a value in bytes; 0 for types that there are not.
std::size_t bytesOf(ArrayView::Type type);

/// The whole header block: header, table, padding, checksum.
std::vector<unsigned char> packHeader(
  PkdTreeFileHeader header, const std::vector<PkdTreeFileTableRow>& table);

/// Reads the header block of a file of `size` bytes at `data`, and checks all in it but what it
/// says of the tree. Throws Error with a sentence.
PkdTreeFileHeader unpackHeader(const std::string& name, const unsigned char* data,
  std::uint64_t size, std::vector<PkdTreeFileTableRow>& table);

/// Throws Error where sections overlap, leave the file or begin elsewhere than at pages.
void checkSections(const std::string& name, const PkdTreeFileHeader& header,
  const std::vector<PkdTreeFileTableRow>& table);

[[noreturn]] void failDamaged(const std::string& name, const std::string& how);

} // namespace mote
