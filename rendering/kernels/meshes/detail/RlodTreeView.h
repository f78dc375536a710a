#pragma once

#include "RlodTreeArrays.h"

namespace mote
{

/// What casting reads of an RlodTree.
struct RlodTreeView
{
  const RlodNode* nodes;
  const TriangleCluster* clusters;
  const RlodPlanes* planes; ///< with `words`, or both none
  const RlodWords* words;
  const std::uint16_t* complete; ///< or null: all are
  ErrorLevels levels;
  Vec3d origin;
  double unit;
  Vec3d lower, upper; ///< of all triangles, in the tree's coordinates
  int depth;
  bool sparesMemory;

  explicit RlodTreeView(const RlodTree& tree)
    : nodes(tree.arrays_->nodes.data())
    , clusters(tree.arrays_->clusters.data())
    , planes(tree.arrays_->planes.data())
    , words(tree.hasLods() ? tree.arrays_->words.data() : nullptr)
    , complete(tree.arrays_->complete.empty() ? nullptr : tree.arrays_->complete.data())
    , levels(tree.arrays_->levels)
    , origin(tree.origin_)
    , unit(tree.unit_)
    , lower(tree.lower_)
    , upper(tree.upper_)
    , depth(tree.depth_)
    , sparesMemory(tree.sparesMemory_)
  {
  }

  /// Whether R-LODs may stand for triangles. Rays that are not told how far they lie apart are
  /// exact.
  template <typename Rays>
  bool takesLods(const Rays& rays, double poe) const
  {
    return poe > 0.0 && words != nullptr && (rays.footprint > 0.0 || rays.footprintPerT > 0.0);
  }

  /// Children of a node, as bits, whose R-LODs may be taken.
  std::uint32_t mayErr(const RlodNode& node) const
  {
    const std::uint32_t all = complete ? complete[&node - nodes] : ~std::uint32_t{0};
    return sparesMemory ? all : all & ~std::uint32_t{0} << node.clusters;
  }

  /// Most references that wait while the tree is gone through depth first.
  std::size_t stackSize() const
  {
    return static_cast<std::size_t>(depth) * RlodNode::fanout + RlodNode::fanout;
  }
};

} // namespace mote
