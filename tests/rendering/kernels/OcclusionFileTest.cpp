// Files of occlusion maps, and the fingerprint of the particles that they belong to.

#include "PkdTreeFileParts.h"

#include <kernels/core/AtomicFile.h>
#include <kernels/core/Error.h>
#include <kernels/occlusion/OcclusionFile.h>
#include <kernels/particles/ParticleHash.h>

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <cstring>

using namespace mote;
using namespace mote::testing;

namespace
{

StoredOcclusion someMaps(std::size_t count, bool allShown = false)
{
  Random random(count);
  OcclusionMaps::Piece piece;
  StoredOcclusion stored;
  for (std::size_t k = 0; k < count; ++k)
  {
    const int level = static_cast<int>(random(0.0, 9.0));
    piece.levels.push_back(static_cast<std::uint8_t>(level == 8 ? 15 : level));
    const auto texels =
      OcclusionMaps::texelsOf(static_cast<OcclusionMaps::Level>(piece.levels.back()));
    for (std::size_t i = 0; i < texels; ++i)
      piece.texels.push_back(static_cast<std::uint8_t>(random(0.0, 256.0)));
  }
  stored.maps = OcclusionMaps({&piece, 1}, {0.75f, 0.25f, {0.0f, 1.0f, 0.0f}});
  stored.content = {0x123456789abcdef0, 42};
  if (!allShown)
    for (std::size_t word = 0; word < (count + 63) / 64; ++word)
      stored.shown.push_back(0x5555 + word);
  stored.side = 32;
  stored.samples = 7;
  stored.reach = 0.3;
  stored.tolerance = 0.125;
  stored.adaptive = false;
  return stored;
}

void expectEqual(const StoredOcclusion& a, const StoredOcclusion& b)
{
  ASSERT_EQ(a.maps.size(), b.maps.size());
  for (std::size_t i = 0; i < a.maps.size(); ++i)
    ASSERT_EQ(a.maps.level(i), b.maps.level(i)) << i;
  EXPECT_TRUE(std::ranges::equal(a.maps.texels(), b.maps.texels()));
  EXPECT_EQ(a.maps.sky(), b.maps.sky());
  EXPECT_EQ(a.content, b.content);
  EXPECT_EQ(a.shown, b.shown);
  EXPECT_EQ(a.side, b.side);
  EXPECT_EQ(a.samples, b.samples);
  EXPECT_EQ(a.reach, b.reach);
  EXPECT_EQ(a.tolerance, b.tolerance);
  EXPECT_EQ(a.adaptive, b.adaptive);
  EXPECT_EQ(a.dilate, b.dilate);
}

std::string complaintOf(const Folder& folder, const Bytes& bytes)
{
  writeBytes(folder.file("b.moteao"), bytes);
  try
  {
    readOcclusionFile(folder.file("b.moteao"));
    return {};
  }
  catch (const Error& error)
  {
    EXPECT_NE(std::strstr(error.what(), "b.moteao"), nullptr) << error.what();
    return error.what();
  }
}

} // namespace

TEST(OcclusionFile, ReadsWhatWasWritten)
{
  const Folder folder;
  for (const std::size_t count : {0, 1, 2, 15, 16, 64, 65, 999})
    for (const bool allShown : {true, false})
    {
      const StoredOcclusion stored = someMaps(count, allShown);
      writeOcclusionFile(folder.file(), stored);
      expectEqual(readOcclusionFile(folder.file()), stored);
    }
}

TEST(OcclusionFile, ADamagedByteIsFoundWhereverItIs)
{
  const Folder folder;
  writeOcclusionFile(folder.file(), someMaps(60));
  const Bytes good = readBytes(folder.file());
  EXPECT_EQ(complaintOf(folder, good), "");
  for (std::size_t at = 0; at < good.size(); at += at < 200 ? 1 : 97)
    for (const unsigned char change : {1, 128})
    {
      Bytes bytes = good;
      bytes[at] ^= change;
      EXPECT_NE(complaintOf(folder, bytes), "") << at;
    }
}

TEST(OcclusionFile, ACutFileIsRefused)
{
  const Folder folder;
  writeOcclusionFile(folder.file(), someMaps(60));
  Bytes bytes = readBytes(folder.file());
  bytes.push_back(0);
  EXPECT_NE(complaintOf(folder, bytes).find("cut short or damaged"), std::string::npos);
  for (std::size_t size = bytes.size() - 2; size > 0; size = size * 2 / 3)
  {
    bytes.resize(size);
    EXPECT_NE(complaintOf(folder, bytes), "") << size;
  }
  EXPECT_NE(complaintOf(folder, {}).find("no file of occlusion maps"), std::string::npos);
  EXPECT_THROW(readOcclusionFile(folder.file("missing")), Error);
}

TEST(OcclusionFile, OtherVersionsAndMachinesAreNamed)
{
  const Folder folder;
  writeOcclusionFile(folder.file(), someMaps(60));
  const Bytes good = readBytes(folder.file());
  Bytes bytes = good;
  bytes[8] = 2;
  EXPECT_NE(complaintOf(folder, bytes).find("its version is 2"), std::string::npos);
  bytes = good;
  std::reverse(bytes.begin() + 12, bytes.begin() + 16);
  EXPECT_NE(complaintOf(folder, bytes).find("byte order"), std::string::npos);
}

TEST(OcclusionFile, CannotBeWrittenIntoAMissingFolder)
{
  const Folder folder;
  EXPECT_THROW(writeOcclusionFile(folder.file("no/a.moteao"), someMaps(3)), WriteError);
}

TEST(ParticleHash, TellsParticlesApart)
{
  Particles particles = randomParticles(5000, 1, 0.1, 0.2);
  const ContentHash hash = hashOf(particles.set());
  EXPECT_EQ(hashOf(particles.set()), hash);
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(hashOf(particles.set()), hash);
  }
  Particles other = particles;
  other.radii[4999] = std::nextafter(other.radii[4999], 1.0);
  EXPECT_NE(hashOf(other.set()), hash);
  other = particles;
  other.positions[3 * 2048] += 1e-12;
  EXPECT_NE(hashOf(other.set()), hash);
  other = particles;
  std::swap(other.radii[0], other.radii[1]);
  EXPECT_NE(hashOf(other.set()), hash);
  ParticleSet scaled = particles.set();
  scaled.radiusScale = 2.0;
  EXPECT_NE(hashOf(scaled), hash);
}

TEST(ParticleHash, TypesDoNotCount)
{
  Particles particles = randomParticles(3000, 1, 0.1, 0.2);
  std::vector<float> positions(particles.positions.begin(), particles.positions.end());
  particles.positions.assign(positions.begin(), positions.end());
  ParticleSet set = particles.set();
  const ContentHash hash = hashOf(set);
  set.positions = ArrayView(positions.data(), particles.size(), 3);
  EXPECT_EQ(hashOf(set), hash);
}
