// Bundles of rays through an RlodTree. Included once per SIMD instruction set.

#if defined(MOTE_RLOD_TREE_BUNDLE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_RLOD_TREE_BUNDLE_INL_H
#undef MOTE_RLOD_TREE_BUNDLE_INL_H
#else
#define MOTE_RLOD_TREE_BUNDLE_INL_H
#endif

#include "ClusterCast-inl.h"
#include "PlaneCast-inl.h"

#include <cmath>
#include <type_traits>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// Where the children of a node lie in a bundle's picture.
struct ChildPlaces
{
  alignas(64) Rect rect[16];
  alignas(64) float z0[16]; ///< not above the z of any point of the child
  unsigned bits;            ///< children that may be met
};

/// Projects the boxes of nodes into a bundle's picture.
class NodeProjector
{
public:
  NodeProjector(const BundleFrame& frame, const BundleRays& rays)
    : frame_(frame)
    , rays_(rays)
  {
  }

  /// Finds the children that hold cells of the picture. Those that end before the rays begin, or
  /// begin behind `farthest`, do not count.
  HWY_INLINE void project(const RlodNode& node, float farthest, ChildPlaces& places) const
  {
    Functions f(frame_, node);
    places.bits = 0;
    for (int set = 0; set < laneSets; ++set)
      projectSet(node, f, farthest, set, places);
    places.bits &= lowest(node.children);
  }

private:
  /// u, v, z on the node's box: at its corner, per half step of its bounds, and how far rounding
  /// may move them, here and where the triangles within are projected.
  struct Functions
  {
    alignas(16) float at[4], step[3][4], size[3][4], error[4];

    HWY_INLINE Functions(const BundleFrame& frame, const RlodNode& node)
    {
      const hn::CappedTag<float, 4> d;
      for (int k = 0; k < 4; k += static_cast<int>(hn::Lanes(d)))
      {
        auto corner = hn::Load(d, frame.atQ + k);
        auto reach = hn::Abs(corner);
        for (int axis = 0; axis < 3; ++axis)
        {
          const float from = node.origin[axis] - frame.q[axis], half = 0.5f * node.scale[axis];
          const auto per = hn::Load(d, frame.perAxis[axis] + k);
          const auto perHalf = hn::Mul(per, hn::Set(d, half));
          corner = hn::MulAdd(per, hn::Set(d, from), corner);
          reach = hn::MulAdd(hn::Abs(per), hn::Set(d, std::abs(from) + 510.0f * half), reach);
          hn::Store(perHalf, d, step[axis] + k);
          hn::Store(hn::Abs(perHalf), d, size[axis] + k);
        }
        hn::Store(corner, d, at + k);
        hn::Store(hn::Mul(reach, hn::Set(d, 0x1p-20f)), d, error + k);
      }
    }
  };

  struct Span
  {
    VF low, high;
  };

