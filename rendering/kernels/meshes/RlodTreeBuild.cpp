// Making the nodes of an RlodTree: a binary tree becomes one of 16 children a node. Boxes and
// clusters are filled in afterwards, as they are when points have moved.

#include "RlodTree.h"

#include "../core/Error.h"
#include "detail/BinaryTree.h"
#include "detail/RlodTreeArrays.h"

#include <algorithm>

namespace mote
{

namespace
{

constexpr int fanout = RlodNode::fanout;

/// What the children of a wide node are: nodes of the binary tree.
struct Children
{
  std::uint32_t node[fanout];
  int count = 0;
  int clusters = 0; ///< of them, which come first
};

/// Opens nodes of the binary tree from `top` on until there are 16. Where all clusters below are
/// 16 at most they become the children. Else nodes with more clusters than that are opened, those
/// with the largest area first: so the nodes at the bottom are as full as they can be.
Children childrenOf(const BinaryTree& tree, std::uint32_t top)
{
  Children all;
  all.node[all.count++] = top;
  const bool atBottom = tree.nodes[top].clusters <= fanout;
  while (all.count < fanout)
  {
    int largest = -1;
    float most = -1.0f;
    for (int k = 0; k < all.count; ++k)
    {
      const BinaryNode& node = tree.nodes[all.node[k]];
      const bool opens = !node.isCluster() && (atBottom || node.clusters > fanout);
      if (opens && node.halfArea() > most)
      {
        most = node.halfArea();
        largest = k;
      }
    }
    if (largest < 0)
      break;
    const BinaryNode& node = tree.nodes[all.node[largest]];
    all.node[largest] = node.left;
    all.node[all.count++] = node.right;
  }
  const auto* firstNode = std::stable_partition(all.node, all.node + all.count,
    [&](std::uint32_t node) { return tree.nodes[node].isCluster(); });
  all.clusters = static_cast<int>(firstNode - all.node);
  return all;
}

struct Task
{
  std::uint32_t binary, wide;
  int depth;
};

} // namespace

void RlodTree::build(const TriangleMesh& mesh, const Progress& progress)
{
  clear();
  BinaryTree tree = buildBinaryTree(mesh, progress);
  if (tree.nodes.empty())
    return;
  const std::size_t clusters = tree.nodes[tree.root].clusters;
  if (clusters >= RlodNode::mostIndices)
    throw Error("The mesh has more triangles than a tree holds: about 1500 million.");
  RlodTreeArrays& a = *arrays_;
  a.clusters.resize(clusters);
  RawVector<RlodNode> nodes;
  nodes.reserve(clusters / 8 + 16);

  std::uint32_t nextCluster = 0;
  nodes.resize(1);
  std::vector<Task> tasks = {{tree.root, 0, 1}};
  while (!tasks.empty())
  {
    const Task task = tasks.back();
    tasks.pop_back();
    depth_ = std::max(depth_, task.depth);
    const Children children = childrenOf(tree, task.binary);
    const auto firstNode = static_cast<std::uint32_t>(nodes.size());
    nodes.resize(firstNode + static_cast<std::size_t>(children.count - children.clusters));
    RlodNode& node = nodes[task.wide];
    node.firstNode = firstNode;
    node.children = static_cast<std::uint32_t>(children.count);
    node.firstCluster = nextCluster;
    node.clusters = static_cast<std::uint32_t>(children.clusters);
    for (int k = 0; k < children.clusters; ++k)
    {
      TriangleCluster& cluster = a.clusters.own()[nextCluster++];
      const BinaryNode& from = tree.nodes[children.node[k]];
      cluster.firstId = from.left;
      cluster.count = static_cast<std::uint8_t>(from.right);
    }
    // The first child is done next, so that its nodes lie next to it.
    for (int k = children.count - 1; k >= children.clusters; --k)
      tasks.push_back({children.node[k],
        firstNode + static_cast<std::uint32_t>(k - children.clusters), task.depth + 1});
  }
  a.nodes.take(std::move(nodes));
  a.triangles = tree.order.size();
  a.ids.take(std::move(tree.order));
  tree = {};
  fill(mesh);
  if (progress && !progress(1.0))
    clear();
}

} // namespace mote
