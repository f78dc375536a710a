// Splitting treelets, compiled once for every SIMD instruction set; all make the same tree.

#include "detail/TreeletBuild.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "meshes/TreeletBuild.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "detail/ClusterCorners.h"

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{
namespace
{

namespace hn = hwy::HWY_NAMESPACE;

/// Bounds as they are stored: the least of x, y, z; any number; and minus the greatest of x, y, z;
/// any number. So two are joined by taking the least of all.
struct alignas(32) Bounds8
{
  float v[8];
};

/// Bounds in registers.
struct Join
{
  using D = hn::CappedTag<float, 8>;
  using V = hn::Vec<D>;
  static constexpr int lanes = static_cast<int>(hn::MaxLanes(D()));
  static constexpr int parts = 8 / lanes;

  V part[parts];

  HWY_INLINE Join()
  {
    for (V& p : part)
      p = hn::Set(D(), 1e30f);
  }
  HWY_INLINE explicit Join(const Bounds8& bounds)
  {
    for (int k = 0; k < parts; ++k)
      part[k] = hn::Load(D(), bounds.v + k * lanes);
  }
  HWY_INLINE void store(Bounds8& bounds) const
  {
    for (int k = 0; k < parts; ++k)
      hn::Store(part[k], D(), bounds.v + k * lanes);
  }
  HWY_INLINE void add(const Join& b)
  {
    for (int k = 0; k < parts; ++k)
      part[k] = hn::Min(part[k], b.part[k]);
  }
  /// Twice the middle of a box, as a point's bounds.
  HWY_INLINE Join twiceMiddle() const
  {
    Join middle;
    for (int k = 0; k < parts; ++k)
      middle.part[k] = hn::Sub(part[k], turned(k));
    return middle;
  }
  /// Writes minus the widths along the axes, and a fourth number.
  HWY_INLINE void storeWidths(float* to) const
  {
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
    for (int k = 0; k < parts / 2; ++k)
      hn::Store(hn::Add(part[k], turned(k)), D(), to + k * lanes);
#else
    const hn::Half<D> half;
    hn::Store(hn::LowerHalf(half, hn::Add(part[0], turned(0))), half, to);
#endif
  }

private:
  /// The part with both halves of the eight numbers in each other's place.
  HWY_INLINE V turned(int k) const
  {
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
    return part[(k + parts / 2) % parts];
#else
    return hn::ConcatLowerUpper(D(), part[k], part[k]);
#endif
  }
};

/// Splits the triangles of one treelet.
class TreeletBuilder
{
public:
  TreeletBuilder(
    const TriangleMesh& mesh, std::uint32_t* order, std::size_t count, std::uint32_t first)
    : mesh_(mesh)
    , order_(order)
    , first_(first)
  {
    nodes_.reserve(count / 4);
    Bounds8 all;
    takeBoxes(count, all);
    split(0, static_cast<int>(count), 0, all);
    std::copy_n(order, count, indices_);
    for (std::size_t i = 0; i < count; ++i)
      order[i] = indices_[static_cast<std::size_t>(boxes_[i].v[place])];
  }

  std::vector<BinaryNode> take() { return std::move(nodes_); }

private:
  static constexpr int bins = 16;
  static constexpr int place = 3; ///< number of a box that tells the triangle's place in order_
  /// What a cluster holds on average: the cost of a side is what that many more clusters cost.
  static constexpr int fill = 14;
  /// Deeper, sides have as many triangles each: so recursion ends soon, whatever the triangles.
  static constexpr int deepest = 24;

  /// The boxes of the triangles, and of all of them.
  void takeBoxes(std::size_t count, Bounds8& all)
  {
    // Triangles and points come from far apart in memory: they are fetched ahead.
    constexpr std::size_t ahead = 16;
    const TriangleMesh::Corners* triangles = mesh_.triangles();
    const auto fetchTriangle = [&](std::size_t i)
    { __builtin_prefetch(&triangles[order_[std::min(i, count - 1)]]); };
    for (std::size_t i = 0; i < 2 * ahead; ++i)
      fetchTriangle(i);
    Join join;
    for (std::size_t i = 0; i < count; ++i)
    {
      fetchTriangle(i + 2 * ahead);
      for (const std::uint32_t corner : triangles[order_[std::min(i + ahead, count - 1)]])
        __builtin_prefetch(&mesh_.points()[corner]);
      const TriangleMesh::Corners& corners = triangles[order_[i]];
      const Vec3f &a = mesh_.points()[corners[0]], &b = mesh_.points()[corners[1]],
                  &c = mesh_.points()[corners[2]];
      float* v = boxes_[i].v;
      for (int axis = 0; axis < 3; ++axis)
      {
        v[axis] = std::min(std::min(a[axis], b[axis]), c[axis]);
        v[4 + axis] = -std::max(std::max(a[axis], b[axis]), c[axis]);
      }
      v[place] = static_cast<float>(i);
      v[7] = 0.0f;
    }
    for (std::size_t i = 0; i < count; ++i)
      join.add(Join(boxes_[i]));
    join.store(all);
  }

  /// Bounds of twice the middles of the triangles' boxes.
  Bounds8 middlesOf(int begin, int end) const
  {
    Join even, odd;
    int i = begin;
    for (; i + 1 < end; i += 2)
    {
      even.add(Join(boxes_[i]).twiceMiddle());
      odd.add(Join(boxes_[i + 1]).twiceMiddle());
    }
    if (i < end)
      even.add(Join(boxes_[i]).twiceMiddle());
    even.add(odd);
    Bounds8 all;
    even.store(all);
    return all;
  }

  /// Whether the triangles have few enough corners for a cluster.
  bool fitsCluster(int begin, int end) const
  {
    if (end - begin > TriangleCluster::capacity)
      return false;
    ClusterCorners corners;
    for (int i = begin; i < end; ++i)
      if (!corners.add(mesh_.triangles()[order_[static_cast<int>(boxes_[i].v[place])]]))
        return false;
    return true;
  }

  /// Two parts of some triangles: where the second begins, and their boxes.
  struct Parts
  {
    int middle;
    Bounds8 boxes[2];
  };

  Parts halves(int begin, int end) const
  {
    Parts parts;
    parts.middle = begin + (end - begin) / 2;
    Join sides[2];
    for (int i = begin; i < end; ++i)
      sides[i < parts.middle ? 0 : 1].add(Join(boxes_[i]));
    sides[0].store(parts.boxes[0]);
    sides[1].store(parts.boxes[1]);
    return parts;
  }

  /// The triangles of each bin along an axis.
  struct Bins
  {
    Bounds8 boxes[bins];
    alignas(64) std::int32_t counts[bins] = {};
  };

  /// Finds the bins of triangles, which lie from `lower` on along the axis; `scale` bins a unit.
  HWY_INLINE void fillBins(int begin, int end, int axis, float lower, float scale, Bins& all)
  {
    for (Bounds8& box : all.boxes)
      Join().store(box);
    for (int i = begin; i < end; ++i)
    {
      const float* v = boxes_[i].v;
      const int bin = static_cast<int>((v[axis] - v[4 + axis] - lower) * scale);
      bin_[i] = static_cast<std::uint8_t>(bin);
      Join join(all.boxes[bin]);
      join.add(Join(boxes_[i]));
      join.store(all.boxes[bin]);
      ++all.counts[bin];
    }
  }

  /// Brings the triangles into two parts.
  Parts partition(int begin, int end)
  {
    const Bounds8 middles = middlesOf(begin, end);
    int axis = 0;
    float extent[3];
    for (int k = 0; k < 3; ++k)
      extent[k] = -middles.v[4 + k] - middles.v[k];
    for (int k = 1; k < 3; ++k)
      if (extent[k] > extent[axis])
        axis = k;
    if (!(extent[axis] > 1e-30f)) // smaller ones have no finite scale
      return halves(begin, end);
    Bins all;
    fillBins(begin, end, axis, middles.v[axis], bins * 0.9999f / extent[axis], all);
    Parts parts;
    const int cut = bestCut(all, end - begin, parts);
    if (cut < 0)
      return halves(begin, end);
    int left = begin, right = 0;
    for (int i = begin; i < end; ++i)
      if (bin_[i] <= cut)
        boxes_[left++] = boxes_[i];
      else
        aside_[right++] = boxes_[i];
    std::copy_n(aside_, right, boxes_ + left);
    parts.middle = left;
    return parts;
  }

  /// What a cut has on one side, for each bin.
  struct Sides
  {
    Bounds8 boxes[bins];
    alignas(64) float widths[bins][4]; ///< of the boxes, negative; and any number
    alignas(64) std::int32_t counts[bins];

    HWY_INLINE void keep(int bin, const Join& join, int count)
    {
      join.store(boxes[bin]);
      counts[bin] = count;
      join.storeWidths(widths[bin]);
    }
    /// Half the area of the boxes from `bin` on, times how many clusters they will become.
    template <typename D>
    HWY_INLINE hn::Vec<D> costs(D d, int bin) const
    {
      const hn::RebindToSigned<D> i;
      hn::Vec<D> x, y, z, rest;
      hn::LoadInterleaved4(d, widths[bin], x, y, z, rest);
      const auto area = hn::Add(hn::Add(hn::Mul(x, y), hn::Mul(y, z)), hn::Mul(z, x));
      const auto sum = hn::Add(hn::Load(i, counts + bin), hn::Set(i, fill - 1));
      // The whole part of sum / fill, for as many triangles as a treelet has.
      const auto clusters = hn::ShiftRight<16>(hn::Mul(sum, hn::Set(i, 65536 / fill + 1)));
      return hn::Mul(area, hn::ConvertTo(d, clusters));
    }
  };

  /// The bin after which a cut costs least, or -1; and the boxes of its parts.
  static HWY_INLINE int bestCut(const Bins& all, int count, Parts& parts)
  {
    Sides below, above; // the bins up to one, and those after it
    Join join;
    int sum = 0;
    above.keep(bins - 1, join, 0);
    for (int k = bins - 1; k > 0; --k)
    {
      join.add(Join(all.boxes[k]));
      above.keep(k - 1, join, sum += all.counts[k]);
    }
    join = Join();
    sum = 0;
    for (int k = 0; k < bins; ++k)
    {
      join.add(Join(all.boxes[k]));
      below.keep(k, join, sum += all.counts[k]);
    }
    const hn::CappedTag<float, 16> d;
    const hn::RebindToSigned<decltype(d)> i;
    alignas(64) float costs[bins];
    for (int k = 0; k < bins; k += static_cast<int>(hn::MaxLanes(d)))
    {
      const auto taken = hn::Load(i, below.counts + k);
      const auto isCut = hn::And(hn::Gt(taken, hn::Zero(i)), hn::Lt(taken, hn::Set(i, count)));
      const auto cost = hn::Add(below.costs(d, k), above.costs(d, k));
      hn::Store(hn::IfThenElse(hn::RebindMask(d, isCut), cost, hn::Set(d, 1e30f)), d, costs + k);
    }
    const auto best = static_cast<int>(std::min_element(costs, costs + bins) - costs);
    if (!(costs[best] < 1e30f))
      return -1;
    parts.boxes[0] = below.boxes[best];
    parts.boxes[1] = above.boxes[best];
    return best;
  }

  std::uint32_t split(int begin, int end, int depth, const Bounds8& box)
  {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    BinaryNode& node = nodes_.emplace_back();
    for (int axis = 0; axis < 3; ++axis)
    {
      node.lower[axis] = box.v[axis];
      node.upper[axis] = -box.v[4 + axis];
    }
    if (fitsCluster(begin, end))
    {
      node.left = first_ + static_cast<std::uint32_t>(begin);
      node.right = static_cast<std::uint32_t>(end - begin);
      return index;
    }
    const Parts parts = depth < deepest ? partition(begin, end) : halves(begin, end);
    const std::uint32_t left = split(begin, parts.middle, depth + 1, parts.boxes[0]);
    const std::uint32_t right = split(parts.middle, end, depth + 1, parts.boxes[1]);
    nodes_[index].left = left;
    nodes_[index].right = right;
    nodes_[index].join(nodes_[left], nodes_[right]);
    return index;
  }

  const TriangleMesh& mesh_;
  std::uint32_t* order_;
  std::uint32_t first_;
  std::vector<BinaryNode> nodes_;
  Bounds8 boxes_[treeletSize];
  Bounds8 aside_[treeletSize];
  std::uint8_t bin_[treeletSize];
  std::uint32_t indices_[treeletSize];
};

} // namespace

std::vector<BinaryNode> splitTreelet(
  const TriangleMesh& mesh, std::uint32_t* order, std::size_t count, std::uint32_t first)
{
  return TreeletBuilder(mesh, order, count, first).take();
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote
{

HWY_EXPORT(splitTreelet);

std::vector<BinaryNode> buildTreelet(
  const TriangleMesh& mesh, std::uint32_t* order, std::size_t count, std::uint32_t first)
{
  return HWY_DYNAMIC_DISPATCH(splitTreelet)(mesh, order, count, first);
}

} // namespace mote

#endif
