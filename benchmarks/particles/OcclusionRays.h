#pragma once

#include "ParticleInput.h"

#include <kernels/core/Camera.h>
#include <kernels/core/RawVector.h>
#include <kernels/core/RayPacket.h>
#include <support/SphereTree.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstdint>
#include <vector>

namespace mote::bench
{

/// Rays from the surfaces that a camera sees into all directions, as ambient occlusion casts them:
/// those of neighbouring pixels stand side by side, and still have little in common. Every method
/// gets the same rays, all as far as `reach`; it answers which of them meet anything.
struct OcclusionRays
{
  static constexpr int packetRays = RayPacket::capacity;

  struct Packet
  {
    int count = 0; ///< rays in use, from the front
    double origin[3][packetRays];
    double direction[3][packetRays]; ///< of unit length
    float origin32[3][packetRays];   ///< relative to the middle of the input
    float direction32[3][packetRays];
    double left[3][packetRays]; ///< centre of the particle that the ray leaves
  };

  double reach = 0.0;
  std::size_t count = 0;
  RawVector<Packet> packets; ///< all full but the last
};

/// Adds a ray of unit direction that leaves the particle about `left`; float numbers count from
/// `middle`.
void addRay(OcclusionRays& rays, const Vec3d& origin, const Vec3d& direction, const Vec3d& left,
  const Vec3d& middle);

/// Two random numbers make a direction about the normal, weighted by the cosine: the normal and a
/// point of the unit sphere, added.
Vec3d cosineWeighted(const Vec3d& normal, double a, double b);

/// A bit a ray and a word a packet: whether the ray meets anything.
using OcclusionAnswers = std::vector<std::uint64_t>;

/// How far a ray of an OcclusionRays goes, in lengths of the longest side of the bounds.
constexpr double occlusionReach = 0.1;

/// Makes `raysPerHit` rays, their directions weighted by the cosine, from the nearest hit of the
/// ray through every pixel's centre. The tree is of the same input. The rays do not depend on the
/// number of threads.
OcclusionRays makeOcclusionRays(const reference::SphereTree& tree, const ParticleInput& input,
  const CameraRays& rays, int width, int height, int raysPerHit);

/// What the reference says.
OcclusionAnswers referenceAnswers(const reference::SphereTree& tree, const OcclusionRays& rays);

/// Calls visit(packet, place) for all packets in parallel, in tasks as large as those of images.
template <typename Visit>
void forPackets(const OcclusionRays& rays, const Visit& visit)
{
  constexpr std::size_t grain = 16; // 1024 rays
  tbb::parallel_for(
    tbb::blocked_range<std::size_t>(0, rays.packets.size(), grain),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t p = range.begin(); p != range.end(); ++p)
        visit(rays.packets[p], p);
    },
    tbb::simple_partitioner());
}

/// Calls answer(packet) for all packets likewise, and keeps the word that it returns.
template <typename Answer>
void forPackets(const OcclusionRays& rays, OcclusionAnswers& answers, const Answer& answer)
{
  forPackets(
    rays, [&](const OcclusionRays::Packet& packet, std::size_t p) { answers[p] = answer(packet); });
}

} // namespace mote::bench
