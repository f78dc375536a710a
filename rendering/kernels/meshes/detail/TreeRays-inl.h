// Rays that have nothing in common, as an RlodTree sees them. Included once per SIMD instruction
// set.

#if defined(MOTE_MESH_TREE_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_MESH_TREE_RAYS_INL_H
#undef MOTE_MESH_TREE_RAYS_INL_H
#else
#define MOTE_MESH_TREE_RAYS_INL_H
#endif

#include "../../core/RayPacket.h"
#include "BundleFrame.h"
#include "MeshSimd-inl.h"
#include "PlaneMeeting-inl.h"
#include "RlodTreeView.h"

#include <algorithm>
#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// The rays of a packet, made many at a time. Each counts from its own Q, a float point near where
/// it enters the triangles. Its steepest axis is its depth: z is how far a point lies from Q that
/// way, and u and v are how far it lies from the ray along the other two axes, at the same depth.
struct TreeRays
{
  static constexpr int capacity = RayPacket::capacity;

  alignas(64) float q[3][capacity];
  alignas(64) float u0[capacity], v0[capacity];       ///< of Q
  alignas(64) float perZu[capacity], perZv[capacity]; ///< what the ray goes there in a step of z
  alignas(64) float sign[capacity];                   ///< of the direction along its depth
  alignas(64) float inverse[3][capacity];   ///< steps of z in a step along an axis, finite
  alignas(64) float first[capacity];        ///< hits with z <= first do not count
  alignas(64) float best[capacity];         ///< of the nearest hit, or the farthest that counts
  alignas(64) std::int32_t depth[capacity]; ///< axis
  alignas(64) double t0[capacity], perZ[capacity]; ///< t = t0 + perZ * z

  TreeRays(const RlodTreeView& view, const RayPacket& packet)
    : end_(packet.onSurface)
  {
    for (int i = 0; i < packet.count; i += static_cast<int>(hn::MaxLanes(DD())))
      place(view, packet, i);
  }

  /// Whether the ray can hit anything at all.
  bool isAnywhere(int i) const { return best[i] > first[i]; }

  /// z of the end that lies on a surface, or NaN.
  float onSurface(int i) const
  {
    if (end_ == OnSurface::Neither)
      return std::numeric_limits<float>::quiet_NaN();
    return end_ == OnSurface::End ? best[i] : static_cast<float>(-t0[i] / perZ[i]);
  }

  /// What rays may err by along z where R-LODs of `factor` footprints are taken.
  Tolerance tolerance(const RayPacket& packet, double factor, int i) const
  {
    return {static_cast<float>(factor * (packet.footprint + t0[i] * packet.footprintPerT)),
      static_cast<float>(factor * (perZ[i] * packet.footprintPerT))};
  }

private:
  /// Where rays enter and leave what holds all triangles, and a little more.
  struct Span
  {
    VD enter, leave;
    VD per[3]; ///< steps of t in a step along an axis, finite
  };

  static HWY_INLINE Span spanOf(
    const RlodTreeView& view, const VD* origin, const VD* way, VD from, VD to)
  {
    const DD d;
    constexpr double more = 1e-6;
    Span span;
    span.enter = from;
    span.leave = to;
    for (int axis = 0; axis < 3; ++axis)
    {
      const VD length = hn::Max(hn::Abs(way[axis]), hn::Set(d, 1e-300));
      const VD per = span.per[axis] = hn::Div(hn::Set(d, 1.0), hn::CopySign(length, way[axis]));
      const VD a = hn::Mul(hn::Sub(hn::Set(d, view.lower[axis] - more), origin[axis]), per);
      const VD b = hn::Mul(hn::Sub(hn::Set(d, view.upper[axis] + more), origin[axis]), per);
      span.enter = hn::Max(span.enter, hn::Min(a, b));
      span.leave = hn::Min(span.leave, hn::Max(a, b));
    }
    return span;
  }

