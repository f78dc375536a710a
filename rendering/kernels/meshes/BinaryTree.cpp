#include "detail/BinaryTree.h"

#include "detail/MortonOrder.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>

namespace mote
{

namespace
{

struct Run
{
  std::size_t begin, end;
};

/// Cuts the codes [begin, end), which agree above `bit`, where that bit and those below change,
/// until no run is longer than a treelet. Equal codes are cut by number.
void addRuns(const RawVector<std::uint64_t>& codes, Run run, int bit, std::vector<Run>& runs)
{
  if (run.end - run.begin <= treeletSize || bit < 32)
  {
    for (std::size_t i = run.begin; i < run.end; i += treeletSize)
      runs.push_back({i, std::min(run.end, i + treeletSize)});
    return;
  }
  const auto middle = static_cast<std::size_t>(
    std::partition_point(codes.begin() + static_cast<std::ptrdiff_t>(run.begin),
      codes.begin() + static_cast<std::ptrdiff_t>(run.end),
      [bit](std::uint64_t code) { return (code >> bit & 1) == 0; }) -
    codes.begin());
  addRuns(codes, {run.begin, middle}, bit - 1, runs);
  addRuns(codes, {middle, run.end}, bit - 1, runs);
}

/// The tree above treelets, whose roots it has as leaves.
class TopBuilder
{
public:
  /// Inner nodes come into the first `treelets.size()` - 1 of `nodes`.
  TopBuilder(BinaryNode* nodes, std::vector<std::uint32_t>& roots)
    : nodes_(nodes)
    , roots_(roots)
  {
  }

  std::uint32_t build() { return split(0, roots_.size(), 0); }

private:
  static constexpr int bins = 32;
  static constexpr int deepest = 40;
  static constexpr std::size_t parallelFrom = 1024;

  struct Bin
  {
    Bounds4 box;
    std::size_t count = 0;
  };

  Bounds4 boxOf(std::uint32_t node) const
  {
    Bounds4 box;
    std::copy_n(nodes_[node].lower, 3, box.lower);
    std::copy_n(nodes_[node].upper, 3, box.upper);
    return box;
  }

  /// Where roots fall into bins along an axis.
  struct Binning
  {
    int axis;
    float lower, scale;
    int of(const BinaryNode& node) const
    {
      const float bin = (node.lower[axis] + node.upper[axis] - lower) * scale;
      return std::clamp(static_cast<int>(bin), 0, bins - 1);
    }
  };

  /// The best cut along one axis; its cost in `least` where that is less.
  void tryAxis(const Binning& binning, std::size_t begin, std::size_t end, float& least,
    Binning& best, int& cut)
  {
    Bin all[bins];
    for (std::size_t i = begin; i < end; ++i)
    {
      Bin& bin = all[binning.of(nodes_[roots_[i]])];
      bin.box.add(boxOf(roots_[i]));
      ++bin.count;
    }
    float above[bins];
    Bin sum;
    for (int i = bins - 1; i > 0; --i)
    {
      sum.box.add(all[i].box);
      sum.count += all[i].count;
      above[i] = sum.box.halfArea() * static_cast<float>(sum.count);
    }
    sum = {};
    for (int i = 0; i + 1 < bins; ++i)
    {
      sum.box.add(all[i].box);
      sum.count += all[i].count;
      const float cost = sum.box.halfArea() * static_cast<float>(sum.count) + above[i + 1];
      if (sum.count > 0 && sum.count < end - begin && cost < least)
      {
        least = cost;
        best = binning;
        cut = i;
      }
    }
  }

  std::size_t partition(std::size_t begin, std::size_t end)
  {
    Bounds4 middles;
    for (std::size_t i = begin; i < end; ++i)
    {
      const BinaryNode& node = nodes_[roots_[i]];
      float middle[4] = {};
      for (int k = 0; k < 3; ++k)
        middle[k] = node.lower[k] + node.upper[k];
      middles.add(middle);
    }
    float least = 1e30f;
    Binning best{};
    int cut = -1;
    for (int axis = 0; axis < 3; ++axis)
      if (const float extent = middles.upper[axis] - middles.lower[axis]; extent > 0.0f)
        tryAxis({axis, middles.lower[axis], bins * 0.9999f / extent}, begin, end, least, best, cut);
    if (cut < 0)
      return begin + (end - begin) / 2;
    // Stable: the tree does not depend on the library.
    return static_cast<std::size_t>(
      std::stable_partition(roots_.begin() + static_cast<std::ptrdiff_t>(begin),
        roots_.begin() + static_cast<std::ptrdiff_t>(end),
        [&](std::uint32_t root) { return best.of(nodes_[root]) <= cut; }) -
      roots_.begin());
  }

