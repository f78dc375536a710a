#pragma once

#include "../../core/RawVector.h"
#include "../RlodTreeFile.h"
#include "RlodTreeArrays.h"

#include <cstdint>

namespace mote
{

/// Another order of a tree's nodes and clusters.
struct RlodTreeLayout
{
  RawVector<std::uint32_t> nodes;     ///< the tree's node at each place
  RawVector<std::uint32_t> clusters;  ///< likewise
  RawVector<std::uint32_t> nodePlace; ///< of each of the tree's nodes
  RawVector<std::uint32_t> clusterPlace;
  RawVector<std::uint32_t> firstTriangle; ///< of each of the tree's clusters, in the new order
};

/// The tree's order or another. Children of a node stay
/// together, and come after it; clusters are in the order of their nodes.
RlodTreeLayout layOut(const RlodTreeArrays& tree, RlodTreeFileContents::Order order);

} // namespace mote
