// Files of particles that are damaged, cut short or none at all.

#include "PkdTreeFileParts.h"

#include <kernels/core/Error.h>
#include <kernels/particles/detail/PkdTreeFileFormat.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include <sys/stat.h>

using namespace mote;
using namespace mote::testing;

namespace
{

/// A file in memory that can be changed, its header in the form that is easy to change.
struct Patient
{
  Folder folder;
  Example example;
  Bytes bytes;
  PkdTreeFileHeader header;
  std::vector<PkdTreeFileTableRow> table;

  explicit Patient(std::size_t count = 3000, bool arrays = true)
    : example(count)
  {
    writePkdTreeFile(
      folder.file(), example.tree, arrays ? example.contents() : PkdTreeFileContents{});
    bytes = readBytes(folder.file());
    header = unpackHeader("a", bytes.data(), bytes.size(), table);
  }

  /// What opening the file says with this header, which has a right checksum.
  template <typename Change>
  std::string with(const Change& change) const
  {
    PkdTreeFileHeader h = header;
    std::vector<PkdTreeFileTableRow> t = table;
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
      const PkdTreeFile file(folder.file("b.mote"));
      return {};
    }
    catch (const Error& error)
    {
      EXPECT_NE(std::strstr(error.what(), "b.mote: "), nullptr) << error.what();
      return error.what();
    }
  }
};

/// Casts many rays, for which nothing can be said but that what they hit are particles.
void castAnyhow(const PkdTree& tree)
{
  Random random(6);
  for (int k = 0; k < 300; ++k)
  {
    RayPacket packet = emptyPacket();
    for (int i = 0; i < RayPacket::capacity; ++i)
      addRay(packet, random(0.0, 3.0) * random.direction(), random.direction(), 0.0, 100.0);
    RayPacket shadow = packet;
    tree.cast(packet, 0);
    for (int i = 0; i < packet.count; ++i)
      ASSERT_TRUE(packet.slot[i] == RayPacket::noHit || packet.slot[i] < tree.size());
    std::copy_n(packet.slot, packet.count, shadow.slot);
    std::copy_n(packet.object, packet.count, shadow.object); // some leave the particle that was hit
    tree.occlude(shadow, 0);
  }
  for (int k = 0; k < 6; ++k)
    for (int y = 0; y < 64; y += 16)
      for (int x = 0; x < 64; x += 16)
      {
        RayBundle bundle;
        const CameraRays rays(
          lookAt(random(1.0, 3.0) * random.direction(), Vec3d(0.0), 60.0), 64, 64);
        rays.fillBundle(bundle, 16, x, y, 0.0, 0.0);
        RayBundle shadow = bundle;
        tree.cast(bundle, 0);
        for (int i = 0; i < bundle.count; ++i)
          ASSERT_TRUE(bundle.slot[i] == RayBundle::noHit || bundle.slot[i] < tree.size());
        tree.occlude(shadow, 0);
      }
}

} // namespace

TEST(PkdTreeFileDamage, CutShortAnywhere)
{
  const Patient patient;
  std::vector<std::uint64_t> lengths = {0, 1, 7, 8, 9, 16, 100, sizeof(PkdTreeFileHeader) - 1,
    sizeof(PkdTreeFileHeader), patient.header.headerBytes - 1, patient.header.headerBytes,
    patient.bytes.size() - 1};
  std::vector<PkdTreeFileHeader::Section> sections = {patient.header.nodes, patient.header.rows};
  for (const PkdTreeFileTableRow& row : patient.table)
    sections.push_back(row.entry.section);
  for (const auto& s : sections)
    for (const std::uint64_t at : {s.offset, s.offset + s.bytes})
      lengths.insert(lengths.end(), {at - 1, at, at + 1});
  for (const std::uint64_t length : lengths)
  {
    if (length >= patient.bytes.size())
      continue;
    const std::string said = patient.complaint(
      Bytes(patient.bytes.begin(), patient.bytes.begin() + static_cast<std::ptrdiff_t>(length)));
    EXPECT_TRUE(said.find("cut short") != said.npos || (length == 0 && !said.empty()))
      << "at " << length << ": " << said;
  }
  EXPECT_EQ(patient.complaint(patient.bytes), "");
}

TEST(PkdTreeFileDamage, EveryByteOfTheHeaderCounts)
{
  const Patient patient(40);
  Random random(7);
  for (std::size_t k = 0; k < patient.header.headerBytes; ++k)
  {
    Bytes changed = patient.bytes;
    changed[k] ^= static_cast<unsigned char>(random(1.0, 256.0));
    ASSERT_NE(patient.complaint(changed), "") << "byte " << k;
  }
}

