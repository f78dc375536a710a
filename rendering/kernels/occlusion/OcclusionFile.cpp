#include "OcclusionFile.h"

#include "../core/AtomicFile.h"
#include "../core/Error.h"
#include "../core/MappedFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace mote
{

namespace
{

/// The file's first bytes: docs/ambient-occlusion.md. Levels follow, two to a byte, then the words
/// of StoredOcclusion::shown, then the texels. Numbers have the byte order of the machine that
/// wrote them, which `byteOrder` shows.
struct Header
{
  static constexpr std::array<char, 8> theMagic = {'M', 'O', 'T', 'E', 'A', 'O', '\r', '\n'};
  static constexpr std::uint32_t theVersion = 1;
  static constexpr std::uint32_t theByteOrder = 0x01020304;

  std::array<char, 8> magic = theMagic;
  std::uint32_t version = theVersion;
  std::uint32_t byteOrder = theByteOrder;
  std::uint64_t checksum = 0; ///< of the whole file with 0 here
  std::uint64_t count = 0;    ///< particles
  std::uint64_t texels = 0;
  std::uint64_t shownWords = 0;
  std::uint64_t contentLow = 0, contentHigh = 0;
  double reach = 0.0, tolerance = 0.0;
  std::uint32_t side = 0, samples = 0, adaptive = 0, dilate = 0;
  float skyTop = 1.0f, skyBottom = 1.0f, skyUp[3] = {};
  std::uint32_t unused = 0;

  std::uint64_t levelBytes() const { return count / 2 + count % 2; }
};
static_assert(sizeof(Header) == 120);

[[noreturn]] void fail(const std::string& name, const std::string& how)
{
  throw Error("The occlusion maps in \"" + name + "\" cannot be used: " + how + ".");
}

std::uint64_t checksumOf(Header header, const unsigned char* rest, std::uint64_t bytes)
{
  header.checksum = 0;
  return combine(hashOf(&header, sizeof header), hashOf(rest, bytes)).low;
}

/// Checks all that can be told from the file's first bytes and its size.
Header readHeader(const std::string& name, const MappedFile& file)
{
  Header header;
  if (file.size() < sizeof header || std::memcmp(file.data(), &header.magic, sizeof header.magic))
    fail(name, "it is no file of occlusion maps");
  std::memcpy(&header, file.data(), sizeof header);
  if (header.byteOrder != Header::theByteOrder)
    fail(name, "it was written on a machine with another byte order");
  if (header.version != Header::theVersion)
    fail(name, "its version is " + std::to_string(header.version) + ", and only version " +
                 std::to_string(Header::theVersion) + " is known");
  const std::uint64_t rest = file.size() - sizeof header;
  const std::uint64_t words = (header.count + 63) / 64;
  // Each part by itself first: sums of damaged numbers may overflow.
  if (header.levelBytes() > rest || header.texels > rest || header.shownWords > rest / 8 ||
      header.levelBytes() + 8 * header.shownWords + header.texels != rest)
    fail(name, "it is cut short or damaged");
  if ((header.shownWords != 0 && header.shownWords != words) ||
      checksumOf(header, file.data() + sizeof header, rest) != header.checksum)
    fail(name, "it is damaged");
  return header;
}

} // namespace

void writeOcclusionFile(const std::string& name, const StoredOcclusion& stored)
{
  const OcclusionMaps& maps = stored.maps;
  Header header;
  header.count = maps.size();
  header.texels = maps.texels().size();
  header.shownWords = stored.shown.size();
  header.contentLow = stored.content.low;
  header.contentHigh = stored.content.high;
  header.reach = stored.reach;
  header.tolerance = stored.tolerance;
  header.side = static_cast<std::uint32_t>(stored.side);
  header.samples = static_cast<std::uint32_t>(stored.samples);
  header.adaptive = stored.adaptive;
  header.dilate = stored.dilate;
  header.skyTop = maps.sky().top;
  header.skyBottom = maps.sky().bottom;
  for (int axis = 0; axis < 3; ++axis)
    header.skyUp[axis] = maps.sky().up[axis];

  RawVector<unsigned char> rest;
  rest.resize(header.levelBytes() + 8 * header.shownWords + header.texels);
  unsigned char* to = rest.data();
  for (std::size_t i = 0; i < maps.size(); i += 2)
  {
    const unsigned second = i + 1 < maps.size() ? unsigned{maps.level(i + 1)} : 0u;
    *to++ = static_cast<unsigned char>(maps.level(i) | second << 4U);
  }
  for (const std::uint64_t word : stored.shown)
  {
    std::memcpy(to, &word, sizeof word);
    to += sizeof word;
  }
  std::copy(maps.texels().begin(), maps.texels().end(), to);
  header.checksum = checksumOf(header, rest.data(), rest.size());

  AtomicFile file(name);
  file.write(&header, sizeof header);
  file.write(rest.data(), rest.size());
  file.commit();
}

StoredOcclusion readOcclusionFile(const std::string& name)
{
  const MappedFile file(name);
  const Header header = readHeader(name, file);
  const unsigned char* from = file.data() + sizeof header;
  OcclusionMaps::Piece piece;
  piece.levels.resize(header.count);
  for (std::size_t i = 0; i < header.count; ++i)
    piece.levels[i] = from[i / 2] >> (4 * (i % 2)) & 15;
  from += header.levelBytes();

  StoredOcclusion stored;
  stored.shown.resize(header.shownWords);
  for (std::uint64_t& word : stored.shown)
  {
    std::memcpy(&word, from, sizeof word);
    from += sizeof word;
  }
  piece.texels.resize(header.texels);
  std::copy_n(from, header.texels, piece.texels.data());
  const OcclusionSky sky{
    header.skyTop, header.skyBottom, {header.skyUp[0], header.skyUp[1], header.skyUp[2]}};
  try
  {
    stored.maps = OcclusionMaps({&piece, 1}, sky);
  }
  catch (const Error&)
  {
    fail(name, "its numbers contradict one another");
  }
  stored.content = {header.contentLow, header.contentHigh};
  stored.side = static_cast<int>(header.side);
  stored.samples = static_cast<int>(header.samples);
  stored.reach = header.reach;
  stored.tolerance = header.tolerance;
  stored.adaptive = header.adaptive != 0;
  stored.dilate = header.dilate != 0;
  return stored;
}

} // namespace mote
