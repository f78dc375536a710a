// The rays of a bundle relative to a grid of references. Included once per SIMD instruction set.

#if defined(MOTE_REFERENCE_GRID_PACKET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_REFERENCE_GRID_PACKET_INL_H
#undef MOTE_REFERENCE_GRID_PACKET_INL_H
#else
#define MOTE_REFERENCE_GRID_PACKET_INL_H
#endif

#include "ReferenceGridView.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace mote::bench
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DU = hn::Rebind<std::uint32_t, DF>;
using DD = hn::CappedTag<double, 8>;
using DH = hn::Rebind<float, DD>;
using VF = hn::Vec<DF>;
using VD = hn::Vec<DD>;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr int packetSize = 64;

/// The rays of a packet in the grid's coordinates, relative to a start plane across the major
/// axis K.
///
/// kappa counts along K from the start plane, forward in the direction of travel. Ray i passes
/// (u, v) = (su + du kappa, sv + dv kappa). Formed in double and only then rounded, so that all
/// float numbers are small.
struct Packet
{
  alignas(64) float su[packetSize], sv[packetSize], du[packetSize], dv[packetSize];
  alignas(64) float inverseLength2[packetSize]; ///< 1 / (1 + du^2 + dv^2)
  alignas(64) float first[packetSize];          ///< hits at kappa <= first do not count
  alignas(64) float best[packetSize];           ///< kappa of the nearest hit; -infinity: dead
  alignas(64) std::uint32_t hit[packetSize];    ///< place of the sphere, noPlace for none
  alignas(64) double planeT[packetSize];        ///< t at the start plane
  alignas(64) double perKappa[packetSize];      ///< t for one kappa
  int count;                                    ///< rays, up to a whole vector
  int K, U, V;                                  ///< axes
  double sign;                                  ///< of travel along K
  double plane;                                 ///< start plane's coordinate on K
  double centerU, centerV;                      ///< where the middle ray crosses it
  float depth;                                  ///< kappa at which the last sphere has ended
};

constexpr std::uint32_t noPlace = std::numeric_limits<std::uint32_t>::max();

/// A bundle in the grid's coordinates: o + x ox + y oy + t (d + x dx + y dy).
struct LocalBundle
{
  Vec3d o, ox, oy, d, dx, dy;

  LocalBundle(const ReferenceGridView& grid, const RayBundle& b)
  {
    const double scale = 1.0 / grid.unit;
    const bool common = b.kind == RayBundle::Kind::CommonOrigin;
    const Vec3d stepX = scale * b.dx, stepY = scale * b.dy, none(0.0);
    o = scale * (b.origin - grid.origin);
    d = scale * b.direction;
    ox = common ? none : stepX;
    oy = common ? none : stepY;
    dx = common ? stepX : none;
    dy = common ? stepY : none;
  }
};

/// One coordinate of the origins or directions of a vector of rays.
HWY_INLINE VD along(double base, double stepX, double stepY, VD x, VD y)
{
  const DD dd;
  return hn::MulAdd(x, hn::Set(dd, stepX), hn::MulAdd(y, hn::Set(dd, stepY), hn::Set(dd, base)));
}

/// Chooses the axes; false where not all rays travel forward along K and nowhere near across it.
/// `nearest`: the smallest signed K at which one of them starts.
inline bool chooseAxes(const LocalBundle& b, const RayBundle& rays, Packet& p, double& nearest)
{
  const DD dd;
  const DH dh;
  p.K = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::abs(b.d[axis]) > std::abs(b.d[p.K]))
      p.K = axis;
  p.U = p.K == 0 ? 1 : 0;
  p.V = p.K == 2 ? 1 : 2;
  p.sign = b.d[p.K] < 0.0 ? -1.0 : 1.0;
  const VD sign = hn::Set(dd, p.sign), tMin = hn::Set(dd, rays.tMin);
  VD least = hn::Set(dd, std::numeric_limits<double>::infinity());
  for (int i = 0; i < rays.count; i += static_cast<int>(hn::Lanes(dd)))
  {
    const auto used = hn::FirstN(dd, static_cast<std::size_t>(rays.count - i));
    const VD x = hn::PromoteTo(dd, hn::Load(dh, rays.x + i));
    const VD y = hn::PromoteTo(dd, hn::Load(dh, rays.y + i));
    const auto direction = [&](int axis) { return along(b.d[axis], b.dx[axis], b.dy[axis], x, y); };
    const VD d = direction(p.K), forward = hn::Mul(sign, d);
    const VD across = hn::Max(hn::Abs(direction(p.U)), hn::Abs(direction(p.V)));
    const auto coherent =
      hn::And(hn::Gt(forward, hn::Zero(dd)), hn::Le(across, hn::Mul(hn::Set(dd, 2.0), forward)));
    if (!hn::AllTrue(dd, hn::Or(coherent, hn::Not(used))))
      return false;
    const VD start = hn::MulAdd(tMin, d, along(b.o[p.K], b.ox[p.K], b.oy[p.K], x, y));
    least = hn::IfThenElse(used, hn::Min(least, hn::Mul(sign, start)), least);
  }
  nearest = hn::GetLane(hn::MinOfLanes(dd, least));
  return true;
}

