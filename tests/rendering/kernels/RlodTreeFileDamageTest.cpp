// Damaged files of triangles get a sentence, and no byte leads out of the file.

#include "RlodTreeFileParts.h"

#include <kernels/meshes/detail/RlodTreeParts.h>

#include <bit>
#include <cmath>
#include <limits>

using namespace mote;
using namespace mote::testing;

namespace
{

/// What opening the file says with these nodes.
std::string withNodes(const Patient& p, const std::vector<RlodNode>& nodes)
{
  Bytes changed = p.bytes;
  std::memcpy(changed.data() + p.header.nodes.offset, nodes.data(), p.header.nodes.bytes);
  return p.complaint(changed);
}

/// Nodes of a tree that is so deep: one of each level has the next, and as many more as there are.
std::vector<RlodNode> chainOf(std::size_t count, std::size_t depth)
{
  std::vector<RlodNode> nodes(count);
  std::size_t next = 1, beside = count - depth, chain = 0;
  for (std::size_t level = 1; level <= depth; ++level)
  {
    const std::size_t more =
      level == depth ? 0 : std::min<std::size_t>(beside, RlodNode::fanout - 2);
    // Those beside it have a cluster each, as it has.
    for (std::size_t k = 0; k < more; ++k)
      nodes[next + k].children = nodes[next + k].clusters = 1;
    nodes[chain].firstNode = static_cast<std::uint32_t>(next) & (RlodNode::mostIndices - 1);
    nodes[chain].clusters = 1;
    nodes[chain].children = static_cast<std::uint32_t>(level == depth ? 1 : 2 + more) & 31U;
    chain = next + more;
    next = chain + 1;
    beside -= more;
  }
  return nodes;
}

} // namespace

TEST(RlodTreeFileDamage, CutShortAnywhere)
{
  const Patient patient;
  patient.expectCutShort(patient.sections());
  EXPECT_EQ(patient.complaint(patient.bytes), "");
}

TEST(RlodTreeFileDamage, EveryByteOfTheHeaderCounts)
{
  Patient(6).expectEveryByteOfTheHeaderCounts();
}

TEST(RlodTreeFileDamage, WhatIsNoFileOfTriangles)
{
  expectNoFilesOf<RlodTreeFile>("triangles");
}

