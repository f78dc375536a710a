#pragma once

#include "../../core/StoredArray.h"
#include "../RlodTree.h"
#include "RlodPlanes.h"
#include "RlodTreeParts.h"

#include <algorithm>

namespace mote
{

/// What an RlodTree holds, or views in a file.
struct RlodTreeArrays
{
  StoredArray<RlodNode> nodes; ///< the root first; children come after their parents
  StoredArray<TriangleCluster> clusters;
  std::size_t triangles = 0, hidden = 0; ///< all; those of them that no ray meets
  /// The input's indices of the triangles, cluster by cluster; empty where they have this order.
  StoredArray<std::uint32_t> ids;

  StoredArray<RlodPlanes> planes; ///< R-LODs of each node's children, or none
  StoredArray<RlodWords> words;   ///< likewise
  ErrorLevels levels;             ///< of their error radii
  /// Where triangles are hidden: children of each node that have all of theirs, as bits.
  StoredArray<std::uint16_t> complete;
  std::shared_ptr<const StoredMeans> means; ///< of a file's arrays, or null

  /// Of a triangle that there is, whatever a damaged file says.
  std::uint64_t idOf(std::uint64_t place) const
  {
    return ids.empty() ? inRange(place) : std::uint64_t{ids[place]};
  }
  std::uint64_t inRange(std::uint64_t triangle) const
  {
    return std::min<std::uint64_t>(triangle, triangles - 1);
  }
  /// Whether they lie in memory of their own, and may be changed.
  bool areOwn() { return nodes.own() && clusters.own() && complete.empty(); }
};

static_assert(sizeof(RlodNode) == RlodTree::bytesPerNode);
static_assert(sizeof(TriangleCluster) == RlodTree::bytesPerCluster);
static_assert(sizeof(RlodWords) == RlodTree::bytesPerWords);
static_assert(sizeof(RlodPlanes) == RlodTree::bytesPerPlanes);

} // namespace mote
