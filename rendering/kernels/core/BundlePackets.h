#pragma once

#include "RayBundle.h"
#include "RayPacket.h"

#include <algorithm>

namespace mote
{

/// Calls ask(packet, first) for the rays of a bundle, as packets whose rays are those from `first`
/// on, and keeps the answers.
template <typename Ask>
void askInPackets(RayBundle& bundle, OnSurface onSurface, const Ask& ask)
{
  RayPacket packet;
  packet.onSurface = onSurface;
  packet.footprint = bundle.footprint;
  packet.footprintPerT = bundle.footprintPerT;
  for (int first = 0; first < bundle.count; first += packet.count)
  {
    packet.count = std::min(RayPacket::capacity, bundle.count - first);
    for (int i = 0; i < packet.count; ++i)
    {
      const Vec3d origin = bundle.originOf(first + i), way = bundle.directionOf(first + i);
      for (int axis = 0; axis < 3; ++axis)
      {
        packet.origin[axis][i] = origin[axis];
        packet.direction[axis][i] = way[axis];
      }
    }
    std::fill_n(packet.tMin, packet.count, bundle.tMin);
    std::copy_n(bundle.t + first, packet.count, packet.t);
    std::copy_n(bundle.slot + first, packet.count, packet.slot);
    std::copy_n(bundle.object + first, packet.count, packet.object);
    ask(packet, first);
    std::copy_n(packet.t, packet.count, bundle.t + first);
    std::copy_n(packet.slot, packet.count, bundle.slot + first);
    std::copy_n(packet.object, packet.count, bundle.object + first);
  }
}

} // namespace mote
