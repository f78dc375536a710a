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

/// A ray in the tree's coordinates: P + tau d, with |d| = 1 and P where it enters the bounds.
struct TreeRay
{
  double p[3];
  double high[3]; ///< P, to what corners of treelets are multiples of
  float low[3];   ///< and the rest of it
  float d[3];
  float inverse[3]; ///< of d, finite
  float first;      ///< hits at tau <= first do not count
  float best;       ///< tau of the nearest hit so far
  double t0;        ///< tau of P counted from the ray's own origin
  double perT;      ///< units of tau in one of the ray's t
  std::uint64_t slot;

  /// False where the ray passes by the bounds.
  bool place(const PkdTreeView& view, const RayPacket& packet, int i)
  {
    const double perUnit = 1.0 / view.tree.unit();
    const Vec3d direction(packet.direction[0][i], packet.direction[1][i], packet.direction[2][i]);
    const Vec3d origin =
      (Vec3d(packet.origin[0][i], packet.origin[1][i], packet.origin[2][i]) - view.tree.origin()) *
      perUnit;
    const double speed = glm::length(direction);
    if (!(speed > 0.0))
      return false;
    perT = speed * perUnit;
    const Vec3d way = direction / speed;
    double enter = packet.tMin[i] * perT, leave = packet.t[i] * perT;
    for (int k = 0; k < 3; ++k)
    {
      if (way[k] == 0.0)
      {
        if (origin[k] < view.least[k] || origin[k] > view.most[k])
          return false;
        continue;
      }
      const double a = (view.least[k] - origin[k]) / way[k];
      const double b = (view.most[k] - origin[k]) / way[k];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    if (!(enter < leave))
      return false;
    t0 = enter;
    for (int k = 0; k < 3; ++k)
    {
      p[k] = origin[k] + t0 * way[k];
      high[k] = std::round(p[k] / double(view.coarse)) * double(view.coarse);
      low[k] = static_cast<float>(p[k] - high[k]);
      d[k] = static_cast<float>(way[k]);
      const double least = std::copysign(std::max(std::abs(way[k]), 1e-18), way[k]);
      inverse[k] = static_cast<float>(1.0 / least);
    }
    first = static_cast<float>(packet.tMin[i] * perT - t0);
    best = static_cast<float>(packet.t[i] * perT - t0);
    slot = RayPacket::noHit;
    return true;
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
      corner_[k] = static_cast<float>(double(node.corner[k]) - ray_.high[k]);
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
    VF perBound[3], base[3];
    const std::uint8_t* near[3];
    const std::uint8_t* far[3];
    for (int k = 0; k < 3; ++k)
    {
      const float inverse = ray_.inverse[k];
      perBound[k] = hn::Set(d, stepOf(node, k) * inverse);
      base[k] = hn::Set(d, static_cast<float>(double(node.lower[k]) - ray_.p[k]) * inverse);
      near[k] = (inverse > 0.0f ? node.low : node.high)[k].data();
      far[k] = (inverse > 0.0f ? node.high : node.low)[k].data();
    }
    for (int c = 0; c < PkdTree::fanout; c += static_cast<int>(hn::Lanes(d)))
    {
      const auto at = [&](const std::uint8_t* bounds, int k)
      { return hn::MulAdd(boundsAt(bounds + c), perBound[k], base[k]); };
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
  for (int i = 0; i < packet.count; ++i)
  {
    TreeRay ray;
    if (!ray.place(view, packet, i))
      continue;
    TreeRayCaster<false>(view, ray, RayPacket::noHit).fromTop();
    if (ray.slot == RayPacket::noHit)
      continue;
    packet.t[i] = (ray.t0 + static_cast<double>(ray.best)) / ray.perT;
    packet.slot[i] = ray.slot;
    packet.object[i] = object;
  }
}

inline void occludeTreePacket(const PkdTreeView& view, RayPacket& packet, std::int32_t object)
{
  for (int i = 0; i < packet.count; ++i)
  {
    TreeRay ray;
    if (!ray.place(view, packet, i))
      continue;
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
