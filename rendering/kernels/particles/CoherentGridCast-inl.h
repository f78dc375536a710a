// The traversal itself, included once per SIMD instruction set by CoherentGridCast.cpp.

#if defined(MOTE_COHERENT_GRID_CAST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_COHERENT_GRID_CAST_INL_H
#undef MOTE_COHERENT_GRID_CAST_INL_H
#else
#define MOTE_COHERENT_GRID_CAST_INL_H
#endif

#include "CoherentGridPacket-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
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
  for (int i = 0; i < 64; i += static_cast<int>(hn::Lanes(d)))
  {
    const VF best = hn::Load(d, p.best + i);
    const auto live = hn::Gt(best, at);
    const auto low = [&](VF old, const float* a)
    { return hn::Min(old, hn::IfThenElse(live, hn::Load(d, a + i), inf)); };
    const auto high = [&](VF old, const float* a)
    { return hn::Max(old, hn::IfThenElse(live, hn::Load(d, a + i), minusInf)); };
    uLow = low(uLow, p.su);
    uHigh = high(uHigh, p.su);
    vLow = low(vLow, p.sv);
    vHigh = high(vHigh, p.sv);
    duLow = low(duLow, p.du);
    duHigh = high(duHigh, p.du);
    dvLow = low(dvLow, p.dv);
    dvHigh = high(dvHigh, p.dv);
    farthest = hn::Max(farthest, best);
  }
  Frustum f;
  f.uLow = hn::GetLane(laneMin(uLow));
  f.uHigh = hn::GetLane(laneMax(uHigh));
  f.vLow = hn::GetLane(laneMin(vLow));
  f.vHigh = hn::GetLane(laneMax(vHigh));
  f.uLowSlope = hn::GetLane(laneMin(duLow));
  f.uHighSlope = hn::GetLane(laneMax(duHigh));
  f.vLowSlope = hn::GetLane(laneMin(dvLow));
  f.vHighSlope = hn::GetLane(laneMax(dvHigh));
  f.farthest = hn::GetLane(laneMax(farthest));
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
};

/// Casts one packet along the axis K. One object a packet: it lives on the stack.
template <int K>
class GridCaster
{
public:
  static constexpr int U = K == 0 ? 1 : 0; ///< x wherever possible: rows of cells run along x
  static constexpr int V = K == 2 ? 1 : 2;

  GridCaster(const CoherentGridView& grid, Packet& packet, std::vector<std::uint64_t>& hits)
    : grid_(grid)
    , p_(packet)
    , hits_(hits)
  {
    const float h = grid.cellSize;
    cells_ = 1.0f / h;
    baseU_ = static_cast<float>((packet.centerU - double(grid.lower[U])) / double(h));
    baseV_ = static_cast<float>((packet.centerV - double(grid.lower[V])) / double(h));
    const double lowerK = grid.lower[K], upperK = lowerK + double(h) * grid.resolution[K];
    sign_ = static_cast<float>(packet.sign);
    front0_ = static_cast<float>(packet.sign > 0.0 ? lowerK - packet.plane : packet.plane - upperK);
    centerU_ = split(packet.centerU);
    centerV_ = split(packet.centerV);
    plane_ = split(packet.plane);
  }

