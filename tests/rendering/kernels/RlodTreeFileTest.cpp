// Files of triangles: what was written comes back, and rays meet the same.

#include "RlodTreeFileParts.h"

#include <cmath>
#include <limits>

using namespace mote;
using namespace mote::testing;

namespace
{

using Order = RlodTreeFileContents::Order;
constexpr Order orders[] = {Order::ByError, Order::DepthFirst, Order::ByArea, Order::Blocks};

} // namespace

TEST(RlodTreeFile, WhatWasWrittenComesBack)
{
  const MeshExample e;
  const Folder folder;
  for (const Order order : orders)
  {
    RlodTreeFileContents contents = e.contents();
    contents.order = order;
    ASSERT_TRUE(writeRlodTreeFile(folder.file(), e.tree, e.mesh, contents));
    const RlodTreeFile file(folder.file());
    ASSERT_EQ(file.size(), e.mesh.size());
    ASSERT_EQ(file.pointCount(), e.mesh.pointCount() - 1); // one that nothing uses
    ASSERT_EQ(file.tree()->size(), e.mesh.size());
    EXPECT_EQ(file.time(), 2.5);
    EXPECT_EQ(file.normals(), "Normals");
    const ArrayView cell = named(file.cells(), "cell").values,
                    part = named(file.cells(), "part").values,
                    point = named(file.points(), "point").values,
                    height = named(file.points(), "h").values;
    EXPECT_EQ(named(file.points(), "Normals").components[2], "z");
    EXPECT_EQ(named(file.facts(), "box").values.value(0, 1), 1.0);
    for (std::size_t i = 0; i < file.pointCount(); ++i)
    {
      const auto input = static_cast<std::size_t>(point.value(i));
      ASSERT_EQ(height.value(i), e.height[input]);
      for (int k = 0; k < 3; ++k)
        ASSERT_EQ(file.places().value(i, k), e.triangles.point(input)[k]);
    }
    std::vector<int> seen(e.mesh.size());
    for (std::size_t t = 0; t < file.size(); ++t)
    {
      ASSERT_EQ(file.offsets().value(t), 3.0 * static_cast<double>(t));
      const auto input = static_cast<std::size_t>(cell.value(t));
      ASSERT_EQ(part.value(t), e.part[input]);
      // It is one of the cell's two triangles.
      int found = 0;
      for (std::size_t of = 2 * input; of < std::min(2 * input + 2, e.mesh.size()); ++of)
      {
        bool same = true;
        for (std::size_t k = 0; k < 3; ++k)
          same = same && point.value((*file.corners())[t][k]) == e.mesh.triangles()[of][k];
        found += same;
        seen[of] += same;
      }
      ASSERT_EQ(found, 1);
    }
    EXPECT_EQ(seen, std::vector<int>(e.mesh.size(), 1));
    EXPECT_EQ(file.offsets().value(file.size()), 3.0 * static_cast<double>(file.size()));
    const FileArray& h = named(file.points(), "h");
    const auto [least, most] = std::minmax_element(e.height.begin(), e.height.end());
    EXPECT_EQ(h.ranges[0][0], *least);
    EXPECT_EQ(h.ranges[0][1], *most);
    const Box expected = e.tree.bounds();
    EXPECT_EQ(file.bounds().lower, expected.lower);
    EXPECT_EQ(file.tree()->bounds().upper, expected.upper);
  }
}

