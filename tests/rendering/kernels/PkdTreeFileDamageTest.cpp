// Files of particles that are damaged, cut short or none at all.

#include "PkdTreeFileParts.h"

#include <kernels/particles/detail/PkdTreeFileFormat.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace mote;
using namespace mote::testing;

namespace
{

/// A file of particles.
struct Patient : FilePatient<PkdTreeFile, PkdTreeFileHeader>
{
  Example example;

  explicit Patient(std::size_t count = 3000, bool arrays = true)
    : example(count)
  {
    example.tree.makeLods();
    writePkdTreeFile(
      folder.file(), example.tree, arrays ? example.contents() : PkdTreeFileContents{});
    this->take();
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
        RayBundle shadow = bundle, far = bundle;
        tree.cast(bundle, 0);
        tree.cast(far, 0, 100.0);
        for (int i = 0; i < far.count; ++i)
        {
          ASSERT_TRUE(far.slot[i] == RayBundle::noHit || far.slot[i] < tree.size() ||
                      PkdTree::isLod(far.slot[i]));
          if (far.slot[i] == RayBundle::noHit || !PkdTree::isLod(far.slot[i]))
            continue;
          ASSERT_LT(PkdTree::lodPlace(far.slot[i]) / PkdTree::fanout, 13u);
          ASSERT_LT(tree.speaker(far.slot[i]), tree.size());
          tree.lod(far.slot[i]);
        }
        for (int i = 0; i < bundle.count; ++i)
          ASSERT_TRUE(bundle.slot[i] == RayBundle::noHit || bundle.slot[i] < tree.size());
        tree.occlude(shadow, 0);
      }
}

} // namespace

TEST(PkdTreeFileDamage, CutShortAnywhere)
{
  const Patient patient;
  patient.expectCutShort({patient.header.nodes, patient.header.rows});
  EXPECT_EQ(patient.complaint(patient.bytes), "");
}

TEST(PkdTreeFileDamage, EveryByteOfTheHeaderCounts)
{
  const Patient patient(40);
  patient.expectEveryByteOfTheHeaderCounts();
}

TEST(PkdTreeFile, NumbersInFilesStayTheSame)
{
  // Files of earlier versions have these.
  const Patient p(300);
  EXPECT_EQ(std::string(p.bytes.begin(), p.bytes.begin() + 8), "MOTEPKD\n");
  EXPECT_EQ(p.header.version, 1u);
  for (const FileTableRow& row : p.table.rows)
    EXPECT_EQ(row.entry.role, row.array.name == "box" ? 1u : 0u) << row.array.name;
}

TEST(PkdTreeFileDamage, HeadersThatDoNotFit)
{
  const Patient p;
  using Header = PkdTreeFileHeader;
  using Table = FileTable;
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = HUGE_VAL;
  EXPECT_EQ(p.with([](Header&, Table&) {}), "");
  const auto expect = [&](const char* what, const auto& change) { p.expect(what, change); };
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
  expect("overlap",
    [](Header&, Table& t) { t.rows[1].entry.section.offset = t.rows[0].entry.section.offset; });
  expect("size of its values", [](Header&, Table& t) { t.rows[0].entry.section.bytes += 4; });
  expect("size of its values",
    [](Header&, Table& t) { t.rows[0].entry.tuples = std::uint64_t{1} << 62; });
  expect("no known kind", [](Header&, Table& t) { t.rows[0].entry.type = 99; });
  expect("no known kind", [](Header&, Table& t) { t.rows[0].entry.type = 256 + 1; });
  expect("no known kind", [](Header&, Table& t) { t.rows[0].entry.components = 0; });
  expect("no known kind", [](Header&, Table& t) { t.rows[0].entry.role = 7; });
  expect("name for every", [](Header&, Table& t) { t.rows[1].entry.componentNames = 2; });
  expect("ends too early",
    [](Header&, Table& t)
    {
      t.rows[0].entry.components = 400;
      t.rows[0].entry.section.bytes = t.rows[0].entry.tuples * 1600;
    });
  expect("not those of its arrays", [](Header&, Table& t) { t.more.pop_back(); });
  expect("not those of its arrays", [](Header&, Table& t) { t.more.resize(1); });
  for (const std::size_t k : {0, 1, 2, 3})
    expect("size that its tree", [&](Header&, Table& t) { t.more[k].bytes -= 4; });
  expect("size that its tree", [](Header&, Table& t) { std::swap(t.more[5], t.more[3]); });
  expect("at a page", [](Header&, Table& t) { t.more[0].offset += 64; });
  expect("overlap", [](Header&, Table& t) { t.more[1].offset = t.more[2].offset; });
  expect("behind its end", [](Header&, Table& t) { t.more[0].offset = std::uint64_t{1} << 40; });
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
    // Garbage in all of the tree and its boxes, or in all but what opening looks at.
    Bytes changed = patient.bytes;
    const PkdTreeFileHeader& h = patient.header;
    const double share = k % 3 == 0 ? 1.0 : 0.02;
    for (std::uint64_t i = h.nodes.offset; i < changed.size(); ++i)
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
  expectNoFilesOf<PkdTreeFile>("particles");
}
