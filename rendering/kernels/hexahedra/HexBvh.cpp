#include "HexBvh.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <numeric>

namespace mote
{

namespace
{

constexpr int binCount = 16;
constexpr std::size_t serial = 4096; ///< cells that one task does alone

/// The bounds and the number of the cells in each bin along each coordinate.
struct Bins
{
  struct Bin
  {
    SpaceBounds bounds;
    std::size_t count = 0;
  };
  std::array<std::array<Bin, binCount>, 3> of;

  void add(const Bins& other)
  {
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t b = 0; b < binCount; ++b)
      {
        of[k][b].bounds.add(other.of[k][b].bounds);
        of[k][b].count += other.of[k][b].count;
      }
  }
};

struct Split
{
  double cost = std::numeric_limits<double>::infinity();
  std::size_t axis = 0;
  int bin = 0; ///< the first one of the upper part
};

template <typename Space>
Split bestSplit(const Bins& bins)
{
  Split best;
  for (std::size_t k = 0; k < 3; ++k)
  {
    std::array<double, binCount> below{};
    SpaceBounds bounds;
    std::size_t count = 0;
    for (std::size_t b = 0; b + 1 < binCount; ++b)
    {
      bounds.add(bins.of[k][b].bounds);
      count += bins.of[k][b].count;
      below[b + 1] = count > 0 ? Space::area(bounds) * static_cast<double>(count) : -1.0;
    }
    bounds = {};
    count = 0;
    for (std::size_t b = binCount - 1; b > 0; --b)
    {
      bounds.add(bins.of[k][b].bounds);
      count += bins.of[k][b].count;
      if (count == 0 || below[b] < 0.0)
        continue;
      const double cost = below[b] + Space::area(bounds) * static_cast<double>(count);
      if (cost < best.cost)
        best = {cost, k, static_cast<int>(b)};
    }
  }
  return best;
}

/// A cell's middle along coordinate k, twice.
float middle2(const SpaceBounds& b, std::size_t k)
{
  return b.lower[k] + b.upper[k];
}

} // namespace

template <typename Space>
class HexBvh<Space>::Builder
{
public:
  Builder(const HexMesh& mesh, const Space& space, int leafSize)
    : leafSize_(static_cast<std::size_t>(std::max(1, leafSize)))
    , bounds_(mesh.cellCount())
    , cells_(mesh.cellCount())
    , nodes_(2 * mesh.cellCount() - 1)
  {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, bounds_.size(), serial),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        for (std::size_t c = range.begin(); c < range.end(); ++c)
          bounds_[c] = space.boundsOf(mesh.corners(c));
      });
    std::iota(cells_.begin(), cells_.end(), 0U);
    this->build(0, 1, 0, cells_.size());
  }

  RawVector<Node>& nodes() { return nodes_; }
  RawVector<std::uint32_t>& cells() { return cells_; }

private:
  /// Makes the node `node` of the cells from first to last; the nodes below it lie from `below` on.
  void build(std::size_t node, std::size_t below, std::size_t first, std::size_t last)
  {
    const auto [all, middles] = boundsOf(first, last);
    Node& n = nodes_[node];
    n.region = typename Space::Region(all);
    if (last - first <= leafSize_)
    {
      n.first = static_cast<std::uint32_t>(first);
      n.count = static_cast<std::uint32_t>(last - first);
      return;
    }
    const std::size_t at = divide(middles, first, last);
    n.first = static_cast<std::uint32_t>(below);
    n.count = 0;
    const std::size_t right = below + 2 * (at - first);
    const auto lower = [&] { build(below, below + 2, first, at); };
    const auto upper = [&] { build(below + 1, right, at, last); };
    if (last - first > serial)
      tbb::parallel_invoke(lower, upper);
    else
    {
      lower();
      upper();
    }
  }

  struct Bounds
  {
    SpaceBounds all, middles; ///< the second of twice the middles
    void add(const SpaceBounds& b)
    {
      all.add(b);
      SpaceBounds middle;
      for (std::size_t k = 0; k < 3; ++k)
        middle.lower[k] = middle.upper[k] = middle2(b, k);
      middles.add(middle);
    }
  };

  /// fold(sum, cell) over the cells from first to last, in parallel where they are many.
  template <typename Sum, typename Fold>
  Sum reduce(std::size_t first, std::size_t last, const Fold& fold, void (*join)(Sum&, const Sum&))
  {
    const auto some = [&](std::size_t from, std::size_t to, Sum sum)
    {
      for (std::size_t i = from; i < to; ++i)
        fold(sum, bounds_[cells_[i]]);
      return sum;
    };
    if (last - first <= 4 * serial)
      return some(first, last, {});
    return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(first, last, serial), Sum{},
      [&](const tbb::blocked_range<std::size_t>& r, const Sum& sum)
      { return some(r.begin(), r.end(), sum); },
      [&](Sum a, const Sum& b)
      {
        join(a, b);
        return a;
      });
  }

  Bounds boundsOf(std::size_t first, std::size_t last)
  {
    return reduce<Bounds>(
      first, last, [](Bounds& sum, const SpaceBounds& b) { sum.add(b); },
      [](Bounds& a, const Bounds& b)
      {
        a.all.add(b.all);
        a.middles.add(b.middles);
      });
  }

  /// Puts the lower part's cells first; gives where the upper part begins.
  std::size_t divide(const SpaceBounds& middles, std::size_t first, std::size_t last)
  {
    std::array<float, 3> scale{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const float size = middles.upper[k] - middles.lower[k];
      scale[k] = size > 0.0F ? (binCount - 1e-3F) / size : 0.0F;
    }
    const auto binOf = [&](const SpaceBounds& b, std::size_t k)
    {
      const int bin = static_cast<int>((middle2(b, k) - middles.lower[k]) * scale[k]);
      return std::clamp(bin, 0, binCount - 1);
    };
    const Bins bins = reduce<Bins>(
      first, last,
      [&](Bins& sum, const SpaceBounds& b)
      {
        for (std::size_t k = 0; k < 3; ++k)
        {
          Bins::Bin& bin = sum.of[k][static_cast<std::size_t>(binOf(b, k))];
          bin.bounds.add(b);
          ++bin.count;
        }
      },
      [](Bins& a, const Bins& b) { a.add(b); });
    const Split split = bestSplit<Space>(bins);
    if (split.cost == std::numeric_limits<double>::infinity())
      return first + (last - first) / 2; // all middles coincide
    const auto begin = cells_.begin();
    const auto at = std::partition(begin + static_cast<std::ptrdiff_t>(first),
      begin + static_cast<std::ptrdiff_t>(last),
      [&](std::uint32_t c) { return binOf(bounds_[c], split.axis) < split.bin; });
    return static_cast<std::size_t>(at - begin);
  }

  std::size_t leafSize_;
  RawVector<SpaceBounds> bounds_;
  RawVector<std::uint32_t> cells_;
  RawVector<Node> nodes_;
};

