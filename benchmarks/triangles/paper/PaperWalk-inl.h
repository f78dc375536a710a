// The way of some rays through an RlodPaperTree. Included once per SIMD instruction set.

#if defined(MOTE_PAPER_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_PAPER_WALK_INL_H
#undef MOTE_PAPER_WALK_INL_H
#else
#define MOTE_PAPER_WALK_INL_H
#endif

#include "PaperRays-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mote::bench
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Takes the rays of a group through the tree together: a node is visited where any of them does.
/// With ANY set rays end at whatever they meet first; with LODS set R-LODs are taken.
template <int SIZE, bool ANY, bool LODS>
class PaperWalk
{
public:
  using D = hn::CappedTag<float, SIZE>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;
  using DU = hn::RebindToUnsigned<D>;
  static constexpr int lanes = static_cast<int>(hn::MaxLanes(D()));
  static constexpr int sets = SIZE / lanes;

  PaperWalk(const RlodPaperArrays& tree, PaperRays<SIZE>& rays, const RlodPaperCast& how)
    : tree_(tree)
    , rays_(rays)
    , clamped_(how.clamped)
    , counts_(how.counts)
  {
  }

  void run(int group)
  {
    rays_.beginGroup(group);
    for (int axis = 0; axis < 3; ++axis)
      nearIsUpper_[axis] = group >> axis & 1;
    alignas(64) float enter[SIZE], leave[SIZE];
    for (int i = 0; i < SIZE; ++i)
    {
      enter[i] = rays_.group[i] == group ? rays_.enter[i] : infinity;
      leave[i] = rays_.group[i] == group ? rays_.leave[i] : -infinity;
    }
    Part now;
    for (int s = 0; s < sets; ++s)
    {
      now.enter[s] = hn::Load(D(), enter + s * lanes);
      now.leave[s] = hn::Load(D(), leave + s * lanes);
    }
    std::uint32_t index = 0;
    do
      visit(index, now);
    while (pop(index, now));
  }

private:
  /// Where rays are in a node: none where they enter after they leave.
  struct Part
  {
    V enter[sets], leave[sets];
  };
  struct Waiting
  {
    alignas(PaperRays<SIZE>::align) float enter[SIZE], leave[SIZE];
    std::uint32_t node;
  };

  static HWY_INLINE V all(float v) { return hn::Set(D(), v); }
  static HWY_INLINE bool any(M mask) { return !hn::AllFalse(D(), mask); }
  static HWY_INLINE V load(const float* row, int s) { return hn::Load(D(), row + s * lanes); }

  /// Goes down to what is nearest.
  HWY_INLINE void visit(std::uint32_t index, Part& now)
  {
    for (;;)
    {
      const RlodPaperNode node = tree_.nodes[index];
      if (counts_ != nullptr)
        count(counts_->nodes, counts_->seenNodes, index);
      if (node.isLeaf())
      {
        for (std::uint32_t k = 0; k < node.value; ++k)
          test(tree_.references[node.first() + k], now);
        return;
      }
      if (LODS && meetsLod(index, now))
        return;
      const int axis = node.axis();
      const V split = all(node.split());
      Part far;
      bool goesNear = false, goesFar = false;
      for (int s = 0; s < sets; ++s)
      {
        const V per = load(rays_.inverse[axis], s);
        const V from = hn::MulAdd(split, per, load(rays_.lower[axis], s));
        const V to = hn::MulAdd(split, per, load(rays_.upper[axis], s));
        far.enter[s] = hn::Max(now.enter[s], from);
        far.leave[s] = now.leave[s];
        now.leave[s] = hn::Min(now.leave[s], to);
        goesNear |= any(hn::Le(now.enter[s], now.leave[s]));
        goesFar |= any(hn::Le(far.enter[s], far.leave[s]));
      }
      const std::uint32_t nearChild = node.first() + nearIsUpper_[axis];
      const std::uint32_t farChild = node.first() + 1 - nearIsUpper_[axis];
      if (goesNear)
      {
        if (goesFar)
          push(farChild, far);
        index = nearChild;
      }
      else if (goesFar)
      {
        now = far;
        index = farChild;
      }
      else
        return;
    }
  }

  HWY_INLINE void push(std::uint32_t node, const Part& part)
  {
    Waiting& waiting = stack_[depth_++];
    waiting.node = node;
    for (int s = 0; s < sets; ++s)
    {
      hn::Store(part.enter[s], D(), waiting.enter + s * lanes);
      hn::Store(part.leave[s], D(), waiting.leave + s * lanes);
    }
  }

