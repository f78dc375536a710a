// Casting packets through a CoherentGrid, compiled once for every SIMD instruction set.

#include "CoherentGridView.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "particles/CoherentGridCast.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "CoherentGridCast-inl.h"

#if HWY_ONCE

namespace mote
{

HWY_EXPORT(castCoherent);

namespace
{

/// Major axis and sign of a direction as one number in [0, 6), or -1 for a direction of length 0.
int directionClass(const RayPacket& p, int i)
{
  double longest = 0.0;
  int found = -1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double d = p.direction[axis][i];
    if (std::abs(d) > longest)
    {
      longest = std::abs(d);
      found = 2 * axis + (d < 0.0 ? 1 : 0);
    }
  }
  return found;
}

void copyRay(const RayPacket& from, int i, RayPacket& to, int k)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    to.origin[axis][k] = from.origin[axis][i];
    to.direction[axis][k] = from.direction[axis][i];
  }
  to.tMin[k] = from.tMin[i];
  to.t[k] = from.t[i];
  to.slot[k] = from.slot[i];
  to.object[k] = from.object[i];
}

/// Rays that do not share a major axis and its sign are cast class by class.
void castSplit(const CoherentGridView& grid, RayPacket& packet, std::int32_t object)
{
  RayPacket part;
  int members[RayPacket::capacity];
  for (int wanted = 0; wanted < 6; ++wanted)
  {
    part.count = 0;
    for (int i = 0; i < packet.count; ++i)
    {
      if (directionClass(packet, i) != wanted)
        continue;
      members[part.count] = i;
      copyRay(packet, i, part, part.count++);
    }
    if (part.count == 0)
      continue;
    HWY_DYNAMIC_DISPATCH(castCoherent)(grid, part, object);
    for (int k = 0; k < part.count; ++k)
    {
      packet.t[members[k]] = part.t[k];
      packet.slot[members[k]] = part.slot[k];
      packet.object[members[k]] = part.object[k];
    }
  }
}

} // namespace

void CoherentGrid::cast(RayPacket& packet, std::int32_t object) const
{
  if (count_ == 0 || packet.count == 0)
    return;
  const CoherentGridView view(*this);
  if (!HWY_DYNAMIC_DISPATCH(castCoherent)(view, packet, object))
    castSplit(view, packet, object);
}

namespace
{

template <typename Visit>
void byPackets(const RayBundle& bundle, const Visit& visit)
{
  for (int first = 0; first < bundle.count; first += RayPacket::capacity)
  {
    RayPacket packet;
    packet.count = std::min(RayPacket::capacity, bundle.count - first);
    for (int k = 0; k < packet.count; ++k)
    {
      const Vec3d o = bundle.originOf(first + k), d = bundle.directionOf(first + k);
      for (int axis = 0; axis < 3; ++axis)
      {
        packet.origin[axis][k] = o[axis];
        packet.direction[axis][k] = d[axis];
      }
      packet.tMin[k] = bundle.tMin;
      packet.t[k] = bundle.t[first + k];
      packet.slot[k] = bundle.slot[first + k];
      packet.object[k] = bundle.object[first + k];
    }
    visit(packet, first);
  }
}

} // namespace

void CoherentGrid::cast(RayBundle& bundle, std::int32_t object) const
{
  byPackets(bundle,
    [&](RayPacket& packet, int first)
    {
      cast(packet, object);
      for (int k = 0; k < packet.count; ++k)
      {
        bundle.t[first + k] = packet.t[k];
        bundle.slot[first + k] = packet.slot[k];
        bundle.object[first + k] = packet.object[k];
      }
    });
}

void CoherentGrid::occlude(RayBundle& bundle, std::int32_t object) const
{
  byPackets(bundle,
    [&](RayPacket& packet, int first)
    {
      for (int k = 0; k < packet.count; ++k)
      {
        const int i = first + k;
        const bool skips = bundle.object[i] == object;
        if (!(bundle.t[i] > bundle.tMin))
          continue;
        RayPacket one;
        one.count = 1;
        for (int axis = 0; axis < 3; ++axis)
        {
          one.origin[axis][0] = packet.origin[axis][k];
          one.direction[axis][0] = packet.direction[axis][k];
        }
        one.tMin[0] = bundle.tMin;
        one.t[0] = bundle.t[i];
        one.slot[0] = RayPacket::noHit;
        cast(one, object);
        if (one.slot[0] != RayPacket::noHit && !(skips && one.slot[0] == bundle.slot[i]))
          bundle.t[i] = -std::numeric_limits<double>::infinity();
      }
    });
}

} // namespace mote

#endif
