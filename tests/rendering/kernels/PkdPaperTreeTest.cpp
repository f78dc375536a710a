// What is the published P-k-d tree's own: its shape, its planes, its memory, and rays that run
// along them.

#include <kernels/particles/PkdPaperTree.h>
#include <kernels/particles/detail/HeapOrder.h>

#include <support/CastOracle.h>
#include <support/Particles.h>
#include <support/Structure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

/// Calls visit(node) for the nodes of the subtree at `node`, in order.
template <typename Visit>
void walkInOrder(std::size_t node, std::size_t count, const Visit& visit)
{
  if (node >= count)
    return;
  walkInOrder(2 * node + 1, count, visit);
  visit(node);
  walkInOrder(2 * node + 2, count, visit);
}

/// No particle lies on the wrong side of the plane of a node above it.
void expectOrdered(const PkdPaperTree& tree)
{
  for (std::size_t node = 0; 2 * node + 1 < tree.size(); ++node)
  {
    const int axis = tree.axis(node);
    ASSERT_LT(axis, 3);
    const double plane = tree.center(node)[axis];
    walkInOrder(2 * node + 1, tree.size(),
      [&](std::size_t i) { ASSERT_LE(tree.center(i)[axis], plane) << i << " below " << node; });
    walkInOrder(2 * node + 2, tree.size(),
      [&](std::size_t i) { ASSERT_GE(tree.center(i)[axis], plane) << i << " above " << node; });
  }
}

void expectRight(const Particles& particles, const PkdPaperTreeOptions& options = {})
{
  expectRightViews<PkdPaperTree>(particles, options);
}

/// Particles on the points of a lattice with `n` points a side and a distance of 1: most share each
/// coordinate with many others.
Particles lattice(int n, double radius)
{
  Particles particles;
  for (int i = 0; i < n * n * n; ++i)
    particles.add({double(i % n), double(i / n % n), double(i / n / n)}, radius);
  return particles;
}

} // namespace

TEST(HeapOrder, LeftSubtreesAreThoseOfLeftBalancedTrees)
{
  for (std::size_t count = 1; count < 300; ++count)
  {
    std::size_t left = 0;
    walkInOrder(1, count, [&](std::size_t) { ++left; });
    EXPECT_EQ(leftSubtreeSize(count), left) << count;
  }
}

TEST(HeapOrder, NodesInOrderComeIntoHeapOrder)
{
  std::vector<std::size_t> counts(260);
  for (std::size_t i = 0; i < counts.size(); ++i)
    counts[i] = i;
  for (const std::size_t more : {1023u, 1024u, 1025u, 5000u, 65535u, 65536u, 100000u, 777777u})
    counts.push_back(more);
  for (const std::size_t count : counts)
  {
    std::vector<std::uint32_t> nodes(count);
    for (std::size_t i = 0; i < count; ++i)
      nodes[i] = static_cast<std::uint32_t>(i);
    HeapOrder<std::uint32_t>::run(nodes.data(), count);
    std::uint32_t next = 0;
    walkInOrder(0, count, [&](std::size_t i) { ASSERT_EQ(nodes[i], next++) << "of " << count; });
    ASSERT_EQ(next, count);
  }
}

TEST(PkdPaperTree, PlanesPartWhatIsBelowThem)
{
  for (const auto split : {PkdTreeOptions::Split::MaximumExtent, PkdTreeOptions::Split::RoundRobin})
    for (const std::size_t count : {1u, 2u, 3u, 7u, 8u, 1000u, 70001u})
    {
      Particles particles = randomParticles(count, count, 0.01, 0.05);
      for (std::size_t i = 0; i < count / 2; ++i) // many coordinates that are the same
        particles.positions[3 * i + i % 3] = 0.25;
      PkdPaperTree tree;
      tree.build(particles.set(), {split, true});
      expectOrdered(tree);
    }
}

TEST(PkdPaperTree, SplitsAcrossTheLongestSideOrInTurn)
{
  const Particles particles =
    randomParticles(5000, 3, 0.01, 0.01, Vec3d(-1.0, -8.0, -1.0), Vec3d(1.0, 8.0, 1.0));
  PkdPaperTree tree;
  tree.build(particles.set());
  for (std::size_t node = 0; node < 7; ++node)
    EXPECT_EQ(tree.axis(node), 1); // halved three times, the side is as long as the others
  tree.build(particles.set(), {PkdTreeOptions::Split::RoundRobin, true});
  for (std::size_t node = 0; node < 100; ++node)
    EXPECT_EQ(tree.axis(node), (std::bit_width(node + 1) - 1) % 3);
}

