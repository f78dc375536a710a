// R-LODs of an RlodTree: the planes that stand for many triangles, and the bounds of their errors.

#include "MeshParts.h"

#include <kernels/meshes/detail/PatchSums.h>
#include <kernels/meshes/detail/RlodPlanes.h>
#include <kernels/meshes/detail/RlodTreeParts.h>
#include <support/Targets.h>

#include <gtest/gtest.h>

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace mote;
using namespace mote::testing;

namespace
{

/// A triangle in double, in the tree's coordinates.
using Corners = std::array<Vec3d, 3>;

std::vector<Corners> trianglesBelow(const RlodTree& tree, std::uint64_t slot)
{
  std::vector<Corners> all;
  for (const std::uint64_t below : tree.slotsBelow(slot))
  {
    const auto corners = tree.localCorners(below);
    all.push_back({Vec3d(corners[0]), Vec3d(corners[1]), Vec3d(corners[2])});
  }
  return all;
}

/// The integral of a function over triangles: from the middles of their edges, which is exact for
/// polynomials of degree two.
template <typename T>
T integral(const std::vector<Corners>& triangles, const std::function<T(const Vec3d&)>& f)
{
  T sum(0.0);
  for (const auto& [a, b, c] : triangles)
    sum += (glm::length(glm::cross(b - a, c - a)) / 6.0) *
           (f(0.5 * (a + b)) + f(0.5 * (b + c)) + f(0.5 * (c + a)));
  return sum;
}

Vec3d middleOf(const std::vector<Corners>& triangles)
{
  return integral<Vec3d>(triangles, [](const Vec3d& p) { return p; }) /
         integral<double>(triangles, [](const Vec3d&) { return 1.0; });
}

/// Calls check(lod, triangles) for every R-LOD of a tree.
template <typename Check>
void forLods(const RlodTree& tree, const Check& check)
{
  ASSERT_TRUE(tree.hasLods());
  const std::vector<std::uint64_t> slots = tree.lodSlots();
  EXPECT_EQ(slots.size(), tree.clusterCount() + tree.nodeCount() - 1);
  for (const std::uint64_t slot : slots)
    check(tree.lod(slot), trianglesBelow(tree, slot));
}

/// Checks that bounds hold for every R-LOD, and are not much larger than they must be.
void expectBounds(const RlodTree& tree)
{
  double loose = 0.0, count = 0.0;
  forLods(tree,
    [&](const RlodTree::Lod& lod, const std::vector<Corners>& triangles)
    {
      double away = 0.0, width = 0.0;
      Box box;
      for (const Corners& triangle : triangles)
        for (const Vec3d& p : triangle)
        {
          away = std::max(away, std::abs(glm::dot(Vec3d(lod.normal), p) - lod.offset));
          width = std::max(width, glm::length(p - triangles[0][0]));
          box.add(p);
        }
      EXPECT_LE(away, lod.deviation);
      EXPECT_LE(0.5 * width + away, lod.error);
      // Of half the box's diagonal: 256 steps of bounds, and a level.
      EXPECT_LT(lod.error, 2.2 * (0.5 * glm::length(box.size()) + lod.deviation) + 1e-5);
      EXPECT_NEAR(glm::length(Vec3d(lod.normal)), 1.0, 1e-6);
      loose += lod.deviation / (away + 1e-4);
      ++count;
    });
  EXPECT_LT(loose, 1.6 * count); // most are those of clusters, and exact
}

/// Clusters of `count` triangles over 16 points about `middle`, `size` large.
TriangleCluster randomCluster(Random& random, int count, const Vec3d& middle, double size)
{
  TriangleCluster cluster = {};
  cluster.count = static_cast<std::uint8_t>(count);
  for (int p = 0; p < 16; ++p)
  {
    const Vec3d at = middle + size * random.inBox(Vec3d(-1.0), Vec3d(1.0));
    for (int axis = 0; axis < 3; ++axis)
      cluster.point[axis][p] = static_cast<float>(at[axis]);
  }
  const auto corner = [&] { return static_cast<unsigned>(random(0.0, 15.99)); };
  for (int t = 0; t < count; ++t)
  {
    cluster.corners01[t] = static_cast<std::uint8_t>(corner() | corner() << 4);
    cluster.corner2[t % 8] =
      static_cast<std::uint8_t>(cluster.corner2[t % 8] | corner() << (t / 8 * 4));
  }
  return cluster;
}

void addTriangles(const TriangleCluster& cluster, std::vector<Corners>& to)
{
  for (int t = 0; t < cluster.count; ++t)
  {
    Corners corners;
    for (int k = 0; k < 3; ++k)
      for (int axis = 0; axis < 3; ++axis)
        corners[k][axis] = cluster.point[axis][cluster.corner(t, k)];
    to.push_back(corners);
  }
}

std::array<double, 6> momentsOf(const std::vector<Corners>& triangles)
{
  constexpr int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  const Vec3d middle = middleOf(triangles);
  std::array<double, 6> moments;
  for (int k = 0; k < 6; ++k)
    moments[k] = integral<double>(triangles,
      [&](const Vec3d& p) { return 2.0 * (p - middle)[pairs[k][0]] * (p - middle)[pairs[k][1]]; });
  return moments;
}

void expectSums(const PatchSums& sums, const std::vector<Corners>& triangles, double size)
{
  const double area = integral<double>(triangles, [](const Vec3d&) { return 1.0; });
  EXPECT_NEAR(sums.weight, 2.0 * area, 1e-12 * area);
  EXPECT_LT(glm::length(sums.middle - middleOf(triangles)), 1e-9 * size);
  const std::array<double, 6> moments = momentsOf(triangles);
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(sums.moments[k], moments[k], 1e-9 * area * size * size);
  Vec3d normal(0.0);
  for (const auto& [a, b, c] : triangles)
    normal += glm::cross(b - a, c - a);
  EXPECT_LT(glm::length(sums.normal - normal), 1e-12 * area);
}

double quadratic(const std::array<double, 6>& m, const Vec3d& v)
{
  return m[0] * v.x * v.x + m[1] * v.y * v.y + m[2] * v.z * v.z +
         2.0 * (m[3] * v.x * v.y + m[4] * v.x * v.z + m[5] * v.y * v.z);
}

} // namespace

