// What is common to the traversal of a grid by packets on every SIMD instruction set: the rays
// relative to the grid. Included once per instruction set.

#if defined(MOTE_COHERENT_GRID_PACKET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_COHERENT_GRID_PACKET_INL_H
#undef MOTE_COHERENT_GRID_PACKET_INL_H
#else
#define MOTE_COHERENT_GRID_PACKET_INL_H
#endif

#include "CoherentGridView.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace mote
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

/// The rays of a packet in the grid's coordinates, relative to a start plane across the major
/// axis K.
///
/// kappa counts along K from the start plane, forward in the direction of travel. Ray i passes
/// (u, v) = (su + du kappa, sv + dv kappa). Formed in double and only then rounded, so that all
/// float numbers are small: their errors are relative to the grid, not to the camera's distance.
struct Packet
{
  alignas(64) float su[64], sv[64], du[64], dv[64];
  alignas(64) float inverseLength2[64]; ///< 1 / (1 + du^2 + dv^2)
  alignas(64) float first[64];          ///< hits at kappa <= first do not count
  alignas(64) float best[64];           ///< kappa of the nearest hit; -infinity: not a live ray
  alignas(64) std::uint32_t hit[64];    ///< 1 + place in `hits`, 0 for none
  alignas(64) double planeT[64];        ///< t at the start plane
  alignas(64) double perKappa[64];      ///< t for one kappa
  int K, U, V;                          ///< axes
  double sign;                          ///< of travel along K
  double plane;                         ///< start plane's coordinate on K
  double centerU, centerV;              ///< where the middle ray crosses it
  float depth;                          ///< kappa at which the last sphere has ended
};

HWY_INLINE VF laneMin(VF v)
{
  return hn::MinOfLanes(DF(), v);
}
HWY_INLINE VF laneMax(VF v)
{
  return hn::MaxOfLanes(DF(), v);
}

/// Whether all rays travel forward along K and nowhere near across it; and, in `nearest`, the
/// smallest signed K at which one of them starts, in the grid's coordinates.
inline bool isCoherent(
  const CoherentGridView& grid, const RayPacket& rays, const Packet& p, double& nearest)
{
  const DD dd;
  const VD zero = hn::Zero(dd), two = hn::Set(dd, 2.0), sign = hn::Set(dd, p.sign);
  const VD originK = hn::Set(dd, grid.origin[p.K]);
  VD least = hn::Set(dd, std::numeric_limits<double>::infinity());
  for (int i = 0; i < rays.count; i += static_cast<int>(hn::Lanes(dd)))
  {
    const auto used = hn::FirstN(dd, static_cast<std::size_t>(rays.count - i));
    const VD d = hn::Load(dd, rays.direction[p.K] + i), dk = hn::Mul(sign, d);
    const VD across = hn::Max(hn::Abs(hn::Load(dd, rays.direction[p.U] + i)),
      hn::Abs(hn::Load(dd, rays.direction[p.V] + i)));
    const auto coherent = hn::And(hn::Gt(dk, zero), hn::Le(across, hn::Mul(two, dk)));
    if (!hn::AllTrue(dd, hn::Or(coherent, hn::Not(used))))
      return false;
    const VD start = hn::MulAdd(
      hn::Load(dd, rays.tMin + i), d, hn::Sub(hn::Load(dd, rays.origin[p.K] + i), originK));
    least = hn::IfThenElse(used, hn::Min(least, hn::Mul(sign, start)), least);
  }
  nearest = grid.perUnit * hn::GetLane(hn::MinOfLanes(dd, least));
  return true;
}

/// Expresses the rays by their crossing of the start plane and their slopes.
inline void localize(const CoherentGridView& grid, const RayPacket& rays, Packet& p)
{
  const DD dd;
  const DH dh;
  const int middle = rays.count / 2;
  const double planeWorld = grid.origin[p.K] + grid.unit * p.plane;
  const double tMiddle = (planeWorld - rays.origin[p.K][middle]) / rays.direction[p.K][middle];
  const auto middleAt = [&](int axis)
  {
    const double along = tMiddle * rays.direction[axis][middle];
    return grid.perUnit * (rays.origin[axis][middle] - grid.origin[axis] + along);
  };
  p.centerU = middleAt(p.U);
  p.centerV = middleAt(p.V);
  const VD planeK = hn::Set(dd, planeWorld);
  const VD shiftU = hn::Set(dd, grid.origin[p.U] + grid.unit * p.centerU);
  const VD shiftV = hn::Set(dd, grid.origin[p.V] + grid.unit * p.centerV);
  const VD one = hn::Set(dd, 1.0), perUnit = hn::Set(dd, grid.perUnit);
  const VD signPerUnit = hn::Set(dd, p.sign * grid.perUnit);
  for (int i = 0; i < 64; i += static_cast<int>(hn::Lanes(dd)))
  {
    const int left = std::max(0, rays.count - i);
    const auto used = hn::FirstN(dd, static_cast<std::size_t>(left));
    // Unused lanes are dead; all that is asked of them is no NaN.
    const VD dk = hn::IfThenElse(used, hn::Load(dd, rays.direction[p.K] + i), one);
    const VD length = hn::Mul(hn::Abs(dk), perUnit);
    const VD perKappa = hn::Div(one, length);
    const VD t =
      hn::Mul(hn::Sub(planeK, hn::Load(dd, rays.origin[p.K] + i)), hn::Mul(perKappa, signPerUnit));
    const VD du = hn::Load(dd, rays.direction[p.U] + i);
    const VD dv = hn::Load(dd, rays.direction[p.V] + i);
    const auto put = [&](VD v, float* to)
    { hn::Store(hn::DemoteTo(dh, hn::IfThenElseZero(used, v)), dh, to + i); };
    const auto crossing = [&](int axis, VD slope, VD shift)
    { return hn::MulAdd(t, slope, hn::Sub(hn::Load(dd, rays.origin[axis] + i), shift)); };
    const VD slopePerUnit = hn::Mul(perKappa, perUnit);
    put(hn::Mul(crossing(p.U, du, shiftU), perUnit), p.su);
    put(hn::Mul(crossing(p.V, dv, shiftV), perUnit), p.sv);
    put(hn::Mul(du, slopePerUnit), p.du);
    put(hn::Mul(dv, slopePerUnit), p.dv);
    put(hn::Mul(hn::Sub(hn::Load(dd, rays.tMin + i), t), length), p.first);
    const VD last = hn::Mul(hn::Sub(hn::Load(dd, rays.t + i), t), length);
    hn::Store(hn::DemoteTo(dh,
                hn::IfThenElse(used, last, hn::Set(dd, -std::numeric_limits<double>::infinity()))),
      dh, p.best + i);
    hn::Store(t, dd, p.planeT + i);
    hn::Store(perKappa, dd, p.perKappa + i);
  }
}