TEST(PkdPaperTree, AnyNumberOfParticlesByEitherRule)
{
  PkdPaperTreeOptions turns;
  turns.split = PkdTreeOptions::Split::RoundRobin;
  for (const std::size_t count : {1u, 2u, 3u, 4u, 6u, 7u, 8u, 100u, 4095u, 4096u, 20000u})
  {
    expectRight(randomParticles(count, count, 0.02, 0.08));
    expectRight(randomParticles(count, count, 0.02, 0.02), turns);
  }
}

TEST(PkdPaperTree, GiantsAmongDwarfs)
{
  Random random(16);
  Particles particles;
  for (int i = 0; i < 20000; ++i)
    particles.add(random.inBox(Vec3d(-1.0), Vec3d(1.0)), std::pow(10.0, random(-5.0, -1.0)));
  expectRight(particles);
}

TEST(PkdPaperTree, RaysInPlanesAndFromThem)
{
  // In a lattice planes go through many centres. Rays along the axes run within them, and rays that
  // start at a centre start on three.
  const Particles particles = lattice(9, 0.3);
  PkdPaperTree tree;
  tree.build(particles.set());
  const CastOracle oracle = CastOracle::forFloat(particles.set());
  CastReport report;
  Random random(5);
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    RayPacket packet = emptyPacket();
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {-1.0, 1.0})
      {
        Vec3d along(0.0), slanting(0.0);
        along[axis] = sign;
        slanting[axis] = -sign;
        slanting[(axis + 1) % 3] = sign * random(0.1, 2.0);
        const Vec3d center = particles.center(i);
        addRay(packet, center, along);
        addRay(packet, center - 20.0 * along, along);
        addRay(packet, center + 0.5 * along, slanting);
        addRay(packet, center + Vec3d(0.3), along); // touches spheres at most
      }
    report.add(checkPacket(tree, oracle, packet));
  }
  EXPECT_EQ(report.wrong, 0u) << report.complaint;
  EXPECT_GT(report.hits, report.rays / 2);
}

TEST(PkdPaperTree, PacketsAndBundlesGiveTheSameAnswers)
{
  const Particles particles = randomParticles(20000, 21, 0.005, 0.03);
  PkdPaperTree tree;
  tree.build(particles.set());
  const CameraRays rays(lookAt({2.0, 1.0, 3.0}, Vec3d(0.0), 40.0), 16, 16);
  RayBundle bundle;
  rays.fillBundle(bundle, 8, 4, 4, 0.0, 0.0);
  ASSERT_EQ(bundle.count, RayPacket::capacity);
  RayPacket packet = emptyPacket();
  for (int i = 0; i < bundle.count; ++i)
    addRay(packet, bundle.originOf(i), bundle.directionOf(i), bundle.tMin, bundle.t[i]);
  RayBundle any = bundle;
  tree.cast(bundle, 1);
  tree.cast(packet, 1);
  tree.occlude(any, 1);
  int hits = 0;
  for (int i = 0; i < bundle.count; ++i)
  {
    EXPECT_EQ(bundle.t[i], packet.t[i]);
    EXPECT_EQ(bundle.slot[i], packet.slot[i]);
    EXPECT_EQ(bundle.object[i], packet.object[i]);
    EXPECT_EQ(any.t[i] < 0.0, bundle.object[i] == 1);
    hits += bundle.object[i] == 1;
  }
  EXPECT_GT(hits, 20);
}

TEST(PkdPaperTree, TakesTheCoordinatesAndTwoBitsANode)
{
  const Particles particles = randomParticles(200000, 14, 0.002, 0.004);
  ParticleSet set = particles.set();
  PkdPaperTree tree;
  tree.build(set);
  // Of the nodes half have children; radii of 128 treelets and what is above them.
  EXPECT_LT(double(tree.bytes()) / 200000.0, 20.0 + 0.125 + 0.01);
  set.radii = {};
  set.radius = 0.002;
  tree.build(set, {PkdTreeOptions::Split::MaximumExtent, false});
  EXPECT_EQ(tree.inputIndex(4321), 4321u); // the slot stands in
  PkdPaperTree fresh;
  fresh.build(set, {PkdTreeOptions::Split::MaximumExtent, false});
  EXPECT_LT(double(fresh.bytes()) / 200000.0, 12.0 + 0.125 + 0.01);
}
