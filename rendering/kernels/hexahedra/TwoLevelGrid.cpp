#include "TwoLevelGrid.h"

#include "../core/Error.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>

namespace mote
{

namespace
{

constexpr std::size_t mostStarts = 0xffffffffU;
constexpr int mostAlong = 1024;     ///< macro cells along a coordinate
constexpr int mostWithin = 255;     ///< leaves along a coordinate of a macro cell
constexpr std::size_t block = 4096; ///< cells that a task takes

// Cells that are flat, long or lie all over one another are referred to from many steps. A grid
// becomes coarser where there would be more of these for a cell; others have a twentieth.
constexpr std::size_t macrosPerCell = 64, leavesPerCell = 512;

/// Steps along the three coordinates, about `wanted` in all; never many more, though a region is
/// flat.
std::array<int, 3> resolution(const Vec3d& sides, double wanted, int limit)
{
  const double volume = sides.x * sides.y * sides.z;
  double k = volume > 0.0 ? std::min(std::cbrt(wanted / volume), 1e30) : 0.0;
  std::array<double, 3> n;
  for (;; k *= 0.75)
  {
    for (int i = 0; i < 3; ++i)
      n[static_cast<std::size_t>(i)] =
        std::clamp(std::round(sides[i] * k), 1.0, static_cast<double>(limit));
    if (n[0] * n[1] * n[2] <= 8.0 * wanted + 8.0)
      return {static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2])};
  }
}

std::size_t sizeOf(const LatticeRange& r)
{
  std::size_t size = 1;
  for (std::size_t k = 0; k < 3; ++k)
    size *= static_cast<std::size_t>(std::max(0, r.last[k] - r.first[k] + 1));
  return size;
}

/// Calls visit(index) for the steps of a range that meets(i, j, k); the second coordinate may go
/// round.
template <typename Meets, typename Visit>
void forSteps(const Lattice& l, const LatticeRange& r, const Meets& meets, const Visit& visit)
{
  for (int k = r.first[2]; k <= r.last[2]; ++k)
    for (int up = r.first[1]; up <= r.last[1]; ++up)
      for (int i = r.first[0]; i <= r.last[0]; ++i)
        if (const int j = up < l.n[1] ? up : up - l.n[1]; meets(i, j, k))
          visit(static_cast<std::size_t>(l.index(i, j, k)));
}

/// Makes starts of counts; the last of `counts` is what the sum comes to. Throws where it is too
/// large.
void toStarts(RawVector<std::uint32_t>& counts, const char* what)
{
  std::size_t sum = 0;
  for (std::uint32_t& c : counts)
  {
    const std::size_t n = c;
    c = static_cast<std::uint32_t>(sum);
    sum += n;
    if (sum > mostStarts)
      throw Error(std::string("The grid would have more than 4294967295 ") + what +
                  "; take a smaller lambda2, or a hierarchy.");
  }
}

template <typename Work>
void forBlocks(std::size_t n, std::size_t size, const Work& work)
{
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, size),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
        work(i);
    });
}

} // namespace

template <typename Space>
TwoLevelGrid<Space>::TwoLevelGrid(
  std::shared_ptr<const HexMesh> mesh, const Space& space, const TwoLevelGridOptions& options)
  : mesh_(std::move(mesh))
  , space_(space)
  , size_(glm::length(mesh_->bounds().size()))
  , trimmed_(options.trimmed)
{
  if (mesh_->cellCount() == 0)
    return;
  RawVector<SpaceBounds> bounds(mesh_->cellCount());
  forBlocks(
    bounds.size(), block, [&](std::size_t c) { bounds[c] = space_.boundsOf(mesh_->corners(c)); });
  layOutMacros(bounds, options.lambda1);
  listMacros(bounds);
  layOutLeaves(options.lambda2);
  fillLeaves(bounds);
}

template <typename Space>
void TwoLevelGrid<Space>::layOutMacros(const RawVector<SpaceBounds>& bounds, double lambda)
{
  SpaceBounds extent;
  for (const SpaceBounds& b : bounds)
    extent.add(b);
  if (Space::wraps) // of a part of a circle there are as many steps as of the whole
  {
    const double turn = 6.283185307179586;
    lambda *= turn / std::min<double>(turn, extent.upper[1] - extent.lower[1]);
    extent.lower[1] = 0.0F;
    extent.upper[1] = static_cast<float>(turn);
  }
  extent_ = typename Space::Region(extent);
  const auto cells = static_cast<double>(bounds.size());
  double wanted = std::min(lambda, static_cast<double>(macrosPerCell)) * cells;
  do
  {
    std::array<int, 3> n = resolution(Space::sides(extent.from(), extent.to()), wanted, mostAlong);
    if (n[1] > 1)
      n[1] = std::max(n[1], Space::leastAround);
    top_ = Space::lattice(extent, n);
    wanted *= 0.5;
  } while (top_.size() > 1 && countReferences(bounds) > macrosPerCell * bounds.size());
  macros_.resize(static_cast<std::size_t>(top_.size()));
}