TEST(RlodTreeLods, SumsOfPatchesAreThoseOfTheirTriangles)
{
  for (const std::int64_t target : everyTarget())
    for (const double size : {0.3, 1e-5})
    {
      SCOPED_TRACE(hwy::TargetName(target));
      const OnlyTargets only(target);
      Random random(1);
      std::vector<PatchSums> parts(16);
      std::vector<Corners> all;
      for (int k = 0; k < 16; ++k)
      {
        const Vec3d middle = random.inBox(Vec3d(0.5), Vec3d(0.5 + size));
        const TriangleCluster cluster = randomCluster(random, k + 1, middle, size);
        std::vector<Corners> own;
        addTriangles(cluster, own);
        addTriangles(cluster, all);
        sumClusters(&cluster, 1, &parts[static_cast<std::size_t>(k)]);
        expectSums(parts[static_cast<std::size_t>(k)], own, size);
      }
      expectSums(PatchSums::joined(parts.data(), 16), all, size);
    }
}

TEST(RlodTreeLods, NoDirectionHasLessSpreadThanTheLeastAxis)
{
  Random random(2);
  for (int k = 0; k < 600; ++k)
  {
    // Patches, needles and points: spreads of many magnitudes, or two or three of one.
    Vec3d spread(1.0, std::pow(10.0, random(-12.0, 0.0)), std::pow(10.0, random(-16.0, 0.0)));
    if (k % 5 == 0)
      spread.y = spread.x;
    if (k % 7 == 0)
      spread.z = spread.y;
    spread *= k % 11 == 0 ? 0.0 : std::pow(10.0, random(-20.0, 3.0));
    Vec3d a = random.direction(), b, c;
    acrossAxes(a, b, c);
    if (k % 3 == 0)
    {
      a = {1.0, 0.0, 0.0};
      b = {0.0, 1.0, 0.0};
      c = {0.0, 0.0, 1.0};
    }
    std::array<double, 6> m{};
    for (int i = 0; i < 3; ++i)
    {
      const Vec3d v = i == 0 ? a : i == 1 ? b : c;
      const double products[6] = {v.x * v.x, v.y * v.y, v.z * v.z, v.x * v.y, v.x * v.z, v.y * v.z};
      for (int j = 0; j < 6; ++j)
        m[j] += spread[i] * products[j];
    }
    const Vec3d towards = k % 13 == 0 ? Vec3d(0.0) : random.direction();
    const Vec3d axis = leastAxis(m.data(), towards);
    ASSERT_NEAR(glm::length(axis), 1.0, 1e-12) << k;
    EXPECT_GE(glm::dot(axis, towards), -1e-12);
    const double least = std::min({spread.x, spread.y, spread.z});
    EXPECT_LE(quadratic(m, axis), least * (1.0 + 1e-6) + 1e-10 * spread.x) << k;
  }
}

TEST(RlodTreeLods, BoundsHoldForEveryPlane)
{
  expectBounds(treeWithLods(bumpySphere(40)));
  expectBounds(treeWithLods(randomTriangles(3000, 3, 0.1)));
}