  HWY_INLINE void place(const RlodTreeView& view, const RayPacket& packet, int i)
  {
    const DD d;
    const DH h;
    const auto set = [&](double v) { return hn::Set(d, v); };
    const VD perUnit = set(1.0 / view.unit);
    VD origin[3], way[3], size[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      origin[axis] =
        hn::Mul(hn::Sub(hn::Load(d, packet.origin[axis] + i), set(view.origin[axis])), perUnit);
      way[axis] = hn::Mul(hn::Load(d, packet.direction[axis] + i), perUnit);
      size[axis] = hn::Abs(way[axis]);
    }
    const VD begin = hn::Load(d, packet.tMin + i), end = hn::Load(d, packet.t + i);
    const Span span = spanOf(view, origin, way, begin, end);
    const auto isX = hn::And(hn::Ge(size[0], size[1]), hn::Ge(size[0], size[2]));
    const auto isY = hn::AndNot(isX, hn::Ge(size[1], size[2]));
    const auto chosen = [&](VD x, VD y, VD z)
    { return hn::IfThenElse(isX, x, hn::IfThenElse(isY, y, z)); };

    VD rest[3]; // from Q to the ray
    for (int axis = 0; axis < 3; ++axis)
    {
      const VD at = hn::MulAdd(span.enter, way[axis], origin[axis]);
      const auto near = hn::DemoteTo(h, at);
      hn::Store(near, h, q[axis] + i);
      rest[axis] = hn::Sub(at, hn::PromoteTo(d, near));
    }
    const VD deep = chosen(way[0], way[1], way[2]);
    const VD steps = chosen(span.per[0], span.per[1], span.per[2]), perDepth = hn::Abs(steps);
    const VD slopeU = hn::Mul(chosen(way[1], way[2], way[0]), steps);
    const VD slopeV = hn::Mul(chosen(way[2], way[0], way[1]), steps);
    const VD restZ = chosen(rest[0], rest[1], rest[2]);
    const auto keep = [&](VD v, float* to) { hn::Store(hn::DemoteTo(h, v), h, to + i); };
    keep(hn::NegMulAdd(restZ, slopeU, chosen(rest[1], rest[2], rest[0])), u0);
    keep(hn::NegMulAdd(restZ, slopeV, chosen(rest[2], rest[0], rest[1])), v0);
    keep(slopeU, perZu);
    keep(slopeV, perZv);
    keep(hn::CopySign(set(1.0), deep), sign);
    for (int axis = 0; axis < 3; ++axis)
    {
      const VD share = hn::Mul(span.per[axis], hn::Abs(deep));
      keep(hn::CopySign(hn::Min(hn::Abs(share), set(1e18)), share), inverse[axis]);
    }
    const VD t = hn::NegMulAdd(restZ, steps, span.enter);
    hn::Store(t, d, t0 + i);
    hn::Store(perDepth, d, perZ + i);
    const VD perT = hn::Abs(deep);
    keep(hn::Mul(hn::Sub(begin, t), perT), first);
    // What passes by, and what has no direction, ends before it begins.
    const auto meets = hn::And(hn::Le(span.enter, span.leave), hn::Gt(perT, hn::Zero(d)));
    keep(hn::IfThenElse(
           meets, hn::Mul(hn::Sub(end, t), perT), set(-std::numeric_limits<double>::infinity())),
      best);
    const hn::Rebind<std::int32_t, DD> whole;
    hn::Store(hn::DemoteTo(whole, chosen(set(0.0), set(1.0), set(2.0))), whole, depth + i);
  }

  OnSurface end_;
};

/// One ray of a packet, ready to be compared with many triangles.
struct TriangleRay
{
  alignas(16) float q[4]; ///< the fourth number is 0
  int axisU, axisV, axisZ;
  float u0, v0, perZu, perZv, sign, first, best;
  float onSurface; ///< z of the end that lies on a surface, or NaN

  TriangleRay() = default;
  HWY_INLINE TriangleRay(const TreeRays& rays, int i)
    : q{rays.q[0][i], rays.q[1][i], rays.q[2][i], 0.0f}
    , axisZ(rays.depth[i])
    , u0(rays.u0[i])
    , v0(rays.v0[i])
    , perZu(rays.perZu[i])
    , perZv(rays.perZv[i])
    , sign(rays.sign[i])
    , first(rays.first[i])
    , best(rays.best[i])
    , onSurface(rays.onSurface(i))
  {
    axisU = axisZ == 2 ? 0 : axisZ + 1;
    axisV = axisU == 2 ? 0 : axisU + 1;
  }

