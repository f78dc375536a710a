#include "detail/TreeletBuild.h"

#include "detail/ClusterCorners.h"

#include <algorithm>

namespace mote
{

namespace
{

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
    // Triangles and points come from far apart in memory: they are fetched ahead.
    constexpr std::size_t ahead = 16;
    const auto fetchTriangle = [&](std::size_t i)
    { __builtin_prefetch(&mesh.triangles()[order[std::min(i, count - 1)]]); };
    for (std::size_t i = 0; i < 2 * ahead; ++i)
      fetchTriangle(i);
    for (std::size_t i = 0; i < count; ++i)
    {
      fetchTriangle(i + 2 * ahead);
      for (const std::uint32_t corner : mesh.triangles()[order[std::min(i + ahead, count - 1)]])
        __builtin_prefetch(&mesh.points()[corner]);
      boxes_[i] = {};
      for (const std::uint32_t corner : mesh.triangles()[order[i]])
      {
        const Vec3f& p = mesh.points()[corner];
        const float point[4] = {p.x, p.y, p.z, 0.0f};
        boxes_[i].add(point);
      }
      boxes_[i].lower[3] = static_cast<float>(i);
    }
    split(0, static_cast<int>(count), 0);
    std::copy_n(order, count, indices_);
    for (std::size_t i = 0; i < count; ++i)
      order[i] = indices_[static_cast<std::size_t>(boxes_[i].lower[3])];
  }

  std::vector<BinaryNode> take() { return std::move(nodes_); }

private:
  static constexpr int bins = 16;
  /// What a cluster holds on average: the cost of a side is what that many more clusters cost.
  static constexpr int fill = 14;
  /// Deeper, sides have as many triangles each: so recursion ends soon, whatever the triangles.
  static constexpr int deepest = 24;

  struct Extent
  {
    Bounds4 box, middles; ///< of the triangles, and of twice the middles of their boxes
  };

  Extent extentOf(int begin, int end) const
  {
    Extent all;
    for (int i = begin; i < end; ++i)
    {
      all.box.add(boxes_[i]);
      float middle[4];
      for (int k = 0; k < 4; ++k)
        middle[k] = boxes_[i].lower[k] + boxes_[i].upper[k];
      all.middles.add(middle);
    }
    return all;
  }

  /// Whether the triangles have few enough corners for a cluster.
  bool fitsCluster(int begin, int end) const
  {
    if (end - begin > TriangleCluster::capacity)
      return false;
    ClusterCorners corners;
    for (int i = begin; i < end; ++i)
      if (!corners.add(mesh_.triangles()[order_[static_cast<int>(boxes_[i].lower[3])]]))
        return false;
    return true;
  }

  /// Where the second part begins, after the triangles have come into parts.
  int partition(int begin, int end, const Bounds4& middles)
  {
    int axis = 0;
    float extent[3];
    for (int k = 0; k < 3; ++k)
      extent[k] = middles.upper[k] - middles.lower[k];
    for (int k = 1; k < 3; ++k)
      if (extent[k] > extent[axis])
        axis = k;
    const int half = begin + (end - begin) / 2;
    if (!(extent[axis] > 0.0f))
      return half;
    const float scale = bins * 0.9999f / extent[axis], lower = middles.lower[axis];
    Bounds4 boxes[bins];
    int counts[bins] = {};
    for (int i = begin; i < end; ++i)
    {
      const int bin =
        static_cast<int>((boxes_[i].lower[axis] + boxes_[i].upper[axis] - lower) * scale);
      bin_[i] = static_cast<std::uint8_t>(std::clamp(bin, 0, bins - 1));
      boxes[bin_[i]].add(boxes_[i]);
      ++counts[bin_[i]];
    }
    const int cut = bestCut(boxes, counts, end - begin);
    if (cut < 0)
      return half;
    int left = begin, right = 0;
    for (int i = begin; i < end; ++i)
      if (bin_[i] <= cut)
        boxes_[left++] = boxes_[i];
      else
        aside_[right++] = boxes_[i];
    std::copy_n(aside_, right, boxes_ + left);
    return left;
  }

  /// The bin after which a cut costs least, or -1.
  static int bestCut(const Bounds4* boxes, const int* counts, int all)
  {
    const auto clustersOf = [](int n) { return static_cast<float>((n + fill - 1) / fill); };
    float above[bins];
    Bounds4 box;
    int count = 0;
    for (int i = bins - 1; i > 0; --i)
    {
      box.add(boxes[i]);
      count += counts[i];
      above[i] = box.halfArea() * clustersOf(count);
    }
    float best = 1e30f;
    int cut = -1;
    box = {};
    count = 0;
    for (int i = 0; i + 1 < bins; ++i)
    {
      box.add(boxes[i]);
      count += counts[i];
      const float cost = box.halfArea() * clustersOf(count) + above[i + 1];
      if (count > 0 && count < all && cost < best)
      {
        best = cost;
        cut = i;
      }
    }
    return cut;
  }

  std::uint32_t split(int begin, int end, int depth)
  {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    const Extent all = extentOf(begin, end);
    BinaryNode& node = nodes_.emplace_back();
    std::copy_n(all.box.lower, 3, node.lower);
    std::copy_n(all.box.upper, 3, node.upper);
    if (fitsCluster(begin, end))
    {
      node.left = first_ + static_cast<std::uint32_t>(begin);
      node.right = static_cast<std::uint32_t>(end - begin);
      return index;
    }
    const int middle =
      depth < deepest ? partition(begin, end, all.middles) : begin + (end - begin) / 2;
    const std::uint32_t left = split(begin, middle, depth + 1);
    const std::uint32_t right = split(middle, end, depth + 1);
    nodes_[index].left = left;
    nodes_[index].right = right;
    nodes_[index].join(nodes_[left], nodes_[right]);
    return index;
  }

  const TriangleMesh& mesh_;
  std::uint32_t* order_;
  std::uint32_t first_;
  std::vector<BinaryNode> nodes_;
  Bounds4 boxes_[treeletSize]; ///< the fourth number of `lower` is the triangle's place in order_
  Bounds4 aside_[treeletSize];
  std::uint8_t bin_[treeletSize];
  std::uint32_t indices_[treeletSize];
};

} // namespace

std::vector<BinaryNode> buildTreelet(
  const TriangleMesh& mesh, std::uint32_t* order, std::size_t count, std::uint32_t first)
{
  return TreeletBuilder(mesh, order, count, first).take();
}

} // namespace mote
