// Casting rays through an RlodTree, compiled once for every SIMD instruction set.

#include "RlodTree.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "meshes/RlodTreeCast.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "detail/RlodTreeBundle-inl.h"
#include "detail/RlodTreeRays-inl.h"
#include "detail/RlodTreeWave-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

bool castNearest(const RlodTreeView& view, RayBundle& bundle, std::int32_t object, double poe,
  RlodTree::Counts* counts)
{
  return castBundle<NearestHit>(view, bundle, object, poe, counts);
}

bool castAny(
  const RlodTreeView& view, RayBundle& bundle, std::int32_t object, RlodTree::Counts* counts)
{
  return castBundle<AnyHit>(view, bundle, object, 0.0, counts);
}

void castNearestOfPacket(
  const RlodTreeView& view, RayPacket& packet, std::int32_t object, double poe)
{
  castPacketNearest(view, packet, object, poe);
}

void castAnyOfPacket(const RlodTreeView& view, RayPacket& packet)
{
  castPacketAny(view, packet);
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <algorithm>

namespace mote
{

HWY_EXPORT(castNearest);
HWY_EXPORT(castAny);
HWY_EXPORT(castNearestOfPacket);
HWY_EXPORT(castAnyOfPacket);

namespace
{

/// Calls ask(packet) for the rays of a bundle, as packets, and keeps the answers.
template <typename Ask>
void askInPackets(RayBundle& bundle, const Ask& ask)
{
  RayPacket packet;
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
    ask(packet);
    std::copy_n(packet.t, packet.count, bundle.t + first);
    std::copy_n(packet.slot, packet.count, bundle.slot + first);
    std::copy_n(packet.object, packet.count, bundle.object + first);
  }
}

} // namespace

void RlodTree::cast(RayPacket& packet, std::int32_t object, double poe) const
{
  if (size() > 0)
    HWY_DYNAMIC_DISPATCH(castNearestOfPacket)(RlodTreeView(*this), packet, object, poe);
}

void RlodTree::occlude(RayPacket& packet, std::int32_t) const
{
  if (size() > 0)
    HWY_DYNAMIC_DISPATCH(castAnyOfPacket)(RlodTreeView(*this), packet);
}

void RlodTree::cast(RayBundle& bundle, std::int32_t object, double poe) const
{
  if (size() == 0 ||
      HWY_DYNAMIC_DISPATCH(castNearest)(RlodTreeView(*this), bundle, object, poe, nullptr))
    return;
  askInPackets(bundle, [&](RayPacket& packet) { cast(packet, object, poe); });
}

void RlodTree::cast(RayBundle& bundle, std::int32_t object, double poe, Counts& counts) const
{
  if (size() > 0)
    HWY_DYNAMIC_DISPATCH(castNearest)(RlodTreeView(*this), bundle, object, poe, &counts);
}

void RlodTree::occlude(RayBundle& bundle, std::int32_t object) const
{
  if (size() == 0 || HWY_DYNAMIC_DISPATCH(castAny)(RlodTreeView(*this), bundle, object, nullptr))
    return;
  askInPackets(bundle, [&](RayPacket& packet) { occlude(packet, object); });
}

} // namespace mote

#endif
