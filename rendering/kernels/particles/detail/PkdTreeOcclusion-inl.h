// Whether anything is in the way of single rays through a PkdTree, included once per SIMD
// instruction set.

#if defined(MOTE_PKD_TREE_OCCLUSION_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_PKD_TREE_OCCLUSION_INL_H
#undef MOTE_PKD_TREE_OCCLUSION_INL_H
#else
#define MOTE_PKD_TREE_OCCLUSION_INL_H
#endif

#include "PkdTreeRays-inl.h"

#include <vector>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// Whether the first of foot -+ sqrt(left) that lies after the ray's begin lies before its end;
/// without the root, which would take as long as all else.
HWY_INLINE hn::Mask<DF> betweenEnds(const TreeRays& rays, int i, VF foot, VF left)
{
  const DF d;
  const VF zero = hn::Zero(d);
  const VF a = hn::Sub(foot, hn::Set(d, rays.first[i])),
           b = hn::Sub(hn::Set(d, rays.best[i]), foot);
  const VF a2 = hn::Mul(a, a), b2 = hn::Mul(b, b);
  const auto ahead = hn::Gt(a, zero), before = hn::Gt(b, zero);
  const auto inAhead = hn::And(ahead, hn::Gt(a2, left));
  const auto inBefore = hn::Or(before, hn::Lt(b2, left));
  const auto outAhead = hn::Or(ahead, hn::Lt(a2, left));
  const auto outBefore = hn::And(before, hn::Gt(b2, left));
  return hn::Or(hn::And(inAhead, inBefore), hn::AndNot(inAhead, hn::And(outAhead, outBefore)));
}

/// The nodes of one level that the rays of a packet may pass: found once for all of them, so that
/// no ray has to descend through what is common to their ways.
class StartNodes
{
public:
  static constexpr int capacity = 32;

  /// `which` are the `count` rays that count.
  StartNodes(const PkdTreeView& view, const TreeRays& rays, const std::uint8_t* which, int count)
    : level_(view.top)
  {
    for (int k = 0; k < 3; ++k)
    {
      least_[k] = infinity;
      most_[k] = -infinity;
      for (int n = 0; n < count; ++n)
      {
        const int i = which[n];
        const float from = rays.p[i][k] + rays.first[i] * rays.d[k][i];
        const float to = rays.p[i][k] + rays.best[i] * rays.d[k][i];
        least_[k] = std::min({least_[k], from, to});
        most_[k] = std::max({most_[k], from, to});
      }
    }
    // The root's bounds do not matter: whoever gets here meets them.
    count_ = 1;
    index_[0] = 0;
    for (int k = 0; k < 3; ++k)
      for (int n = 0; n < capacity; ++n)
      {
        low_[k][n] = n == 0 ? static_cast<float>(view.least[k]) : infinity;
        high_[k][n] = n == 0 ? static_cast<float>(view.most[k]) : -infinity;
      }
    while (level_ > 0 && descend(view))
    {
    }
  }

  int level() const { return level_; }

  int count() const { return count_; }

  /// The nodes n to n + lanes that the ray meets, as bits.
  HWY_INLINE unsigned met(const TreeRays& rays, int i, int n) const
  {
    const DF d;
    VF enter = hn::Set(d, rays.first[i]), leave = hn::Set(d, rays.best[i]);
    for (int k = 0; k < 3; ++k)
    {
      const VF inverse = hn::Set(d, rays.inverse[i][k]), p = hn::Set(d, rays.p[i][k]);
      const VF a = hn::Mul(hn::Sub(hn::Load(d, low_[k] + n), p), inverse);
      const VF b = hn::Mul(hn::Sub(hn::Load(d, high_[k] + n), p), inverse);
      enter = hn::Max(enter, hn::Min(a, b));
      leave = hn::Min(leave, hn::Max(a, b));
    }
    return bitsOf(
      hn::And(hn::Le(enter, leave), hn::FirstN(d, static_cast<std::size_t>(count_ - n))));
  }

  const std::uint32_t* indices() const { return index_; }

private:
  /// Replaces the nodes by their children that the rays' bounds overlap, if there is room.
  bool descend(const PkdTreeView& view)
  {
    int count = 0;
    std::uint32_t index[capacity];
    float low[3][capacity], high[3][capacity];
    for (int n = 0; n < count_; ++n)
    {
      const PkdTreeView::Node& node = view.node(level_, index_[n]);
      float step[3];
      for (int k = 0; k < 3; ++k)
        step[k] = stepOf(node, static_cast<std::size_t>(k));
      for (unsigned bits = overlapped(node, step) & view.shownOf(node); bits != 0; bits &= bits - 1)
      {
        if (count == capacity)
          return false;
        const int child = __builtin_ctz(bits);
        for (int k = 0; k < 3; ++k)
        {
          low[k][count] = node.lower[k] + static_cast<float>(node.low[k][child]) * step[k];
          high[k][count] = node.lower[k] + static_cast<float>(node.high[k][child]) * step[k];
        }
        index[count++] = index_[n] * PkdTree::fanout + static_cast<std::uint32_t>(child);
      }
    }
    count_ = count;
    --level_;
    std::copy_n(index, count, index_);
    for (int k = 0; k < 3; ++k)
    {
      std::copy_n(low[k], count, low_[k]);
      std::copy_n(high[k], count, high_[k]);
    }
    return true;
  }

