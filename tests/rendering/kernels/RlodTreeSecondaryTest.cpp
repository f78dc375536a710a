// Rays that begin or end on surfaces, at the R-LODs of an RlodTree.

#include "LodParts.h"

#include <support/Targets.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Sets where points lie on the unit sphere; a closed mesh that is convex.
Triangles smoothSphere(int rings)
{
  Triangles sphere = bumpySphere(rings);
  sphere.move([](const Vec3d& p) { return glm::normalize(p); });
  return sphere;
}

bool isHit(double t)
{
  return t < 0.0;
}

struct Answers
{
  std::size_t rays = 0, met = 0, missed = 0, invented = 0;
};

/// Asks for anything in the way of rays, exactly and with an error.
void compare(const RlodTree& tree, const RayBundle& question, double poe, Answers& answers)
{
  RayBundle exact = question, rough = question;
  tree.occlude(exact, 0);
  tree.occlude(rough, 0, poe);
  int i = 0;
  for (RayPacket& packet : packetsOf(question))
  {
    tree.occlude(packet, 0, poe);
    for (int k = 0; k < packet.count; ++k, ++i)
    {
      ++answers.rays;
      answers.met += isHit(exact.t[i]);
      for (const bool met : {isHit(rough.t[i]), isHit(packet.t[k])})
      {
        answers.missed += isHit(exact.t[i]) && !met;
        answers.invented += !isHit(exact.t[i]) && met;
      }
    }
  }
}

void expectNothingMissed(const Triangles& triangles, int bundles, std::uint64_t seed)
{
  const RlodTree tree = treeWithLods(triangles);
  std::size_t invented = 0;
  for (const double poe : {0.3, 1.0, 4.0, 16.0})
  {
    SCOPED_TRACE(poe);
    Answers answers;
    for (const RayBundle& question : endlessQuestions(bundles, seed))
      compare(tree, question, poe, answers);
    EXPECT_EQ(answers.missed, 0u) << "of " << answers.met << " of " << answers.rays << " rays";
    EXPECT_GT(answers.met, answers.rays / 10);
    invented += answers.invented;
  }
  EXPECT_GT(invented, 0u) << "R-LODs are larger than their triangles: were they taken at all?";
}

/// Hits of the pixels of a picture.
struct Seen
{
  Vec3d at;
  double width;
  std::uint64_t slot;
};
std::vector<Seen> seenBy(const RlodTree& tree, const Camera& camera, double poe)
{
  constexpr int size = 192;
  const CameraRays rays(camera, size, size);
  std::vector<Seen> seen;
  for (int y = 0; y < size; y += 16)
    for (int x = 0; x < size; x += 16)
    {
      RayBundle bundle;
      rays.fillBundle(bundle, 16, x, y, 0.0, 0.0);
      tree.cast(bundle, 0, poe);
      for (int i = 0; i < bundle.count; ++i)
        if (bundle.object[i] == 0)
          seen.push_back({bundle.originOf(i) + bundle.t[i] * bundle.directionOf(i),
            bundle.footprint + bundle.t[i] * bundle.footprintPerT, bundle.slot[i]});
    }
  return seen;
}

/// How far a ray goes before it has left an R-LOD behind: as MeshSurface has it.
double clearanceOf(const RlodTree& tree, std::uint64_t slot, double cosine)
{
  if (!RlodTree::isLod(slot))
    return 1e-5 / cosine;
  const RlodTree::Lod lod = tree.lod(slot);
  return 1e-5 / cosine +
         2.0 * tree.unit() * std::min(double(lod.deviation) / cosine, double(lod.error));
}

/// Rays from what is seen of a sphere about the origin, outwards; `visit` gets them in packets.
template <typename Visit>
void leave(const RlodTree& tree, const std::vector<Seen>& seen, double least, const Visit& visit)
{
  Random random(11);
  RayPacket packet = emptyPacket();
  packet.onSurface = OnSurface::Start;
  packet.footprint = infinity;
  for (const Seen& from : seen)
  {
    const Vec3d outward = glm::normalize(from.at);
    Vec3d way = random.direction();
    if (glm::dot(way, outward) < least)
      way = glm::normalize(way + (least - glm::dot(way, outward) + 0.01) * outward);
    const double cosine = glm::dot(way, outward);
    packet.footprint = std::min(packet.footprint, from.width);
    addRay(packet, from.at, way, clearanceOf(tree, from.slot, cosine));
    if (packet.count < RayPacket::capacity && &from != &seen.back())
      continue;
    visit(packet);
    packet.count = 0;
    packet.footprint = infinity;
  }
}

