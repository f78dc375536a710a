// Casting bundles through a CoherentGrid, compiled once for every SIMD instruction set.

#include "detail/BundleCast.h"
#include "detail/CoherentGridView.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "particles/CoherentGridCast.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "detail/CoherentGridCastBundle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

bool castNearest(const CoherentGridView& view, RayBundle& bundle, std::int32_t object)
{
  return castBundle<NearestPolicy>(view, bundle, object, nullptr);
}

bool castAny(const CoherentGridView& view, RayBundle& bundle, std::int32_t object)
{
  return castBundle<AnyPolicy>(view, bundle, object, nullptr);
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote
{

HWY_EXPORT(castNearest);
HWY_EXPORT(castAny);

void CoherentGrid::cast(RayBundle& bundle, std::int32_t object) const
{
  castInParts<CoherentGridView>(*this, bundle, object, HWY_DYNAMIC_DISPATCH(castNearest));
}

void CoherentGrid::occlude(RayBundle& bundle, std::int32_t object) const
{
  castInParts<CoherentGridView>(*this, bundle, object, HWY_DYNAMIC_DISPATCH(castAny));
}

namespace
{

/// Calls ask(bundle) for each ray of a packet, as a bundle of one ray, and keeps the answers.
template <typename Ask>
void askOneByOne(RayPacket& packet, const Ask& ask)
{
  RayBundle ray;
  for (int i = 0; i < packet.count; ++i)
  {
    ray.count = 1;
    ray.origin = {packet.origin[0][i], packet.origin[1][i], packet.origin[2][i]};
    ray.direction = {packet.direction[0][i], packet.direction[1][i], packet.direction[2][i]};
    ray.tMin = packet.tMin[i];
    ray.x[0] = ray.y[0] = 0.0f;
    ray.t[0] = packet.t[i];
    ray.slot[0] = packet.slot[i];
    ray.object[0] = packet.object[i];
    ask(ray);
    packet.t[i] = ray.t[0];
    packet.slot[i] = ray.slot[0];
    packet.object[i] = ray.object[0];
  }
}

} // namespace

void CoherentGrid::cast(RayPacket& packet, std::int32_t object) const
{
  askOneByOne(packet, [&](RayBundle& ray) { cast(ray, object); });
}

void CoherentGrid::occlude(RayPacket& packet, std::int32_t object) const
{
  askOneByOne(packet, [&](RayBundle& ray) { occlude(ray, object); });
}

} // namespace mote

#endif
