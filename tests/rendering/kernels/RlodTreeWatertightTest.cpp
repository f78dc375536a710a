// No ray slips through a closed mesh.

#include "MeshParts.h"

#include <support/Targets.h>

#include <gtest/gtest.h>

#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

/// A closed surface of crumpled, tiny and sliver triangles, all seen from the origin: a sphere
/// whose points are moved about along their directions, and round these a little.
Triangles crumpledSphere(int rings, double depth)
{
  Triangles sphere = bumpySphere(rings);
  Random random(31);
  sphere.move([&](const Vec3d& p) { return (1.0 + depth * random(-1.0, 1.0)) * p; });
  return sphere;
}

/// Asks about rays from the origin, in packets and bundles, nearest and any: each must hit.
struct Closed
{
  const RlodTree& tree;
  std::atomic<std::size_t> rays{0}, missed{0};

  template <typename Rays>
  void ask(Rays& asked)
  {
    Rays dark = asked;
    tree.cast(asked, 0);
    tree.occlude(dark, 0);
    for (int i = 0; i < asked.count; ++i)
    {
      rays += 2;
      missed += (asked.object[i] != 0) + (dark.t[i] > 0.0);
    }
  }
};

/// A bundle around a direction, so narrow that its rays are about as far apart as rounding.
RayBundle narrowBundle(const Vec3d& origin, const Vec3d& target, double width)
{
  const CameraRays rays(lookAt(origin, target, 60.0), 16, 16);
  RayBundle bundle;
  rays.fillBundle(bundle, 16, 0, 0, 0.0, 0.0);
  bundle.dx *= width;
  bundle.dy *= width;
  return bundle;
}

} // namespace

TEST(RlodTreeWatertight, RandomRaysFromWithinHitClosedMeshes)
{
  for (const std::int64_t target : everyTarget())
    for (const int rings : {6, 60, 300})
    {
      SCOPED_TRACE(hwy::TargetName(target));
      const OnlyTargets only(target);
      const Triangles sphere = crumpledSphere(rings, rings > 10 ? 0.2 : 0.5);
      const RlodTree tree = treeOver(sphere);
      Closed closed{tree};
      tbb::parallel_for(0, 1500,
        [&](int k)
        {
          Random random(1000 + static_cast<std::uint64_t>(k));
          RayPacket packet = emptyPacket();
          const Vec3d origin = random.inBox(Vec3d(-0.01), Vec3d(0.01));
          for (int i = 0; i < RayPacket::capacity; ++i)
            addRay(packet, origin, random.direction());
          closed.ask(packet);
          for (int i = 0; i < 8; ++i)
          {
            RayPacket single = emptyPacket();
            addRay(single, origin, random.direction());
            closed.ask(single);
          }
          if (k % 8 == 0)
          {
            RayBundle bundle = narrowBundle(origin, random.direction(), 1.0);
            closed.ask(bundle);
          }
        });
      EXPECT_EQ(closed.missed, 0u) << "of " << closed.rays << " rays, " << rings << " rings";
      EXPECT_GT(closed.rays, 300000u);
    }
}

TEST(RlodTreeWatertight, RaysThroughPointsOfCornersAndEdgesHitFromBothSides)
{
  for (const std::int64_t target : everyTarget())
  {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnlyTargets only(target);
    const Triangles sphere = crumpledSphere(120, 0.2);
    const RlodTree tree = treeOver(sphere);
    const TriangleMesh mesh = sphere.mesh();
    Closed closed{tree};
    tbb::parallel_for(std::size_t(0), sphere.size() / 6,
      [&](std::size_t t)
      {
        Random random(2000 + t);
        const auto corner = [&](int k) { return mesh.point(mesh.triangles()[6 * t][k]); };
        RayPacket packet = emptyPacket();
        const auto add = [&](const Vec3d& at)
        {
          // From the middle, from beside it, and from without towards the middle.
          const Vec3d beside = random.inBox(Vec3d(-0.1), Vec3d(0.1));
          addRay(packet, Vec3d(0.0), at);
          addRay(packet, beside, at - beside);
          addRay(packet, random(2.0, 5.0) * at, -at);
        };
        for (int k = 0; k < 3; ++k)
        {
          add(corner(k));
          const double share = random();
          add((1.0 - share) * corner(k) + share * corner((k + 1) % 3));
        }
        for (int i = 0; i < packet.count; ++i)
        {
          RayPacket single = emptyPacket();
          const reference::Ray ray = rayOf(packet, i);
          addRay(single, ray.origin, ray.direction);
          closed.ask(single);
        }
        closed.ask(packet);
      });
    EXPECT_EQ(closed.missed, 0u) << "of " << closed.rays << " rays";
    EXPECT_GT(closed.rays, 500000u);
  }
}