  /// The next node that any ray gets to before it ends.
  HWY_INLINE bool pop(std::uint32_t& node, Part& part)
  {
    while (depth_ > 0)
    {
      const Waiting& waiting = stack_[--depth_];
      bool some = false;
      for (int s = 0; s < sets; ++s)
      {
        part.enter[s] = load(waiting.enter, s);
        part.leave[s] = hn::Min(load(waiting.leave, s), load(rays_.best, s));
        some |= any(hn::Le(part.enter[s], part.leave[s]));
      }
      if (!some)
        continue;
      node = waiting.node;
      return true;
    }
    return false;
  }

  /// Rays that meet something at tau, if that counts.
  HWY_INLINE void keep(M meets, V tau, int s, std::uint32_t slot)
  {
    const D d;
    const V best = load(rays_.best, s);
    meets = hn::And(meets, hn::And(hn::Gt(tau, load(rays_.least, s)), hn::Lt(tau, best)));
    if (!any(meets))
      return;
    hn::Store(hn::IfThenElse(meets, ANY ? all(-infinity) : tau, best), d, rays_.best + s * lanes);
    const DU du;
    std::uint32_t* slots = rays_.slot + s * lanes;
    hn::Store(
      hn::IfThenElse(hn::RebindMask(du, meets), hn::Set(du, slot), hn::Load(du, slots)), du, slots);
  }

  HWY_INLINE void test(std::uint32_t index, const Part& now)
  {
    const std::array<Vec3f, 3>& corners = tree_.triangles[index];
    if (counts_ != nullptr)
      count(counts_->triangles, counts_->seenTriangles, index);
    const int* axes = rays_.axes;
    for (int s = 0; s < sets; ++s)
    {
      const V shearX = load(rays_.shearX, s), shearY = load(rays_.shearY, s);
      const V fromX = load(rays_.origin[axes[0]], s), fromY = load(rays_.origin[axes[1]], s);
      const V fromZ = load(rays_.origin[axes[2]], s);
      V x[3], y[3], z[3];
      for (int k = 0; k < 3; ++k)
      {
        z[k] = hn::Sub(all(corners[k][axes[2]]), fromZ);
        x[k] = hn::NegMulAdd(shearX, z[k], hn::Sub(all(corners[k][axes[0]]), fromX));
        y[k] = hn::NegMulAdd(shearY, z[k], hn::Sub(all(corners[k][axes[1]]), fromY));
      }
      // Products are rounded before they are subtracted: so no ray passes between two triangles.
      const auto edge = [&](int p, int q)
      { return hn::Sub(hn::Mul(x[p], y[q]), hn::Mul(x[q], y[p])); };
      const V a = edge(1, 2), b = edge(2, 0), c = edge(0, 1), zero = hn::Zero(D());
      const M one = hn::Ge(hn::Min(hn::Min(a, b), c), zero);
      const M other = hn::Le(hn::Max(hn::Max(a, b), c), zero);
      const V sum = hn::Add(hn::Add(a, b), c);
      const M meets =
        hn::And(hn::And(hn::Or(one, other), hn::Ne(sum, zero)), hn::Le(now.enter[s], now.leave[s]));
      if (!any(meets))
        continue;
      const V depth = hn::Div(hn::MulAdd(a, z[0], hn::MulAdd(b, z[1], hn::Mul(c, z[2]))), sum);
      keep(meets, hn::Mul(depth, load(rays_.perDepth, s)), s, index);
    }
  }

  /// Tests the node's R-LOD in place of the node, where all rays allow its error.
  HWY_INLINE bool meetsLod(std::uint32_t index, const Part& now)
  {
    const std::uint32_t word = tree_.words[index], place = word & RlodPaperPlane::none;
    if (place == RlodPaperPlane::none)
      return false;
    const V error = all(tree_.levels.radius(word >> RlodWords::indexBits));
    for (int s = 0; s < sets; ++s)
    {
      const V allowed =
        hn::MulAdd(load(rays_.allowedPerTau, s), now.enter[s], load(rays_.allowed, s));
      if (any(hn::And(hn::Le(now.enter[s], now.leave[s]), hn::Ge(error, allowed))))
        return false;
    }
    if (counts_ != nullptr)
      count(counts_->lods, counts_->seenPlanes, place);
    const RlodPaperPlane& plane = tree_.planes[place];
    for (int s = 0; s < sets; ++s)
      testLod(plane, static_cast<std::uint32_t>(RlodTree::lodBit | place), now, s);
    return true;
  }

