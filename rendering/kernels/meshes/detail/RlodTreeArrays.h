#pragma once

#include "../../core/RawVector.h"
#include "../RlodTree.h"
#include "RlodPlanes.h"
#include "RlodTreeParts.h"

namespace mote
{

struct RlodTree::Arrays
{
  RawVector<RlodNode> nodes; ///< the root first; children come after their parents
  RawVector<TriangleCluster> clusters;
  RawVector<std::uint32_t> ids; ///< input's indices of the triangles, cluster by cluster

  RawVector<RlodPlanes> planes; ///< R-LODs of each node's children, or none
  RawVector<RlodWords> words;   ///< likewise
  ErrorLevels levels;           ///< of their error radii
};

static_assert(sizeof(RlodNode) == RlodTree::bytesPerNode);
static_assert(sizeof(TriangleCluster) == RlodTree::bytesPerCluster);
static_assert(sizeof(RlodWords) == RlodTree::bytesPerWords);
static_assert(sizeof(RlodPlanes) == RlodTree::bytesPerPlanes);

} // namespace mote