  /// Triangles of a cluster that the ray meets between its ends, as bits; `z` becomes where.
  /// `corners` are the cluster's: many rays meet it.
  template <typename Policy>
  HWY_INLINE unsigned trianglesMet(
    const TriangleCluster& cluster, const AllCornerIndices& corners, Row& z) const
  {
    const DF d;
    Row u, v, deep;
    for (int set = 0; set < laneSets; ++set)
    {
      const auto along = [&](int axis)
      { return hn::Sub(hn::LoadU(d, cluster.point[axis] + set * lanes), all(q[axis])); };
      const VF depth = along(axisZ);
      u.store(hn::NegMulAdd(depth, all(perZu), hn::Sub(along(axisU), all(u0))), set);
      v.store(hn::NegMulAdd(depth, all(perZv), hn::Sub(along(axisV), all(v0))), set);
      deep.store(hn::Mul(depth, all(sign)), set);
    }
    unsigned bits = 0;
    for (int set = 0; set < laneSets; ++set)
    {
      const CornerIndices& at = corners.sets[set];
      const Edges edges(
        {u.at(at.a), v.at(at.a)}, {u.at(at.b), v.at(at.b)}, {u.at(at.c), v.at(at.c)});
      const VF sum = edges.sum();
      const MF hits = Policy::isInner ? edges.hitsInner(sum, sign) : edges.hits(sum);
      if (hn::AllFalse(d, hits))
        continue;
      const VF depth = edges.at(sum, deep.at(at.a), deep.at(at.b), deep.at(at.c));
      z.store(depth, set);
      bits |= bitsOf(hn::And(hits, hn::And(hn::Gt(depth, all(first)), hn::Lt(depth, all(best)))))
              << (set * lanes);
    }
    return bits & lowest(cluster.count);
  }

  /// R-LODs of a node that the ray meets between `near` and `far`, where it is in the children's
  /// boxes, as bits; z becomes where. Those that hold the ray's end on a surface are none of them.
  HWY_INLINE unsigned planesMet(
    const RlodPlanes& planes, const Row& near, const Row& far, Row& z) const
  {
    const DF d;
    const float nearest = std::nextafter(first, infinity);
    // Where the ray is in boxes is known between its ends alone.
    const float between =
      std::isnan(onSurface) ? onSurface : std::clamp(onSurface, nearest, std::max(nearest, best));
    unsigned bits = 0;
    for (int set = 0; set < laneSets; ++set)
    {
      const auto normal = [&](int axis) { return hn::Load(d, planes.normal[axis] + set * lanes); };
      const VF deep = normal(axisZ), u = normal(axisU), v = normal(axisV);
      PlaneMeeting meeting = {hn::Max(near.load(set), all(nearest)), far.load(set),
        hn::Neg(hn::Load(d, planes.offset + set * lanes)), hn::Zero(d)};
      for (int axis = 0; axis < 3; ++axis)
        meeting.height = hn::MulAdd(normal(axis), all(q[axis]), meeting.height);
      meeting.height = hn::MulAdd(u, all(u0), hn::MulAdd(v, all(v0), meeting.height));
      meeting.slope =
        hn::Mul(all(sign), hn::MulAdd(u, all(perZu), hn::MulAdd(v, all(perZv), deep)));
      const VF deviation = hn::Load(d, planes.deviation + set * lanes);
      VF at;
      MF met = meeting.meets(deviation, at);
      z.store(at, set);
      met = hn::And(met, hn::And(hn::Gt(at, all(first)), hn::Lt(at, all(best))));
      if (!hn::AllFalse(d, met))
        met = hn::AndNot(meeting.holds(deviation, all(onSurface), all(between)), met);
      bits |= bitsOf(met) << (set * lanes);
    }
    return bits;
  }
};

/// Those of the children `may` of a node whose R-LODs err by less than allowed(set), a vector.
template <typename Allowed>
HWY_INLINE unsigned finerChildren(
  const RlodTreeView& view, std::uint32_t index, unsigned may, const Allowed& allowed)
{
  if (may == 0)
    return 0;
  unsigned bits = 0;
  for (int set = 0; set < laneSets; ++set)
    bits |= bitsOf(hn::Gt(allowed(set), errorRadii(view.words[index], view.levels, set)))
            << (set * lanes);
  return bits & may;
}

/// By less than a number.
HWY_INLINE unsigned fineChildren(
  const RlodTreeView& view, std::uint32_t index, unsigned may, float allowed)
{
  return finerChildren(view, index, may, [&](int) { return all(allowed); });
}

/// By less than is allowed where the ray meets them first.
HWY_INLINE unsigned fineChildren(const RlodTreeView& view, std::uint32_t index, unsigned may,
  const Tolerance& tolerance, const Row& near)
{
  return finerChildren(view, index, may,
    [&](int set) { return hn::MulAdd(near.load(set), all(tolerance.perZ), all(tolerance.atQ)); });
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
