// Casting bundles through a CoherentGrid, compiled once for every SIMD instruction set.

#include "CoherentGridView.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "particles/CoherentGridCast.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "CoherentGridCastBundle-inl.h"

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

#include <tuple>

namespace mote
{

HWY_EXPORT(castNearest);
HWY_EXPORT(castAny);

namespace
{

/// A bundle of one ray has no steps: it gets some across the ray, of the length `unit`, so that
/// all is well conditioned. Its own steps come back in the end.
class SingleRay
{
public:
  SingleRay(RayBundle& bundle, double unit)
    : bundle_(bundle)
  {
    if (bundle.count != 1)
      return;
    kept_ = {bundle.origin, bundle.direction, bundle.dx, bundle.dy};
    kind_ = bundle.kind;
    x_ = bundle.x[0];
    y_ = bundle.y[0];
    const Vec3d origin = bundle.originOf(0), direction = bundle.directionOf(0);
    bundle.kind = RayBundle::Kind::CommonDirection;
    bundle.origin = origin;
    bundle.direction = direction;
    acrossAxes(direction, bundle.dx, bundle.dy);
    bundle.dx *= unit;
    bundle.dy *= unit;
    bundle.x[0] = bundle.y[0] = 0.0f;
  }
  ~SingleRay()
  {
    if (bundle_.count != 1)
      return;
    std::tie(bundle_.origin, bundle_.direction, bundle_.dx, bundle_.dy) = kept_;
    bundle_.kind = kind_;
    bundle_.x[0] = x_;
    bundle_.y[0] = y_;
  }
  SingleRay(const SingleRay&) = delete;
  SingleRay& operator=(const SingleRay&) = delete;

private:
  RayBundle& bundle_;
  std::tuple<Vec3d, Vec3d, Vec3d, Vec3d> kept_;
  RayBundle::Kind kind_ = RayBundle::Kind::CommonOrigin;
  float x_ = 0.0f, y_ = 0.0f;
};

} // namespace

void CoherentGrid::cast(RayBundle& bundle, std::int32_t object) const
{
  if (count_ == 0 || bundle.count == 0)
    return;
  const CoherentGridView view(*this);
  bySplitting(bundle,
    [&](RayBundle& part)
    {
      const SingleRay single(part, unit_);
      return HWY_DYNAMIC_DISPATCH(castNearest)(view, part, object);
    });
}

void CoherentGrid::occlude(RayBundle& bundle, std::int32_t object) const
{
  if (count_ == 0 || bundle.count == 0)
    return;
  const CoherentGridView view(*this);
  bySplitting(bundle,
    [&](RayBundle& part)
    {
      const SingleRay single(part, unit_);
      return HWY_DYNAMIC_DISPATCH(castAny)(view, part, object);
    });
}

namespace
{

/// Ray i of a packet as a bundle of one ray.
void oneRay(const RayPacket& packet, int i, RayBundle& ray)
{
  ray.count = 1;
  ray.origin = {packet.origin[0][i], packet.origin[1][i], packet.origin[2][i]};
  ray.direction = {packet.direction[0][i], packet.direction[1][i], packet.direction[2][i]};
  ray.tMin = packet.tMin[i];
  ray.x[0] = ray.y[0] = 0.0f;
  ray.t[0] = packet.t[i];
  ray.slot[0] = packet.slot[i];
  ray.object[0] = packet.object[i];
}

} // namespace

void CoherentGrid::cast(RayPacket& packet, std::int32_t object) const
{
  RayBundle ray;
  for (int i = 0; i < packet.count; ++i)
  {
    oneRay(packet, i, ray);
    cast(ray, object);
    packet.t[i] = ray.t[0];
    packet.slot[i] = ray.slot[0];
    packet.object[i] = ray.object[0];
  }
}

void CoherentGrid::occlude(RayPacket& packet, std::int32_t object) const
{
  RayBundle ray;
  for (int i = 0; i < packet.count; ++i)
  {
    oneRay(packet, i, ray);
    occlude(ray, object);
    packet.t[i] = ray.t[0];
  }
}

} // namespace mote

#endif