/// From how many macro cells the cells' bounds are met.
template <typename Space>
std::size_t TwoLevelGrid<Space>::countReferences(const RawVector<SpaceBounds>& bounds) const
{
  return tbb::parallel_reduce(
    tbb::blocked_range<std::size_t>(0, bounds.size(), block), std::size_t{0},
    [&](const tbb::blocked_range<std::size_t>& range, std::size_t sum)
    {
      for (std::size_t c = range.begin(); c < range.end(); ++c)
        sum += sizeOf(Space::overlap(top_, bounds[c]));
      return sum;
    },
    std::plus<>());
}

/// Calls visit(index) for the steps, of those in a range, that a cell is referred to from.
template <typename Space>
template <typename Visit>
void TwoLevelGrid<Space>::forCellSteps(std::size_t cell, const Lattice& lattice,
  const typename Space::Steps& steps, const LatticeRange& range, const Visit& visit) const
{
  if (!trimmed_ || range.isOne())
  {
    forSteps(
      lattice, range, [](int, int, int) { return true; }, visit);
    return;
  }
  const CellOutline outline = space_.outlineOf(mesh_->corners(cell));
  forSteps(
    lattice, range,
    [&](int i, int j, int k)
    {
      return steps.meets(outline.slabs[0], i, j, k) && steps.meets(outline.slabs[1], i, j, k) &&
             steps.meets(outline.slabs[2], i, j, k);
    },
    visit);
}

template <typename Space>
void TwoLevelGrid<Space>::listMacros(const RawVector<SpaceBounds>& bounds)
{
  const std::size_t n = macros_.size();
  std::vector<std::atomic<std::uint32_t>> counters(n);
  const typename Space::Steps steps(top_);
  const auto forMacros = [&](std::size_t c, const auto& visit)
  { forCellSteps(c, top_, steps, Space::overlap(top_, bounds[c]), visit); };
  forBlocks(bounds.size(), block,
    [&](std::size_t c)
    { forMacros(c, [&](std::size_t m) { counters[m].fetch_add(1, std::memory_order_relaxed); }); });
  lists_.starts.resize(n + 1);
  for (std::size_t m = 0; m < n; ++m)
    lists_.starts[m] = counters[m].load(std::memory_order_relaxed);
  lists_.starts[n] = 0;
  toStarts(lists_.starts, "references");
  for (std::size_t m = 0; m < n; ++m)
    counters[m].store(lists_.starts[m], std::memory_order_relaxed);
  lists_.cells.resize(lists_.starts[n]);
  forBlocks(bounds.size(), block,
    [&](std::size_t c)
    {
      forMacros(c,
        [&](std::size_t m)
        {
          lists_.cells[counters[m].fetch_add(1, std::memory_order_relaxed)] =
            static_cast<std::uint32_t>(c);
        });
    });
  // Threads filled the lists in any order.
  forBlocks(n, 16,
    [&](std::size_t m)
    {
      const auto begin = lists_.cells.begin();
      std::sort(begin + lists_.starts[m], begin + lists_.starts[m + 1]);
    });
}

template <typename Space>
void TwoLevelGrid<Space>::layOutLeaves(double lambda)
{
  std::size_t leaves = 0;
  for (int k = 0; k < top_.n[2]; ++k)
    for (int j = 0; j < top_.n[1]; ++j)
      for (int i = 0; i < top_.n[0]; ++i)
      {
        const auto m = static_cast<std::size_t>(top_.index(i, j, k));
        const Vec3d lower = top_.lower + Vec3d(i, j, k) * top_.step;
        const double wanted = lambda * (lists_.starts[m + 1] - lists_.starts[m]);
        const auto n = resolution(Space::sides(lower, lower + top_.step), wanted, mostWithin);
        macros_[m].leaf = static_cast<std::uint32_t>(leaves);
        for (std::size_t a = 0; a < 3; ++a)
          macros_[m].n[a] = static_cast<std::uint8_t>(n[a]);
        leaves += static_cast<std::size_t>(n[0]) * n[1] * n[2];
        if (leaves >= mostStarts)
          throw Error("The grid would have more than 4294967294 leaves; take a smaller lambda2.");
      }
  starts_.resize(leaves + 1);
}

/// Calls visit(leaf, cell) for the references from a macro cell's leaves; false, and then some are
/// missing, where there are more than `most`.
template <typename Space>
template <typename Visit>
bool TwoLevelGrid<Space>::forLeaves(
  std::size_t m, const RawVector<SpaceBounds>& bounds, std::size_t most, const Visit& visit) const
{
  const int i = static_cast<int>(m);
  const Lattice l =
    macroLattice({i % top_.n[0], i / top_.n[0] % top_.n[1], i / top_.n[0] / top_.n[1]}, macros_[m]);
  const typename Space::Steps steps(l);
  std::size_t references = 0;
  for (std::uint32_t at = lists_.starts[m]; at < lists_.starts[m + 1]; ++at)
  {
    const std::uint32_t c = lists_.cells[at];
    const LatticeRange range = Space::overlapWithin(l, bounds[c]);
    references += sizeOf(range);
    if (references > most)
      return false;
    forCellSteps(c, l, steps, range, [&](std::size_t leaf) { visit(macros_[m].leaf + leaf, c); });
  }
  return true;
}

