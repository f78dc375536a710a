#pragma once

#include "SecondaryRays.h"

#include <kernels/core/RayBundle.h>
#include <kernels/core/RayPacket.h>

#include <algorithm>
#include <limits>

namespace mote::bench
{

/// Triangles and normals of hits that stand side by side.
template <typename Tree>
void describe(const Tree& tree, const std::uint64_t* slots, int count, TriangleImage::Block& block)
{
  float* const normals[3] = {block.normal[0], block.normal[1], block.normal[2]};
  std::uint64_t ids[16];
  tree.normals(slots, count, normals);
  tree.inputIndices(slots, count, ids);
  for (int k = 0; k < count; ++k)
    block.triangle[k] = static_cast<std::uint32_t>(ids[k]);
}

template <typename Tree>
void describeSome(const Tree& tree, const RayBundle& bundle, int first, TriangleImage::Block& block)
{
  std::uint64_t slots[16];
  int count = 0;
  for (int k = 0; k < 16; ++k)
    if (bundle.object[first + k] >= 0)
      slots[count++] = bundle.slot[first + k];
  describe(tree, slots, count, block);
  for (int k = 15; k >= 0; --k) // from the last: none is written over before it is moved
    if (bundle.object[first + k] >= 0)
    {
      --count;
      block.triangle[k] = block.triangle[count];
      for (auto& normal : block.normal)
        normal[k] = normal[count];
    }
}

/// Writes what a bundle of pixels has hit into an image.
template <typename Tree>
void keepHits(
  const Tree& tree, const RayBundle& bundle, int side, int x0, int y0, TriangleImage& image)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (int i = 0; i < bundle.count; i += 16)
  {
    int x = 0, y = 0;
    bundleOffset(side, i, x, y);
    TriangleImage::Block& block = image.blockAt(x0 + x, y0 + y);
    int hits = 0;
    for (int k = 0; k < 16; ++k)
    {
      hits += bundle.object[i + k] >= 0;
      block.t[k] = bundle.object[i + k] < 0 ? infinity : static_cast<float>(bundle.t[i + k]);
    }
    if (hits == 16)
      describe(tree, bundle.slot + i, 16, block);
    else if (hits > 0)
      describeSome(tree, bundle, i, block);
  }
}

/// Rays as the kernels take them.
inline void fillPacket(
  const SecondaryRays& rays, const OcclusionRays::Packet& asked, RayPacket& packet)
{
  packet.count = asked.count;
  packet.onSurface = OnSurface::Start;
  packet.footprint = rays.widthOf(asked);
  packet.footprintPerT = rays.widthPerLength;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::copy_n(asked.origin[axis], asked.count, packet.origin[axis]);
    std::copy_n(asked.direction[axis], asked.count, packet.direction[axis]);
  }
  std::fill_n(packet.tMin, asked.count, 0.0);
  std::fill_n(packet.t, asked.count, rays.rays.reach);
  std::fill_n(packet.slot, asked.count, RayPacket::noHit);
  std::fill_n(packet.object, asked.count, -1);
}

/// Answers which rays meet anything, by occlude(packet).
template <typename Occlude>
void occludePackets(const SecondaryRays& rays, OcclusionAnswers& answers, const Occlude& occlude)
{
  forPackets(rays.rays, answers,
    [&](const OcclusionRays::Packet& asked)
    {
      RayPacket packet;
      fillPacket(rays, asked, packet);
      occlude(packet);
      std::uint64_t bits = 0;
      for (int i = 0; i < asked.count; ++i)
        bits |= std::uint64_t{packet.t[i] < 0.0} << i;
      return bits;
    });
}

/// Finds what rays meet first, by cast(packet).
template <typename Tree, typename Cast>
void castPackets(
  const Tree& tree, const SecondaryRays& rays, std::vector<PacketHits>& hits, const Cast& cast)
{
  forPackets(rays.rays,
    [&](const OcclusionRays::Packet& asked, std::size_t place)
    {
      RayPacket packet;
      fillPacket(rays, asked, packet);
      cast(packet);
      std::uint64_t slots[RayPacket::capacity], ids[RayPacket::capacity];
      int found[RayPacket::capacity], count = 0;
      PacketHits& to = hits[place];
      for (int i = 0; i < asked.count; ++i)
      {
        const bool isHit = packet.object[i] >= 0;
        to.t[i] = isHit ? static_cast<float>(packet.t[i]) : std::numeric_limits<float>::infinity();
        slots[count] = packet.slot[i];
        found[count] = i;
        count += isHit;
      }
      float normals[3][RayPacket::capacity];
      float* const rows[3] = {normals[0], normals[1], normals[2]};
      tree.normals(slots, count, rows);
      tree.inputIndices(slots, count, ids);
      for (int k = 0; k < count; ++k)
      {
        to.triangle[found[k]] = static_cast<std::uint32_t>(ids[k]);
        for (int axis = 0; axis < 3; ++axis)
          to.normal[axis][found[k]] = normals[axis][k];
      }
    });
}

} // namespace mote::bench