TEST(RlodTreeFile, RaysMeetTheSame)
{
  const MeshExample e(90);
  const Folder folder;
  for (const Order order : orders)
  {
    RlodTreeFileContents contents = e.contents();
    contents.cellOf = {};
    contents.cells = {};
    contents.order = order;
    ASSERT_TRUE(writeRlodTreeFile(folder.file(), e.tree, e.mesh, contents));
    const RlodTreeFile file(folder.file());
    const ArrayView input = named(file.cells(), "cell").values;
    const auto tree = file.tree();
    const RlodTree& stored = *tree;
    EXPECT_EQ(stored.nodeCount(), e.tree.nodeCount());
    int hits = 0;
    for (const RayBundle& question : meshQuestions(120, 5))
      for (const double poe : {0.0, 2.0, 8.0})
      {
        RayBundle a = question, b = question;
        e.tree.cast(a, 3, poe);
        stored.cast(b, 3, poe);
        for (int i = 0; i < a.count; ++i)
        {
          ASSERT_EQ(a.t[i], b.t[i]);
          ASSERT_EQ(a.slot[i] == RayBundle::noHit, b.slot[i] == RayBundle::noHit);
          if (a.slot[i] == RayBundle::noHit)
            continue;
          ++hits;
          ASSERT_EQ(RlodTree::isLod(a.slot[i]), RlodTree::isLod(b.slot[i]));
          ASSERT_EQ(e.tree.inputIndex(a.slot[i]), input.value(stored.inputIndex(b.slot[i])));
          ASSERT_EQ(e.tree.normal(a.slot[i]), stored.normal(b.slot[i]));
        }
      }
    EXPECT_GT(hits, 1000);
    // R-LODs have the same means.
    const auto mean = [](const RlodTree& tree, const auto& value)
    {
      std::vector<float> means = tree.lodMeans(
        1, [&](std::uint64_t triangle, double* values) { values[0] = value(triangle); });
      std::vector<float> found;
      for (const std::uint64_t slot : tree.lodSlots())
        found.push_back(means[RlodTree::lodPlace(slot)]);
      std::sort(found.begin(), found.end());
      return found;
    };
    EXPECT_EQ(mean(e.tree, [](std::uint64_t t) { return std::sin(double(t)); }),
      mean(stored, [&](std::uint64_t t) { return std::sin(input.value(t)); }));
    EXPECT_FALSE(tree->refit(e.mesh)); // the file stays what it is
  }
}

TEST(RlodTreeFile, HoldsMeansOfItsArrays)
{
  const MeshExample e;
  const Folder folder;
  for (const Order order : orders)
  {
    RlodTreeFileContents contents = e.contents();
    contents.order = order;
    contents.points.push_back({"way", ArrayView(e.normals.data(), e.height.size(), 3), {}});
    ASSERT_TRUE(writeRlodTreeFile(folder.file(), e.tree, e.mesh, contents));
    const RlodTreeFile file(folder.file());
    const auto tree = file.tree();
    const MeshCorners& corners = *file.corners();
    const auto expectSame = [&](const ArrayView& values, int component, bool ofPoints)
    {
      const ArrayView stored = tree->storedMeans(values, component);
      const std::vector<float> made = tree->lodMeans(1,
        [&](std::uint64_t t, double* value)
        {
          *value = !ofPoints ? values.value(t, component)
                             : (values.value(corners[t][0], component) +
                                 values.value(corners[t][1], component) +
                                 values.value(corners[t][2], component)) /
                                 3.0;
        });
      ASSERT_EQ(stored.count(), made.size());
      for (const std::uint64_t slot : tree->lodSlots())
      {
        const std::uint64_t place = RlodTree::lodPlace(slot);
        ASSERT_EQ(stored.value(place), double(made[place]));
      }
    };
    expectSame(named(file.points(), "h").values, 0, true);
    for (const int component : {0, 1, 2, ArrayView::magnitude})
      expectSame(named(file.points(), "way").values, component, true);
    expectSame(named(file.cells(), "part").values, 0, false);
    // Nobody colours by these.
    EXPECT_TRUE(tree->storedMeans(named(file.points(), "Normals").values, 0).empty());
    EXPECT_TRUE(tree->storedMeans(named(file.points(), "point").values, 0).empty());
    EXPECT_TRUE(e.tree.storedMeans(contents.points[0].values, 0).empty());
  }
}