TEST(RlodTreeFileDamage, HeadersThatDoNotFit)
{
  const Patient p;
  using Header = RlodTreeFileHeader;
  using Table = FileTable;
  EXPECT_EQ(p.with([](Header&, Table&) {}), "");
  const auto expect = [&](const char* what, const auto& change) { p.expect(what, change); };
  expect("version 2", [](Header& h, Table&) { h.version = 2; });
  expect("another shape", [](Header& h, Table&) { h.nodeBytes = 64; });
  expect("another shape", [](Header& h, Table&) { h.planesBytes = 0; });
  expect("numbers of triangles", [](Header& h, Table&) { h.triangles = 0; });
  expect("numbers of triangles", [](Header& h, Table&) { h.points = ~std::uint64_t{0}; });
  expect("numbers of triangles", [](Header& h, Table&) { h.placeBytes = 5; });
  expect("numbers of triangles", [](Header& h, Table&) { h.nodes.bytes = 0; });
  expect("numbers of triangles", [](Header& h, Table&) { h.triangles = ~std::uint64_t{0}; });
  expect("numbers of triangles", [](Header& h, Table&) { h.points = 0; });
  expect("numbers of triangles", [](Header& h, Table&) { h.clusters.bytes = 0; });
  expect("size that its triangles", [](Header& h, Table&) { h.triangles -= 1; });
  expect("size that its triangles", [](Header& h, Table&) { h.placeBytes = 4; });
  for (FileSection Header::*part : {&Header::nodes, &Header::words, &Header::planes,
         &Header::clusters, &Header::corners, &Header::offsets, &Header::places})
    expect("size that its triangles", [=](Header& h, Table&) { (h.*part).bytes -= 4; });
  expect("at a page", [](Header& h, Table&) { h.planes.offset += 64; });
  expect("overlap", [](Header& h, Table&) { h.corners.offset = h.places.offset; });
  expect("behind its end", [](Header& h, Table&) { h.places.offset = std::uint64_t{1} << 40; });
  expect("no array of points", [](Header& h, Table&) { h.normals = 99; });
  expect("no known kind", [](Header&, Table& t) { t.rows[0].entry.role = 3; });
  expect("one tuple a point", [](Header&, Table& t) { t.rows[0].entry.role = Header::ofCells; });
  expect("not those of its arrays", [](Header&, Table& t) { t.more.pop_back(); });
  expect("size that its tree", [](Header&, Table& t) { t.more[0].bytes -= 4; });
  expect("size that its tree", [](Header&, Table& t) { std::swap(t.more.back(), t.more[0]); });
  expect("overlap", [](Header&, Table& t) { t.more[0].offset = t.rows[0].entry.section.offset; });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double v : {nan, double(HUGE_VAL), -1.0, 0.0, 1e-320})
    expect("numbers on places", [&](Header& h, Table&) { h.unit = v; });
  for (int k = 0; k < 3; ++k)
  {
    expect("numbers on places", [&](Header& h, Table&) { h.origin[k] = nan; });
    expect("numbers on places", [&](Header& h, Table&) { h.lower[k] = 3.0; });
    expect("numbers on places", [&](Header& h, Table&) { h.lower[k] = -2.1; });
    expect("numbers on places", [&](Header& h, Table&) { h.upper[k] = 2.1; });
    expect("numbers on places", [&](Header& h, Table&) { std::swap(h.lower[k], h.upper[k]); });
    expect("numbers on places", [&](Header& h, Table&) { h.bounds[k] = nan; });
    expect(
      "numbers on places", [&](Header& h, Table&) { std::swap(h.bounds[k], h.bounds[3 + k]); });
    // The ends of what is allowed, and nothing thick at all.
    EXPECT_EQ(p.with([&](Header& h, Table&) { h.lower[k] = -2.0, h.upper[k] = 2.0; }), "");
    EXPECT_EQ(p.with([&](Header& h, Table&) { h.lower[k] = h.upper[k]; }), "");
    EXPECT_EQ(p.with([&](Header& h, Table&) { h.bounds[k] = h.bounds[3 + k]; }), "");
  }
  expect("numbers on places", [](Header& h, Table&) { h.levelStep = ~0U; });
  // The last of 32 levels is the bits of a float below 1e30.
  const auto below = std::bit_cast<std::uint32_t>(1e30f) - 1;
  const auto levels = [](std::uint32_t first, std::uint32_t step)
  { return [=](Header& h, Table&) { h.firstLevel = first, h.levelStep = step; }; };
  EXPECT_EQ(p.with(levels(below, 0)), "");
  EXPECT_EQ(p.with(levels(below - 31, 1)), "");
  EXPECT_EQ(p.with(levels(below % 31, below / 31)), "");
  expect("numbers on places", levels(below + 1, 0));
  expect("numbers on places", levels(below - 30, 1));
  expect("numbers on places", levels(below % 31 + 1, below / 31));
}

