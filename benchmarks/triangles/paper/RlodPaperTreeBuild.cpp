// The kd-tree of an RlodPaperTree: Wald, Havran, "On building fast kd-trees for ray tracing, and on
// doing that in O(N log N)" (2006), with bins in place of sorted bounds where nodes are large.

#include "ClippedTriangle.h"
#include "RlodPaperTree.h"

#include <kernels/core/Error.h>
#include <kernels/core/ScratchSpace.h>

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote::bench
{

namespace
{

constexpr double stepCost = 1.0;         ///< of a node
constexpr double testCost = 0.25;        ///< of a triangle: the fastest, measured with packets
constexpr double emptyShare = 0.8;       ///< of its cost counts where a split cuts off empty space
constexpr int deepest = 60;              ///< levels
constexpr std::size_t sortedCount = 512; ///< above, bounds are not sorted but put into bins
constexpr std::size_t serialCount = 1 << 15; ///< triangles that are one task

struct Cell
{
  float low[3], high[3];
};

/// A triangle in a cell, with the extents of its part there.
struct Reference
{
  Cell box;
  std::uint32_t triangle;
};
using References = std::vector<Reference>;

struct Split
{
  int axis = -1; ///< -1: a leaf is best
  float at = 0.0f;
  bool flatBelow = false; ///< triangles in the plane go below
  double cost = 0.0;
};

/// Finds the split of a cell that costs least.
class SplitFinder
{
public:
  Split find(const References& references, const Cell& cell)
  {
    cell_ = cell;
    best_ = {};
    best_.cost = testCost * static_cast<double>(references.size());
    for (int axis = 0; axis < 3; ++axis)
    {
      enter(axis);
      if (references.size() <= sortedCount)
        trySorted(references);
      else
        tryBins(references);
    }
    return best_;
  }

private:
  static constexpr int bins = 64;

  void enter(int axis)
  {
    axis_ = axis;
    const auto side = [&](int k) { return double(cell_.high[k % 3]) - cell_.low[k % 3]; };
    face_ = side(axis + 1) * side(axis + 2);
    girth_ = side(axis + 1) + side(axis + 2);
    area_ = face_ + side(axis) * girth_;
  }

  /// A plane with so many triangles below, in and above it.
  void consider(float at, std::size_t below, std::size_t flat, std::size_t above)
  {
    if (!(at > cell_.low[axis_]) || !(at < cell_.high[axis_]) || !(area_ > 0.0))
      return;
    for (const bool flatBelow : {false, true})
    {
      const std::size_t left = below + (flatBelow ? flat : 0),
                        right = above + (flatBelow ? 0 : flat);
      const double leftArea = face_ + (double(at) - cell_.low[axis_]) * girth_;
      const double rightArea = face_ + (double(cell_.high[axis_]) - at) * girth_;
      double cost =
        stepCost +
        testCost * (leftArea * static_cast<double>(left) + rightArea * static_cast<double>(right)) /
          area_;
      if (left == 0 || right == 0)
        cost *= emptyShare;
      if (cost < best_.cost)
        best_ = {axis_, at, flatBelow, cost};
    }
  }

  /// Tries all bounds.
  void trySorted(const References& references)
  {
    lows_.clear();
    highs_.clear();
    flats_.clear();
    for (const Reference& r : references)
    {
      lows_.push_back(r.box.low[axis_]);
      highs_.push_back(r.box.high[axis_]);
      if (lows_.back() == highs_.back())
        flats_.push_back(lows_.back());
    }
    for (std::vector<float>* all : {&lows_, &highs_, &flats_})
      std::sort(all->begin(), all->end());
    const std::size_t count = references.size();
    std::size_t begun = 0, ended = 0, flat = 0;
    const auto pass = [](const std::vector<float>& all, std::size_t& place, float at)
    {
      const std::size_t before = place;
      while (place < all.size() && all[place] == at)
        ++place;
      return place - before;
    };
    while (ended < count)
    {
      const float at = begun < count ? std::min(lows_[begun], highs_[ended]) : highs_[ended];
      const std::size_t below = begun;
      pass(lows_, begun, at);
      pass(highs_, ended, at);
      consider(at, below, pass(flats_, flat, at), count - ended);
    }
  }

  /// Tries the bounds of bins that are as wide as one another, and those of all triangles.
  void tryBins(const References& references)
  {
    float low = cell_.high[axis_], high = cell_.low[axis_];
    for (const Reference& r : references)
    {
      low = std::min(low, r.box.low[axis_]);
      high = std::max(high, r.box.high[axis_]);
    }
    const std::size_t count = references.size();
    if (!(high > low))
    {
      consider(low, 0, count, 0);
      return;
    }
    const float width = (high - low) / float(bins), perWidth = float(bins) / (high - low);
    std::size_t begin[bins] = {}, end[bins] = {};
    const auto binOf = [&](float v)
    { return std::clamp(static_cast<int>((v - low) * perWidth), 0, bins - 1); };
    for (const Reference& r : references)
    {
      ++begin[binOf(r.box.low[axis_])];
      ++end[binOf(r.box.high[axis_])];
    }
    consider(low, 0, 0, count);
    std::size_t begun = 0, ended = 0;
    for (int k = 1; k < bins; ++k)
    {
      begun += begin[k - 1];
      ended += end[k - 1];
      consider(low + float(k) * width, begun, 0, count - ended);
    }
    consider(high, count, 0, 0);
  }

  Cell cell_;
  Split best_;
  int axis_ = 0;
  double face_ = 0.0, girth_ = 0.0, area_ = 0.0; ///< halves of what lies across the axis; of all
  std::vector<float> lows_, highs_, flats_;
};

/// A subtree: its root is the first node, and indices count within it.
struct Subtree
{
  std::vector<RlodPaperNode> nodes;
  std::vector<std::uint32_t> references;

  void add(const Subtree& part, std::uint32_t root)
  {
    const auto nodeShift = static_cast<std::uint32_t>(nodes.size()) - 1;
    const auto shift = static_cast<std::uint32_t>(references.size());
    for (std::size_t k = 0; k < part.nodes.size(); ++k)
    {
      RlodPaperNode node = part.nodes[k];
      node.link += (node.isLeaf() ? shift : nodeShift) << 2;
      if (k == 0)
        nodes[root] = node;
      else
        nodes.push_back(node);
    }
    references.insert(references.end(), part.references.begin(), part.references.end());
  }
};

class KdBuilder
{
public:
  explicit KdBuilder(const TriangleMesh& mesh)
    : mesh_(mesh)
  {
  }

  Subtree grow(References references, const Cell& cell, int depth) const
  {
    Subtree tree;
    tree.nodes.resize(1);
    SplitFinder finder;
    if (references.size() <= serialCount || depth == deepest)
    {
      growSerial(tree, 0, std::move(references), cell, depth, finder);
      return tree;
    }
    const Split split = finder.find(references, cell);
    if (split.axis < 0)
    {
      makeLeaf(tree, 0, references);
      return tree;
    }
    Cell cells[2];
    References sides[2];
    divide(std::move(references), cell, split, cells, sides);
    Subtree parts[2];
    tbb::parallel_invoke([&] { parts[0] = grow(std::move(sides[0]), cells[0], depth + 1); },
      [&] { parts[1] = grow(std::move(sides[1]), cells[1], depth + 1); });
    tree.nodes.resize(3);
    tree.nodes[0] = RlodPaperNode::inner(split.axis, split.at, 1);
    for (std::uint32_t k = 0; k < 2; ++k)
    {
      tree.add(parts[k], 1 + k);
      parts[k] = {};
    }
    return tree;
  }

  /// Narrows a reference to a cell; false where nothing is left.
  bool clip(Reference& reference, const Cell& cell) const
  {
    const TriangleMesh::Corners& corners = mesh_.triangles()[reference.triangle];
    const Vec3f* points = mesh_.points();
    ClippedTriangle triangle{
      Vec3d(points[corners[0]]), Vec3d(points[corners[1]]), Vec3d(points[corners[2]])};
    triangle.clip(cell.low, cell.high);
    if (triangle.count() == 0)
      return false;
    Vec3d low = triangle.point(0), high = low;
    for (int k = 1; k < triangle.count(); ++k)
    {
      low = glm::min(low, triangle.point(k));
      high = glm::max(high, triangle.point(k));
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      // Rounded outwards, and within the cell all the same, whose bounds are float.
      auto least = static_cast<float>(low[axis]), most = static_cast<float>(high[axis]);
      if (double(least) > low[axis])
        least = std::nextafter(least, -2.0f);
      if (double(most) < high[axis])
        most = std::nextafter(most, 2.0f);
      reference.box.low[axis] = std::max(least, cell.low[axis]);
      reference.box.high[axis] = std::min(most, cell.high[axis]);
    }
    return true;
  }

private:
  void growSerial(Subtree& tree, std::size_t index, References references, const Cell& cell,
    int depth, SplitFinder& finder) const
  {
    const Split split = depth < deepest ? finder.find(references, cell) : Split();
    if (split.axis < 0)
    {
      makeLeaf(tree, index, references);
      return;
    }
    Cell cells[2];
    References sides[2];
    divide(std::move(references), cell, split, cells, sides);
    const std::size_t children = tree.nodes.size();
    tree.nodes.resize(children + 2);
    tree.nodes[index] = RlodPaperNode::inner(split.axis, split.at, children);
    for (std::size_t k = 0; k < 2; ++k)
      growSerial(tree, children + k, std::move(sides[k]), cells[k], depth + 1, finder);
  }

  static void makeLeaf(Subtree& tree, std::size_t index, const References& references)
  {
    tree.nodes[index] = RlodPaperNode::leaf(tree.references.size(), references.size());
    for (const Reference& r : references)
      tree.references.push_back(r.triangle);
  }

  void divide(References references, const Cell& cell, const Split& split, Cell (&cells)[2],
    References (&sides)[2]) const
  {
    const int axis = split.axis;
    cells[0] = cells[1] = cell;
    cells[0].high[axis] = cells[1].low[axis] = split.at;
    for (const Reference& r : references)
    {
      const float low = r.box.low[axis], high = r.box.high[axis];
      if (low == split.at && high == split.at)
        sides[split.flatBelow ? 0 : 1].push_back(r);
      else if (high <= split.at)
        sides[0].push_back(r);
      else if (low >= split.at)
        sides[1].push_back(r);
      else
        for (int k = 0; k < 2; ++k)
          if (Reference part = r; clip(part, cells[k]))
            sides[k].push_back(part);
    }
  }

  const TriangleMesh& mesh_;
};

/// References to all valid triangles, and the box about them.
References referencesTo(const TriangleMesh& mesh, const KdBuilder& builder, Cell& box)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  box = {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  const Cell everything = {{-2.0f, -2.0f, -2.0f}, {2.0f, 2.0f, 2.0f}};
  References references;
  references.reserve(mesh.validCount());
  for (std::size_t i = 0; i < mesh.size(); ++i)
  {
    if (!mesh.isValid(i))
      continue;
    Reference r = {{}, static_cast<std::uint32_t>(i)};
    builder.clip(r, everything);
    for (int axis = 0; axis < 3; ++axis)
    {
      box.low[axis] = std::min(box.low[axis], r.box.low[axis]);
      box.high[axis] = std::max(box.high[axis], r.box.high[axis]);
    }
    references.push_back(r);
  }
  return references;
}

/// Room for numbers that are read from all over.
template <typename Numbers>
void makeRoom(Numbers& numbers, std::size_t size)
{
  numbers.resize(size);
  preferHugePages(numbers.data(), size * sizeof(numbers[0]));
}

/// Takes nodes as they are, and triangles in the order in which leaves first name them.
void takeTree(const Subtree& tree, const TriangleMesh& mesh, RlodPaperArrays& arrays)
{
  makeRoom(arrays.nodes, tree.nodes.size());
  std::copy(tree.nodes.begin(), tree.nodes.end(), arrays.nodes.begin());
  makeRoom(arrays.references, tree.references.size());
  makeRoom(arrays.triangles, mesh.validCount());
  arrays.ids.reserve(mesh.validCount());
  constexpr std::uint32_t unknown = ~0U;
  std::vector<std::uint32_t> placeOf(mesh.size(), unknown);
  for (std::size_t k = 0; k < tree.references.size(); ++k)
  {
    const std::uint32_t input = tree.references[k];
    if (placeOf[input] == unknown)
    {
      placeOf[input] = static_cast<std::uint32_t>(arrays.ids.size());
      const auto& [a, b, c] = mesh.triangles()[input];
      arrays.triangles[arrays.ids.size()] = {mesh.points()[a], mesh.points()[b], mesh.points()[c]};
      arrays.ids.push_back(input);
    }
    arrays.references[k] = placeOf[input];
  }
  arrays.triangles.resize(arrays.ids.size());
}

} // namespace

void RlodPaperTree::build(const TriangleMesh& mesh)
{
  arrays_ = {};
  planeNodes_.clear();
  origin_ = mesh.origin();
  unit_ = mesh.unit();
  const KdBuilder builder(mesh);
  Cell box;
  References references = referencesTo(mesh, builder, box);
  if (references.empty())
    return;
  arrays_.lower = {box.low[0], box.low[1], box.low[2]};
  arrays_.upper = {box.high[0], box.high[1], box.high[2]};
  const Subtree tree = builder.grow(std::move(references), box, 0);
  if (std::max(tree.nodes.size(), tree.references.size()) >> 30 != 0)
    throw Error("The mesh has more triangles than a kd-tree with 8 bytes a node holds.");
  takeTree(tree, mesh, arrays_);
}

} // namespace mote::bench