  HWY_INLINE void projectSet(
    const RlodNode& node, const Functions& f, float farthest, int set, ChildPlaces& places) const
  {
    const DF d;
    VF middle[3], width[3]; // in half steps
    for (int axis = 0; axis < 3; ++axis)
    {
      const VI low = widened(node.low(axis) + set * lanes);
      const VI high = widened(node.high(axis) + set * lanes);
      middle[axis] = hn::ConvertTo(d, hn::Add(low, high));
      width[axis] = hn::ConvertTo(d, hn::Sub(high, low));
    }
    const auto span = [&](int k) -> Span
    {
      const VF at = hn::MulAdd(middle[0], all(f.step[0][k]),
        hn::MulAdd(
          middle[1], all(f.step[1][k]), hn::MulAdd(middle[2], all(f.step[2][k]), all(f.at[k]))));
      const VF half = hn::MulAdd(width[0], all(f.size[0][k]),
        hn::MulAdd(
          width[1], all(f.size[1][k]), hn::MulAdd(width[2], all(f.size[2][k]), all(f.error[k]))));
      return {hn::Sub(at, half), hn::Add(at, half)};
    };
    const Span z = span(2);
    const VF perZ = all(frame_.weightPerZ), atQ = all(frame_.weightAtQ);
    const VF s0 = hn::MulAdd(z.low, perZ, atQ), s1 = hn::MulAdd(z.high, perZ, atQ);
    const VF per0 = hn::ApproximateReciprocal(s0), per1 = hn::ApproximateReciprocal(s1);
    const VF end = all(float(rays_.lastCell)), zero = hn::Zero(d);
    const auto cells = [&](const Span& u, VF& first, VF& last)
    {
      const VF low = hn::Min(hn::Mul(u.low, per0), hn::Mul(u.low, per1));
      const VF high = hn::Max(hn::Mul(u.high, per0), hn::Mul(u.high, per1));
      first = hn::Max(hn::Ceil(hn::Add(low, all(rays_.toFirst))), zero);
      last = hn::Min(hn::Floor(hn::Add(high, all(rays_.toLast))), end);
    };
    VF x0, x1, y0, y1;
    cells(span(0), x0, x1);
    cells(span(1), y0, y1);
    const MF inDepth = hn::And(hn::Gt(z.high, all(frame_.first)), hn::Lt(z.low, all(farthest)));
    unsigned bits = bitsOf(hn::And(hn::And(hn::Le(x0, x1), hn::Le(y0, y1)), inDepth));
    const auto byte = [&](VF cell) { return hn::NearestInt(cell); };
    const VI rect = hn::Or(hn::Or(byte(x0), hn::ShiftLeft<8>(byte(x1))),
      hn::Or(hn::ShiftLeft<16>(byte(y0)), hn::ShiftLeft<24>(byte(y1))));
    const DU du;
    hn::Store(hn::BitCast(du, rect), du, places.rect + set * lanes);
    hn::Store(z.low, d, places.z0 + set * lanes);
    if (const unsigned beside = bitsOf(hn::Lt(s0, all(leastWeight))); HWY_UNLIKELY(beside != 0))
      bits = projectBeside(node, f, set, beside, bits, bitsOf(inDepth), places);
    places.bits |= bits << (set * lanes);
  }

  /// Children that reach to where the rays begin, or behind, have no rectangle: they count unless
  /// they lie outside one of the four planes around the rays.
  HWY_NOINLINE unsigned projectBeside(const RlodNode& node, const Functions& f, int set,
    unsigned beside, unsigned bits, unsigned inDepth, ChildPlaces& places) const
  {
    const auto last = static_cast<Rect>(rays_.lastCell);
    bits &= ~beside;
    for (unsigned left = beside & inDepth; left != 0; left &= left - 1)
    {
      const int k = std::countr_zero(left), child = set * lanes + k;
      bool outside = false;
      for (int plane = 0; plane < 4; ++plane)
        outside = outside || isOutside(node, f, child, plane / 2, plane % 2 == 0 ? 8.0f : -8.0f);
      if (outside)
        continue;
      bits |= 1U << k;
      places.rect[child] = last << 8 | last << 24;
    }
    return bits;
  }

  /// Whether all of a child's box lies beyond the plane u = edge s, or v, seen from the rays.
  bool isOutside(const RlodNode& node, const Functions& f, int child, int k, float edge) const
  {
    const float perS = edge * frame_.weightPerZ, sign = edge < 0.0f ? -1.0f : 1.0f;
    float middle = f.at[k] - perS * f.at[2] - edge * frame_.weightAtQ;
    float half = f.error[k] + std::abs(perS) * f.error[2];
    for (int axis = 0; axis < 3; ++axis)
    {
      const float step = f.step[axis][k] - perS * f.step[axis][2];
      const int low = node.low(axis)[child], high = node.high(axis)[child];
      middle += step * static_cast<float>(low + high);
      half += std::abs(step) * static_cast<float>(high - low);
    }
    return sign * middle > half;
  }

  static constexpr float leastWeight = 1e-6f;

  const BundleFrame& frame_;
  const BundleRays& rays_;
};

/// In place of what casts at planes, where there are none.
struct NoPlanes
{
  NoPlanes(const RlodTreeView&, const BundleFrame&, const BundleRays&) {}
};

