// Single rays through a PkdTree, included once per SIMD instruction set by PkdTreeCast.cpp: many
// children or particles at once, one ray at a time.

#if defined(MOTE_PKD_TREE_RAY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_PKD_TREE_RAY_INL_H
#undef MOTE_PKD_TREE_RAY_INL_H
#else
#define MOTE_PKD_TREE_RAY_INL_H
#endif

#include "../core/RayPacket.h"
#include "PkdTreeBundle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

using D4 = hn::CappedTag<float, 4>;

/// A ray in the tree's coordinates: P + tau d, with |d| = 1 and P where it enters the bounds. The
/// fourth numbers hold nothing.
struct TreeRay
{
  alignas(16) float p[4];
  alignas(16) float high[4];    ///< P, to what corners of treelets are multiples of
  alignas(16) float low[4];     ///< and the rest of it
  alignas(16) float inverse[4]; ///< of d, finite
  float d[3];
  float first; ///< hits at tau <= first do not count
  float best;  ///< tau of the nearest hit so far
  std::uint64_t slot;
};

/// The rays of a packet in the tree's coordinates, many at a time.
struct TreeRays
{
  alignas(64) float p[3][RayPacket::capacity], high[3][RayPacket::capacity],
    low[3][RayPacket::capacity], d[3][RayPacket::capacity], inverse[3][RayPacket::capacity];
  alignas(64) float first[RayPacket::capacity], best[RayPacket::capacity];
  alignas(64) double t0[RayPacket::capacity];   ///< tau of P counted from the ray's own origin
  alignas(64) double perT[RayPacket::capacity]; ///< units of tau in one of the ray's t

  TreeRays(const PkdTreeView& view, const RayPacket& packet)
  {
    const DD d;
    const DH h;
    const auto set = [&](double v) { return hn::Set(d, v); };
    const VD perUnit = set(1.0 / view.tree.unit()), one = set(1.0);
    const VD coarse = set(view.coarse), perCoarse = set(1.0 / double(view.coarse));
    for (int i = 0; i < packet.count; i += static_cast<int>(hn::Lanes(d)))
    {
      VD origin[3], way[3], inverses[3], length2 = hn::Zero(d);
      for (int k = 0; k < 3; ++k)
      {
        origin[k] =
          hn::Mul(hn::Sub(hn::Load(d, packet.origin[k] + i), set(view.tree.origin()[k])), perUnit);
        way[k] = hn::Load(d, packet.direction[k] + i);
        length2 = hn::MulAdd(way[k], way[k], length2);
      }
      const VD speed = hn::Sqrt(length2), perSpeed = hn::Div(one, speed);
      const VD toTau = hn::Mul(speed, perUnit);
      VD enter = hn::Mul(hn::Load(d, packet.tMin + i), toTau);
      VD leave = hn::Mul(hn::Load(d, packet.t + i), toTau);
      const VD begin = enter, end = leave;
      for (int k = 0; k < 3; ++k)
      {
        way[k] = hn::Mul(way[k], perSpeed);
        // Never infinite, so that no product with it is without meaning.
        inverses[k] = hn::Div(one, hn::CopySign(hn::Max(hn::Abs(way[k]), set(1e-18)), way[k]));
        const VD a = hn::Mul(hn::Sub(set(view.least[k]), origin[k]), inverses[k]);
        const VD b = hn::Mul(hn::Sub(set(view.most[k]), origin[k]), inverses[k]);
        enter = hn::Max(enter, hn::Min(a, b));
        leave = hn::Min(leave, hn::Max(a, b));
      }
      for (int k = 0; k < 3; ++k)
      {
        const VD at = hn::MulAdd(enter, way[k], origin[k]);
        const VD rough = hn::Mul(hn::Round(hn::Mul(at, perCoarse)), coarse);
        hn::Store(hn::DemoteTo(h, at), h, p[k] + i);
        hn::Store(hn::DemoteTo(h, rough), h, high[k] + i);
        hn::Store(hn::DemoteTo(h, hn::Sub(at, rough)), h, low[k] + i);
        hn::Store(hn::DemoteTo(h, way[k]), h, this->d[k] + i);
        hn::Store(hn::DemoteTo(h, inverses[k]), h, inverse[k] + i);
      }
      // A ray that passes by, or has no direction, ends before it begins.
      const auto meets = hn::And(hn::Lt(enter, leave), hn::Gt(length2, hn::Zero(d)));
      const VD last =
        hn::IfThenElse(meets, hn::Sub(end, enter), set(-std::numeric_limits<double>::infinity()));
      hn::Store(hn::DemoteTo(h, hn::Sub(begin, enter)), h, first + i);
      hn::Store(hn::DemoteTo(h, last), h, best + i);
      hn::Store(enter, d, t0 + i);
      hn::Store(toTau, d, perT + i);
    }
  }

  bool meets(int i) const { return best[i] > first[i]; }

