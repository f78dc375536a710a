// Bundles of rays through a PkdTree, included once per SIMD instruction set by PkdTreeCast.cpp.

#if defined(MOTE_PKD_TREE_BUNDLE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_PKD_TREE_BUNDLE_INL_H
#undef MOTE_PKD_TREE_BUNDLE_INL_H
#else
#define MOTE_PKD_TREE_BUNDLE_INL_H
#endif

#include "NearestFirst-inl.h"
#include "PkdTreeBoxes-inl.h"

#include <hwy/cache_control.h>

#include <array>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// Centres, from their treelet's corner, and radii of a bucket's particles from `lane` on.
struct Spheres
{
  VF x, y, z, r;

  HWY_INLINE Spheres(const PkdTreeView& view, std::size_t bucket, int lane)
  {
    const DF d;
    const DU du;
    const PkdTreeView::Row* rows = view.rows + bucket * view.rowsABucket;
    const auto number = [&](int row)
    { return hn::Load(d, reinterpret_cast<const float*>(rows[row].words.data()) + lane); };
    if (view.placeRows == 3)
    {
      x = number(0);
      y = number(1);
      z = number(2);
    }
    else
    {
      const hn::Rebind<std::int32_t, DF> di;
      const auto a = hn::Load(du, rows[0].words.data() + lane);
      const VF step = hn::Set(d, view.step);
      const auto inSteps = [&](auto steps) { return hn::ConvertTo(d, hn::BitCast(di, steps)); };
      if (view.placeRows == 2)
      {
        const auto b = hn::Load(du, rows[1].words.data() + lane);
        const auto low = hn::Set(du, 0xfffff);
        x = hn::Mul(inSteps(hn::And(a, low)), step);
        y = hn::Mul(inSteps(hn::And(b, low)), step);
        z = hn::Mul(
          inSteps(hn::Or(hn::ShiftRight<20>(a), hn::ShiftLeft<12>(hn::ShiftRight<20>(b)))), step);
      }
      else
      {
        const PkdTreeView::Node& node = view.node(0, bucket / PkdTree::fanout);
        const auto place = [&](auto upmost, std::size_t k)
        {
          const auto steps = hn::ShiftRight<22>(hn::BitCast(di, upmost));
          const VF middle = hn::Set(d, node.middle(k, bucket % PkdTree::fanout));
          return hn::MulAdd(hn::ConvertTo(d, steps), step, middle); // exact
        };
        x = place(hn::ShiftLeft<22>(a), 0);
        y = place(hn::ShiftLeft<12>(a), 1);
        z = place(hn::ShiftLeft<2>(a), 2);
      }
    }
    r = view.ownRadii ? number(view.placeRows) : hn::Set(d, view.radius);
  }
};

/// Casts a bundle, its major axis being any.
template <typename Policy>
class TreeCaster
{
public:
  /// `poe` matters where the policy has levels of detail.
  TreeCaster(const PkdTreeView& view, Pencil& pencil, const RayBundle& bundle, std::int32_t object,
    double poe, std::vector<std::uint64_t>& hits)
    : view_(view)
    , p_(pencil)
    , tester_(view, pencil, bundle, object, hits, nullptr)
    , queue_(queueOfThread())
  {
    queue_.clear();
    if constexpr (Policy::lods)
      boxes_.prepare(view, pencil, bundle, poe);
  }

  void run()
  {
    if (!tester_.narrow(-infinity, p_.U, p_.V))
      return;
    queue_.push({0.0f, view_.top, 0});
    while (!queue_.empty())
    {
      const NearestFirst::Entry next = queue_.pop();
      if (tester_.changed() && !tester_.narrow(next.near, p_.U, p_.V))
        return;
      if (!(next.near < tester_.farthestKappa()))
        return;
      if (next.level < 0)
        visitBucket(next.index);
      else
        visitNode(next.level, next.index);
    }
  }

private:
  static NearestFirst& queueOfThread()
  {
    static thread_local NearestFirst queue;
    return queue;
  }

  void visitNode(int level, std::size_t index)
  {
    findChildren(view_.node(level, index),
      [&](unsigned bits, const float* near, int first)
      {
        const std::size_t firstChild = index * PkdTree::fanout + static_cast<std::size_t>(first);
        if constexpr (Policy::lods)
        {
          const unsigned boxes = bits & boxes_.fitting(view_.node(level, index), near, first);
          if (boxes != 0)
            boxes_.test(view_.node(level, index), boxes, first, tester_);
          bits &= ~boxes;
        }
        for (unsigned left = bits; left != 0; left &= left - 1)
          prefetch(level - 1, firstChild + static_cast<std::size_t>(__builtin_ctz(left)));
        // Where little is shown, little hides anything: order is not worth its time.
        const bool atOnce = level == 0 && view_.slots != nullptr;
        for (; bits != 0; bits &= bits - 1)
        {
          const int lane = __builtin_ctz(bits);
          const std::size_t child = firstChild + static_cast<std::size_t>(lane);
          if (!atOnce)
            queue_.push({near[lane], level - 1, child});
          else if (near[lane] < tester_.farthestKappa())
            visitBucket(child);
        }
      });
  }

  /// What is visited later is brought from memory meanwhile.
  HWY_INLINE void prefetch(int level, std::size_t index) const
  {
    if (level >= 0)
    {
      const PkdTreeView::Node* node = &view_.node(level, index);
      hwy::Prefetch(node);
      hwy::Prefetch(&node->low[2]);
      return;
    }
    const PkdTreeView::Row* rows = view_.rows + index * view_.rowsABucket;
    const int needed = view_.slots != nullptr ? 6 : view_.placeRows;
    for (int k = 0; k < needed + view_.ownRadii; ++k)
      hwy::Prefetch(rows + k);
  }

