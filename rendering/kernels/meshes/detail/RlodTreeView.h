#pragma once

#include "RlodTreeArrays.h"

namespace mote
{

/// What casting reads of an RlodTree.
struct RlodTreeView
{
  const RlodNode* nodes;
  const TriangleCluster* clusters;
  Vec3d origin;
  double unit;
  Vec3d lower, upper; ///< of all triangles, in the tree's coordinates
  int depth;

  explicit RlodTreeView(const RlodTree& tree)
    : nodes(tree.arrays_->nodes.data())
    , clusters(tree.arrays_->clusters.data())
    , origin(tree.origin_)
    , unit(tree.unit_)
    , lower(tree.lower_)
    , upper(tree.upper_)
    , depth(tree.depth_)
  {
  }

  /// Most references that wait while the tree is gone through depth first.
  std::size_t stackSize() const
  {
    return static_cast<std::size_t>(depth) * RlodNode::fanout + RlodNode::fanout;
  }
};

} // namespace mote
