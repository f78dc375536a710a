// The published structure of R-LODs, a peer of the benchmark, judged by brute force.

#include "../rendering/kernels/MeshParts.h"

#include <support/Targets.h>
#include <triangles/paper/ClippedTriangle.h>
#include <triangles/paper/RlodPaperTree.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace mote;
using namespace mote::bench;
using namespace mote::testing;

namespace
{

using Rule = RlodPaperTree::Rule;

RlodPaperTree paperTreeOver(const Triangles& triangles, Rule rule = Rule::Published)
{
  RlodPaperTree tree;
  tree.build(triangles.mesh());
  tree.makeLods();
  tree.setRule(rule);
  return tree;
}

/// The tree, whose rays go through it alone.
struct SingleRays
{
  const RlodPaperTree& tree;

  template <typename Rays>
  void cast(Rays& rays, std::int32_t object) const
  {
    tree.cast(rays, object, 0.0, 1);
  }
  template <typename Rays>
  void occlude(Rays& rays, std::int32_t object) const
  {
    tree.occlude(rays, object, 1);
  }
  std::uint64_t inputIndex(std::uint64_t slot) const { return tree.inputIndex(slot); }
};

void expectRight(const Triangles& triangles, int bundles, std::uint64_t seed)
{
  const RlodPaperTree tree = paperTreeOver(triangles);
  EXPECT_EQ(tree.size(), triangles.size());
  const TriangleOracle oracle(triangles);
  const std::vector<RayBundle> questions = meshQuestions(bundles, seed);
  CastReport report = checkMesh(tree, oracle, questions);
  report.add(checkMesh(SingleRays{tree}, oracle, questions));
  EXPECT_EQ(report.wrong, 0u) << "of " << report.rays << " rays; " << report.complaint;
  EXPECT_GT(double(report.hits), 0.05 * double(report.rays));
}

/// Calls visit(node, low, high, depth) for every node.
template <typename Visit>
void forNodes(const RlodPaperArrays& a, std::uint32_t index, Vec3f low, Vec3f high, int depth,
  const Visit& visit)
{
  visit(index, low, high, depth);
  const RlodPaperNode node = a.nodes[index];
  if (node.isLeaf())
    return;
  Vec3f lowerHigh = high, upperLow = low;
  lowerHigh[node.axis()] = upperLow[node.axis()] = node.split();
  forNodes(a, node.first(), low, lowerHigh, depth + 1, visit);
  forNodes(a, node.first() + 1, upperLow, high, depth + 1, visit);
}

double areaOf(const ClippedTriangle& t)
{
  Vec3d sum(0.0);
  for (int k = 2; k < t.count(); ++k)
    sum += 0.5 * glm::cross(t.point(k - 1) - t.point(0), t.point(k) - t.point(0));
  return glm::length(sum);
}

struct LodCounts
{
  std::size_t rays = 0, holes = 0, lods = 0;
  double most = 0.0; ///< distance of a hit from what its R-LOD stands for, over its error
};

/// Casts views with pixels of error, packets and single rays, beside the exact picture.
LodCounts castWithError(const RlodPaperTree& tree, double poe)
{
  LodCounts counts;
  Random random(71);
  for (int view = 0; view < 6; ++view)
  {
    const CameraRays rays(lookAt(random(2.0, 4.0) * random.direction(), Vec3d(0.0), 40.0), 64, 64);
    for (int y = 0; y < 64; y += 16)
      for (int x = 0; x < 64; x += 16)
      {
        RayBundle exact;
        rays.fillBundle(exact, 16, x, y, 0.0, 0.0);
        RayBundle rough[2] = {exact, exact};
        tree.cast(exact, 0);
        tree.cast(rough[0], 0, poe);
        tree.cast(rough[1], 0, poe, 1);
        for (const RayBundle& bundle : rough)
          for (int i = 0; i < exact.count; ++i)
          {
            ++counts.rays;
            counts.holes += exact.object[i] == 0 && bundle.object[i] != 0;
            if (bundle.object[i] != 0 || !RlodPaperTree::isLod(bundle.slot[i]))
              continue;
            ++counts.lods;
            const Vec3d at =
              (bundle.originOf(i) + bundle.t[i] * bundle.directionOf(i) - tree.origin()) /
              tree.unit();
            double nearest = 1e30;
            for (const std::uint64_t slot : tree.slotsBelow(bundle.slot[i]))
            {
              const auto c = tree.localCorners(slot);
              nearest =
                std::min(nearest, distanceFrom({Vec3d(c[0]), Vec3d(c[1]), Vec3d(c[2])}, at));
            }
            counts.most = std::max(counts.most, nearest / double(tree.error(bundle.slot[i])));
          }
      }
  }
  return counts;
}

} // namespace

