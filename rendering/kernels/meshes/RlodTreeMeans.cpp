// Means over the triangles that R-LODs stand for, carried from the clusters up in linear time.

#include "RlodTree.h"

#include "../core/WeightedSum.h"
#include "detail/RlodTreeArrays.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace mote
{

namespace
{

double areaOf(const TriangleCluster& cluster, int triangle)
{
  Vec3d corners[3];
  for (int k = 0; k < 3; ++k)
  {
    const unsigned p = cluster.corner(triangle, k);
    corners[k] = {cluster.point[0][p], cluster.point[1][p], cluster.point[2][p]};
  }
  return glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
}

} // namespace

ArrayView RlodTree::storedMeans(const ArrayView& values, int component) const
{
  return arrays_->means ? arrays_->means->find(values, component) : ArrayView();
}

std::vector<float> RlodTree::lodMeans(int components, const TriangleValues& valuesOf) const
{
  const RlodTreeArrays& a = *arrays_;
  const auto perNode = trianglesPerCluster * static_cast<std::size_t>(components);
  std::vector<float> means(a.nodes.size() * perNode, 0.0f);
  std::vector<WeightedSum> sums(a.nodes.size());
  const auto sumOf = [&](const TriangleCluster& cluster)
  {
    WeightedSum sum;
    double values[mostMeans];
    for (int t = 0; t < std::min<int>(cluster.count, TriangleCluster::capacity); ++t)
    {
      valuesOf(a.idOf(cluster.firstId + static_cast<std::uint32_t>(t)), values);
      // Those without area count for next to nothing, and for all where there is nothing else.
      const double least = std::numeric_limits<float>::min();
      sum.add(values, areaOf(cluster, t) + least, components);
    }
    return sum;
  };
  const auto make = [&](std::size_t index)
  {
    const RlodNode& node = a.nodes[index];
    for (unsigned k = 0; k < node.children; ++k)
    {
      const WeightedSum part =
        k < node.clusters ? sumOf(a.clusters[node.firstCluster + k]) : sums[node.nodeOf(k)];
      for (int c = 0; c < components; ++c)
        means[index * perNode + k * static_cast<std::size_t>(components) +
              static_cast<std::size_t>(c)] = part.mean(c);
      sums[index].add(part);
    }
  };
  const auto isBottom = [&](std::size_t k) { return a.nodes[k].clusters == a.nodes[k].children; };
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, a.nodes.size(), 1 << 7),
    [&](const Range& range)
    {
      for (std::size_t k = range.begin(); k != range.end(); ++k)
        if (isBottom(k))
          make(k);
    });
  // Children come after their parents.
  for (std::size_t k = a.nodes.size(); k-- > 0;)
    if (!isBottom(k))
      make(k);
  return means;
}

} // namespace mote