TEST(RlodTreeLods, PlanesAreThoseThatTheirTrianglesAreNearestTo)
{
  Random random(4);
  forLods(treeWithLods(bumpySphere(24)),
    [&](const RlodTree::Lod& lod, const std::vector<Corners>& triangles)
    {
      const Vec3d normal(lod.normal);
      EXPECT_NEAR(glm::dot(normal, middleOf(triangles)), lod.offset, 1e-6);
      const std::array<double, 6> moments = momentsOf(triangles);
      Vec3d sum(0.0);
      double weight = 0.0;
      for (const auto& [a, b, c] : triangles)
      {
        sum += glm::cross(b - a, c - a);
        weight += glm::length(glm::cross(b - a, c - a));
      }
      EXPECT_GE(glm::dot(sum, normal), 0.0);
      // Directions away from the mean normal count as worse.
      const double size = moments[0] + moments[1] + moments[2];
      const double penalty = 0.1 * size * std::pow(glm::length(sum) / weight, 4.0);
      const auto badness = [&](const Vec3d& d)
      {
        const double along = glm::dot(d, glm::normalize(sum));
        return quadratic(moments, d) + penalty * (1.0 - along * along);
      };
      for (int k = 0; k < 200; ++k)
        EXPECT_LE(badness(normal), badness(random.direction()) + 1e-7 * size);
    });
}

TEST(RlodTreeLods, PlanesOfBentStripsLieInTheSurface)
{
  // A strip of 8 x 1 cells, ten times as long as wide, bent by more than it is wide.
  Triangles strip;
  for (int i = 0; i <= 8; ++i)
    for (const double y : {0.0, 0.1})
      strip.addPoint({i / 8.0, y, 0.25 * std::sin(M_PI * i / 8.0)});
  for (std::int32_t i = 0; i < 16; i += 2)
  {
    strip.add(i, i + 2, i + 3);
    strip.add(i, i + 3, i + 1);
  }
  int planes = 0;
  forLods(treeWithLods(strip),
    [&](const RlodTree::Lod& lod, const std::vector<Corners>&)
    {
      EXPECT_GT(lod.normal.z, 0.7f);
      ++planes;
    });
  EXPECT_GT(planes, 0);
}

TEST(RlodTreeLods, PlanesOfFlatPatchesAreExact)
{
  const Vec3d normal = glm::normalize(Vec3d(1.0, -2.0, 3.0));
  Vec3d u, v;
  acrossAxes(normal, u, v);
  Random random(5);
  Triangles flat;
  constexpr int side = 60;
  for (int j = 0; j <= side; ++j)
    for (int i = 0; i <= side; ++i)
      flat.addPoint(
        Vec3d(7.0) + (i + 0.3 * random(0.0, 1.0)) * u + (j + 0.3 * random(0.0, 1.0)) * v);
  addGrid(flat, side);
  const RlodTree tree = treeWithLods(flat);
  const double offset = glm::dot(normal, Vec3d(7.0) - tree.origin()) / tree.unit();
  const double side1 = glm::dot(glm::cross(u, v), normal) > 0.0 ? 1.0 : -1.0;
  forLods(tree,
    [&](const RlodTree::Lod& lod, const std::vector<Corners>&)
    {
      EXPECT_LT(glm::length(Vec3d(lod.normal) - side1 * normal), 1e-5);
      EXPECT_NEAR(lod.offset, side1 * offset, 1e-5);
      EXPECT_LT(lod.deviation, 1e-5);
    });
}

TEST(RlodTreeLods, LevelsAreNeverBelowTheErrors)
{
  Random random(6);
  for (int k = 0; k < 2000; ++k)
  {
    const float least = static_cast<float>(std::pow(10.0, random(-7.0, 0.0)));
    const float most = k % 10 == 0 ? least : least * float(std::pow(10.0, random(0.0, 6.0)));
    const ErrorLevels levels(least, most);
    const double share = std::pow(double(most) / least, 1.0 / 31.0);
    for (int i = 0; i < 50; ++i)
    {
      const float error =
        i == 0   ? least
        : i == 1 ? most
                 : std::clamp(float(least * std::pow(most / least, random(0, 1))), least, most);
      const std::uint32_t level = levels.levelOf(error);
      ASSERT_LT(level, 32u);
      ASSERT_GE(levels.radius(level), error);
      // Even in a float's bits is within 6 % of even in the logarithm, a level each way.
      ASSERT_LE(levels.radius(level), error * share * share * 1.07);
    }
  }
}

