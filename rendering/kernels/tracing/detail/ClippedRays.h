#pragma once

#include "../../core/BundlePackets.h"
#include "../../core/ClipRegion.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace mote
{

/// Casts the parts of rays that lie in a region: calls visit(packet), which finds hits or
/// occluders, for rays with the ends of those parts, nearest parts first, and keeps the answers in
/// `rays`. rayOf(i) calls its argument with the origin and direction of ray i in the world, where t
/// is the same.
class ClippedPacket
{
public:
  template <typename RayOf>
  ClippedPacket(const ClipRegion& region, const RayPacket& rays, const RayOf& rayOf)
  {
    for (int i = 0; i < rays.count; ++i)
      rayOf(i, [&](const Vec3d& origin, const Vec3d& direction)
        { count_[i] = region.spansOf(origin, direction, rays.tMin[i], rays.t[i], spans_[i]); });
  }

  template <typename Visit>
  void cast(RayPacket& rays, const Visit& visit)
  {
    this->cast(rays, visit, [](RayPacket&, const bool*) {});
  }

  /// Likewise, for the nearest hits on `surface`. Where a part begins in a solid that the region
  /// has cut, it meets the cut there: the hit is on that solid, and t the part's own begin.
  template <typename Surface>
  void castNearest(RayPacket& rays, const Surface& surface, std::int32_t index)
  {
    this->cast(
      rays, [&](RayPacket& part) { surface.cast(part, index); },
      [&](RayPacket& part, const bool* isCut)
      {
        if constexpr (Surface::isConvex)
          findCuts(surface, index, isCut, part);
      });
  }

private:
  template <typename Visit, typename Finish>
  void cast(RayPacket& rays, const Visit& visit, const Finish& finish)
  {
    for (int s = 0; s < ClipRegion::mostSpans; ++s)
      for (const bool keepsEnd : {true, false})
        if (RayPacket part; this->take(rays, s, keepsEnd, part))
        {
          visit(part);
          bool isCut[RayPacket::capacity];
          for (int k = 0; k < part.count; ++k)
            isCut[k] = part.tMin[k] > rays.tMin[ray_[k]];
          finish(part, isCut);
          this->keep(part, rays);
        }
  }

  /// A solid that holds the begin of a part is left by it within the solid's width: what the part
  /// meets until then is looked at, one after another.
  template <typename Surface>
  static void findCuts(
    const Surface& surface, std::int32_t index, const bool* isCut, RayPacket& part)
  {
    constexpr int mostMet = 256; // of solids that overlap
    RayPacket next = part;
    std::uint64_t last[RayPacket::capacity];
    bool isOpen[RayPacket::capacity];
    std::copy_n(isCut, part.count, isOpen);
    for (int round = 0; round < mostMet; ++round)
    {
      bool anyOpen = false;
      for (int k = 0; k < part.count; ++k)
      {
        const bool isMet = isOpen[k] && next.object[k] == index;
        // Something nearer than where the solid ends may have hidden that at first.
        isOpen[k] = isOpen[k] && (isMet ? !takeCut(surface, index, next, k, part) : round == 0);
        const double perLength = 1.0 / glm::length(wayOf(next, k));
        const double end = part.tMin[k] + surface.largestWidth() * perLength;
        const double at = isMet ? next.t[k] : part.tMin[k];
        isOpen[k] = isOpen[k] && (isMet ? at : part.t[k]) < end;
        anyOpen = anyOpen || isOpen[k];
        // Rounding may have the ray meet the same again.
        const bool isAgain = isMet && round > 0 && next.slot[k] == last[k];
        next.tMin[k] = isAgain ? at + surface.rounding() * perLength : at;
        next.t[k] = isOpen[k] ? end : -std::numeric_limits<double>::infinity();
        last[k] = std::exchange(next.slot[k], RayPacket::noHit);
        next.object[k] = -1;
      }
      if (!anyOpen)
        return;
      surface.cast(next, index);
    }
  }

  static Vec3d wayOf(const RayPacket& rays, int k)
  {
    return {rays.direction[0][k], rays.direction[1][k], rays.direction[2][k]};
  }

  /// Takes the solid that ray k of `next` has met where it holds the begin of the part.
  template <typename Surface>
  static bool takeCut(
    const Surface& surface, std::int32_t index, const RayPacket& next, int k, RayPacket& part)
  {
    const Vec3d origin(next.origin[0][k], next.origin[1][k], next.origin[2][k]);
    if (!surface.encloses(next.slot[k], origin + part.tMin[k] * wayOf(next, k)))
      return false;
    part.t[k] = part.tMin[k];
    part.slot[k] = next.slot[k];
    part.object[k] = index;
    return true;
  }

  /// Whether the end that lies on a surface is one of this part's.
  static bool isSameEnd(const RayPacket& rays, int i, const RaySpan& span)
  {
    return rays.onSurface == OnSurface::Start ? span.tIn <= rays.tMin[i] : span.tOut >= rays.t[i];
  }

  /// Makes a packet of the parts with that number. False where there are none.
  bool take(const RayPacket& rays, int s, bool keepsEnd, RayPacket& part)
  {
    part.count = 0;
    part.footprint = rays.footprint;
    part.footprintPerT = rays.footprintPerT;
    part.onSurface = keepsEnd ? rays.onSurface : OnSurface::Neither;
    for (int i = 0; i < rays.count; ++i)
    {
      const RaySpan& span = spans_[i][s];
      if (s >= count_[i] || isSameEnd(rays, i, span) != keepsEnd)
        continue;
      const int k = part.count++;
      ray_[k] = i;
      for (int axis = 0; axis < 3; ++axis)
      {
        part.origin[axis][k] = rays.origin[axis][i];
        part.direction[axis][k] = rays.direction[axis][i];
      }
      part.tMin[k] = span.tIn;
      part.t[k] = end_[k] = span.tOut;
      part.slot[k] = rays.slot[i];
      part.object[k] = rays.object[i];
    }
    return part.count > 0;
  }

  /// Rays that have met something have no parts behind it.
  void keep(const RayPacket& part, RayPacket& rays)
  {
    for (int k = 0; k < part.count; ++k)
    {
      if (!(part.t[k] < end_[k]))
        continue;
      const int i = ray_[k];
      rays.t[i] = part.t[k];
      rays.slot[i] = part.slot[k];
      rays.object[i] = part.object[k];
      count_[i] = 0;
    }
  }

  RaySpan spans_[RayPacket::capacity][ClipRegion::mostSpans];
  int count_[RayPacket::capacity];
  int ray_[RayPacket::capacity];
  double end_[RayPacket::capacity];
};

/// The same for a bundle: together, by visitBundle(bundle), where all begin in the region and do
/// not come back into it, else in packets, by visitPacket(clipped, packet). `world` tells where the
/// rays, whose x and y are those of the bundle, run in the world.
template <typename VisitBundle, typename VisitPacket>
void castClipped(const ClipRegion& region, const RayBundle& world, OnSurface onSurface,
  RayBundle& rays, const VisitBundle& visitBundle, const VisitPacket& visitPacket)
{
  const bool fan = world.kind == RayBundle::Kind::CommonOrigin;
  const auto aside = [&](int i)
  { return double(rays.x[i]) * world.dx + double(rays.y[i]) * world.dy; };
  const auto originOf = [&](int i) { return fan ? world.origin : world.origin + aside(i); };
  const auto wayOf = [&](int i) { return fan ? world.direction + aside(i) : world.direction; };
  double end[RayBundle::capacity];
  bool isTogether = true;
  for (int i = 0; isTogether && i < rays.count; ++i)
  {
    RaySpan spans[ClipRegion::mostSpans];
    const int count = region.spansOf(originOf(i), wayOf(i), rays.tMin, rays.t[i], spans);
    isTogether = count == 0 || (count == 1 && spans[0].tIn <= rays.tMin);
    // Where a ray was cut, its end lies on no surface.
    isTogether =
      isTogether && (onSurface == OnSurface::Neither || count == 0 || spans[0].tOut >= rays.t[i]);
    end[i] = count == 0 ? -std::numeric_limits<double>::infinity() : spans[0].tOut;
  }
  if (!isTogether)
  {
    askInPackets(rays, onSurface,
      [&](RayPacket& packet, int first)
      {
        ClippedPacket clipped(region, packet,
          [&](int i, const auto& with) { with(originOf(first + i), wayOf(first + i)); });
        visitPacket(clipped, packet);
      });
    return;
  }
  double before[RayBundle::capacity];
  std::copy_n(rays.t, rays.count, before);
  std::copy_n(end, rays.count, rays.t);
  visitBundle(rays);
  for (int i = 0; i < rays.count; ++i)
    if (!(rays.t[i] < end[i]))
      rays.t[i] = before[i];
}

} // namespace mote
