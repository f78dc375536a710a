// The nearest hits of single rays through a PkdTree, included once per SIMD instruction set.

#if defined(MOTE_PKD_TREE_NEAREST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_PKD_TREE_NEAREST_INL_H
#undef MOTE_PKD_TREE_NEAREST_INL_H
#else
#define MOTE_PKD_TREE_NEAREST_INL_H
#endif

#include "PkdTreeRays-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// Finds what a ray meets first.
class NearestCaster
{
public:
  NearestCaster(const PkdTreeView& view, TreeRays& rays, int ray)
    : view_(view)
    , rays_(rays)
    , ray_(ray)
  {
  }

  /// Slot of the particle that is hit, or noHit; the ray's `best` is where.
  std::uint64_t cast()
  {
    stack_[depth_++] = {0, view_.top, rays_.first[ray_]};
    while (depth_ > 0)
    {
      const Entry next = stack_[--depth_];
      // Not <: of coincident particles another one may count.
      if (next.near <= rays_.best[ray_])
        visit(next.level, next.node);
    }
    return slot_;
  }

private:
  struct Entry
  {
    std::size_t node;
    int level;
    float near;
  };

  void visit(int level, std::size_t index)
  {
    const PkdTreeView::Node& node = view_.node(level, index);
    alignas(64) float enter[PkdTree::fanout];
    const unsigned bits = childrenMet(node, rays_, ray_, enter) & view_.shownOf(node);
    Children children;
    children.take(bits, enter);
    if (level > 0)
    {
      for (int i = children.count; i-- > 0;)
        stack_[depth_++] = {
          index * PkdTree::fanout + children.child[i], level - 1, enter[children.child[i]]};
      return;
    }
    cornerFrom(node, rays_, ray_, corner_);
    for (int i = 0; i < children.count; ++i)
      if (enter[children.child[i]] <= rays_.best[ray_])
        visitBucket(index * PkdTree::fanout + children.child[i]);
  }

  /// Children that the ray meets, nearest first.
  struct Children
  {
    int count = 0;
    std::uint8_t child[PkdTree::fanout];

    HWY_INLINE void take(unsigned bits, const float* enter)
    {
      for (; bits != 0; bits &= bits - 1)
      {
        const int lane = __builtin_ctz(bits);
        int place = count++;
        for (; place > 0 && enter[child[place - 1]] > enter[lane]; --place)
          child[place] = child[place - 1];
        child[place] = static_cast<std::uint8_t>(lane);
      }
    }
  };

  HWY_INLINE void visitBucket(std::size_t bucket)
  {
    const DF d;
    for (int lane = 0; lane < PkdTree::bucketSize; lane += static_cast<int>(hn::Lanes(d)))
    {
      VF foot, left;
      spheresBeside(view_, bucket, lane, corner_, rays_, ray_, foot, left);
      const auto meets = hn::Ge(left, hn::Zero(d));
      if (hn::AllFalse(d, meets))
        continue;
      const VF half = hn::Sqrt(hn::Max(left, hn::Zero(d)));
      const VF first = hn::Set(d, rays_.first[ray_]), best = hn::Set(d, rays_.best[ray_]);
      const VF in = hn::Sub(foot, half), out = hn::Add(foot, half);
      const VF t = hn::IfThenElse(hn::Gt(in, first), in, out);
      const auto hits = hn::And(meets, hn::And(hn::Gt(t, first), hn::Le(t, best)));
      alignas(64) float at[PkdTree::bucketSize];
      hn::Store(t, d, at);
      keep(bitsOf(hits) & (view_.shownIn(bucket) >> lane), at,
        bucket * PkdTree::bucketSize + static_cast<std::size_t>(lane));
    }
  }

  HWY_INLINE void keep(unsigned hits, const float* at, std::uint64_t first)
  {
    for (; hits != 0; hits &= hits - 1)
    {
      const int lane = __builtin_ctz(hits);
      const std::uint64_t slot = view_.slotOf(first + static_cast<std::uint64_t>(lane));
      if (at[lane] < rays_.best[ray_] ||
          (at[lane] == rays_.best[ray_] && slot_ != RayPacket::noHit &&
            view_.takesTie(slot, slot_)))
      {
        rays_.best[ray_] = at[lane];
        slot_ = slot;
      }
    }
  }

  const PkdTreeView& view_;
  TreeRays& rays_;
  const int ray_;
  std::uint64_t slot_ = RayPacket::noHit;
  float corner_[3]; ///< of the treelet that is visited, from the ray's `high`
  int depth_ = 0;
  Entry stack_[PkdTree::fanout * 16];
};

inline void castTreePacket(const PkdTreeView& view, RayPacket& packet, std::int32_t object)
{
  TreeRays rays(view, packet);
  for (int i = 0; i < packet.count; ++i)
  {
    if (!rays.isAnywhere(i))
      continue;
    const std::uint64_t slot = NearestCaster(view, rays, i).cast();
    if (slot == RayPacket::noHit)
      continue;
    packet.t[i] = (rays.t0[i] + static_cast<double>(rays.best[i])) / rays.perT[i];
    packet.slot[i] = slot;
    packet.object[i] = object;
  }
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
