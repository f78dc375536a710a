#pragma once

#include "../TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace mote
{

/// Bounds in float, in rows of four for the compiler to make vectors of; the fourth numbers mean
/// nothing.
struct Bounds4
{
  float lower[4] = {1e30f, 1e30f, 1e30f, 0.0f};
  float upper[4] = {-1e30f, -1e30f, -1e30f, 0.0f};

  void add(const Bounds4& b)
  {
    for (int k = 0; k < 4; ++k)
    {
      lower[k] = lower[k] < b.lower[k] ? lower[k] : b.lower[k];
      upper[k] = upper[k] > b.upper[k] ? upper[k] : b.upper[k];
    }
  }
  void add(const float* point)
  {
    for (int k = 0; k < 4; ++k)
    {
      lower[k] = lower[k] < point[k] ? lower[k] : point[k];
      upper[k] = upper[k] > point[k] ? upper[k] : point[k];
    }
  }
  /// Half its area, or 0 where it is empty.
  float halfArea() const
  {
    const float x = upper[0] - lower[0], y = upper[1] - lower[1], z = upper[2] - lower[2];
    return x < 0.0f ? 0.0f : x * y + y * z + z * x;
  }
};

/// A node of the binary tree that wide nodes are made from.
struct BinaryNode
{
  float lower[3], upper[3];
  std::uint32_t left, right;  ///< children; of a cluster: its first triangle, and how many
  std::uint32_t clusters = 1; ///< below it, 1: it is one itself

  bool isCluster() const { return clusters == 1; }
  /// As many clusters as both children have.
  void join(const BinaryNode& a, const BinaryNode& b) { clusters = a.clusters + b.clusters; }
  float halfArea() const
  {
    const float x = upper[0] - lower[0], y = upper[1] - lower[1], z = upper[2] - lower[2];
    return x * y + y * z + z * x;
  }
};

/// Triangles that are split together by the surface-area heuristic, few enough for a cache.
constexpr std::size_t treeletSize = 1024;

/// Builds the binary tree over up to treeletSize triangles of a mesh: `order`, indices of
/// triangles, comes into the order of the clusters, whose first triangles count from `first`. The
/// root is node 0, and children come after their parents.
std::vector<BinaryNode> buildTreelet(
  const TriangleMesh& mesh, std::uint32_t* order, std::size_t count, std::uint32_t first);

} // namespace mote