TEST(RlodTreeFile, PagesHoldWhatRaysReadTogether)
{
  const MeshExample e(300);
  const Folder folder;
  std::vector<std::size_t> pages;
  for (const Order order : {Order::ByError, Order::DepthFirst})
  {
    RlodTreeFileContents contents;
    contents.places = e.triangles.pointView();
    contents.order = order;
    ASSERT_TRUE(writeRlodTreeFile(folder.file(), e.tree, e.mesh, contents));
    const RlodTreeFile file(folder.file());
    const auto tree = file.tree();
    RlodTree::Counts counts;
    counts.seenPlanes.resize(tree->nodeCount());
    tree->setSparesMemory(true);
    const CameraRays rays(lookAt({0.0, 0.0, 5.0}, Vec3d(0.0), 30.0), 64, 64);
    for (int y = 0; y < 64; y += 16)
      for (int x = 0; x < 64; x += 16)
      {
        RayBundle bundle;
        rays.fillBundle(bundle, 16, x, y, 0.0, 0.0);
        tree->cast(bundle, 0, 2.0, counts);
      }
    std::vector<bool> seen(counts.seenPlanes.size() / 10 + 1);
    for (std::size_t k = 0; k < counts.seenPlanes.size(); ++k)
      if (counts.seenPlanes[k])
        seen[k / 10] = true;
    pages.push_back(static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true)));
  }
  EXPECT_GT(pages[0], 10u);
  EXPECT_LT(1.2 * static_cast<double>(pages[0]), static_cast<double>(pages[1]));
}

TEST(RlodTreeFile, ErrorsAreSentences)
{
  const MeshExample e(10);
  const Folder folder;
  const auto expect = [&](const char* what, const RlodTree& tree, const auto& change)
  {
    RlodTreeFileContents contents = e.contents();
    change(contents);
    try
    {
      writeRlodTreeFile(folder.file(), tree, e.mesh, contents);
      ADD_FAILURE() << what;
    }
    catch (const Error& error)
    {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
    EXPECT_TRUE(folder.empty());
  };
  RlodTree plain;
  plain.build(e.mesh);
  expect("levels of detail", plain, [](RlodTreeFileContents&) {});
  expect("no triangles", RlodTree(), [](RlodTreeFileContents&) {});
  expect("Two arrays", e.tree, [](RlodTreeFileContents& c) { c.points[1].name = "h"; });
  expect("Two arrays", e.tree, [](RlodTreeFileContents& c) { c.cellIndices = "part"; });
  expect("needs a name", e.tree, [](RlodTreeFileContents& c) { c.points[1].name = ""; });
  expect("places of the points", e.tree, [](RlodTreeFileContents& c) { c.places = {}; });
  expect("one cell for each", e.tree,
    [](RlodTreeFileContents& c)
    { c.cellOf = ArrayView(c.cellOf.data(), c.cellOf.type(), c.cellOf.count() - 1, 1); });
  expect("5 values for 183 points", e.tree,
    [](RlodTreeFileContents& c) {
      c.points[0].values = ArrayView(static_cast<const float*>(c.points[0].values.data()), 5, 1);
    });
  // Stopped: nothing is left.
  EXPECT_FALSE(writeRlodTreeFile(
    folder.file(), e.tree, e.mesh, e.contents(), [](double done) { return done < 0.3; }));
  EXPECT_TRUE(folder.empty());
}

TEST(RlodTreeFile, NumbersInFilesStayTheSame)
{
  // Files of earlier versions have these.
  const Patient p;
  EXPECT_EQ(std::string(p.bytes.begin(), p.bytes.begin() + 8), "MOTETRI\n");
  EXPECT_EQ(p.header.version, 1u);
  for (const FileTableRow& row : p.table.rows)
  {
    const std::string& name = row.array.name;
    EXPECT_EQ(row.entry.role, name == "box"                      ? 1u
                              : name == "part" || name == "cell" ? 2u
                                                                 : 0u)
      << name;
  }
}