  TreeRay ray(int i) const
  {
    TreeRay r;
    for (int k = 0; k < 3; ++k)
    {
      r.p[k] = p[k][i];
      r.high[k] = high[k][i];
      r.low[k] = low[k][i];
      r.inverse[k] = inverse[k][i];
      r.d[k] = d[k][i];
    }
    r.p[3] = r.high[3] = r.low[3] = r.inverse[3] = 0.0f;
    r.first = first[i];
    r.best = best[i];
    r.slot = RayPacket::noHit;
    return r;
  }
};

/// Finds the nearest hit of a ray, or, with ANY, whether there is one.
template <bool ANY>
class TreeRayCaster
{
public:
  TreeRayCaster(const PkdTreeView& view, TreeRay& ray, std::uint64_t own)
    : view_(view)
    , ray_(ray)
    , own_(own)
  {
  }

  bool fromTop() { return below(view_.top, 0, -infinity); }

  /// From the bucket of a particle near the ray's begin upwards: what is near is met first, and
  /// for most rays that meet something that is enough.
  bool from(std::uint64_t slot)
  {
    const std::size_t bucket = slot / PkdTree::bucketSize, treelet = bucket / PkdTree::fanout;
    setCorner(view_.node(0, treelet));
    if (visitBucket(bucket))
      return true;
    std::size_t done = bucket;
    for (int level = 0; level <= view_.top; ++level)
    {
      const std::size_t node = done / PkdTree::fanout;
      if (visitChildren(level, node, static_cast<int>(done % PkdTree::fanout)) || drain())
        return true;
      done = node;
    }
    return false;
  }

private:
  struct Entry
  {
    std::size_t node;
    int level;
    float near;
  };

  bool below(int level, std::size_t node, float near)
  {
    stack_[depth_++] = {node, level, near};
    return drain();
  }

  bool drain()
  {
    while (depth_ > 0)
    {
      const Entry next = stack_[--depth_];
      if (next.near <= ray_.best && visitChildren(next.level, next.node, -1))
        return true;
    }
    return false;
  }

  void setCorner(const PkdTreeView::Node& node)
  {
    for (int k = 0; k < 3; ++k)
      corner_[k] = node.corner[k] - ray_.high[k]; // exact
  }

  /// All children that the ray meets but `left`. True: the answer is known.
  HWY_INLINE bool visitChildren(int level, std::size_t index, int left)
  {
    const PkdTreeView::Node& node = view_.node(level, index);
    NearChildren children;
    findChildren(node, left, children);
    if (level > 0)
    {
      for (int i = children.count; i-- > 0;)
        stack_[depth_++] = {
          index * PkdTree::fanout + children.child[i], level - 1, children.near[i]};
      return false;
    }
    if (children.count == 0)
      return false;
    setCorner(node);
    for (int i = 0; i < children.count; ++i)
      if (children.near[i] <= ray_.best && visitBucket(index * PkdTree::fanout + children.child[i]))
        return true;
    return false;
  }

  HWY_INLINE void findChildren(
    const PkdTreeView::Node& node, int left, NearChildren& children) const
  {
    const DF d;
    const unsigned shown = view_.shownOf(node);
    alignas(16) float perBound[4], base[4];
    const D4 d4;
    const hn::Rebind<std::uint32_t, D4> u4;
    const hn::Rebind<std::uint8_t, D4> bytes;
    for (int k = 0; k < 4; k += static_cast<int>(hn::Lanes(d4)))
    {
      const auto inverse = hn::Load(d4, ray_.inverse + k);
      const auto step = hn::BitCast(
        d4, hn::ShiftLeft<23>(hn::PromoteTo(u4, hn::LoadU(bytes, node.exponent.data() + k))));
      hn::Store(hn::Mul(step, inverse), d4, perBound + k);
      const auto from = hn::Sub(hn::LoadU(d4, node.lower.data() + k), hn::Load(d4, ray_.p + k));
      hn::Store(hn::Mul(from, inverse), d4, base + k);
    }
    const auto* low = node.low.data();
    const auto* high = node.high.data();
    const std::uint8_t* near[3];
    const std::uint8_t* far[3];
    for (int k = 0; k < 3; ++k)
    {
      near[k] = (ray_.inverse[k] > 0.0f ? low : high)[k].data();
      far[k] = (ray_.inverse[k] > 0.0f ? high : low)[k].data();
    }
    for (int c = 0; c < PkdTree::fanout; c += static_cast<int>(hn::Lanes(d)))
    {
      const auto at = [&](const std::uint8_t* bounds, int k)
      { return hn::MulAdd(boundsAt(bounds + c), hn::Set(d, perBound[k]), hn::Set(d, base[k])); };
      const VF enter = hn::Max(
        hn::Max(at(near[0], 0), at(near[1], 1)), hn::Max(at(near[2], 2), hn::Set(d, ray_.first)));
      const VF leave = hn::Min(
        hn::Min(at(far[0], 0), at(far[1], 1)), hn::Min(at(far[2], 2), hn::Set(d, ray_.best)));
      // Children that do not exist have turned bounds on every axis.
      unsigned bits = bitsOf(hn::Le(enter, leave)) & (shown >> c);
      if (left >= c && left < c + static_cast<int>(hn::Lanes(d)))
        bits &= ~(1u << (left - c));
      if (bits == 0)
        continue;
      alignas(64) float from[PkdTree::fanout];
      hn::Store(enter, d, from);
      children.add(bits, from, c);
    }
  }

