// Where nodes and clusters of an RlodTree stand in a file.

#include "detail/RlodTreeLayout.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace mote
{

namespace
{

/// The nodes in an order in which those come first that err by more where they are taken for their
/// triangles; where these are alike the tree's order stays. What is read of them for a picture that
/// may err are those that err by a little more than it may.
RawVector<std::uint32_t> byError(const RlodTreeArrays& tree)
{
  struct Siblings
  {
    std::uint32_t level; ///< of the greatest error, and no more than of what is above them
    std::uint32_t parent;
  };
  std::vector<Siblings> all;
  std::vector<std::uint32_t> levels(tree.nodes.size(), RlodWords::levels);
  for (std::uint32_t k = 0; k < tree.nodes.size(); ++k) // parents come first
  {
    const RlodNode& node = tree.nodes[k];
    std::uint32_t level = 0;
    for (unsigned c = node.clusters; c < node.children; ++c)
      level = std::max(level, tree.words[k].level(c));
    level = std::min(level, levels[k]);
    for (unsigned c = node.clusters; c < node.children; ++c)
      levels[node.nodeOf(c)] = level;
    if (node.children > node.clusters)
      all.push_back({level, k});
  }
  std::stable_sort(
    all.begin(), all.end(), [](const Siblings& a, const Siblings& b) { return a.level > b.level; });
  RawVector<std::uint32_t> order;
  order.reserve(tree.nodes.size());
  order.push_back(0);
  for (const Siblings& siblings : all)
  {
    const RlodNode& parent = tree.nodes[siblings.parent];
    for (unsigned k = parent.clusters; k < parent.children; ++k)
      order.push_back(parent.nodeOf(k));
  }
  return order;
}

RawVector<std::uint32_t> placesOf(const RawVector<std::uint32_t>& order)
{
  RawVector<std::uint32_t> places(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    places[order[i]] = static_cast<std::uint32_t>(i);
  return places;
}

} // namespace

RlodTreeLayout layOut(const RlodTreeArrays& tree, RlodTreeFileContents::Order order)
{
  RlodTreeLayout layout;
  if (tree.nodes.empty())
    return layout;
  if (order == RlodTreeFileContents::Order::ByError)
    layout.nodes = byError(tree);
  else
  {
    layout.nodes.resize(tree.nodes.size());
    std::iota(layout.nodes.begin(), layout.nodes.end(), 0U);
  }
  layout.nodePlace = placesOf(layout.nodes);
  layout.clusters.reserve(tree.clusters.size());
  layout.firstTriangle.resize(tree.clusters.size());
  std::uint32_t triangles = 0;
  for (const std::uint32_t index : layout.nodes)
    for (std::uint32_t k = 0; k < tree.nodes[index].clusters; ++k)
    {
      const std::uint32_t cluster = tree.nodes[index].firstCluster + k;
      layout.clusters.push_back(cluster);
      layout.firstTriangle[cluster] = triangles;
      triangles += tree.clusters[cluster].count;
    }
  layout.clusterPlace = placesOf(layout.clusters);
  return layout;
}

} // namespace mote