  std::uint32_t split(std::size_t begin, std::size_t end, int depth)
  {
    if (end - begin == 1)
      return roots_[begin];
    const std::size_t middle = depth < deepest ? partition(begin, end) : begin + (end - begin) / 2;
    std::uint32_t left = 0, right = 0;
    const auto goLeft = [&] { left = split(begin, middle, depth + 1); };
    const auto goRight = [&] { right = split(middle, end, depth + 1); };
    if (end - begin > parallelFrom)
      tbb::parallel_invoke(goLeft, goRight);
    else
    {
      goLeft();
      goRight();
    }
    // Every cut between roots is made once: its place is the node's.
    BinaryNode& node = nodes_[middle - 1];
    Bounds4 box = boxOf(left);
    box.add(boxOf(right));
    std::copy_n(box.lower, 3, node.lower);
    std::copy_n(box.upper, 3, node.upper);
    node.left = left;
    node.right = right;
    node.join(nodes_[left], nodes_[right]);
    return static_cast<std::uint32_t>(middle - 1);
  }

  BinaryNode* nodes_;
  std::vector<std::uint32_t>& roots_;
};

/// Builds all treelets; false where `progress` said so.
bool buildTreelets(const TriangleMesh& mesh, const std::vector<Run>& runs, BinaryTree& tree,
  std::vector<std::vector<BinaryNode>>& treelets, const Progress& progress)
{
  std::atomic<std::size_t> done{0};
  std::atomic<bool> goOn{true};
  std::mutex asking;
  tbb::parallel_for(std::size_t{0}, runs.size(),
    [&](std::size_t k)
    {
      if (!goOn)
        return;
      const Run& run = runs[k];
      treelets[k] = buildTreelet(mesh, tree.order.data() + run.begin, run.end - run.begin,
        static_cast<std::uint32_t>(run.begin));
      if (const std::size_t count = ++done; progress && count % 256 == 0)
        if (const std::unique_lock lock(asking, std::try_to_lock); lock)
          if (!progress(0.2 + 0.6 * static_cast<double>(count) / static_cast<double>(runs.size())))
            goOn = false;
    });
  return goOn;
}

} // namespace

BinaryTree buildBinaryTree(const TriangleMesh& mesh, const Progress& progress)
{
  BinaryTree tree;
  if (mesh.validCount() == 0 || (progress && !progress(0.0)))
    return tree;
  std::vector<Run> runs;
  {
    const RawVector<std::uint64_t> codes = mortonOrder(mesh);
    addRuns(codes, {0, codes.size()}, 32 + mortonBits - 1, runs);
    tree.order.resize(codes.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, codes.size()),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
          tree.order[i] = static_cast<std::uint32_t>(codes[i]);
      });
  }
  if (progress && !progress(0.2))
    return {};
  std::erase_if(runs, [](const Run& run) { return run.begin == run.end; });
  std::vector<std::vector<BinaryNode>> treelets(runs.size());
  if (!buildTreelets(mesh, runs, tree, treelets, progress))
    return {};

  // First the nodes above treelets, then one treelet after another.
  std::vector<std::uint32_t> roots(treelets.size());
  std::size_t count = treelets.size() - 1;
  for (std::size_t k = 0; k < treelets.size(); ++k)
  {
    roots[k] = static_cast<std::uint32_t>(count);
    count += treelets[k].size();
  }
  tree.nodes.resize(count);
  tbb::parallel_for(std::size_t{0}, treelets.size(),
    [&](std::size_t k)
    {
      BinaryNode* to = tree.nodes.data() + roots[k];
      for (BinaryNode node : treelets[k])
      {
        if (!node.isCluster())
        {
          node.left += roots[k];
          node.right += roots[k];
        }
        *to++ = node;
      }
      treelets[k] = {};
    });
  tree.root = TopBuilder(tree.nodes.data(), roots).build();
  return tree;
}

} // namespace mote