  HWY_INLINE bool visitBucket(std::size_t bucket)
  {
    const DF d;
    const PkdTreeView::Row* rows = view_.rows + bucket * view_.rowsABucket;
    for (int lane = 0; lane < PkdTree::bucketSize; lane += static_cast<int>(hn::Lanes(d)))
    {
      const auto load = [&](int row)
      { return hn::Load(d, reinterpret_cast<const float*>(rows[row].words.data()) + lane); };
      VF f[3], foot = hn::Zero(d);
      for (int k = 0; k < 3; ++k)
      {
        f[k] = hn::Sub(hn::Add(load(k), hn::Set(d, corner_[k])), hn::Set(d, ray_.low[k]));
        foot = hn::MulAdd(f[k], hn::Set(d, ray_.d[k]), foot);
      }
      const VF r = view_.ownRadii ? load(3) : hn::Set(d, view_.radius);
      VF left = hn::Mul(r, r);
      for (int k = 0; k < 3; ++k)
      {
        const VF across = hn::NegMulAdd(foot, hn::Set(d, ray_.d[k]), f[k]);
        left = hn::NegMulAdd(across, across, left);
      }
      const auto meets = hn::Ge(left, hn::Zero(d));
      if (hn::AllFalse(d, meets))
        continue;
      const VF half = hn::Sqrt(hn::Max(left, hn::Zero(d)));
      const VF first = hn::Set(d, ray_.first), best = hn::Set(d, ray_.best);
      const VF in = hn::Sub(foot, half), out = hn::Add(foot, half);
      const VF t = hn::IfThenElse(hn::Gt(in, first), in, out);
      const auto before = ANY ? hn::Lt(t, best) : hn::Le(t, best);
      const unsigned hits =
        bitsOf(hn::And(meets, hn::And(hn::Gt(t, first), before))) & (view_.shownIn(bucket) >> lane);
      if (hits != 0 && keep(hits, t, bucket * PkdTree::bucketSize + static_cast<std::size_t>(lane)))
        return true;
    }
    return false;
  }

  bool keep(unsigned hits, VF t, std::uint64_t firstSlot)
  {
    if constexpr (ANY)
    {
      if (own_ >= firstSlot && own_ < firstSlot + hn::Lanes(DF()))
        hits &= ~(1u << (own_ - firstSlot));
      return hits != 0;
    }
    alignas(64) float at[PkdTree::bucketSize];
    hn::Store(t, DF(), at);
    for (; hits != 0; hits &= hits - 1)
    {
      const int lane = __builtin_ctz(hits);
      const std::uint64_t slot = firstSlot + static_cast<std::uint64_t>(lane);
      if (at[lane] < ray_.best || (at[lane] == ray_.best && ray_.slot != RayPacket::noHit &&
                                    view_.takesTie(slot, ray_.slot)))
      {
        ray_.best = at[lane];
        ray_.slot = slot;
      }
    }
    return false;
  }

  const PkdTreeView& view_;
  TreeRay& ray_;
  const std::uint64_t own_; ///< what does not count
  float corner_[3];         ///< of the treelet that is visited, from `high`
  int depth_ = 0;
  Entry stack_[PkdTree::fanout * 16];
};

inline void castTreePacket(const PkdTreeView& view, RayPacket& packet, std::int32_t object)
{
  const TreeRays rays(view, packet);
  for (int i = 0; i < packet.count; ++i)
  {
    if (!rays.meets(i))
      continue;
    TreeRay ray = rays.ray(i);
    TreeRayCaster<false>(view, ray, RayPacket::noHit).fromTop();
    if (ray.slot == RayPacket::noHit)
      continue;
    packet.t[i] = (rays.t0[i] + static_cast<double>(ray.best)) / rays.perT[i];
    packet.slot[i] = ray.slot;
    packet.object[i] = object;
  }
}

inline void occludeTreePacket(const PkdTreeView& view, RayPacket& packet, std::int32_t object)
{
  const TreeRays rays(view, packet);
  for (int i = 0; i < packet.count; ++i)
  {
    if (!rays.meets(i))
      continue;
    TreeRay ray = rays.ray(i);
    const bool isOwn = packet.object[i] == object && packet.slot[i] < view.tree.size();
    TreeRayCaster<true> caster(view, ray, isOwn ? packet.slot[i] : RayPacket::noHit);
    if (isOwn ? caster.from(packet.slot[i]) : caster.fromTop())
      packet.t[i] = -std::numeric_limits<double>::infinity();
  }
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
