// Where the rays of a packet enter an RlodTree together. Included once per SIMD instruction set.

#if defined(MOTE_TREE_ENTRIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_TREE_ENTRIES_INL_H
#undef MOTE_TREE_ENTRIES_INL_H
#else
#define MOTE_TREE_ENTRIES_INL_H
#endif

#include "TreeRays-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// Up to 16 nodes or clusters that hold all triangles near some rays, found once for all of them:
/// the rays pass over the upper nodes of the tree, which are the same for each.
class TreeEntries
{
public:
  TreeEntries(const RlodTreeView& view, const TreeRays& rays, int count)
  {
    measure(rays, count);
    for (int axis = 0; axis < 3; ++axis)
    {
      std::fill_n(low_[axis].v, 16, infinity);
      std::fill_n(high_[axis].v, 16, -infinity);
      low_[axis].v[0] = -2.0f;
      high_[axis].v[0] = 2.0f;
    }
    index_[0] = 0;
    nodes_ = 1;
    count_ = 1;
    unsigned whole = 0; // those that would make too many when opened
    for (int next = 0; next >= 0; next = largest(nodes_ & ~whole))
      whole = open(view.nodes[index_[next]], next) ? 0 : whole | 1U << next;
  }

  std::uint32_t index(int k) const { return index_[k]; }
  bool isNode(int k) const { return (nodes_ >> k & 1U) != 0; }

  /// The entries that a ray meets, as bits.
  HWY_INLINE unsigned met(const TreeRay& ray) const
  {
    unsigned bits = 0;
    for (int set = 0; set < laneSets; ++set)
    {
      VF enter = all(ray.first), leave = all(ray.best);
      for (int axis = 0; axis < 3; ++axis)
      {
        const bool forward = ray.inverse[axis] > 0.0f;
        const VF q = all(ray.q[axis]), inverse = all(ray.inverse[axis]);
        const VF error = hn::Mul(all(0x1p-18f), hn::Abs(inverse));
        const Row& near = (forward ? low_ : high_)[axis];
        const Row& far = (forward ? high_ : low_)[axis];
        enter = hn::Max(enter, hn::MulSub(hn::Sub(near.load(set), q), inverse, error));
        leave = hn::Min(leave, hn::MulAdd(hn::Sub(far.load(set), q), inverse, error));
      }
      bits |= bitsOf(hn::Le(enter, leave)) << (set * lanes);
    }
    return bits & lowest(static_cast<unsigned>(count_));
  }

private:
  /// The box of all rays.
  void measure(const TreeRays& rays, int count)
  {
    const DF d;
    const VF margin = all(0x1p-18f);
    for (int axis = 0; axis < 3; ++axis)
    {
      VF lower = all(2.0f), upper = all(-2.0f);
      for (int i = 0; i < count; i += lanes)
      {
        const VF first = hn::Load(d, rays.first + i), best = hn::Load(d, rays.best + i);
        const MF isRay =
          hn::And(hn::Gt(best, first), hn::FirstN(d, static_cast<std::size_t>(count - i)));
        const VF from = hn::Load(d, rays.q[axis] + i);
        const VF perZ = hn::Div(all(1.0f), hn::Load(d, rays.inverse[axis] + i));
        const VF begin = hn::MulAdd(hn::Max(first, all(-4.0f)), perZ, from);
        const VF end = hn::MulAdd(hn::Min(best, all(4.0f)), perZ, from);
        const VF least = hn::Sub(hn::Min(begin, end), margin);
        const VF most = hn::Add(hn::Max(begin, end), margin);
        lower = hn::IfThenElse(isRay, hn::Min(lower, least), lower);
        upper = hn::IfThenElse(isRay, hn::Max(upper, most), upper);
      }
      lower_[axis] = hn::GetLane(hn::MinOfLanes(d, lower));
      upper_[axis] = hn::GetLane(hn::MaxOfLanes(d, upper));
    }
  }

  /// The one of these with the largest surface, or -1.
  int largest(unsigned some) const
  {
    int found = -1;
    for (float most = -1.0f; some != 0; some &= some - 1)
    {
      const int k = std::countr_zero(some);
      const float x = high_[0].v[k] - low_[0].v[k], y = high_[1].v[k] - low_[1].v[k],
                  z = high_[2].v[k] - low_[2].v[k];
      if (const float area = x * y + y * z + z * x; area > most)
      {
        most = area;
        found = k;
      }
    }
    return found;
  }

  /// Puts the children of a node that are near the rays in its place; false where there is no room.
  bool open(const RlodNode& node, int place)
  {
    Row low[3], high[3];
    unsigned bits = 0;
    for (int set = 0; set < laneSets; ++set)
    {
      const DF d;
      MF near = hn::Eq(hn::Zero(d), hn::Zero(d));
      for (int axis = 0; axis < 3; ++axis)
      {
        const VF scale = all(node.scale[axis]), origin = all(node.origin[axis]);
        const auto bound = [&](const std::uint8_t* row)
        { return hn::MulAdd(hn::ConvertTo(d, widened(row + set * lanes)), scale, origin); };
        const VF least = bound(node.low(axis)), most = bound(node.high(axis));
        low[axis].store(least, set);
        high[axis].store(most, set);
        near =
          hn::And(near, hn::And(hn::Le(least, all(upper_[axis])), hn::Ge(most, all(lower_[axis]))));
      }
      bits |= bitsOf(near) << (set * lanes);
    }
    bits &= lowest(node.children);
    if (count_ - 1 + std::popcount(bits) > 16)
      return false;
    remove(place);
    for (; bits != 0; bits &= bits - 1, ++count_)
    {
      const auto k = static_cast<unsigned>(std::countr_zero(bits));
      for (int axis = 0; axis < 3; ++axis)
      {
        low_[axis].v[count_] = low[axis].v[k];
        high_[axis].v[count_] = high[axis].v[k];
      }
      const bool isCluster = k < node.clusters;
      index_[count_] = isCluster ? node.firstCluster + k : node.nodeOf(k);
      nodes_ |= (isCluster ? 0U : 1U) << count_;
    }
    return true;
  }

  /// The last comes in its place.
  void remove(int place)
  {
    const int last = --count_;
    const unsigned lastIsNode = nodes_ >> last & 1U;
    for (int axis = 0; axis < 3; ++axis)
    {
      low_[axis].v[place] = low_[axis].v[last];
      high_[axis].v[place] = high_[axis].v[last];
    }
    index_[place] = index_[last];
    nodes_ &= ~(1U << place) & ~(1U << last);
    if (place != last)
      nodes_ |= lastIsNode << place;
  }

  float lower_[3], upper_[3];
  Row low_[3], high_[3];
  std::uint32_t index_[16];
  unsigned nodes_ = 0; ///< entries that are nodes, not clusters, as bits
  int count_ = 0;
};

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
