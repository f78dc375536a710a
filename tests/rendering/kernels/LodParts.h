#pragma once

#include "MeshParts.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace mote::testing
{

/// The rays of a bundle in packets, with its footprints.
inline std::vector<RayPacket> packetsOf(const RayBundle& bundle)
{
  std::vector<RayPacket> packets;
  for (int i = 0; i < bundle.count; ++i)
  {
    if (i % RayPacket::capacity == 0)
    {
      packets.push_back(emptyPacket());
      packets.back().footprint = bundle.footprint;
      packets.back().footprintPerT = bundle.footprintPerT;
    }
    addRay(packets.back(), bundle.originOf(i), bundle.directionOf(i), bundle.tMin, bundle.t[i]);
  }
  return packets;
}

/// Bundles of meshQuestions() whose rays end nowhere.
inline std::vector<RayBundle> endlessQuestions(int count, std::uint64_t seed)
{
  std::vector<RayBundle> questions = meshQuestions(count, seed);
  for (RayBundle& question : questions)
    std::fill_n(question.t, question.count, std::numeric_limits<double>::infinity());
  return questions;
}

/// What R-LODs did to some rays.
struct LodErrors
{
  std::size_t rays = 0, lods = 0;
  std::size_t holes = 0; ///< rays that hit or are stopped exactly, and are not with an error
  double worst = 0.0; ///< distance of a hit on an R-LOD from its triangles, over its error radius
  double tooCoarse = 0.0; ///< greatest error radius over what was allowed where the hit is
};

/// Judges a hit: it may be anywhere near the triangles that the R-LOD stands for.
inline void judgeHit(
  const RlodTree& tree, std::uint64_t slot, const Vec3d& at, double allowed, LodErrors& errors)
{
  if (!RlodTree::isLod(slot))
    return;
  constexpr double rounding = 2e-6; // where triangles have no size
  ++errors.lods;
  const RlodTree::Lod lod = tree.lod(slot);
  const Vec3d local = (at - tree.origin()) / tree.unit();
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::uint64_t below : tree.slotsBelow(slot))
  {
    const auto corners = tree.localCorners(below);
    nearest = std::min(
      nearest, distanceFrom({Vec3d(corners[0]), Vec3d(corners[1]), Vec3d(corners[2])}, local));
  }
  errors.worst = std::max(errors.worst, nearest / (double(lod.error) + rounding));
  errors.tooCoarse = std::max(errors.tooCoarse, lod.error * tree.unit() / allowed);
}

/// Casts rays exactly and with an error, and looks for anything in their way likewise; judges all.
template <typename Rays, typename RayOf>
void judgeLods(
  const RlodTree& tree, const Rays& question, const RayOf& rayAt, double poe, LodErrors& errors)
{
  Rays exact = question, rough = question, exactDark = question, roughDark = question;
  tree.cast(exact, 0);
  tree.cast(rough, 0, poe);
  tree.occlude(exactDark, 0);
  tree.occlude(roughDark, 0, poe);
  for (int i = 0; i < question.count; ++i)
  {
    const double width = question.footprint + rough.t[i] * question.footprintPerT;
    errors.rays += 2;
    errors.holes += exact.object[i] == 0 && rough.object[i] != 0;
    errors.holes += exactDark.t[i] < 0.0 && !(roughDark.t[i] < 0.0);
    if (rough.object[i] == 0)
      judgeHit(tree, rough.slot[i], rayAt(i, rough.t[i]), poe * width, errors);
  }
}

inline void judgeLods(
  const RlodTree& tree, const RayPacket& question, double poe, LodErrors& errors)
{
  const auto at = [&](int i, double t)
  {
    const reference::Ray ray = rayOf(question, i);
    return ray.origin + t * ray.direction;
  };
  judgeLods(tree, question, at, poe, errors);
}

/// A bundle, and the same rays in packets.
inline void judgeLods(
  const RlodTree& tree, const RayBundle& question, double poe, LodErrors& errors)
{
  const auto at = [&](int i, double t)
  { return question.originOf(i) + t * question.directionOf(i); };
  judgeLods(tree, question, at, poe, errors);
  for (const RayPacket& packet : packetsOf(question))
    judgeLods(tree, packet, poe, errors);
}

} // namespace mote::testing
