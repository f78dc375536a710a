// Where nodes and clusters of an RlodTree stand in a file.

#include "detail/RlodTreeLayout.h"
#include "../core/detail/FileHeader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace mote
{

namespace
{

void addChildren(const RlodNode& parent, RawVector<std::uint32_t>& order)
{
  for (unsigned k = parent.clusters; k < parent.children; ++k)
    order.push_back(parent.nodeOf(k));
}

/// The nodes with those of the highest levels first, and in the tree's order where these are alike.
/// levelOf(k) is that of the children of node k; they are never before what is above them.
template <typename LevelOf>
RawVector<std::uint32_t> byLevel(const RlodTreeArrays& tree, const LevelOf& levelOf)
{
  struct Siblings
  {
    std::uint32_t level, parent;
  };
  std::vector<Siblings> all;
  std::vector<std::uint32_t> levels(
    tree.nodes.size(), std::numeric_limits<std::uint32_t>::max()); // of what is above
  for (std::uint32_t k = 0; k < tree.nodes.size(); ++k)            // parents come first
  {
    const RlodNode& node = tree.nodes[k];
    const std::uint32_t level = std::min<std::uint32_t>(levelOf(k), levels[k]);
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
    addChildren(tree.nodes[siblings.parent], order);
  return order;
}

/// Those first that err by more where they are taken for their triangles: what is read of them for
/// a picture that may err are those that err by a little more than it may.
RawVector<std::uint32_t> byError(const RlodTreeArrays& tree)
{
  return byLevel(tree,
    [&](std::uint32_t k)
    {
      std::uint32_t level = 0;
      for (unsigned c = tree.nodes[k].clusters; c < tree.nodes[k].children; ++c)
        level = std::max(level, tree.words[k].level(c));
      return level;
    });
}

/// Half the surface of what a node holds: how likely rays are to meet it.
float areaOf(const RlodNode& node)
{
  float size[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::uint8_t *low = node.low(axis), *high = node.high(axis);
    size[axis] =
      node.scale[axis] * static_cast<float>(*std::max_element(high, high + node.children) -
                                            *std::min_element(low, low + node.children));
  }
  return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
}

/// The likeliest nodes first, in steps of two.
RawVector<std::uint32_t> byArea(const RlodTreeArrays& tree)
{
  constexpr int most = 1 << 10;
  return byLevel(tree,
    [&](std::uint32_t k)
    {
      const float area = areaOf(tree.nodes[k]);
      return area > 0.0f ? static_cast<std::uint32_t>(most + std::ilogb(area)) : 0;
    });
}

/// Blocks that fill a page with planes, each begun with the likeliest nodes that are left and
/// filled with the likeliest below these.
RawVector<std::uint32_t> inBlocks(const RlodTreeArrays& tree)
{
  constexpr std::size_t room = FileSection::alignment / sizeof(RlodPlanes);
  using Parents = std::priority_queue<std::pair<float, std::uint32_t>>;
  Parents begins;
  begins.emplace(areaOf(tree.nodes[0]), 0);
  RawVector<std::uint32_t> order;
  order.reserve(tree.nodes.size());
  order.push_back(0);
  while (!begins.empty())
  {
    Parents block;
    block.push(begins.top());
    begins.pop();
    for (std::size_t taken = 0; !block.empty();)
    {
      const auto likeliest = block.top();
      block.pop();
      const RlodNode& parent = tree.nodes[likeliest.second];
      const std::size_t children = parent.children - parent.clusters;
      if (taken > 0 && taken + children > room)
      {
        begins.push(likeliest);
        continue;
      }
      taken += children;
      addChildren(parent, order);
      for (unsigned k = parent.clusters; k < parent.children; ++k)
        block.emplace(areaOf(tree.nodes[parent.nodeOf(k)]), parent.nodeOf(k));
    }
  }
  return order;
}

RawVector<std::uint32_t> orderOf(const RlodTreeArrays& tree, RlodTreeFileContents::Order order)
{
  using Order = RlodTreeFileContents::Order;
  switch (order)
  {
  case Order::ByError:
    return byError(tree);
  case Order::ByArea:
    return byArea(tree);
  case Order::Blocks:
    return inBlocks(tree);
  case Order::DepthFirst:
    break;
  }
  RawVector<std::uint32_t> same(tree.nodes.size());
  std::iota(same.begin(), same.end(), 0U);
  return same;
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
  layout.nodes = orderOf(tree, order);
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