TEST(ClippedTriangle, PartsOfAGridOfBoxesAreTheWhole)
{
  Random random(72);
  for (int round = 0; round < 200; ++round)
  {
    const auto point = [&] { return random.inBox(Vec3d(-1.0), Vec3d(1.0)); };
    const ClippedTriangle whole{point(), point(), point()};
    double area = 0.0;
    for (int x = 0; x < 3; ++x)
      for (int y = 0; y < 3; ++y)
        for (int z = 0; z < 3; ++z)
        {
          constexpr float bounds[] = {-1.0f, -0.3f, 0.2f, 1.0f};
          const float low[3] = {bounds[x], bounds[y], bounds[z]};
          const float high[3] = {bounds[x + 1], bounds[y + 1], bounds[z + 1]};
          ClippedTriangle part = whole;
          part.clip(low, high);
          for (int k = 0; k < part.count(); ++k)
            for (int axis = 0; axis < 3; ++axis)
            {
              EXPECT_GE(part.point(k)[axis], low[axis] - 1e-12);
              EXPECT_LE(part.point(k)[axis], high[axis] + 1e-12);
            }
          area += areaOf(part);
        }
    EXPECT_NEAR(area, areaOf(whole), 1e-12);
  }
}

TEST(RlodPaperTree, AgreesWithTheReference)
{
  expectRight(randomTriangles(300, 1, 0.3), 40, 81);
  expectRight(randomTriangles(3000, 2, 0.05), 9, 82);
  expectRight(bumpySphere(20), 24, 83);
}

TEST(RlodPaperTree, EveryInstructionSetAgreesWithTheReference)
{
  const Triangles sphere = bumpySphere(16), loose = randomTriangles(200, 3, 0.4);
  for (const std::int64_t target : everyTarget())
  {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnlyTargets only(target);
    expectRight(sphere, 12, 84);
    expectRight(loose, 12, 85);
  }
}

TEST(RlodPaperTree, TakesSliversDuplicatesAndDegenerateTriangles)
{
  Random random(4);
  Triangles all = randomTriangles(100, 5, 0.2);
  for (int i = 0; i < 100; ++i)
  {
    const Vec3d a = random.inBox(Vec3d(-1.0), Vec3d(1.0)), way = random.direction();
    all.add(a, a + way, a + 0.5 * way + std::pow(10.0, random(-9.0, -2.0)) * random.direction());
    all.add(a, a + way, i % 2 == 0 ? a : a + way);
    all.add({-0.9, -0.9, 0.1}, {0.1, -0.8, 0.2}, {-0.3, 0.1, -0.2});
  }
  for (int i = 0; i < 50; ++i) // in one plane, over one another
  {
    const auto at = [&] { return Vec3d(random(-1.0, 1.0), random(-1.0, 1.0), 0.5); };
    const Vec3d a = at(), b = at();
    all.add(a, b, at());
  }
  expectRight(all, 40, 86);
}