TEST(RlodTreeLods, FollowPointsThatMove)
{
  Triangles sphere = bumpySphere(20);
  TriangleMesh mesh = sphere.mesh();
  RlodTree tree = treeWithLods(sphere);
  sphere.move(
    [](const Vec3d& p) { return Vec3d(p.x + 0.3 * std::sin(3.0 * p.z), 0.8 * p.y, p.z); });
  mesh.movePoints(sphere.pointView());
  ASSERT_TRUE(tree.refit(mesh));
  expectBounds(tree);
  tree.dropLods();
  EXPECT_FALSE(tree.hasLods());
  ASSERT_TRUE(tree.refit(mesh));
  EXPECT_FALSE(tree.hasLods());
}

TEST(RlodTreeLods, DoNotDependOnTheNumberOfThreads)
{
  const Triangles sphere = bumpySphere(90);
  RlodTree alone = treeOver(sphere), together = treeOver(sphere);
  tbb::task_arena(1).execute([&] { alone.makeLods(); });
  tbb::task_arena(4).execute([&] { together.makeLods(); });
  for (const std::uint64_t slot : alone.lodSlots())
  {
    const RlodTree::Lod a = alone.lod(slot), b = together.lod(slot);
    ASSERT_EQ(a.normal, b.normal);
    ASSERT_EQ(a.offset, b.offset);
    ASSERT_EQ(a.error, b.error);
    ASSERT_EQ(alone.inputIndex(slot), together.inputIndex(slot));
  }
}

TEST(RlodTreeLods, SpeakThroughTrianglesOfTheirOwn)
{
  const RlodTree tree = treeWithLods(bumpySphere(30));
  for (const std::uint64_t slot : tree.lodSlots())
  {
    const std::uint64_t speaker = tree.inputIndex(slot);
    const auto below = tree.slotsBelow(slot);
    EXPECT_TRUE(std::any_of(below.begin(), below.end(),
      [&](std::uint64_t triangle) { return tree.inputIndex(triangle) == speaker; }));
    std::uint64_t index = 0;
    float normal[3][1];
    float* const rows[3] = {normal[0], normal[1], normal[2]};
    tree.inputIndices(&slot, 1, &index);
    tree.normals(&slot, 1, rows);
    EXPECT_EQ(index, speaker);
    EXPECT_EQ(Vec3f(normal[0][0], normal[1][0], normal[2][0]), tree.normal(slot));
    const RlodTree::Lod lod = tree.lod(slot);
    EXPECT_LT(glm::length(tree.normal(slot) - lod.evenness * lod.normal), 1e-6f);
  }
}

TEST(RlodTreeLods, TellHowEvenlyTheirTrianglesLook)
{
  int uneven = 0;
  for (const Triangles& triangles : {bumpySphere(30), randomTriangles(900, 3, 0.2)})
    forLods(treeWithLods(triangles),
      [&](const RlodTree::Lod& lod, const std::vector<Corners>& below)
      {
        Vec3d sum(0.0);
        double area = 0.0;
        for (const Corners& c : below)
        {
          const Vec3d normal = glm::cross(c[1] - c[0], c[2] - c[0]);
          sum += normal;
          area += glm::length(normal);
        }
        const double evenness = std::max(0.25, glm::length(sum) / area);
        EXPECT_NEAR(lod.evenness, evenness, 1e-4);
        uneven += evenness < 0.5;
      });
  EXPECT_GT(uneven, 20);
}

TEST(RlodTreeLods, TakeFewBytesAndOnlyWhereTheyAre)
{
  const Triangles sphere = bumpySphere(150);
  RlodTree tree = treeOver(sphere);
  const auto perTriangle = [&] { return double(tree.bytes()) / double(sphere.size()); };
  EXPECT_LT(perTriangle(), 26.0);
  tree.makeLods();
  EXPECT_LT(perTriangle(), 30.0);
  tree.dropLods();
  EXPECT_LT(perTriangle(), 26.0);
}

TEST(RlodTreeLods, TakeDegenerateTrianglesAndNone)
{
  RlodTree none = treeWithLods({});
  EXPECT_FALSE(none.hasLods());
  Triangles bad;
  Random random(7);
  for (int i = 0; i < 300; ++i)
  {
    const Vec3d a = random.inBox(Vec3d(-1.0), Vec3d(1.0)),
                b = random.inBox(Vec3d(-1.0), Vec3d(1.0));
    bad.add(a, b, i % 3 == 0 ? a : b);
  }
  for (int i = 0; i < 40; ++i)
    bad.add(0, 0, 0);
  forLods(treeWithLods(bad),
    [](const RlodTree::Lod& lod, const std::vector<Corners>& triangles)
    {
      ASSERT_NEAR(glm::length(Vec3d(lod.normal)), 1.0, 1e-6);
      for (const Corners& triangle : triangles)
        for (const Vec3d& p : triangle)
          EXPECT_LE(std::abs(glm::dot(Vec3d(lod.normal), p) - lod.offset), lod.deviation);
    });
}