/// Expresses the rays by their crossing of the start plane and their slopes.
inline void localize(const LocalBundle& b, const RayBundle& rays, Packet& p)
{
  const DD dd;
  const DH dh;
  const double tMiddle = (p.plane - b.o[p.K]) / b.d[p.K];
  p.centerU = b.o[p.U] + tMiddle * b.d[p.U];
  p.centerV = b.o[p.V] + tMiddle * b.d[p.V];
  const VD one = hn::Set(dd, 1.0), sign = hn::Set(dd, p.sign);
  const VD none = hn::Set(dd, -std::numeric_limits<double>::infinity());
  const VD centerU = hn::Set(dd, p.centerU), centerV = hn::Set(dd, p.centerV);
  for (int i = 0; i < p.count; i += static_cast<int>(hn::Lanes(dd)))
  {
    const auto used = hn::FirstN(dd, static_cast<std::size_t>(std::max(0, rays.count - i)));
    const VD x = hn::IfThenElseZero(used, hn::PromoteTo(dd, hn::Load(dh, rays.x + i)));
    const VD y = hn::IfThenElseZero(used, hn::PromoteTo(dd, hn::Load(dh, rays.y + i)));
    const auto origin = [&](int axis) { return along(b.o[axis], b.ox[axis], b.oy[axis], x, y); };
    const auto direction = [&](int axis) { return along(b.d[axis], b.dx[axis], b.dy[axis], x, y); };
    const VD length = hn::Mul(sign, direction(p.K)), perKappa = hn::Div(one, length);
    const VD t = hn::Mul(hn::Sub(hn::Set(dd, p.plane), origin(p.K)), hn::Mul(perKappa, sign));
    const VD du = direction(p.U), dv = direction(p.V);
    const auto put = [&](VD v, float* to) { hn::Store(hn::DemoteTo(dh, v), dh, to + i); };
    put(hn::MulAdd(t, du, hn::Sub(origin(p.U), centerU)), p.su);
    put(hn::MulAdd(t, dv, hn::Sub(origin(p.V), centerV)), p.sv);
    put(hn::Mul(du, perKappa), p.du);
    put(hn::Mul(dv, perKappa), p.dv);
    put(hn::Mul(hn::Sub(hn::Set(dd, rays.tMin), t), length), p.first);
    const VD last = hn::Mul(hn::Sub(hn::Load(dd, rays.t + i), t), length);
    put(hn::IfThenElse(used, last, none), p.best);
    hn::Store(t, dd, p.planeT + i);
    hn::Store(perKappa, dd, p.perKappa + i);
  }
}

/// Clips the rays to the box of all spheres: those that miss it, or start or end before it, are
/// dead. Returns the smallest kappa at which a ray enters, or infinity.
inline float clipToBox(const ReferenceGridView& grid, Packet& p)
{
  const DF d;
  const DU du32;
  const VF zero = hn::Zero(d), one = hn::Set(d, 1.0f), tiny = hn::Set(d, 1e-30f);
  const VF depth = hn::Set(d, p.depth);
  VF nearest = hn::Set(d, infinity);
  for (int i = 0; i < p.count; i += static_cast<int>(hn::Lanes(d)))
  {
    const VF du = hn::Load(d, p.du + i), dv = hn::Load(d, p.dv + i);
    VF in = hn::Max(zero, hn::Load(d, p.first + i)), out = hn::Min(hn::Load(d, p.best + i), depth);
    const auto slab = [&](VF start, VF slope, int axis, double center)
    {
      const VF safe = hn::IfThenElse(hn::Lt(hn::Abs(slope), tiny), tiny, slope);
      const VF inverse = hn::Div(one, safe);
      const VF low = hn::Set(d, static_cast<float>(grid.lower[axis] - center));
      const VF high = hn::Set(d, static_cast<float>(grid.upper[axis] - center));
      const VF k0 = hn::Mul(hn::Sub(low, start), inverse);
      const VF k1 = hn::Mul(hn::Sub(high, start), inverse);
      in = hn::Max(in, hn::Min(k0, k1));
      out = hn::Min(out, hn::Max(k0, k1));
    };
    slab(hn::Load(d, p.su + i), du, p.U, p.centerU);
    slab(hn::Load(d, p.sv + i), dv, p.V, p.centerV);
    const auto live = hn::Le(in, out);
    hn::Store(hn::IfThenElse(live, out, hn::Set(d, -infinity)), d, p.best + i);
    nearest = hn::IfThenElse(live, hn::Min(nearest, in), nearest);
    const VF length2 = hn::MulAdd(du, du, hn::MulAdd(dv, dv, one));
    hn::Store(hn::Div(one, length2), d, p.inverseLength2 + i);
    hn::Store(hn::Set(du32, noPlace), du32, p.hit + i);
  }
  return hn::GetLane(hn::MinOfLanes(d, nearest));
}

/// Writes the hits back to the rays.
inline void keepHits(const Packet& p, RayBundle& rays)
{
  const DD dd;
  const DH dh;
  alignas(64) double t[packetSize];
  for (int i = 0; i < p.count; i += static_cast<int>(hn::Lanes(dd)))
    hn::Store(hn::MulAdd(hn::PromoteTo(dd, hn::Load(dh, p.best + i)), hn::Load(dd, p.perKappa + i),
                hn::Load(dd, p.planeT + i)),
      dd, t + i);
  for (int i = 0; i < rays.count; ++i)
  {
    if (p.hit[i] == noPlace || !(t[i] < rays.t[i]))
      continue;
    rays.t[i] = t[i];
    rays.slot[i] = p.hit[i];
  }
}

} // namespace HWY_NAMESPACE
} // namespace mote::bench
HWY_AFTER_NAMESPACE();

#endif