  HWY_INLINE unsigned overlapped(const PkdTreeView::Node& node, const float* step) const
  {
    const DF d;
    unsigned bits = 0;
    for (int c = 0; c < PkdTree::fanout; c += static_cast<int>(hn::Lanes(d)))
    {
      auto in = hn::FirstN(d, hn::Lanes(d));
      for (int k = 0; k < 3; ++k)
      {
        const VF lower = hn::Set(d, node.lower[k]), size = hn::Set(d, step[k]);
        const VF low = boundsAt(node.low[k].data() + c), high = boundsAt(node.high[k].data() + c);
        in = hn::And(in, hn::And(hn::Le(hn::MulAdd(low, size, lower), hn::Set(d, most_[k])),
                           hn::Ge(hn::MulAdd(high, size, lower), hn::Set(d, least_[k]))));
        in = hn::And(in, hn::Le(low, high));
      }
      bits |= bitsOf(in) << c;
    }
    return bits;
  }

  int level_;
  int count_ = 0;
  float least_[3], most_[3]; ///< of the rays
  alignas(64) std::uint32_t index_[capacity];
  alignas(64) float low_[3][capacity], high_[3][capacity];
};

/// Finds which rays of a packet meet anything.
///
/// No ray is followed by itself: a step tests all pairs of a ray and a node, or a ray and a bucket,
/// that are known, and finds the next ones. So no branch depends on a single answer, which no
/// processor could foresee, and one test does not wait for the other.
class OcclusionCaster
{
public:
  OcclusionCaster(const PkdTreeView& view, RayPacket& packet, std::int32_t object)
    : view_(view)
    , packet_(packet)
    , rays_(view, packet)
    , pairs_(pairsOfThread())
  {
    for (int i = 0; i < packet.count; ++i)
      own_[i] = packet.object[i] == object && packet.slot[i] < view.tree.size() ? packet.slot[i]
                                                                                : RayPacket::noHit;
  }

  void run()
  {
    int count = 0;
    for (int i = 0; i < packet_.count; ++i)
    {
      hit_[i] = !rays_.isAnywhere(i);
      count += add(left_, count, i, !hit_[i]);
    }
    count = besides(count);
    if (count > 0)
    {
      const StartNodes nodes(view_, rays_, left_, count);
      for (int n = 0; n < count; ++n)
        startAt(nodes, left_[n]);
      drain(nodes.level());
    }
    for (int i = 0; i < packet_.count; ++i)
      if (hit_[i] && rays_.isAnywhere(i))
        packet_.t[i] = -std::numeric_limits<double>::infinity();
  }

private:
  /// Rays, and for each a node or a bucket that it meets.
  struct Pairs
  {
    std::vector<std::uint32_t> index, ray;
    std::size_t size = 0;

    /// So that `more` and a few others may be written behind those there are.
    void reserve(std::size_t more)
    {
      const std::size_t wanted = size + more + PkdTree::fanout;
      if (index.size() < wanted)
      {
        index.resize(2 * wanted);
        ray.resize(2 * wanted);
      }
    }
  };
  /// Pairs of one level, -1 being that of buckets; they lie one after another.
  struct Run
  {
    std::size_t first;
    int level;
  };
  static constexpr std::size_t together = 64; ///< pairs that are tested in one step

  static Pairs& pairsOfThread()
  {
    static thread_local Pairs pairs;
    pairs.size = 0;
    return pairs;
  }

  static HWY_INLINE int add(std::uint8_t* list, int count, int i, bool wanted)
  {
    list[count] = static_cast<std::uint8_t>(i);
    return wanted;
  }

  /// Rays that leave a particle first look into its bucket and then its treelet: for many that is
  /// enough. Returns how many are left.
  int besides(int count)
  {
    int left = 0;
    for (int n = 0; n < count; ++n)
    {
      const int i = left_[n];
      if (knowsOwnBucket(i))
        hit_[i] |= testBucket(own_[i] / PkdTree::bucketSize, i);
      left += add(left_, left, i, !hit_[i]);
    }
    pairs_.reserve(static_cast<std::size_t>(left) * PkdTree::fanout);
    for (int n = 0; n < left; ++n)
    {
      const int i = left_[n];
      done_[i] = ~0u;
      if (!knowsOwnBucket(i))
        continue;
      const std::size_t bucket = own_[i] / PkdTree::bucketSize;
      done_[i] = static_cast<std::uint32_t>(bucket / PkdTree::fanout);
      expand(0, done_[i], i, ~(1u << (bucket % PkdTree::fanout)));
    }
    for (std::size_t k = 0; k < pairs_.size; ++k)
      hit_[pairs_.ray[k]] |= testBucket(pairs_.index[k], static_cast<int>(pairs_.ray[k]));
    pairs_.size = 0;
    count = 0;
    for (int n = 0; n < left; ++n)
      count += add(left_, count, left_[n], !hit_[left_[n]]);
    return count;
  }