TEST(PkdTreeFileDamage, HeadersThatDoNotFit)
{
  const Patient p;
  using Header = PkdTreeFileHeader;
  using Table = std::vector<PkdTreeFileTableRow>;
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = HUGE_VAL;
  EXPECT_EQ(p.with([](Header&, Table&) {}), "");
  const auto expect = [&](const char* what, const auto& change)
  {
    const std::string said = p.with(change);
    EXPECT_NE(said.find(what), said.npos) << "'" << said << "' and not '" << what << "'";
  };
  expect("version 2", [](Header& h, Table&) { h.version = 2; });
  expect("order of bytes", [](Header& h, Table&) { h.byteOrder = 0x04030201; });
  expect("damaged", [](Header& h, Table&) { h.byteOrder = 1; });
  expect("no file of particles", [](Header& h, Table&) { h.magic[3] = 'e'; });
  expect("another shape", [](Header& h, Table&) { h.nodeBytes = 64; });
  expect("another shape", [](Header& h, Table&) { h.fanout = 8; });
  expect("cut short", [](Header& h, Table&) { h.fileBytes += 1; });
  expect("numbers of particles", [](Header& h, Table&) { h.count = ~std::uint64_t{0}; });
  expect("numbers of particles", [](Header& h, Table&) { h.rowsABucket = 1; });
  expect("size that its particles", [](Header& h, Table&) { h.rowsABucket = 2; });
  expect("size that its particles", [](Header& h, Table&) { h.rowsABucket = 3; });
  expect("numbers of particles", [](Header& h, Table&) { h.ownRadii = 2; });
  expect("size that its particles", [](Header& h, Table&) { h.count += 16; });
  expect("size that its particles", [](Header& h, Table&) { h.count = 0; });
  expect("size that its particles", [](Header& h, Table&) { h.levels = 1; });
  expect("size that its particles", [](Header& h, Table&) { h.nodes.bytes -= 128; });
  expect("size that its particles", [](Header& h, Table&) { h.rows.bytes = 0; });
  expect("one tuple a particle", [](Header& h, Table&) { h.count -= 1; });
  expect("at a page", [](Header& h, Table&) { h.nodes.offset += 64; });
  expect("overlap", [](Header& h, Table&) { h.nodes.offset = h.rows.offset; });
  expect("overlap", [](Header& h, Table&) { h.nodes.offset = 0; });
  expect("behind its end", [](Header& h, Table&) { h.rows.offset = std::uint64_t{1} << 40; });
  expect("behind its end", [](Header& h, Table&) { h.rows.offset = ~std::uint64_t{4095}; });
  expect(
    "overlap", [](Header&, Table& t) { t[1].entry.section.offset = t[0].entry.section.offset; });
  expect("size of its values", [](Header&, Table& t) { t[0].entry.section.bytes += 4; });
  expect(
    "size of its values", [](Header&, Table& t) { t[0].entry.tuples = std::uint64_t{1} << 62; });
  expect("no known kind", [](Header&, Table& t) { t[0].entry.type = 99; });
  expect("no known kind", [](Header&, Table& t) { t[0].entry.type = 256 + 1; });
  expect("no known kind", [](Header&, Table& t) { t[0].entry.components = 0; });
  expect("no known kind", [](Header&, Table& t) { t[0].entry.role = 7; });
  expect("name for every", [](Header&, Table& t) { t[1].entry.componentNames = 2; });
  expect("ends too early",
    [](Header&, Table& t)
    {
      t[0].entry.components = 400;
      t[0].entry.section.bytes = t[0].entry.tuples * 1600;
    });
  for (double Header::*number : {&Header::unit, &Header::step, &Header::coarse, &Header::radius})
    for (const double v : {nan, infinity, -1.0})
      expect("numbers on places", [&](Header& h, Table&) { h.*number = v; });
  for (int k = 0; k < 6; ++k)
    for (const double v : {nan, infinity})
    {
      expect("numbers on places", [&](Header& h, Table&) { h.bounds[k] = v; });
      expect("numbers on places", [&](Header& h, Table&) { h.origin[k % 3] = v; });
    }
  expect("numbers on places", [](Header& h, Table&) { h.unit = 1e-300; });
}

TEST(PkdTreeFileDamage, NoByteLeadsRaysOutOfTheFile)
{
  const Patient patient(3000, false); // what lies behind the tree is no memory
  Random random(8);
  std::size_t opened = 0, refused = 0;
  for (int k = 0; k < 24; ++k)
  {
    // Garbage in all of the tree, or in all but what opening looks at.
    Bytes changed = patient.bytes;
    const PkdTreeFileHeader& h = patient.header;
    const double share = k % 3 == 0 ? 1.0 : 0.02;
    for (std::uint64_t i = h.nodes.offset; i < h.rows.offset + h.rows.bytes; ++i)
      if (random() < share)
        changed[i] = k % 2 == 0 ? static_cast<unsigned char>(random(0.0, 256.0)) : 0xff;
    if (k % 4 != 3)
    {
      std::size_t at = h.nodes.offset;
      for (const std::size_t nodes : {1, 12}) // the levels of 3060 particles in 192 buckets
      {
        at += nodes * h.nodeBytes;
        std::copy_n(&patient.bytes[at - h.nodeBytes], h.nodeBytes, &changed[at - h.nodeBytes]);
      }
      ASSERT_EQ(at - h.nodes.offset, h.nodes.bytes);
      const std::size_t bucket = h.rowsABucket * 64;
      const std::size_t last = h.rows.offset + h.rows.bytes - bucket;
      std::copy_n(&patient.bytes[last], bucket, &changed[last]);
    }
    const std::string said = patient.complaint(changed);
    ++(said.empty() ? opened : refused);
    if (said.empty())
      castAnyhow(PkdTreeFile(patient.folder.file("b.mote")).tree());
  }
  EXPECT_GE(opened, 12u);
  EXPECT_GT(refused, 0u);
}

TEST(PkdTreeFileDamage, WhatIsNoFileOfParticles)
{
  const Folder folder;
  const auto expect = [&](const std::string& name, const char* what)
  {
    try
    {
      const PkdTreeFile file(name);
      ADD_FAILURE() << name << " was opened";
    }
    catch (const Error& error)
    {
      EXPECT_NE(std::strstr(error.what(), what), nullptr) << error.what();
    }
  };
  writeBytes(folder.file("text"), Bytes(10000, 'x'));
  writeBytes(folder.file("short"), Bytes(3, 'x'));
  writeBytes(folder.file("empty"), {});
  ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
  expect(folder.file("text"), "no file of particles");
  expect(folder.file("short"), "no file of particles");
  expect(folder.file("empty"), "empty");
  expect(folder.file("none"), "no such file");
  expect(folder.file("."), "folder");
  expect(folder.file("pipe"), "not a regular file");
}