/// Counts the references from a macro cell's leaves into starts_. Where there are too many it uses
/// fewer of its leaves.
template <typename Space>
void TwoLevelGrid<Space>::countLeaves(std::size_t m, const RawVector<SpaceBounds>& bounds)
{
  Macro& macro = macros_[m];
  const double share = (lists_.starts[m + 1] - lists_.starts[m]) / double(lists_.cells.size());
  const std::size_t least = lists_.starts[m + 1] - lists_.starts[m]; // with a single leaf
  const auto most = least + static_cast<std::size_t>(share * double(leavesPerCell * bounds.size()));
  const auto count = [&](std::size_t leaf, std::uint32_t) { ++starts_[leaf]; };
  while (!forLeaves(m, bounds, most, count))
  {
    std::fill_n(
      starts_.begin() + macro.leaf, std::size_t{macro.n[0]} * macro.n[1] * macro.n[2], 0U);
    auto& longest = *std::max_element(macro.n.begin(), macro.n.end());
    longest = static_cast<std::uint8_t>((longest + 1) / 2);
  }
}

template <typename Space>
void TwoLevelGrid<Space>::fillLeaves(const RawVector<SpaceBounds>& bounds)
{
  // A macro cell's leaves are counted, and filled, by one task.
  std::fill(starts_.begin(), starts_.end(), 0U);
  forBlocks(macros_.size(), 16, [&](std::size_t m) { countLeaves(m, bounds); });
  toStarts(starts_, "references");
  references_.resize(starts_.back());
  forBlocks(macros_.size(), 16,
    [&](std::size_t m)
    {
      forLeaves(m, bounds, mostStarts,
        [&](std::size_t leaf, std::uint32_t c) { references_[starts_[leaf]++] = c; });
    });
  // Each start is now the next one's.
  std::copy_backward(starts_.begin(), starts_.end() - 1, starts_.end());
  starts_[0] = 0;
}

template <typename Space>
void TwoLevelGrid<Space>::gatherWithin(const Box& box, std::vector<std::uint32_t>& cells) const
{
  if (macros_.empty())
    return;
  const SpaceBounds bounds = space_.boundsOf(cornersOf(box));
  const auto always = [](int, int, int) { return true; };
  const auto append = [&cells](const RawVector<std::uint32_t>& from, std::size_t i, std::size_t end)
  { cells.insert(cells.end(), from.begin() + i, from.begin() + end); };
  forSteps(top_, Space::overlap(top_, bounds), always,
    [&](std::size_t m)
    {
      const int i = static_cast<int>(m);
      const Lattice l = macroLattice(
        {i % top_.n[0], i / top_.n[0] % top_.n[1], i / top_.n[0] / top_.n[1]}, macros_[m]);
      const LatticeRange range = Space::overlapWithin(l, bounds);
      // A macro cell that is wanted as a whole has a list without repetitions.
      if (range.first == std::array<int, 3>{} && range.last[0] == l.n[0] - 1 &&
          range.last[1] == l.n[1] - 1 && range.last[2] == l.n[2] - 1)
        append(lists_.cells, lists_.starts[m], lists_.starts[m + 1]);
      else
        forSteps(l, range, always,
          [&](std::size_t step)
          {
            const std::size_t leaf = macros_[m].leaf + step;
            append(references_, starts_[leaf], starts_[leaf + 1]);
          });
    });
}

template <typename Space>
void TwoLevelGrid<Space>::setRanges(const RawVector<ScalarRange>& ofCells)
{
  ranges_.resize(macros_.size());
  forBlocks(macros_.size(), 16,
    [&](std::size_t m)
    {
      ScalarRange range;
      for (std::uint32_t at = lists_.starts[m]; at < lists_.starts[m + 1]; ++at)
        range.add(ofCells[lists_.cells[at]]);
      ranges_[m] = range;
    });
}

template <typename Space>
std::size_t TwoLevelGrid<Space>::bytes() const
{
  return macros_.capacity() * sizeof(Macro) +
         (lists_.starts.capacity() + lists_.cells.capacity()) * sizeof(std::uint32_t) +
         starts_.capacity() * sizeof(std::uint32_t) +
         references_.capacity() * sizeof(std::uint32_t) + ranges_.capacity() * sizeof(ScalarRange);
}

template <typename Space>
std::size_t TwoLevelGrid<Space>::largestLeaf() const
{
  std::size_t largest = 0;
  for (std::size_t i = 0; i < leaves(); ++i)
    largest = std::max<std::size_t>(largest, starts_[i + 1] - starts_[i]);
  return largest;
}

template <typename Space>
HexStructureShape TwoLevelGrid<Space>::shape() const
{
  if (macros_.empty())
    return {};
  return {macros_.size() + leaves(), 2};
}

template class TwoLevelGrid<CartesianSpace>;
template class TwoLevelGrid<CylindricalSpace>;

} // namespace mote