  HWY_INLINE void testLod(const RlodPaperPlane& plane, std::uint32_t slot, const Part& now, int s)
  {
    const V wider = all((clamped_ ? 0.0f : plane.spread) + placeRounding);
    V enter = load(rays_.least, s), leave = load(rays_.best, s);
    V height = all(-plane.offset), slope = hn::Zero(D());
    for (int axis = 0; axis < 3; ++axis)
    {
      const V per = load(rays_.inverse[axis], s), normal = all(plane.normal[axis]);
      const V from = load(rays_.origin[axis], s);
      const V a = hn::Mul(hn::Sub(hn::Sub(all(plane.low[axis]), wider), from), per);
      const V b = hn::Mul(hn::Sub(hn::Add(all(plane.high[axis]), wider), from), per);
      enter = hn::Max(enter, hn::Min(a, b));
      leave = hn::Min(leave, hn::Max(a, b));
      height = hn::MulAdd(normal, from, height);
      slope = hn::MulAdd(normal, load(rays_.way[axis], s), slope);
    }
    const V steep = hn::CopySign(hn::Max(hn::Abs(slope), all(1e-18f)), slope);
    V tau = hn::Div(hn::Neg(height), steep);
    M meets = hn::And(hn::Le(enter, leave), hn::Le(now.enter[s], now.leave[s]));
    if (clamped_)
    {
      tau = hn::Min(hn::Max(tau, enter), leave);
      const V away = hn::Abs(hn::MulAdd(slope, tau, height));
      meets = hn::And(meets, hn::Le(away, all(plane.deviation + placeRounding)));
    }
    else
      meets = hn::And(meets, hn::And(hn::Ge(tau, enter), hn::Le(tau, leave)));
    keep(meets, tau, s, slot);
  }

  static void count(std::uint64_t& number, std::vector<bool>& seen, std::uint32_t index)
  {
    ++number;
    if (!seen.empty())
      seen[index] = true;
  }

  const RlodPaperArrays& tree_;
  PaperRays<SIZE>& rays_;
  bool clamped_;
  RlodPaperTree::Counts* counts_;
  std::uint32_t nearIsUpper_[3];
  int depth_ = 0;
  Waiting stack_[64]; ///< one a level
};

/// Casts some rays, group by group.
template <int SIZE, bool ANY, bool LODS>
void walk(const RlodPaperArrays& tree, PaperRays<SIZE>& rays, const RlodPaperCast& how)
{
  PaperWalk<SIZE, ANY, LODS> walk(tree, rays, how);
  for (int i = 0; i < SIZE; ++i)
  {
    const int group = rays.group[i];
    if (group < 0)
      continue;
    walk.run(group);
    for (int k = i; k < SIZE; ++k)
      if (rays.group[k] == group)
        rays.group[k] = -1;
  }
}

/// Casts all rays of a bundle or a packet, SIZE at a time.
template <int SIZE, bool ANY, typename Rays>
void castRays(const RlodPaperTree& tree, Rays& rays, std::int32_t object, const RlodPaperCast& how)
{
  const RlodPaperArrays& arrays = tree.arrays();
  PaperRays<SIZE> some;
  for (int first = 0; first < rays.count; first += SIZE)
  {
    const int count = takeRays(tree, rays, first, how.poe, some);
    if (!ANY && how.poe > 0.0 && tree.hasLods())
      walk<SIZE, false, true>(arrays, some, how);
    else
      walk<SIZE, ANY, false>(arrays, some, how);
    for (int i = 0; i < count; ++i)
    {
      if (some.slot[i] == PaperRays<SIZE>::none)
        continue;
      if (ANY)
      {
        rays.t[first + i] = -std::numeric_limits<double>::infinity();
        continue;
      }
      const double t = (some.tau0[i] + double(some.best[i])) / some.perT[i];
      if (!(t < rays.t[first + i]))
        continue;
      rays.t[first + i] = t;
      rays.slot[first + i] = some.slot[i];
      rays.object[first + i] = object;
    }
  }
}

} // namespace HWY_NAMESPACE
} // namespace mote::bench
HWY_AFTER_NAMESPACE();

#endif
