#pragma once

#include "../../core/Progress.h"
#include "TreeletBuild.h"

#include <vector>

namespace mote
{

/// A binary tree over the valid triangles of a mesh.
struct BinaryTree
{
  RawVector<BinaryNode> nodes;
  std::uint32_t root = 0;
  RawVector<std::uint32_t> order; ///< input's indices of the triangles, cluster by cluster
};

/// Builds it in parallel: along a space-filling curve down to treelets, by the surface-area
/// heuristic within and above these. Without nodes where the mesh has no valid triangle, or where
/// `progress` answers false.
BinaryTree buildBinaryTree(const TriangleMesh& mesh, const Progress& progress);

} // namespace mote
