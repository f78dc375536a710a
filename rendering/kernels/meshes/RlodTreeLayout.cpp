// Where nodes and clusters of an RlodTree stand in a file.
//
// Source: Yoon, Lauterbach, Manocha, "R-LODs: Fast LOD-based Ray Tracing of Massive Models" (2006),
// section 5, which takes the ratio of areas for the probability that a ray goes on to a child.

#include "detail/RlodTreeLayout.h"

#include "../core/detail/FileHeader.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace mote
{

namespace
{

constexpr std::size_t nodesAPage = FileSection::alignment / sizeof(RlodNode);

/// The children of a node that are nodes, which stand together.
struct Siblings
{
  float likelihood; ///< that a ray meets their parent, times a number that all share
  std::uint32_t parent;

  bool operator<(const Siblings& s) const { return likelihood < s.likelihood; }
};

float areaOf(const RlodNode& node)
{
  const float* s = node.scale;
  return s[0] * s[1] + s[1] * s[2] + s[2] * s[0];
}

/// Puts nodes in the order of pages.
class PageFiller
{
public:
  explicit PageFiller(const RlodTreeArrays& tree)
    : tree_(tree)
  {
    order_.reserve(tree.nodes.size());
    order_.push_back(0);
    this->wait(0, waiting_);
  }

  RawVector<std::uint32_t> fill()
  {
    while (!waiting_.empty())
    {
      const Siblings first = waiting_.back();
      waiting_.pop_back();
      this->goOn(first);
    }
    return std::move(order_);
  }

private:
  std::size_t room() const { return nodesAPage - order_.size() % nodesAPage; }

  std::size_t countOf(const Siblings& s) const
  {
    const RlodNode& parent = tree_.nodes[s.parent];
    return parent.children - parent.clusters;
  }

  template <typename List>
  void wait(std::uint32_t node, List& list) const
  {
    const RlodNode& n = tree_.nodes[node];
    if (n.children > n.clusters)
      list.push_back({areaOf(n), node});
  }

  /// Fills what is left of a page with what is below these, which go where they can.
  void goOn(const Siblings& first)
  {
    std::vector<Siblings> below = {first}; // a heap
    for (bool begins = true; !below.empty() && (begins || this->countOf(below.front()) <= room());
         begins = false)
    {
      std::pop_heap(below.begin(), below.end());
      const RlodNode& parent = tree_.nodes[below.back().parent];
      below.pop_back();
      for (unsigned k = parent.clusters; k < parent.children; ++k)
      {
        order_.push_back(parent.nodeOf(k));
        const std::size_t before = below.size();
        this->wait(parent.nodeOf(k), below);
        if (below.size() > before)
          std::push_heap(below.begin(), below.end());
      }
    }
    std::sort_heap(below.begin(), below.end()); // the likeliest last, and next
    waiting_.insert(waiting_.end(), below.begin(), below.end());
  }

  const RlodTreeArrays& tree_;
  RawVector<std::uint32_t> order_;
  std::vector<Siblings> waiting_; ///< a stack, so that what lies together stays together
};

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
  if (order == RlodTreeFileContents::Order::ByPages)
    layout.nodes = PageFiller(tree).fill();
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