/// Clips the rays to the box of all spheres: those that miss it, or start or end before it, are
/// dead. Returns the smallest kappa at which a ray enters, or infinity.
inline float clipToBox(const CoherentGridView& grid, Packet& p)
{
  const DF d;
  const DU du32;
  const VF zero = hn::Zero(d), one = hn::Set(d, 1.0f), tiny = hn::Set(d, 1e-30f);
  // Rounding may lose no sphere that touches the box's face: the box is a little larger.
  const auto bounds = [&](int axis, double center, float& low, float& high)
  {
    const double h = double(grid.cellSize) * grid.resolution[axis];
    low = static_cast<float>(grid.lower[axis] - center - grid.reach);
    high = static_cast<float>(grid.lower[axis] + h - center + grid.reach);
    const float margin = 1e-3f * grid.reach + 1e-6f * std::max(std::abs(low), std::abs(high));
    low -= margin;
    high += margin;
  };
  float low[2], high[2];
  bounds(p.U, p.centerU, low[0], high[0]);
  bounds(p.V, p.centerV, low[1], high[1]);
  const float depth = p.depth * 1.000001f;
  VF nearest = hn::Set(d, infinity);
  for (int i = 0; i < 64; i += static_cast<int>(hn::Lanes(d)))
  {
    const VF last = hn::Load(d, p.best + i);
    const VF du = hn::Load(d, p.du + i), dv = hn::Load(d, p.dv + i);
    VF in = hn::Max(zero, hn::Load(d, p.first + i)), out = hn::Min(last, hn::Set(d, depth));
    const auto slab = [&](VF start, VF slope, float lowest, float highest)
    {
      const VF safe = hn::IfThenElse(hn::Lt(hn::Abs(slope), tiny), tiny, slope);
      const VF inverse = hn::Div(one, safe);
      const VF k0 = hn::Mul(hn::Sub(hn::Set(d, lowest), start), inverse);
      const VF k1 = hn::Mul(hn::Sub(hn::Set(d, highest), start), inverse);
      in = hn::Max(in, hn::Min(k0, k1));
      out = hn::Min(out, hn::Max(k0, k1));
    };
    slab(hn::Load(d, p.su + i), du, low[0], high[0]);
    slab(hn::Load(d, p.sv + i), dv, low[1], high[1]);
    const VF padded = hn::MulAdd(out, hn::Set(d, 2e-6f), hn::Add(out, hn::Set(d, p.depth * 1e-6f)));
    const auto live = hn::Le(in, padded);
    hn::Store(hn::IfThenElse(live, padded, hn::Set(d, -infinity)), d, p.best + i);
    nearest = hn::IfThenElse(live, hn::Min(nearest, in), nearest);
    const VF length2 = hn::MulAdd(du, du, hn::MulAdd(dv, dv, one));
    hn::Store(hn::Div(one, length2), d, p.inverseLength2 + i);
    hn::Store(hn::Zero(du32), du32, p.hit + i);
  }
  return hn::GetLane(laneMin(nearest));
}

/// Writes the hits back to the rays they belong to.
inline void keepHits(
  const Packet& p, const std::vector<std::uint64_t>& hits, std::int32_t object, RayPacket& rays)
{
  const DD dd;
  const DH dh;
  alignas(64) double t[64];
  for (int i = 0; i < 64; i += static_cast<int>(hn::Lanes(dd)))
  {
    const VD kappa = hn::PromoteTo(dd, hn::Load(dh, p.best + i));
    hn::Store(
      hn::MulAdd(kappa, hn::Load(dd, p.perKappa + i), hn::Load(dd, p.planeT + i)), dd, t + i);
  }
  for (int i = 0; i < rays.count; ++i)
  {
    if (p.hit[i] == 0 || !(t[i] < rays.t[i]))
      continue;
    rays.t[i] = t[i];
    rays.slot[i] = hits[p.hit[i] - 1];
    rays.object[i] = object;
  }
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
