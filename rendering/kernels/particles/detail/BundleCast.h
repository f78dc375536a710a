#pragma once

#include "../../core/RayBundle.h"
#include "../../core/RayPacket.h"

#include <tuple>

namespace mote
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

/// Casts the rays of a bundle through a structure by kernel(View(structure), part, object), which
/// answers false where it needs parts whose rays are nearer to one another, down to single rays.
template <typename View, typename Structure, typename Kernel>
void castInParts(
  const Structure& structure, RayBundle& bundle, std::int32_t object, const Kernel& kernel)
{
  if (structure.size() == 0 || bundle.count == 0)
    return;
  const View view(structure);
  bySplitting(bundle,
    [&](RayBundle& part)
    {
      const SingleRay single(part, structure.unit());
      return kernel(view, part, object);
    });
}

} // namespace mote
