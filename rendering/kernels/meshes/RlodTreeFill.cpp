// Clusters and boxes of an RlodTree, from where the points of the mesh are.

#include "RlodTree.h"

#include "detail/ClusterCorners.h"
#include "detail/RlodTreeArrays.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace mote
{

namespace
{

using Range = tbb::blocked_range<std::size_t>;

constexpr float infinity = std::numeric_limits<float>::infinity();

struct FloatBox
{
  float lower[3] = {infinity, infinity, infinity};
  float upper[3] = {-infinity, -infinity, -infinity};

  void add(const FloatBox& b)
  {
    for (int k = 0; k < 3; ++k)
    {
      lower[k] = std::min(lower[k], b.lower[k]);
      upper[k] = std::max(upper[k], b.upper[k]);
    }
  }
  double area() const
  {
    const double x = upper[0] - lower[0], y = upper[1] - lower[1], z = upper[2] - lower[2];
    return 2.0 * (x * y + y * z + z * x);
  }
};

/// Fetches the triangles of a cluster, or the points of its triangles.
void fetchTriangles(
  const TriangleMesh& mesh, const std::uint32_t* ids, const TriangleCluster& cluster)
{
  for (int t = 0; t < cluster.count; ++t)
    __builtin_prefetch(&mesh.triangles()[ids[cluster.firstId + t]]);
}
void fetchPoints(const TriangleMesh& mesh, const std::uint32_t* ids, const TriangleCluster& cluster)
{
  for (int t = 0; t < cluster.count; ++t)
    for (const std::uint32_t corner : mesh.triangles()[ids[cluster.firstId + t]])
      __builtin_prefetch(&mesh.points()[corner]);
}

/// Fills all of a cluster but firstId and count. Answers its box.
FloatBox fillCluster(const TriangleMesh& mesh, const std::uint32_t* ids, TriangleCluster& cluster)
{
  ClusterCorners corners;
  std::fill_n(cluster.corners01, TriangleCluster::capacity, std::uint8_t{0});
  std::fill_n(cluster.corner2, TriangleCluster::capacity / 2, std::uint8_t{0});
  for (int t = 0; t < cluster.count; ++t)
  {
    const TriangleMesh::Corners& c = mesh.triangles()[ids[cluster.firstId + t]];
    const int a = corners.numberOf(c[0]), b = corners.numberOf(c[1]);
    cluster.corners01[t] = static_cast<std::uint8_t>(a | b << 4);
    cluster.corner2[t % 8] =
      static_cast<std::uint8_t>(cluster.corner2[t % 8] | corners.numberOf(c[2]) << (t / 8 * 4));
  }
  FloatBox box;
  for (int p = 0; p < TriangleCluster::capacity; ++p)
  {
    const Vec3f& point = mesh.points()[corners.point(p < corners.count() ? p : 0)];
    for (int axis = 0; axis < 3; ++axis)
    {
      cluster.point[axis][p] = point[axis];
      box.lower[axis] = std::min(box.lower[axis], point[axis]);
      box.upper[axis] = std::max(box.upper[axis], point[axis]);
    }
  }
  return box;
}

/// Where the bounds of a node's children fall on its 8 bits; exact numbers lie within.
void quantise(const FloatBox& all, const FloatBox* boxes, RlodNode& node)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double origin = all.lower[axis];
    float scale = static_cast<float>((all.upper[axis] - origin) / 255.0);
    while (origin + 255.0 * scale < all.upper[axis])
      scale = std::nextafter(scale, infinity);
    node.origin[axis] = all.lower[axis];
    node.scale[axis] = scale;
    const double steps = scale > 0.0f ? 1.0 / scale : 0.0;
    const auto clamped = [](double v) { return std::clamp(v, 0.0, 255.0); };
    for (int k = 0; k < RlodNode::fanout; ++k)
    {
      if (k >= static_cast<int>(node.children))
      {
        node.low(axis)[k] = 255;
        node.high(axis)[k] = 0;
        continue;
      }
      double low = clamped(std::floor((boxes[k].lower[axis] - origin) * steps));
      double high = clamped(std::ceil((boxes[k].upper[axis] - origin) * steps));
      low -= origin + low * scale > boxes[k].lower[axis] ? 1.0 : 0.0;
      high += origin + high * scale < boxes[k].upper[axis] ? 1.0 : 0.0;
      node.low(axis)[k] = static_cast<std::uint8_t>(clamped(low));
      node.high(axis)[k] = static_cast<std::uint8_t>(clamped(high));
    }
  }
}

} // namespace

void RlodTree::fill(const TriangleMesh& mesh)
{
  RlodTreeArrays& a = *arrays_;
  std::vector<FloatBox> clusters(a.clusters.size()), nodes(a.nodes.size());
  tbb::parallel_for(Range(0, a.clusters.size(), 1 << 10),
    [&](const Range& range)
    {
      const std::uint32_t* ids = a.ids.data();
      for (std::size_t k = range.begin(); k != range.end(); ++k)
      {
        if (k + 2 < range.end())
          fetchTriangles(mesh, ids, a.clusters[k + 2]);
        if (k + 1 < range.end())
          fetchPoints(mesh, ids, a.clusters[k + 1]);
        clusters[k] = fillCluster(mesh, ids, a.clusters.own()[k]);
      }
    });
  // Children come after their parents.
  double area = 0.0;
  for (std::size_t k = a.nodes.size(); k-- > 0;)
  {
    const RlodNode& node = a.nodes[k];
    for (std::uint32_t c = 0; c < node.clusters; ++c)
    {
      nodes[k].add(clusters[node.firstCluster + c]);
      area += clusters[node.firstCluster + c].area();
    }
    for (std::uint32_t c = node.clusters; c < node.children; ++c)
      nodes[k].add(nodes[node.nodeOf(c)]);
    area += nodes[k].area();
  }
  const double whole = nodes[0].area();
  cost_ = whole > 0.0 ? area / whole : 0.0;
  tbb::parallel_for(Range(0, a.nodes.size(), 1 << 9),
    [&](const Range& range)
    {
      for (std::size_t k = range.begin(); k != range.end(); ++k)
      {
        RlodNode& node = a.nodes.own()[k];
        FloatBox boxes[RlodNode::fanout];
        for (std::uint32_t c = 0; c < node.children; ++c)
          boxes[c] = c < node.clusters ? clusters[node.firstCluster + c] : nodes[node.nodeOf(c)];
        quantise(nodes[k], boxes, node);
      }
    });
  origin_ = mesh.origin();
  unit_ = mesh.unit();
  for (int axis = 0; axis < 3; ++axis)
  {
    lower_[axis] = nodes[0].lower[axis];
    upper_[axis] = nodes[0].upper[axis];
  }
}

bool RlodTree::refit(const TriangleMesh& mesh)
{
  const StoredArray<std::uint32_t>& ids = arrays_->ids;
  if (mesh.validCount() != size() || ids.size() != size() || !arrays_->areOwn())
    return false;
  for (std::size_t k = 0; k < ids.size(); ++k)
    if (const std::uint32_t id = ids[k]; id >= mesh.size() || !mesh.isValid(id))
      return false;
  if (size() > 0)
    fill(mesh);
  if (hasLods())
    makeLods();
  return true;
}

} // namespace mote