TEST(RlodTreeWatertight, RaysAtCornersAndEdgesHit)
{
  const Triangles sphere = crumpledSphere(40, 0.2);
  for (const std::int64_t target : everyTarget())
  {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnlyTargets only(target);
    const RlodTree tree = treeOver(sphere);
    Closed closed{tree};
    const TriangleMesh mesh = sphere.mesh();
    Random random(41);
    for (std::size_t t = 0; t < sphere.size(); t += 3)
    {
      const auto corner = [&](int k) { return mesh.point(mesh.triangles()[t][k]); };
      RayPacket packet = emptyPacket();
      for (const Vec3d& origin : {Vec3d(0.0), random.inBox(Vec3d(-0.1), Vec3d(0.1))})
      {
        for (int k = 0; k < 3; ++k)
          addRay(packet, origin, corner(k) - origin);
        for (const double share : {0.5, 0.25, random(0.0, 1.0)})
          addRay(packet, origin, (1.0 - share) * corner(0) + share * corner(1) - origin);
      }
      closed.ask(packet);
      // Rays as close as rounding about a corner and an edge.
      if (t % 30 == 0)
        for (const double width : {1.0, 1e-3, 1e-6, 1e-8})
        {
          RayBundle atCorner = narrowBundle(Vec3d(0.0), corner(0), width);
          closed.ask(atCorner);
          RayBundle atEdge = narrowBundle(Vec3d(0.0), 0.5 * (corner(0) + corner(1)), width);
          closed.ask(atEdge);
        }
    }
    EXPECT_EQ(closed.missed, 0u) << "of " << closed.rays << " rays";
  }
}

TEST(RlodTreeWatertight, RaysInThePlanesOfTrianglesHitWhatIsBehind)
{
  // A box of coplanar triangles, and rays that run within its walls' planes or along its edges.
  Triangles box;
  constexpr int cells = 8;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0})
      for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j)
        {
          const auto at = [&](int u, int v)
          {
            Vec3d p;
            p[axis] = side;
            p[(axis + 1) % 3] = 2.0 * u / cells - 1.0;
            p[(axis + 2) % 3] = 2.0 * v / cells - 1.0;
            return p;
          };
          box.add(at(i, j), at(i + 1, j), at(i, j + 1));
          box.add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        }
  const RlodTree tree = treeOver(box);
  Closed closed{tree};
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i <= cells; ++i)
      for (const double sign : {-1.0, 1.0})
      {
        RayPacket packet = emptyPacket();
        for (int j = 0; j <= cells; ++j)
        {
          Vec3d from, way(0.0);
          from[axis] = -3.0 * sign;
          way[axis] = sign;
          from[(axis + 1) % 3] = 2.0 * i / cells - 1.0;
          from[(axis + 2) % 3] = 2.0 * j / cells - 1.0;
          addRay(packet, from, way);
          way[(axis + 1) % 3] = 0.25 * way[axis] * (i < cells / 2 ? 1.0 : -1.0);
          addRay(packet, from - 0.5 * way, way);
        }
        RayPacket answers = packet;
        tree.cast(answers, 0);
        for (int k = 0; k < answers.count; k += 2)
        {
          ++closed.rays;
          closed.missed += answers.object[k] != 0;
          EXPECT_NEAR(answers.t[k], 2.0, 1e-5);
        }
      }
  EXPECT_EQ(closed.missed, 0u) << "of " << closed.rays;
}

TEST(RlodTreeWatertight, EveryViewFromWithinIsFull)
{
  const Triangles sphere = crumpledSphere(120, 0.1);
  const RlodTree tree = treeOver(sphere);
  Closed closed{tree};
  Random random(51);
  for (int view = 0; view < 12; ++view)
  {
    const Vec3d eye = random(0.0, 0.8) * random.direction();
    const CameraRays rays(lookAt(eye, random.direction(), view % 2 == 0 ? 150.0 : 60.0), 128, 128);
    for (int y = 0; y < 128; y += 16)
      for (int x = 0; x < 128; x += 16)
      {
        RayBundle bundle;
        rays.fillBundle(bundle, 16, x, y, 0.0, 0.0);
        closed.ask(bundle);
      }
  }
  EXPECT_EQ(closed.missed, 0u) << "of " << closed.rays << " rays";
}