  /// Children whose bounds the frustum overlaps, from Q's plane on.
  template <typename Found>
  HWY_INLINE void findChildren(const PkdTreeView::Node& node, const Found& found) const
  {
    const DF d;
    const Walls& walls = tester_.walls();
    const auto set = [&](float v) { return hn::Set(d, v); };
    const auto lowerOf = [&](int axis)
    { return set(static_cast<float>(double(node.lower[axis]) - p_.q[axis])); };
    const auto lowerK = lowerOf(p_.K), lowerU = lowerOf(p_.U), lowerV = lowerOf(p_.V);
    const auto stepK = set(stepOf(node, p_.K)), stepU = set(stepOf(node, p_.U)),
               stepV = set(stepOf(node, p_.V));
    const auto& first = p_.sign > 0.0 ? node.low[p_.K] : node.high[p_.K];
    const auto& last = p_.sign > 0.0 ? node.high[p_.K] : node.low[p_.K];
    const auto sign = set(static_cast<float>(p_.sign));
    const auto farthest = set(tester_.farthestKappa());
    const unsigned shown = view_.shownOf(node);
    for (int c = 0; c < PkdTree::fanout; c += static_cast<int>(hn::Lanes(d)))
    {
      const VF enter = hn::Mul(sign, hn::MulAdd(boundsAt(first.data() + c), stepK, lowerK));
      const VF leave = hn::Mul(sign, hn::MulAdd(boundsAt(last.data() + c), stepK, lowerK));
      // No ray is anywhere before Q's plane.
      const VF from = hn::Max(enter, hn::Zero(d));
      auto in = hn::And(hn::Ge(leave, from), hn::Lt(from, farthest));
      // A wall is a line over kappa: its extremes lie at the ends.
      const auto wall = [&](int k, bool most)
      {
        const bool late = (walls.slope[k] > 0.0f) == most;
        return hn::MulAdd(late ? leave : from, set(walls.slope[k]), set(walls.at[k]));
      };
      const auto beside = [&](const auto& low, const auto& high, VF step, VF lower, int k)
      {
        const VF least = hn::MulAdd(boundsAt(low.data() + c), step, lower);
        const VF most = hn::MulAdd(boundsAt(high.data() + c), step, lower);
        in = hn::And(in, hn::And(hn::Ge(most, wall(k, false)), hn::Le(least, wall(k + 1, true))));
      };
      beside(node.low[p_.U], node.high[p_.U], stepU, lowerU, 0);
      beside(node.low[p_.V], node.high[p_.V], stepV, lowerV, 2);
      alignas(64) float near[PkdTree::fanout];
      hn::Store(from, d, near);
      found(bitsOf(in) & (shown >> c), near, c);
    }
  }

  void visitBucket(std::size_t bucket)
  {
    const PkdTreeView::Row* corners = view_.cornersOf(bucket);
    const auto number = [&](std::size_t k)
    { return reinterpret_cast<const float*>(corners[k].words.data()); };
    if (corners == nullptr)
    {
      const PkdTreeView::Node& node = view_.node(0, bucket / PkdTree::fanout);
      const OneBase base{Vec3d(node.corner[0], node.corner[1], node.corner[2]) - p_.q};
      testBucket(bucket, [&](int) { return base; });
    }
    else
      testBucket(bucket,
        [&](int lane)
        {
          const float* const rows[3] = {number(0) + lane, number(1) + lane, number(2) + lane};
          return BaseEach(p_.q, rows);
        });
  }

  /// Tests the spheres of a bucket, those from `lane` on given from baseOf(lane).
  template <typename BaseOf>
  HWY_INLINE void testBucket(std::size_t bucket, const BaseOf& baseOf)
  {
    const DF d;
    const unsigned shown = view_.shownIn(bucket);
    Projected s;
    for (int lane = 0; lane < PkdTree::bucketSize; lane += static_cast<int>(hn::Lanes(d)))
    {
      const Spheres spheres(view_, bucket, lane);
      tester_.projectFrom(
        baseOf(lane), spheres.x, spheres.y, spheres.z, spheres.r, hn::FirstN(d, hn::Lanes(d)), s);
      if (s.in == 0)
        continue;
      for (unsigned bits = s.in & (shown >> lane); bits != 0; bits &= bits - 1)
      {
        const int j = __builtin_ctz(bits);
        tester_.test(
          s, j, view_.slotOf(bucket * PkdTree::bucketSize + static_cast<std::size_t>(lane + j)));
      }
      tester_.refresh();
    }
  }

  const PkdTreeView& view_;
  Pencil& p_;
  SphereTester<Policy, PkdTreeView> tester_;
  NearestFirst& queue_;
  struct NoBoxes
  {
  };
  std::conditional_t<Policy::lods, LodBoxes, NoBoxes> boxes_;
};

/// Casts a bundle; false, with nothing done, where its rays do not travel the same way along one
/// axis.
template <typename Policy>
bool castTreeBundle(
  const PkdTreeView& view, RayBundle& bundle, std::int32_t object, double poe = 0.0)
{
  Pencil p;
  bool coherent = false;
  const Spread spread = spreadOf(bundle);
  if (!placePencil(
        {view.tree.origin(), view.tree.unit()}, bundle, spread, view.least, view.most, p, coherent))
    return coherent || bundle.count == 1;
  prepareProjection(spread, p);
  prepareRays(bundle, p);
  prepareBlocks(bundle, p);
  static thread_local std::vector<std::uint64_t> hits;
  hits.assign(1, RayBundle::noHit);
  TreeCaster<Policy>(view, p, bundle, object, poe, hits).run();
  keepAnswers<Policy>(p, hits.data(), object, bundle);
  return true;
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
