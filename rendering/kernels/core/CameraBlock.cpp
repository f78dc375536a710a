// Filling packets with camera rays, compiled once for every SIMD instruction set.

#include "Camera.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/CameraBlock.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Rays' places in the block: column and row of the pixel, plus one half.
struct BlockOffsets
{
  alignas(64) double x[RayPacket::capacity], y[RayPacket::capacity];
  BlockOffsets()
  {
    for (int i = 0; i < RayPacket::capacity; ++i)
    {
      int column = 0, row = 0;
      packetOffset(i, column, row);
      x[i] = column + 0.5;
      y[i] = row + 0.5;
    }
  }
};

void fillRays(const CameraRays& rays, double x, double y, RayPacket& packet)
{
  static const BlockOffsets offsets;
  const hn::CappedTag<double, 8> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto fill = [&](double at, double stepX, double stepY, double* to)
  {
    const auto base = hn::Set(d, at), sx = hn::Set(d, stepX), sy = hn::Set(d, stepY);
    for (int i = 0; i < RayPacket::capacity; i += lanes)
      hn::Store(hn::MulAdd(
                  hn::Load(d, offsets.y + i), sy, hn::MulAdd(hn::Load(d, offsets.x + i), sx, base)),
        d, to + i);
  };
  const Vec3d o = rays.originAt(x, y), direction = rays.directionAt(x, y);
  for (int axis = 0; axis < 3; ++axis)
  {
    fill(o[axis], rays.ox[axis], rays.oy[axis], packet.origin[axis]);
    fill(direction[axis], rays.dx[axis], rays.dy[axis], packet.direction[axis]);
  }
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <algorithm>

namespace mote
{

HWY_EXPORT(fillRays);

void CameraRays::fillBlock(RayPacket& packet, int x0, int y0, double jitterX, double jitterY) const
{
  HWY_DYNAMIC_DISPATCH(fillRays)(*this, x0 + jitterX, y0 + jitterY, packet);
  std::fill_n(packet.tMin, RayPacket::capacity, tMin);
  std::fill_n(packet.t, RayPacket::capacity, tMax);
  std::fill_n(packet.slot, RayPacket::capacity, RayPacket::noHit);
  std::fill_n(packet.object, RayPacket::capacity, -1);
  packet.count = RayPacket::capacity;
}

} // namespace mote

#endif
