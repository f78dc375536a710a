// Where the rays of a packet enter an RlodTree together. Included once per SIMD instruction set.

#if defined(MOTE_TREE_ENTRIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_TREE_ENTRIES_INL_H
#undef MOTE_TREE_ENTRIES_INL_H
#else
#define MOTE_TREE_ENTRIES_INL_H
#endif

#include "TreeBoxes-inl.h"

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
  /// Nodes that `opens` refuses stay as they are.
  template <typename Opens>
  TreeEntries(const RlodTreeView& view, const TreeRays& rays, int count, const Opens& opens)
  {
    measure(rays, count);
    for (int axis = 0; axis < 3; ++axis)
    {
      std::fill_n(low(axis), 16, 2.0f);
      std::fill_n(high(axis), 16, -2.0f);
      low(axis)[0] = -2.0f;
      high(axis)[0] = 2.0f;
    }
    index_[0] = 0;
    nodes_ = 1;
    count_ = 1;
    int next = 0;
    do
    {
      const RlodNode& node = view.nodes[index_[next]];
      if (!opens(node) || !open(node, next))
        break;
      next = largest();
    } while (next >= 0);
  }

  std::uint32_t index(int k) const { return index_[k]; }
  bool isNode(int k) const { return (nodes_ >> k & 1U) != 0; }

  /// The entries that a ray meets, as bits.
  template <typename Depths>
  HWY_INLINE unsigned met(const BoxRays& rays, int ray, Depths& depths) const
  {
    return rays.met(boxes_, ray, depths) & lowest(static_cast<unsigned>(count_));
  }

private:
  float* low(int axis) { return boxes_.low(axis); }
  float* high(int axis) { return boxes_.high(axis); }

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

  /// The node with the largest surface, or -1.
  int largest() const
  {
    Row areas;
    for (int set = 0; set < laneSets; ++set)
    {
      const auto width = [&](int axis)
      {
        return hn::Sub(hn::Load(DF(), boxes_.high(axis) + set * lanes),
          hn::Load(DF(), boxes_.low(axis) + set * lanes));
      };
      const VF x = width(0), y = width(1), z = width(2);
      const VF area = hn::MulAdd(x, y, hn::MulAdd(y, z, hn::Mul(z, x)));
      areas.store(area, set);
    }
    int found = -1;
    float largest = -1.0f;
    for (unsigned left = nodes_; left != 0; left &= left - 1)
      if (const int k = std::countr_zero(left); areas.v[k] > largest)
      {
        largest = areas.v[k];
        found = k;
      }
    return found;
  }

  /// Puts the children of a node that are near the rays in its place; false where there is no room.
  bool open(const RlodNode& node, int place)
  {
    const TreeBoxes boxes(node);
    unsigned bits = 0;
    for (int set = 0; set < laneSets; ++set)
    {
      const DF d;
      MF near = hn::Eq(hn::Zero(d), hn::Zero(d));
      for (int axis = 0; axis < 3; ++axis)
      {
        const VF least = hn::Load(d, boxes.low(axis) + set * lanes),
                 most = hn::Load(d, boxes.high(axis) + set * lanes);
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
        low(axis)[count_] = boxes.low(axis)[k];
        high(axis)[count_] = boxes.high(axis)[k];
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
      low(axis)[place] = low(axis)[last];
      high(axis)[place] = high(axis)[last];
    }
    index_[place] = index_[last];
    nodes_ &= ~(1U << place) & ~(1U << last);
    if (place != last)
      nodes_ |= lastIsNode << place;
  }

  float lower_[3], upper_[3];
  TreeBoxes boxes_;
  std::uint32_t index_[16];
  unsigned nodes_ = 0; ///< entries that are nodes, not clusters, as bits
  int count_ = 0;
};

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