  /// `entry`: smallest kappa at which a ray enters the box of all spheres.
  void run(float entry)
  {
    const float h = grid_.cellSize;
    const int slices = grid_.resolution[K];
    frustum_ = frustumOf(p_, -infinity);
    const float place = std::floor((entry - grid_.reach - front0_) * cells_ - 1e-3f);
    const int start = static_cast<int>(std::clamp(place, 0.0f, static_cast<float>(slices)));
    for (int step = start; step < slices; ++step)
    {
      const float front = front0_ + h * static_cast<float>(step);
      if (changed_)
      {
        frustum_ = frustumOf(p_, front - grid_.reach);
        changed_ = false;
      }
      // Measured along K: comparing with the rays' own distance would visit far more slices.
      if (!(frustum_.farthest > front - grid_.reach))
        break;
      const int slice = sign_ > 0.0f ? step : slices - 1 - step;
      const int left = stepsLeftInMacrocell(slice);
      if ((step == start || left == CoherentGrid::macrocellSize - 1) &&
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
    constexpr int m = CoherentGrid::macrocellSize;
    return sign_ > 0.0f ? std::min(m - 1 - slice % m, grid_.resolution[K] - 1 - slice) : slice % m;
  }

  /// Cells whose particles' spheres may reach the frustum between two values of kappa.
  CellRange rangeU(float k0, float k1) const
  {
    return range(frustum_.uLow, frustum_.uLowSlope, frustum_.uHigh, frustum_.uHighSlope,
      frustum_.uWiden, k0, k1, baseU_, grid_.resolution[U]);
  }
  CellRange rangeV(float k0, float k1) const
  {
    return range(frustum_.vLow, frustum_.vLowSlope, frustum_.vHigh, frustum_.vHighSlope,
      frustum_.vWiden, k0, k1, baseV_, grid_.resolution[V]);
  }
  CellRange range(float low, float lowSlope, float high, float highSlope, float widen, float k0,
    float k1, float base, int resolution) const
  {
    const float reach = grid_.reach * widen;
    const float from = std::min(low + lowSlope * k0, low + lowSlope * k1) - reach;
    const float to = std::max(high + highSlope * k0, high + highSlope * k1) + reach;
    // The comparisons are written so that rays beside the grid give an empty range.
    const float last = static_cast<float>(resolution - 1);
    const float a = std::floor(from * cells_ + base), b = std::floor(to * cells_ + base);
    if (!(a <= last) || !(b >= 0.0f))
      return {1, 0};
    return {static_cast<int>(std::max(a, 0.0f)), static_cast<int>(std::min(b, last))};
  }

  bool macrocellsEmpty(int slice, float k0, float k1) const
  {
    constexpr int m = CoherentGrid::macrocellSize;
    const CellRange u = rangeU(k0, k1), v = rangeV(k0, k1);
    if (u.first > u.last || v.first > v.last)
      return true;
    const Vec3i n = grid_.macroResolution;
    Vec3i c;
    c[K] = slice / m;
    for (c[V] = v.first / m; c[V] <= v.last / m; ++c[V])
      for (c[U] = u.first / m; c[U] <= u.last / m; ++c[U])
        if (grid_.macrocellShown[(static_cast<std::size_t>(c.z) * n.y + c.y) * n.x + c.x])
          return false;
    return true;
  }

  void visitSlice(int slice, float k0, float k1)
  {
    const CellRange u = rangeU(k0, k1), v = rangeV(k0, k1);
    if (u.first > u.last)
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

  /// Cells x0 to x1 of the row (y, z): their particles lie one after another.
  HWY_INLINE void visitCells(int y, int z, int x0, int x1)
  {
    const std::size_t row = static_cast<std::size_t>(z) * grid_.resolution.y + y;
    const std::uint32_t* start =
      grid_.cellStart + row * (static_cast<std::size_t>(grid_.resolution.x) + 1);
    std::uint64_t slot = grid_.rowStart[row] + start[x0];
    const std::uint64_t end = grid_.rowStart[row] + start[x1 + 1];
    // Four records at a time; what is copied too much is overwritten by the next row.
    for (; slot < end; slot += 4)
    {
      const float* from = &grid_.records[slot].x;
      float* to = buffer_ + 4 * buffered_;
      for (int k = 0; k < 16; k += static_cast<int>(hn::Lanes(DF())))
        hn::StoreU(hn::LoadU(DF(), from + k), DF(), to + k);
      for (int k = 0; k < 4; ++k)
        slots_[buffered_ + k] = slot + k;
      buffered_ += static_cast<int>(std::min<std::uint64_t>(4, end - slot));
      if (buffered_ > bufferSize - 4)
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
      const VF ru = hn::Mul(r, hn::Set(d, frustum_.uWiden));
      const VF rv = hn::Mul(r, hn::Set(d, frustum_.vWiden));
      // At its own depth the sphere's centre may lie as far outside as the widened radius. That
      // holds before the start plane too, where the bounds alone do not: the ray meets the sphere
      // behind the plane, and |slope| x + sqrt(r^2 - x^2), for a hit x behind the centre, is never
      // more.
      const VF uLow = hn::MulAdd(hn::Set(d, frustum_.uLowSlope), k, hn::Set(d, frustum_.uLow));
      const VF uHigh = hn::MulAdd(hn::Set(d, frustum_.uHighSlope), k, hn::Set(d, frustum_.uHigh));
      const VF vLow = hn::MulAdd(hn::Set(d, frustum_.vLowSlope), k, hn::Set(d, frustum_.vLow));
      const VF vHigh = hn::MulAdd(hn::Set(d, frustum_.vHighSlope), k, hn::Set(d, frustum_.vHigh));
      const auto inU = hn::And(hn::Ge(hn::Add(u, ru), uLow), hn::Le(hn::Sub(u, ru), uHigh));
      const auto inV = hn::And(hn::Ge(hn::Add(v, rv), vLow), hn::Le(hn::Sub(v, rv), vHigh));
      const auto before = hn::Lt(hn::Sub(k, r), hn::Set(d, frustum_.farthest));
      const auto in = hn::And(
        hn::And(inU, inV), hn::And(before, hn::FirstN(d, static_cast<std::size_t>(buffered_ - i))));
      std::uint8_t bytes[8] = {};
      hn::StoreMaskBits(d, in, bytes);
      unsigned bits = bytes[0] | (static_cast<unsigned>(bytes[1]) << 8);
      if (bits == 0)
        continue;
      hn::Store(u, d, u_);
      hn::Store(v, d, v_);
      hn::Store(k, d, k_);
      for (; bits != 0; bits &= bits - 1)
      {
        const int j = __builtin_ctz(bits);
        if (grid_.isShown(slots_[i + j]))
          testSphere(u_[j], v_[j], k_[j], buffer_[4 * (i + j) + 3], slots_[i + j]);
      }
    }
    buffered_ = 0;
  }

  /// The stable form: distance from the centre to the ray by the perpendicular remainder, never as
  /// a difference of squared distances to the origin.
  HWY_INLINE void testSphere(float u, float v, float k, float radius, std::uint64_t slot)
  {
    const DF d;
    const DU du32;
    const VF cu = hn::Set(d, u), cv = hn::Set(d, v), ck = hn::Set(d, k);
    const VF r2 = hn::Set(d, radius * radius);
    const auto mark = hn::Set(du32, static_cast<std::uint32_t>(hits_.size() + 1));
    bool isHit = false;
    for (int i = 0; i < 64; i += static_cast<int>(hn::Lanes(d)))
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
      isHit = true;
      hn::Store(hn::IfThenElse(nearer, near, best), d, p_.best + i);
      const auto old = hn::Load(du32, p_.hit + i);
      hn::Store(hn::IfThenElse(hn::RebindMask(du32, nearer), mark, old), du32, p_.hit + i);
    }
    if (isHit)
    {
      hits_.push_back(slot);
      changed_ = true;
    }
  }

  static constexpr int bufferSize = 64;

  const CoherentGridView& grid_;
  Packet& p_;
  std::vector<std::uint64_t>& hits_;
  Frustum frustum_;
  Split centerU_, centerV_, plane_;
  float cells_, baseU_, baseV_, front0_, sign_;
  bool changed_ = false;
  int buffered_ = 0;
  alignas(64) float buffer_[4 * (bufferSize + 16)];
  std::uint64_t slots_[bufferSize + 16];
  alignas(64) float u_[16], v_[16], k_[16];
};

/// Casts a packet whose rays travel the same way along one axis; false, with nothing done, where
/// they do not.
bool castCoherent(const CoherentGridView& grid, RayPacket& rays, std::int32_t object)
{
  Packet p;
  const int middle = rays.count / 2;
  const double d[3] = {
    rays.direction[0][middle], rays.direction[1][middle], rays.direction[2][middle]};
  p.K = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::abs(d[axis]) > std::abs(d[p.K]))
      p.K = axis;
  p.U = p.K == 0 ? 1 : 0;
  p.V = p.K == 2 ? 1 : 2;
  p.sign = d[p.K] < 0.0 ? -1.0 : 1.0;
  double nearest = 0.0;
  if (!isCoherent(grid, rays, p, nearest))
    return false;
  // In the direction of travel the box of all spheres reaches from nearFace to farFace.
  const double lowerK = grid.lower[p.K] - grid.reach;
  const double upperK = grid.lower[p.K] + double(grid.cellSize) * grid.resolution[p.K] + grid.reach;
  const double nearFace = p.sign > 0.0 ? lowerK : -upperK;
  const double farFace = p.sign > 0.0 ? upperK : -lowerK;
  const double start = std::max(nearFace, nearest);
  if (!(start <= farFace))
    return true;
  p.plane = p.sign * start;
  p.depth = static_cast<float>(farFace - start);
  localize(grid, rays, p);
  const float entry = clipToBox(grid, p);
  if (!(entry < infinity))
    return true;

  static thread_local std::vector<std::uint64_t> hits;
  hits.clear();
  switch (p.K)
  {
  case 0:
    GridCaster<0>(grid, p, hits).run(entry);
    break;
  case 1:
    GridCaster<1>(grid, p, hits).run(entry);
    break;
  default:
    GridCaster<2>(grid, p, hits).run(entry);
  }
  keepHits(p, hits, object, rays);
  return true;
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