const Camera aside = lookAt({1.0, 2.0, 5.0}, Vec3d(0.0), 30.0);
const Camera near = lookAt({0.4, 0.6, 1.7}, Vec3d(0.0), 30.0);

} // namespace

TEST(RlodTreeSecondary, NothingInTheWayIsMissed)
{
  expectNothingMissed(bumpySphere(60), 30, 1);
  expectNothingMissed(randomTriangles(2000, 3, 0.1), 20, 4);
}

TEST(RlodTreeSecondary, EveryInstructionSetMissesNothing)
{
  const Triangles sphere = bumpySphere(24);
  for (const std::int64_t target : everyTarget())
  {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnlyTargets only(target);
    expectNothingMissed(sphere, 12, 5);
  }
}

TEST(RlodTreeSecondary, IsExactWithoutFootprints)
{
  const RlodTree tree = treeWithLods(bumpySphere(40));
  for (RayBundle& question : endlessQuestions(20, 6))
  {
    question.footprint = question.footprintPerT = 0.0;
    Answers answers;
    compare(tree, question, 16.0, answers);
    EXPECT_EQ(answers.missed + answers.invented, 0u);
  }
}

TEST(RlodTreeSecondary, ConvexSurfacesAreNotInTheirOwnWay)
{
  const RlodTree tree = treeWithLods(smoothSphere(200));
  for (const double poe : {1.0, 4.0, 8.0})
    for (const double seenAt : {0.0, poe}) // hits on triangles, and on planes
    {
      SCOPED_TRACE(poe);
      std::size_t rays = 0, met = 0, lods = 0;
      const std::vector<Seen> seen = seenBy(tree, aside, seenAt);
      for (const Seen& hit : seen)
        lods += RlodTree::isLod(hit.slot);
      leave(tree, seen, 0.05,
        [&](RayPacket packet)
        {
          tree.occlude(packet, 0, poe);
          rays += static_cast<std::size_t>(packet.count);
          for (int i = 0; i < packet.count; ++i)
            met += isHit(packet.t[i]);
        });
      EXPECT_GT(rays, 1000u);
      // Planes reach beyond their triangles in the corners of boxes. Rays that begin on planes meet
      // few of these; such rays go together, since both kinds may err by as much.
      EXPECT_LE(double(met), (seenAt > 0.0 ? 0.008 : 0.03) * double(rays)) << "of " << rays;
      EXPECT_EQ(lods > 0, seenAt > 0.0);
    }
}

TEST(RlodTreeSecondary, RaysFromWithinAMeshMeetWhatIsAroundThem)
{
  // Two spheres, one in the other: whatever leaves the inner one meets the outer one.
  Triangles both = bumpySphere(100, Vec3d(0.0), 0.3);
  append(both, bumpySphere(100));
  const RlodTree tree = treeWithLods(both);
  for (const double poe : {1.0, 4.0, 16.0})
  {
    SCOPED_TRACE(poe);
    std::size_t rays = 0, missed = 0, lods = 0;
    double worst = 0.0;
    leave(tree, seenBy(treeOver(bumpySphere(100, Vec3d(0.0), 0.3)), near, 0.0), 0.7,
      [&](const RayPacket& question)
      {
        RayPacket packet = question;
        tree.cast(packet, 0, poe);
        rays += static_cast<std::size_t>(packet.count);
        for (int i = 0; i < packet.count; ++i)
        {
          missed += packet.object[i] != 0;
          if (!RlodTree::isLod(packet.slot[i]))
            continue;
          ++lods;
          worst = std::max(
            worst, tree.lod(packet.slot[i]).error * tree.unit() / (poe * packet.footprint));
        }
      });
    EXPECT_GT(rays, 500u);
    EXPECT_EQ(missed, 0u);
    EXPECT_LT(worst, 2.001) << "R-LODs err by at most two footprints a pixel of error";
    if (poe > 1.0)
    {
      EXPECT_GT(lods, poe > 4.0 ? rays / 2 : rays / 50);
    }
  }
}

TEST(RlodTreeSecondary, WideAndNarrowBundlesOfShadowRaysAgreeWithTheReference)
{
  // Rays that lie far apart beside the triangles go in packets, others as a bundle.
  const Triangles few = bumpySphere(6), many = bumpySphere(60);
  for (const Triangles* triangles : {&few, &many})
  {
    const RlodTree tree = treeOver(*triangles);
    const TriangleOracle oracle(*triangles);
    EXPECT_EQ(checkMesh(tree, oracle, meshQuestions(6, 21)).complaint, "");
  }
}