  void startAt(const StartNodes& nodes, int i)
  {
    const DU d;
    pairs_.reserve(StartNodes::capacity);
    for (int n = 0; n < nodes.count(); n += static_cast<int>(hn::Lanes(d)))
      append(nodes.met(rays_, i, n), hn::Load(d, nodes.indices() + n), i);
  }

  void drain(int level)
  {
    Run runs[64];
    int depth = 0;
    runs[depth++] = {0, level};
    while (depth > 0)
    {
      const Run run = runs[depth - 1];
      const std::size_t count = std::min(together, pairs_.size - run.first);
      if (count == 0)
      {
        --depth;
        continue;
      }
      std::uint32_t index[together], ray[together];
      std::size_t live = 0;
      for (std::size_t k = pairs_.size - count; k < pairs_.size; ++k)
      {
        index[live] = pairs_.index[k];
        ray[live] = pairs_.ray[k];
        live += !hit_[ray[live]] && (run.level != 0 || done_[ray[live]] != index[live]);
      }
      pairs_.size -= count;
      if (run.level < 0)
        for (std::size_t k = 0; k < live; ++k)
          hit_[ray[k]] |= testBucket(index[k], static_cast<int>(ray[k]));
      else
      {
        runs[depth++] = {pairs_.size, run.level - 1};
        pairs_.reserve(live * PkdTree::fanout);
        for (std::size_t k = 0; k < live; ++k)
          expand(run.level, index[k], static_cast<int>(ray[k]), ~0u);
      }
    }
  }

  /// Adds the ray's pairs with the node's children that it meets and `mask` has.
  HWY_INLINE void expand(int level, std::uint32_t index, int i, unsigned mask)
  {
    const DU d;
    const PkdTreeView::Node& node = view_.node(level, index);
    alignas(64) float near[PkdTree::fanout];
    const unsigned bits = childrenMet(node, rays_, i, near) & view_.shownOf(node) & mask;
    for (int c = 0; c < PkdTree::fanout; c += static_cast<int>(hn::Lanes(d)))
      append(bits >> c, hn::Iota(d, index * PkdTree::fanout + static_cast<std::uint32_t>(c)), i);
  }

  /// Adds the ray's pairs with the lanes of `indices` that `bits` has.
  HWY_INLINE void append(unsigned bits, hn::Vec<DU> indices, int i)
  {
    const DU d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    bits &= (1u << lanes) - 1;
    const std::uint8_t bytes[8] = {
      static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8)};
    // Into a register first: straight into memory takes some processors ten times as long.
    const auto packed = hn::Compress(indices, hn::LoadMaskBits(d, bytes));
    hn::StoreU(packed, d, &pairs_.index[pairs_.size]);
    hn::StoreU(hn::Set(d, static_cast<std::uint32_t>(i)), d, &pairs_.ray[pairs_.size]);
    pairs_.size += static_cast<std::size_t>(__builtin_popcount(bits));
  }

  HWY_INLINE bool testBucket(std::size_t bucket, int i) const
  {
    const DF d;
    float corner[3];
    cornerFrom(view_.node(0, bucket / PkdTree::fanout), rays_, i, corner);
    unsigned hits = 0;
    for (int lane = 0; lane < PkdTree::bucketSize; lane += static_cast<int>(hn::Lanes(d)))
    {
      VF foot, left;
      spheresBeside(view_, bucket, lane, corner, rays_, i, foot, left);
      const auto meets = hn::Ge(left, hn::Zero(d));
      hits |= bitsOf(hn::And(meets, betweenEnds(rays_, i, foot, left))) << lane;
    }
    hits &= view_.shownIn(bucket);
    if (view_.slots != nullptr)
      return isHitByOther(hits, bucket, i);
    const std::uint64_t lane = own_[i] - bucket * PkdTree::bucketSize;
    hits &= lane < PkdTree::bucketSize ? ~(1u << lane) : ~0u;
    return hits != 0;
  }

  /// Where slots are no places, what does not count is known only when it is met.
  bool knowsOwnBucket(int i) const { return view_.slots == nullptr && own_[i] != RayPacket::noHit; }

  bool isHitByOther(unsigned hits, std::size_t bucket, int i) const
  {
    for (; hits != 0; hits &= hits - 1)
    {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(hits));
      if (view_.slots[bucket * PkdTree::bucketSize + lane] != own_[i])
        return true;
    }
    return false;
  }

  const PkdTreeView& view_;
  RayPacket& packet_;
  TreeRays rays_;
  std::uint64_t own_[RayPacket::capacity];  ///< what does not count
  std::uint32_t done_[RayPacket::capacity]; ///< treelet that has been visited
  bool hit_[RayPacket::capacity];
  std::uint8_t left_[RayPacket::capacity + 1]; ///< rays whose answer is not known
  Pairs& pairs_;
};

inline void occludeTreePacket(const PkdTreeView& view, RayPacket& packet, std::int32_t object)
{
  OcclusionCaster(view, packet, object).run();
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