template <typename Space>
HexBvh<Space>::HexBvh(
  std::shared_ptr<const HexMesh> mesh, const Space& space, const HexBvhOptions& options)
  : mesh_(std::move(mesh))
  , space_(space)
  , size_(glm::length(mesh_->bounds().size()))
{
  if (mesh_->cellCount() == 0)
    return;
  Builder builder(*mesh_, space_, options.leafSize);
  if (options.leafSize > 1)
    compact(builder.nodes());
  nodes_.share(std::move(builder.nodes()));
  cells_.share(std::move(builder.cells()));
}

/// Larger leaves leave nodes unused.
template <typename Space>
void HexBvh<Space>::compact(RawVector<Node>& nodes)
{
  RawVector<Node> packed;
  packed.push_back(nodes[0]);
  for (std::size_t i = 0; i < packed.size(); ++i)
    if (packed[i].count == 0)
    {
      const std::uint32_t from = packed[i].first;
      packed[i].first = static_cast<std::uint32_t>(packed.size());
      packed.push_back(nodes[from]);
      packed.push_back(nodes[from + 1]);
    }
  packed.shrink_to_fit();
  nodes = std::move(packed);
}

template <typename Space>
void HexBvh<Space>::gatherWithin(const Box& box, std::vector<std::uint32_t>& cells) const
{
  if (nodes_.empty())
    return;
  const typename Space::Region region(space_.boundsOf(cornersOf(box)));
  std::vector<std::uint32_t> stack = {0};
  while (!stack.empty())
  {
    const Node& node = nodes_[stack.back()];
    stack.pop_back();
    if (!node.region.overlaps(region))
      continue;
    if (node.count == 0)
      stack.insert(stack.end(), {node.first, node.first + 1});
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      cells.push_back(cells_[i]);
  }
}

template <typename Space>
void HexBvh<Space>::setRanges(const RawVector<ScalarRange>& ofCells)
{
  ranges_.resize(nodes_.size());
  if (!nodes_.empty())
    setRangesBelow(0, ofCells, parallelLevels);
}

/// Sets the ranges of a node and all below it; of so many levels both sides at a time.
template <typename Space>
void HexBvh<Space>::setRangesBelow(
  std::uint32_t root, const RawVector<ScalarRange>& ofCells, int levels)
{
  const auto setRange = [&](std::uint32_t i)
  {
    const Node& node = nodes_[i];
    ScalarRange range;
    for (std::uint32_t k = 0; k < node.count; ++k)
      range.add(ofCells[cells_[node.first + k]]);
    if (node.count == 0)
    {
      range.add(ranges_[node.first]);
      range.add(ranges_[node.first + 1]);
    }
    ranges_[i] = range;
  };
  const std::uint32_t first = nodes_[root].first;
  if (nodes_[root].count == 0 && levels > 0)
    tbb::parallel_invoke([&] { setRangesBelow(first, ofCells, levels - 1); },
      [&] { setRangesBelow(first + 1, ofCells, levels - 1); });
  else if (nodes_[root].count == 0)
  {
    // Parents before their children, to be gone through backwards.
    std::vector<std::uint32_t> below = {first, first + 1};
    for (std::size_t i = 0; i < below.size(); ++i)
      if (const Node& node = nodes_[below[i]]; node.count == 0)
        below.insert(below.end(), {node.first, node.first + 1});
    for (std::size_t i = below.size(); i-- > 0;)
      setRange(below[i]);
  }
  setRange(root);
}

template <typename Space>
std::size_t HexBvh<Space>::bytes() const
{
  return nodes_.bytes() + cells_.bytes() + ownBytes();
}

template <typename Space>
std::size_t HexBvh<Space>::largestLeaf() const
{
  std::size_t largest = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    largest = std::max<std::size_t>(largest, nodes_[i].count);
  return largest;
}

template <typename Space>
HexStructureShape HexBvh<Space>::shape() const
{
  HexStructureShape shape;
  shape.nodes = nodes_.size();
  std::vector<std::size_t> levels(nodes_.size(), 1); // parents come before their children
  for (std::size_t i = 0; i < nodes_.size(); ++i)
  {
    const Node& node = nodes_[i];
    const double area = node.region.area();
    shape.area += area;
    shape.levels = std::max(shape.levels, levels[i]);
    if (node.count > 0)
      shape.leafArea += area;
    else
      levels[node.first] = levels[node.first + 1] = levels[i] + 1;
  }
  return shape;
}

template class HexBvh<CartesianSpace>;
template class HexBvh<CylindricalSpace>;

} // namespace mote