/// Takes a bundle through a tree, front to back; with R-LODs where `lods`.
template <typename Policy, bool lods>
class BundleCaster
{
public:
  BundleCaster(const RlodTreeView& view, const BundleFrame& frame, BundleRays& rays,
    const Tolerance& tolerance)
    : view_(view)
    , rays_(rays)
    , tolerance_(tolerance)
    , projector_(frame, rays)
    , clusters_(frame, rays)
    , planes_(view, frame, rays)
  {
  }

  void run(RlodTree::Counts* counts)
  {
    static thread_local std::vector<Waiting> stack;
    if (stack.size() < view_.stackSize())
      stack.resize(view_.stackSize());
    Waiting* top = stack.data();
    const auto last = static_cast<Rect>(rays_.lastCell);
    *top++ = {0, -infinity, last << 8 | last << 24};
    while (top != stack.data())
    {
      const Waiting next = *--top;
      if (rays_.hides(next.z0, next.rect))
        continue;
      const RlodNode& node = view_.nodes[next.index];
      ChildPlaces places;
      projector_.project(node, rays_.farthest(), places);
      if (counts != nullptr)
        count(counts->nodes, 1, counts->seenNodes, next.index);
      if constexpr (lods)
        if (const unsigned may = places.bits & view_.mayErr(node); may != 0)
          castPlanes(next.index, may, places, counts);
      if (const unsigned clusters = places.bits & lowest(node.clusters); clusters != 0)
        castClusters(node, places, clusters, counts);
      if (const unsigned nodes = places.bits & ~lowest(node.clusters); nodes != 0)
        top = waitNearestLast(node, places, nodes, top);
    }
  }

private:
  struct Waiting
  {
    std::uint32_t index;
    float z0;
    Rect rect;
  };

  static void count(std::uint64_t& all, int more, std::vector<bool>& seen, std::uint32_t index)
  {
    all += static_cast<std::uint64_t>(more);
    if (!seen.empty())
      seen[index] = true;
  }

  /// Casts at the R-LODs of those of the children `may` that err by less than is allowed where they
  /// begin, in place of the children.
  void castPlanes(std::uint32_t index, unsigned may, ChildPlaces& places, RlodTree::Counts* counts)
  {
    unsigned fine = 0;
    for (int set = 0; set < laneSets; ++set)
    {
      const VF z0 = hn::Load(DF(), places.z0 + set * lanes);
      const VF allowed = hn::MulAdd(z0, all(tolerance_.perZ), all(tolerance_.atQ));
      const VF error = errorRadii(view_.words[index], view_.levels, set);
      fine |= bitsOf(hn::Gt(allowed, error)) << (set * lanes);
    }
    fine &= may;
    if (fine == 0)
      return;
    places.bits &= ~fine;
    unsigned seen = 0;
    for (unsigned left = fine; left != 0; left &= left - 1)
    {
      const int k = std::countr_zero(left);
      if (!rays_.hides(places.z0[k], places.rect[k]))
        seen |= 1U << k;
    }
    if (seen == 0)
      return;
    planes_.cast(index, places.rect, seen);
    if (counts != nullptr)
      count(counts->lods, std::popcount(seen), counts->seenPlanes, index);
  }

  void castClusters(
    const RlodNode& node, const ChildPlaces& places, unsigned bits, RlodTree::Counts* counts)
  {
    unsigned seen = 0;
    for (; bits != 0; bits &= bits - 1)
    {
      const int k = std::countr_zero(bits);
      if (rays_.hides(places.z0[k], places.rect[k]))
        continue;
      seen |= 1U << k;
      prefetch(
        &view_.clusters[node.firstCluster + static_cast<unsigned>(k)], sizeof(TriangleCluster));
    }
    for (; seen != 0; seen &= seen - 1)
    {
      const int k = std::countr_zero(seen);
      if (rays_.hides(places.z0[k], places.rect[k]))
        continue;
      const std::uint32_t cluster = node.firstCluster + static_cast<unsigned>(k);
      clusters_.cast(view_.clusters[cluster], cluster * TriangleCluster::capacity);
      if (counts != nullptr)
        count(counts->clusters, 1, counts->seenClusters, cluster);
    }
  }

