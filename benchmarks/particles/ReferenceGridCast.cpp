// Casting packets through a grid of references, compiled once for every SIMD instruction set.

#include "ReferenceGridView.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "particles/ReferenceGridCast.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "ReferenceGridPacket-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote::bench
{
namespace HWY_NAMESPACE
{

/// Bounds of the live rays' (u, v) as linear functions of kappa, for kappa >= 0.
struct Frustum
{
  float uLow, uLowSlope, uHigh, uHighSlope;
  float vLow, vLowSlope, vHigh, vHighSlope;
  float uWiden, vWiden; ///< a sphere's radius counts this many times along u and v
  float farthest;       ///< largest kappa that any live ray can still reach
};

/// Bounds of the rays that can still hit something at kappa > `front`.
inline Frustum frustumOf(const Packet& p, float front)
{
  const DF d;
  const VF inf = hn::Set(d, infinity), minusInf = hn::Set(d, -infinity), at = hn::Set(d, front);
  VF uLow = inf, uHigh = minusInf, vLow = inf, vHigh = minusInf;
  VF duLow = inf, duHigh = minusInf, dvLow = inf, dvHigh = minusInf, farthest = minusInf;
  for (int i = 0; i < p.count; i += static_cast<int>(hn::Lanes(d)))
  {
    const VF best = hn::Load(d, p.best + i);
    const auto live = hn::Gt(best, at);
    const auto widen = [&](VF& low, VF& high, const float* a)
    {
      const VF value = hn::Load(d, a + i);
      low = hn::Min(low, hn::IfThenElse(live, value, inf));
      high = hn::Max(high, hn::IfThenElse(live, value, minusInf));
    };
    widen(uLow, uHigh, p.su);
    widen(vLow, vHigh, p.sv);
    widen(duLow, duHigh, p.du);
    widen(dvLow, dvHigh, p.dv);
    farthest = hn::Max(farthest, best);
  }
  const auto least = [&](VF v) { return hn::GetLane(hn::MinOfLanes(d, v)); };
  const auto most = [&](VF v) { return hn::GetLane(hn::MaxOfLanes(d, v)); };
  Frustum f{least(uLow), least(duLow), most(uHigh), most(duHigh), least(vLow), least(dvLow),
    most(vHigh), most(dvHigh), 1.0f, 1.0f, most(farthest)};
  const float u = std::max(std::abs(f.uLowSlope), std::abs(f.uHighSlope));
  const float v = std::max(std::abs(f.vLowSlope), std::abs(f.vHighSlope));
  f.uWiden = std::sqrt(1.0f + u * u);
  f.vWiden = std::sqrt(1.0f + v * v);
  return f;
}

/// A range of cells; empty where first > last.
struct CellRange
{
  int first, last;
  bool empty() const { return first > last; }
};

/// Casts one packet along the axis K. One object a packet: it lives on the stack.
template <int K>
class ReferenceCaster
{
public:
  static constexpr int U = K == 0 ? 1 : 0; ///< x wherever possible: rows of cells run along x
  static constexpr int V = K == 2 ? 1 : 2;

  ReferenceCaster(const ReferenceGridView& grid, Packet& packet, Mailbox& mailbox)
    : grid_(grid)
    , p_(packet)
    , mailbox_(mailbox)
    , cells_(1.0f / grid.cellSize)
    , baseU_(static_cast<float>((packet.centerU - grid.lower[U]) / grid.cellSize))
    , baseV_(static_cast<float>((packet.centerV - grid.lower[V]) / grid.cellSize))
    , sign_(static_cast<float>(packet.sign))
    , centerU_(split(packet.centerU))
    , centerV_(split(packet.centerV))
    , plane_(split(packet.plane))
  {
    const double lower = grid.lower[K];
    const double upper = lower + double(grid.cellSize) * grid.resolution[K];
    front0_ = static_cast<float>(packet.sign > 0.0 ? lower - packet.plane : packet.plane - upper);
  }

  /// `entry`: smallest kappa at which a ray enters the box of all spheres.
  void run(float entry)
  {
    const float h = grid_.cellSize;
    const int slices = grid_.resolution[K];
    frustum_ = frustumOf(p_, -infinity);
    const float place = std::floor((entry - front0_) * cells_ - 1e-3f);
    const int start = static_cast<int>(std::clamp(place, 0.0f, static_cast<float>(slices)));
    for (int step = start; step < slices; ++step)
    {
      const float front = front0_ + h * static_cast<float>(step);
      if (changed_)
      {
        frustum_ = frustumOf(p_, front - margin * h);
        changed_ = false;
      }
      if (!(frustum_.farthest > front - margin * h))
        break;
      const int slice = sign_ > 0.0f ? step : slices - 1 - step;
      const int left = stepsLeftInMacrocell(slice);
      if ((step == start || left == ReferenceGrid::macrocellSide - 1) &&
          macrocellsEmpty(slice, front, front + h * static_cast<float>(left + 1)))
      {
        step += left;
        continue;
      }
      visitSlice(slice, front, front + h);
      flush();
    }
  }

private:
  static constexpr float margin = 1e-3f; ///< in cells, for rounding; spheres are entered with more

  /// A double as the sum of two floats, to subtract it from floats with less error.
  struct Split
  {
    float high, low;
  };
  static Split split(double v)
  {
    const float high = static_cast<float>(v);
    return {high, static_cast<float>(v - static_cast<double>(high))};
  }

  int stepsLeftInMacrocell(int slice) const
  {
    constexpr int m = ReferenceGrid::macrocellSide;
    return sign_ > 0.0f ? std::min(m - 1 - slice % m, grid_.resolution[K] - 1 - slice) : slice % m;
  }

  /// Cells that the frustum overlaps between two values of kappa: no sphere reaches into it from
  /// another one.
  CellRange rangeU(float k0, float k1) const
  {
    return range(frustum_.uLow, frustum_.uLowSlope, frustum_.uHigh, frustum_.uHighSlope, k0, k1,
      baseU_, grid_.resolution[U]);
  }
  CellRange rangeV(float k0, float k1) const
  {
    return range(frustum_.vLow, frustum_.vLowSlope, frustum_.vHigh, frustum_.vHighSlope, k0, k1,
      baseV_, grid_.resolution[V]);
  }
  CellRange range(float low, float lowSlope, float high, float highSlope, float k0, float k1,
    float base, int resolution) const
  {
    k0 = std::max(k0, 0.0f); // nothing counts before the start plane, nor do the bounds hold there
    k1 = std::max(k1, 0.0f);
    const float from = std::min(low + lowSlope * k0, low + lowSlope * k1);
    const float to = std::max(high + highSlope * k0, high + highSlope * k1);
    // The comparisons are written so that rays beside the grid give an empty range.
    const float last = static_cast<float>(resolution - 1);
    const float a = std::floor(from * cells_ + base - margin);
    const float b = std::floor(to * cells_ + base + margin);
    if (!(a <= last) || !(b >= 0.0f))
      return {1, 0};
    return {static_cast<int>(std::max(a, 0.0f)), static_cast<int>(std::min(b, last))};
  }

  bool macrocellsEmpty(int slice, float k0, float k1) const
  {
    constexpr int m = ReferenceGrid::macrocellSide;
    const CellRange u = rangeU(k0, k1), v = rangeV(k0, k1);
    if (u.empty() || v.empty())
      return true;
    const Vec3i n = grid_.macroResolution;
    Vec3i c;
    c[K] = slice / m;
    for (c[V] = v.first / m; c[V] <= v.last / m; ++c[V])
      for (c[U] = u.first / m; c[U] <= u.last / m; ++c[U])
        if (grid_.macrocellUsed[(static_cast<std::size_t>(c.z) * n.y + c.y) * n.x + c.x])
          return false;
    return true;
  }

  void visitSlice(int slice, float k0, float k1)
  {
    const CellRange u = rangeU(k0, k1), v = rangeV(k0, k1);
    if (u.empty())
      return;
    for (int j = v.first; j <= v.last; ++j)
    {
      if constexpr (K == 2)
        visitCells(j, slice, u.first, u.last);
      else if constexpr (K == 1)
        visitCells(slice, j, u.first, u.last);
      else
        for (int i = u.first; i <= u.last; ++i)
          visitCells(i, j, slice, slice);
    }
  }

  /// Cells x0 to x1 of the row (y, z): their references lie one after another.
  HWY_INLINE void visitCells(int y, int z, int x0, int x1)
  {
    const std::size_t row = static_cast<std::size_t>(z) * grid_.resolution.y + y;
    const std::uint32_t* start =
      grid_.cellStart + row * (static_cast<std::size_t>(grid_.resolution.x) + 1);
    const std::uint32_t* reference = grid_.references + grid_.rowStart[row] + start[x0];
    const std::uint32_t* end = grid_.references + grid_.rowStart[row] + start[x1 + 1];
    const hn::CappedTag<float, 4> four;
    for (; reference < end; ++reference)
    {
      if (!mailbox_.insert(*reference))
        continue;
      const float* from = &grid_.records[*reference].x;
      for (int k = 0; k < 4; k += static_cast<int>(hn::Lanes(four)))
        hn::StoreU(hn::LoadU(four, from + k), four, buffer_ + 4 * buffered_ + k);
      places_[buffered_] = *reference;
      if (++buffered_ == bufferSize)
        flush();
    }
  }

  /// Tests the gathered spheres against the frustum, many at once, and those that overlap it
  /// against the rays.
  void flush()
  {
    const DF d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const auto difference = [&](VF c, Split s)
    { return hn::Sub(hn::Sub(c, hn::Set(d, s.high)), hn::Set(d, s.low)); };
    for (int i = 0; i < buffered_; i += lanes)
    {
      VF c[3], r;
      hn::LoadInterleaved4(d, buffer_ + 4 * i, c[0], c[1], c[2], r);
      const VF u = difference(c[U], centerU_);
      const VF v = difference(c[V], centerV_);
      const VF k = hn::Mul(difference(c[K], plane_), hn::Set(d, sign_));
      const auto at = [&](float start, float slope)
      { return hn::MulAdd(hn::Set(d, slope), k, hn::Set(d, start)); };
      // At its own depth the sphere's centre may lie as far outside as the widened radius.
      const VF ru = hn::Mul(r, hn::Set(d, frustum_.uWiden));
      const VF rv = hn::Mul(r, hn::Set(d, frustum_.vWiden));
      const auto inU = hn::And(hn::Ge(hn::Add(u, ru), at(frustum_.uLow, frustum_.uLowSlope)),
        hn::Le(hn::Sub(u, ru), at(frustum_.uHigh, frustum_.uHighSlope)));
      const auto inV = hn::And(hn::Ge(hn::Add(v, rv), at(frustum_.vLow, frustum_.vLowSlope)),
        hn::Le(hn::Sub(v, rv), at(frustum_.vHigh, frustum_.vHighSlope)));
      const auto before = hn::Lt(hn::Sub(k, r), hn::Set(d, frustum_.farthest));
      const auto used = hn::FirstN(d, static_cast<std::size_t>(buffered_ - i));
      std::uint8_t bytes[8] = {};
      hn::StoreMaskBits(d, hn::And(hn::And(inU, inV), hn::And(before, used)), bytes);
      unsigned bits = bytes[0] | (static_cast<unsigned>(bytes[1]) << 8);
      if (bits == 0)
        continue;
      hn::Store(u, d, u_);
      hn::Store(v, d, v_);
      hn::Store(k, d, k_);
      for (; bits != 0; bits &= bits - 1)
      {
        const int j = __builtin_ctz(bits);
        testSphere(u_[j], v_[j], k_[j], buffer_[4 * (i + j) + 3], places_[i + j]);
      }
    }
    buffered_ = 0;
  }

  /// The stable form: distance from the centre to the ray by the perpendicular remainder, never as
  /// a difference of squared distances to the origin.
  HWY_INLINE void testSphere(float u, float v, float k, float radius, std::uint32_t place)
  {
    const DF d;
    const DU du32;
    const VF cu = hn::Set(d, u), cv = hn::Set(d, v), ck = hn::Set(d, k);
    const VF r2 = hn::Set(d, radius * radius);
    for (int i = 0; i < p_.count; i += static_cast<int>(hn::Lanes(d)))
    {
      const VF du = hn::Load(d, p_.du + i), dv = hn::Load(d, p_.dv + i);
      const VF inverse = hn::Load(d, p_.inverseLength2 + i);
      const VF fu = hn::Sub(cu, hn::Load(d, p_.su + i)), fv = hn::Sub(cv, hn::Load(d, p_.sv + i));
      const VF at = hn::Mul(hn::MulAdd(fu, du, hn::MulAdd(fv, dv, ck)), inverse);
      const VF pu = hn::NegMulAdd(at, du, fu), pv = hn::NegMulAdd(at, dv, fv);
      const VF pk = hn::Sub(ck, at);
      const VF left = hn::NegMulAdd(pu, pu, hn::NegMulAdd(pv, pv, hn::NegMulAdd(pk, pk, r2)));
      const auto meets = hn::Ge(left, hn::Zero(d));
      if (hn::AllFalse(d, meets))
        continue;
      const VF half = hn::Sqrt(hn::Mul(hn::Max(left, hn::Zero(d)), inverse));
      const VF first = hn::Load(d, p_.first + i), best = hn::Load(d, p_.best + i);
      const VF in = hn::Sub(at, half), out = hn::Add(at, half);
      const VF near = hn::IfThenElse(hn::Gt(in, first), in, out);
      const auto nearer = hn::And(meets, hn::And(hn::Gt(near, first), hn::Lt(near, best)));
      if (hn::AllFalse(d, nearer))
        continue;
      changed_ = true;
      hn::Store(hn::IfThenElse(nearer, near, best), d, p_.best + i);
      const auto old = hn::Load(du32, p_.hit + i);
      hn::Store(
        hn::IfThenElse(hn::RebindMask(du32, nearer), hn::Set(du32, place), old), du32, p_.hit + i);
    }
  }

  static constexpr int bufferSize = 64;

  const ReferenceGridView& grid_;
  Packet& p_;
  Mailbox& mailbox_;
  Frustum frustum_;
  float cells_, baseU_, baseV_, front0_, sign_;
  Split centerU_, centerV_, plane_;
  bool changed_ = false;
  int buffered_ = 0;
  alignas(64) float buffer_[4 * bufferSize];
  std::uint32_t places_[bufferSize];
  alignas(64) float u_[16], v_[16], k_[16];
};

/// Casts a bundle whose rays travel the same way along one axis; false, with nothing done, where
/// they do not.
bool castCoherent(const ReferenceGridView& grid, Mailbox& mailbox, RayBundle& rays)
{
  const LocalBundle bundle(grid, rays);
  Packet p;
  const int lanes = static_cast<int>(hn::Lanes(DF()));
  p.count = (rays.count + lanes - 1) / lanes * lanes;
  double nearest = 0.0;
  if (!chooseAxes(bundle, rays, p, nearest))
    return false;
  const double nearFace = p.sign > 0.0 ? grid.lower[p.K] : -grid.upper[p.K];
  const double farFace = p.sign > 0.0 ? grid.upper[p.K] : -grid.lower[p.K];
  const double start = std::max(nearFace, nearest);
  if (!(start <= farFace))
    return true;
  p.plane = p.sign * start;
  p.depth = static_cast<float>(farFace - start);
  localize(bundle, rays, p);
  const float entry = clipToBox(grid, p);
  if (!(entry < infinity))
    return true;
  mailbox.start();
  switch (p.K)
  {
  case 0:
    ReferenceCaster<0>(grid, p, mailbox).run(entry);
    break;
  case 1:
    ReferenceCaster<1>(grid, p, mailbox).run(entry);
    break;
  default:
    ReferenceCaster<2>(grid, p, mailbox).run(entry);
  }
  keepHits(p, rays);
  return true;
}

} // namespace HWY_NAMESPACE
} // namespace mote::bench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote::bench
{

HWY_EXPORT(castCoherent);

void ReferenceGrid::cast(RayBundle& bundle) const
{
  static thread_local Mailbox mailbox;
  const ReferenceGridView view(*this);
  if (HWY_DYNAMIC_DISPATCH(castCoherent)(view, mailbox, bundle))
    return;
  // Rays that share no major axis are cast one by one: that is rare, and right.
  for (int i = 0; i < bundle.count; ++i)
  {
    RayBundle one;
    one.kind = RayBundle::Kind::CommonOrigin;
    one.count = 1;
    one.origin = bundle.originOf(i);
    one.direction = bundle.directionOf(i);
    one.tMin = bundle.tMin;
    one.x[0] = one.y[0] = 0.0f;
    one.t[0] = bundle.t[i];
    one.slot[0] = bundle.slot[i];
    HWY_DYNAMIC_DISPATCH(castCoherent)(view, mailbox, one);
    bundle.t[i] = one.t[0];
    bundle.slot[i] = one.slot[0];
  }
}

} // namespace mote::bench

#endif