TEST(RlodPaperTree, TakesNoneAndOne)
{
  RlodPaperTree tree = paperTreeOver(Triangles());
  RayPacket packet = emptyPacket();
  addRay(packet, {0.2, 0.2, 3.0}, {0.0, 0.0, -1.0});
  tree.cast(packet, 0, 4.0);
  EXPECT_EQ(packet.object[0], -1);
  Triangles one;
  one.add({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
  tree = paperTreeOver(one);
  tree.cast(packet, 0, 4.0);
  EXPECT_EQ(packet.object[0], 0);
  EXPECT_NEAR(packet.t[0], 3.0, 1e-6);
}

TEST(RlodPaperTree, SeesWhatTheDefaultTreeSees)
{
  const Triangles sphere = bumpySphere(100);
  const RlodTree other = treeOver(sphere);
  const RlodPaperTree tree = paperTreeOver(sphere);
  std::size_t hits = 0, differing = 0;
  for (const RayBundle& question : meshQuestions(120, 87))
  {
    RayBundle a = question, b = question;
    other.cast(a, 0);
    tree.cast(b, 0);
    for (int i = 0; i < question.count; ++i)
    {
      hits += a.object[i] == 0;
      differing += a.object[i] != b.object[i] ||
                   (a.object[i] == 0 && std::abs(a.t[i] - b.t[i]) > 1e-5 * std::max(1.0, a.t[i]));
    }
  }
  EXPECT_GT(hits, 3000u);
  EXPECT_LE(differing, hits / 1000); // at outlines
}

TEST(RlodPaperTree, NoRaySlipsThroughAClosedMesh)
{
  Triangles sphere = bumpySphere(60);
  Random crumple(88);
  sphere.move([&](const Vec3d& p) { return (1.0 + crumple(-0.2, 0.2)) * p; });
  const RlodPaperTree tree = paperTreeOver(sphere);
  std::size_t missed = 0, rays = 0;
  const auto ask = [&](const RayPacket& question)
  {
    for (const int together : {1, 16})
    {
      RayPacket packet = question, dark = question;
      tree.cast(packet, 0, 0.0, together);
      tree.occlude(dark, 0, together);
      for (int i = 0; i < packet.count; ++i)
        missed += (packet.object[i] != 0) + (dark.t[i] > 0.0);
      rays += 2 * static_cast<std::size_t>(packet.count);
    }
  };
  for (std::uint64_t k = 0; k < 2000; ++k)
  {
    Random random(1000 + k);
    RayPacket packet = emptyPacket();
    const Vec3d origin = random.inBox(Vec3d(-0.1), Vec3d(0.1));
    for (int i = 0; i < 32; ++i)
      addRay(packet, origin, random.direction());
    const auto corners = sphere.of(7 * k % sphere.size()); // and at corners and edges
    for (int i = 0; i < 16; ++i)
    {
      const double share = i < 4 ? 0.0 : random(0.0, 1.0);
      addRay(packet, origin,
        (1.0 - share) * corners[std::size_t(i % 3)] + share * corners[std::size_t((i + 1) % 3)] -
          origin);
    }
    ask(packet);
  }
  EXPECT_EQ(missed, 0u) << "of " << rays;
}

TEST(RlodPaperTree, LeavesNameTheTrianglesOfTheirCells)
{
  const Triangles sphere = bumpySphere(40);
  const RlodPaperTree tree = paperTreeOver(sphere);
  const RlodPaperArrays& a = tree.arrays();
  std::vector<double> area(a.triangles.size(), 0.0);
  double volume = 0.0, empty = 0.0;
  std::size_t references = 0;
  forNodes(a, 0, a.lower, a.upper, 0,
    [&](std::uint32_t index, const Vec3f& low, const Vec3f& high, int depth)
    {
      const RlodPaperNode node = a.nodes[index];
      const bool hasPlane = (a.words[index] & RlodPaperPlane::none) != RlodPaperPlane::none;
      EXPECT_EQ(hasPlane, !node.isLeaf() && depth % 3 == 0);
      if (!node.isLeaf())
        return;
      const Vec3d size(high - low);
      volume += size.x * size.y * size.z;
      if (node.value == 0)
        empty += size.x * size.y * size.z;
      references += node.value;
      for (std::uint32_t k = 0; k < node.value; ++k)
      {
        const std::uint32_t triangle = a.references[node.first() + k];
        const auto& [p, q, r] = a.triangles[triangle];
        ClippedTriangle part{Vec3d(p), Vec3d(q), Vec3d(r)};
        part.clip(&low.x, &high.x);
        EXPECT_GT(part.count(), 0);
        area[triangle] += areaOf(part);
      }
    });
  for (std::size_t k = 0; k < area.size(); ++k)
  {
    const auto& [p, q, r] = a.triangles[k];
    const double whole = areaOf(ClippedTriangle{Vec3d(p), Vec3d(q), Vec3d(r)});
    EXPECT_NEAR(area[k], whole, 1e-6 * whole + 1e-12); // no part is missing or named twice
  }
  EXPECT_GT(empty, 0.8 * volume); // cut off
  EXPECT_LT(references, 4 * sphere.size());
}

TEST(RlodPaperTree, TheClampedRuleLeavesNoHolesAndThePublishedOneDoes)
{
  const Triangles sphere = bumpySphere(80);
  const RlodPaperTree clamped = paperTreeOver(sphere, Rule::Clamped);
  const RlodPaperTree published = paperTreeOver(sphere);
  std::size_t holes = 0;
  for (const double poe : {0.5, 1.0, 2.0, 4.0, 16.0})
  {
    SCOPED_TRACE(poe);
    const LodCounts counts = castWithError(clamped, poe);
    EXPECT_EQ(counts.holes, 0u) << "of " << counts.rays;
    EXPECT_LT(counts.most, 2.0);
    if (poe >= 4.0)
    {
      EXPECT_GT(counts.lods, counts.rays / 100);
    }
    holes += castWithError(published, poe).holes;
  }
  EXPECT_GT(holes, 0u);
}

TEST(RlodPaperTree, EveryInstructionSetTakesTheSameLods)
{
  const RlodPaperTree tree = paperTreeOver(bumpySphere(40), Rule::Clamped);
  std::set<std::size_t> lods;
  for (const std::int64_t target : everyTarget())
  {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnlyTargets only(target);
    const LodCounts counts = castWithError(tree, 4.0);
    EXPECT_EQ(counts.holes, 0u);
    lods.insert(counts.lods);
  }
  EXPECT_LT(*lods.rbegin() - *lods.begin(), *lods.begin() / 100 + 1);
}