  /// Puts children onto the stack so that the nearest is the last. Answers the stack's top.
  Waiting* waitNearestLast(
    const RlodNode& node, const ChildPlaces& places, unsigned bits, Waiting* bottom)
  {
    Waiting* top = bottom;
    for (; bits != 0; bits &= bits - 1)
    {
      const auto k = static_cast<unsigned>(std::countr_zero(bits));
      const Waiting child = {node.nodeOf(k), places.z0[k], places.rect[k]};
      prefetch(&view_.nodes[child.index], sizeof(RlodNode));
      Waiting* at = top++;
      for (; at != bottom && at[-1].z0 < child.z0; --at)
        *at = at[-1];
      *at = child;
    }
    return top;
  }

  static HWY_INLINE void prefetch(const void* what, std::size_t bytes)
  {
    for (std::size_t byte = 0; byte < bytes; byte += 64)
      __builtin_prefetch(static_cast<const char*>(what) + byte);
  }

  const RlodTreeView& view_;
  BundleRays& rays_;
  Tolerance tolerance_;
  NodeProjector projector_;
  ClusterCaster<Policy> clusters_;
  std::conditional_t<lods, PlaneCaster<Policy>, NoPlanes> planes_;
};

/// Writes what the rays have hit into the bundle.
template <typename Policy>
void keepAnswers(
  const BundleFrame& frame, const BundleRays& rays, std::int32_t object, RayBundle& bundle)
{
  const DD d;
  const DH h;
  const hn::Rebind<std::uint32_t, DD> u32;
  const hn::RebindToUnsigned<DD> u64;
  const VD zOfQ = hn::Set(d, frame.zOfQ), perSpeed = hn::Set(d, 1.0 / frame.speed);
  const auto none = hn::Set(u64, std::uint64_t{noSlot});
  for (int i = 0; i < bundle.count; i += static_cast<int>(hn::MaxLanes(d)))
  {
    const auto slot = hn::PromoteTo(u64, hn::Load(u32, rays.slot + i));
    const auto z = hn::PromoteTo(d, hn::Load(h, rays.z + i));
    const VD before = hn::Load(d, bundle.t + i), t = hn::Mul(hn::Add(zOfQ, z), perSpeed);
    // What is as near already may be a little farther in float.
    const auto hit = hn::And(
      hn::RebindMask(d, hn::Ne(slot, none)), hn::Lt(Policy::any ? hn::Set(d, -1e300) : t, before));
    if (hn::AllFalse(d, hit))
      continue;
    if constexpr (Policy::any)
    {
      hn::Store(hn::IfThenElse(hit, hn::Set(d, -std::numeric_limits<double>::infinity()), before),
        d, bundle.t + i);
      continue;
    }
    hn::Store(hn::IfThenElse(hit, t, before), d, bundle.t + i);
    const auto hit64 = hn::RebindMask(u64, hit);
    hn::Store(hn::IfThenElse(hit64, slot, hn::Load(u64, bundle.slot + i)), u64, bundle.slot + i);
    alignas(64) std::uint64_t hits[hn::MaxLanes(d)];
    hn::Store(hn::VecFromMask(u64, hit64), u64, hits);
    for (std::size_t k = 0; k < hn::MaxLanes(d); ++k)
      bundle.object[i + static_cast<int>(k)] =
        hits[k] != 0 ? object : bundle.object[i + static_cast<int>(k)];
  }
}

/// Casts a bundle, at R-LODs that err by less than `poe` footprints where that is above 0; false,
/// with nothing done, where its rays are better cast one by one.
template <typename Policy>
bool castBundle(const RlodTreeView& view, RayBundle& bundle, std::int32_t object, double poe,
  RlodTree::Counts* counts)
{
  const bool lods = view.takesLods(bundle, poe);
  BundleFrame frame;
  if (bundle.count < 4 || !frame.place(view, bundle, lods))
    return false;
  BundleRays rays(frame, bundle);
  if (lods)
    BundleCaster<Policy, true>(view, frame, rays, frame.tolerance(view, bundle, poe)).run(counts);
  else
    BundleCaster<Policy, false>(view, frame, rays, {}).run(counts);
  keepAnswers<Policy>(frame, rays, object, bundle);
  return true;
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