TEST(RlodTreeFileDamage, NodesThatAreNoTree)
{
  const Patient p;
  std::vector<RlodNode> nodes(p.header.nodes.bytes / sizeof(RlodNode));
  std::memcpy(nodes.data(), p.bytes.data() + p.header.nodes.offset, p.header.nodes.bytes);
  const auto clusters =
    static_cast<std::uint32_t>(p.header.clusters.bytes / sizeof(TriangleCluster));
  ASSERT_EQ(withNodes(p, nodes), "");
  const auto expect = [&](std::size_t k, const auto& change, bool isTree = false)
  {
    std::vector<RlodNode> changed = nodes;
    change(changed[k]);
    EXPECT_EQ(withNodes(p, changed).find("its tree is none") != std::string::npos, !isTree) << k;
  };
  std::size_t inner = 0, leaf = 0; // the last of both kinds
  for (std::size_t k = 0; k < nodes.size(); ++k)
    (nodes[k].children > nodes[k].clusters ? inner : leaf) = k;
  ASSERT_EQ(leaf, nodes.size() - 1);
  for (const std::size_t k : {std::size_t{0}, inner, leaf})
  {
    expect(k, [](RlodNode& n) { n.children = 0; });
    expect(k, [](RlodNode& n) { n.children = n.clusters = 0; });
    expect(k, [](RlodNode& n) { n.children = n.clusters = 17; });
    expect(k, [](RlodNode& n) { n.clusters = n.children + 1; });
    expect(k, [&](RlodNode& n) { n.firstCluster = clusters - n.clusters + 1; });
    expect(
      k, [&](RlodNode& n) { n.firstCluster = clusters - n.clusters; }, true);
  }
  for (const std::size_t k : {std::size_t{0}, inner})
  {
    const auto below = nodes[k].children - nodes[k].clusters;
    expect(k, [&](RlodNode& n) { n.firstNode = static_cast<std::uint32_t>(k); });
    expect(
      k, [&](RlodNode& n) { n.firstNode = static_cast<std::uint32_t>(nodes.size() - below + 1); });
    expect(k, [](RlodNode& n) { n.firstNode += 1; }); // leaves one out
  }
  // The last node's only child would be itself, or one before it, or none.
  for (const std::size_t first : {std::size_t{0}, leaf - 1, leaf, leaf + 1})
    expect(leaf,
      [&](RlodNode& n)
      {
        n.children = n.clusters + 1;
        n.firstNode = static_cast<std::uint32_t>(first) & (RlodNode::mostIndices - 1);
      });
  // A leaf that other clusters come behind.
  std::size_t early = 0;
  while (nodes[early].children > nodes[early].clusters)
    ++early;
  expect(early, [](RlodNode& n) { n.clusters = n.children + 1; });
  expect(
    leaf, [](RlodNode& n) { n.firstNode = 0; }, true); // which it has no use for
}

TEST(RlodTreeFileDamage, TreesOfManyLevels)
{
  const Patient p(180, false);
  const std::size_t count = p.header.nodes.bytes / sizeof(RlodNode);
  ASSERT_GT(count, 1001u);
  EXPECT_EQ(withNodes(p, chainOf(count, 1000)), "");
  EXPECT_NE(withNodes(p, chainOf(count, 1001)).find("its tree is none"), std::string::npos);
}

TEST(RlodTreeFileDamage, NoByteLeadsRaysOutOfTheFile)
{
  const Patient patient(30);
  Random random(8);
  int opened = 0, refused = 0;
  for (int k = 0; k < 24; ++k)
  {
    // Garbage in all parts, the nodes left alone or not.
    Bytes changed = patient.bytes;
    const double share = k % 3 == 0 ? 1.0 : 0.02;
    for (const FileSection& s : patient.sections())
      for (std::uint64_t i = s.offset; i < s.offset + s.bytes; ++i)
        if (random() < share && (k % 4 == 3 || s.offset != patient.header.nodes.offset))
          changed[i] = k % 2 == 0 ? static_cast<unsigned char>(random(0.0, 256.0)) : 0xff;
    const std::string said = patient.complaint(changed);
    ++(said.empty() ? opened : refused);
    if (!said.empty())
      continue;
    const RlodTreeFile file(patient.folder.file("b.mote"));
    MeshLook look;
    look.corners = file.corners();
    look.normals = named(file.points(), "Normals").values;
    look.mixesColors = true;
    const auto tree = file.tree();
    const MeshSurface surface(tree, look);
    for (const RayBundle& question : meshQuestions(30, 5))
    {
      RayBundle bundle = question, shadow = question;
      tree->cast(bundle, 3, k % 2 == 0 ? 4.0 : 0.0);
      tree->occlude(shadow, 3);
      for (int i = 0; i < bundle.count; ++i)
      {
        if (bundle.slot[i] == RayBundle::noHit)
          continue;
        ASSERT_LT(tree->inputIndex(bundle.slot[i]), file.size());
        const Vec3d at(1.0);
        ColorMix mix;
        surface.normalAt(bundle.slot[i], at);
        surface.mixColors(&bundle.slot[i], &at, 1, mix);
        for (const auto& index : mix.index)
          ASSERT_LT(index[0], file.pointCount());
      }
    }
    tree->lodMeans(1, [&](std::uint64_t triangle, double* values)
      { values[0] = double((*file.corners())[triangle][0]); });
  }
  EXPECT_GE(opened, 12);
  EXPECT_GT(refused, 0);
}
