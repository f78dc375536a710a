// Which particles of a PkdTree lie in ranges: decided for whole nodes wherever the least and the
// greatest of the values below them tell.

#include "PkdTree.h"

#include "detail/PkdTreeView.h"
#include "detail/StoredRanges.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace mote
{

PkdTree::ValueBounds::ValueBounds()
{
  least.fill(std::numeric_limits<float>::infinity());
  greatest.fill(-std::numeric_limits<float>::infinity());
}

void PkdTree::ValueBounds::add(const ValueBounds& b)
{
  smallest = std::min(smallest, b.smallest);
  largest = std::max(largest, b.largest);
  for (std::size_t k = 0; k < 4; ++k)
  {
    // Comparisons with NaN fail: it widens no bounds.
    least[k] = b.least[k] < least[k] ? b.least[k] : least[k];
    greatest[k] = b.greatest[k] > greatest[k] ? b.greatest[k] : greatest[k];
    hasNaN[k] |= b.hasNaN[k];
  }
}

PkdTree::ValueBounds PkdTree::boundsOfTreelet(std::size_t treelet) const
{
  const std::size_t first = treelet * treeletSize, last = std::min(count_, first + treeletSize);
  ValueBounds bounds;
  bounds.smallest = bounds.largest = radius_;
  if (ownRadii_)
  {
    bounds.smallest = bounds.largest = storedRadius(first);
    for (std::size_t slot = first; slot < last; ++slot)
    {
      bounds.smallest = std::min(bounds.smallest, storedRadius(slot));
      bounds.largest = std::max(bounds.largest, storedRadius(slot));
    }
  }
  ValueBounds one = bounds;
  if (!values_.empty())
    for (std::size_t slot = first; slot < last; ++slot)
    {
      one.least = one.greatest = values_[slot];
      for (std::size_t k = 0; k < 4; ++k)
        one.hasNaN[k] = values_[slot][k] != values_[slot][k];
      bounds.add(one);
    }
  return bounds;
}

void PkdTree::findValueBounds()
{
  valueBounds_.resize(nodes_.size());
  for (std::size_t k = 0; k < levels_.size(); ++k)
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, levels_[k].count, 16),
      [&, k](const tbb::blocked_range<std::size_t>& range)
      {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
        {
          ValueBounds bounds;
          if (k == 0)
            bounds = boundsOfTreelet(i);
          else
            for (std::size_t child = i * fanout;
                 child < std::min(levels_[k - 1].count, (i + 1) * fanout); ++child)
              bounds.add(valueBounds_[levels_[k - 1].first + child]);
          valueBounds_[levels_[k].first + i] = bounds;
        }
      });
}

/// One query: goes down from the root as far as a node lies neither inside nor outside of a range.
struct PkdTreeQuery
{
  using Node = PkdTree::Node;
  using Bits = PkdTree::Bits;

  PkdTree& tree;
  const StoredRanges& stored;

  /// Of the spheres below a node, along each axis, both ends included.
  struct Box
  {
    std::array<double, 3> lower, upper;
  };

  enum class Place
  {
    Outside,
    Inside,
    Across
  };

  /// Where the values of the limit `k` below a node are.
  Place placeOf(int k, std::size_t node, const Box& box) const
  {
    const auto value = static_cast<std::size_t>(stored.value[k]);
    double least, greatest;
    bool hasNaN = false;
    if (value < 3)
    {
      // Spheres reach beyond their centres, which may be rounded.
      least = box.lower[value];
      greatest = box.upper[value];
    }
    else
    {
      const PkdTree::ValueBounds& bounds = tree.valueBounds_[node];
      least = value == 3 ? bounds.smallest : bounds.least[value - 4];
      greatest = value == 3 ? bounds.largest : bounds.greatest[value - 4];
      hasNaN = value > 3 && bounds.hasNaN[value - 4] != 0;
    }
    if (least > stored.upper[k] || greatest < stored.lower[k])
      return Place::Outside;
    const bool in = least >= stored.lower[k] && greatest <= stored.upper[k] && !hasNaN;
    return in ? Place::Inside : Place::Across;
  }

  /// Decides what the limits `open`, a bit each, leave of a node.
  void visit(std::size_t level, std::size_t i, const Box& box, unsigned open) const
  {
    const std::size_t place = tree.levels_[level].first + i;
    for (int k = 0; k < stored.limits; ++k)
      if ((open >> k & 1) != 0)
      {
        const Place where = placeOf(k, place, box);
        if (where == Place::Outside)
          return fill(level, i, false);
        if (where == Place::Inside)
          open &= ~(1u << k);
      }
    if (open == 0)
      return fill(level, i, true);
    if (level == 0)
      return look(i, open);
    const std::size_t first = i * PkdTree::fanout;
    const std::size_t last =
      std::min<std::size_t>(tree.levels_[level - 1].count, first + PkdTree::fanout);
    const auto child = [&](std::size_t c)
    { visit(level - 1, c, childBox(tree.nodes_[place], c - first), open); };
    if (level == 1)
      for (std::size_t c = first; c < last; ++c)
        child(c);
    else
      tbb::parallel_for(first, last, child);
  }

  static Box childBox(const Node& node, std::size_t child)
  {
    Box box;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double step = stepOf(node, k);
      box.lower[k] = double(node.lower[k]) + step * node.low[k][child];
      box.upper[k] = double(node.lower[k]) + step * node.high[k][child];
    }
    return box;
  }

  /// Shows all below a node but what visibility hides, or nothing.
  void fill(std::size_t level, std::size_t i, bool all) const
  {
    const std::size_t each = std::size_t{PkdTree::fanout} << (4 * level); // buckets
    const std::size_t first = i * each, last = std::min(tree.buckets(), first + each);
    if (!all)
      std::fill(tree.shown_.begin() + static_cast<std::ptrdiff_t>(first),
        tree.shown_.begin() + static_cast<std::ptrdiff_t>(last), Bits{0});
    else
      for (std::size_t b = first; b < last; ++b)
        tree.shown_[b] = tree.visibleIn(b);
  }

  /// Looks at each particle of a treelet.
  void look(std::size_t treelet, unsigned open) const
  {
    const std::size_t first = treelet * PkdTree::fanout;
    const std::size_t last = std::min(tree.buckets(), first + PkdTree::fanout);
    const Node& node = tree.nodes_[tree.levels_[0].first + treelet];
    for (std::size_t bucket = first; bucket < last; ++bucket)
    {
      unsigned bits = tree.visibleIn(bucket);
      for (int k = 0; k < stored.limits && bits != 0; ++k)
        if ((open >> k & 1) != 0)
          bits &= within(node, bucket, k);
      tree.shown_[bucket] = static_cast<Bits>(bits);
    }
  }

  unsigned within(const Node& node, std::size_t bucket, int k) const
  {
    const int value = stored.value[k];
    const float lower = stored.lower[k], upper = stored.upper[k];
    const std::size_t first = bucket * PkdTree::bucketSize;
    const std::size_t count = std::min<std::size_t>(tree.count_ - first, PkdTree::bucketSize);
    unsigned bits = 0;
    const auto each = [&](const auto& valueOf)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        const float v = valueOf(first + i);
        bits |= static_cast<unsigned>((v >= lower) & (v <= upper)) << i;
      }
    };
    if (value > 3)
      each(
        [&](std::size_t slot) { return tree.values_[slot][static_cast<std::size_t>(value - 4)]; });
    else if (value == 3)
      each([&](std::size_t slot) { return tree.storedRadius(slot); });
    else
      each([&](std::size_t slot)
        { return node.corner[static_cast<std::size_t>(value)] + tree.place(slot)[value]; });
    return bits;
  }
};

void PkdTree::findInRange(const StoredRanges& stored)
{
  for (int k = 0; k < stored.limits; ++k)
    if (stored.value[k] > 2 && valueBounds_.empty())
      findValueBounds();
  shown_.resize(buckets());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  PkdTreeQuery::Box everywhere;
  everywhere.lower.fill(-infinity);
  everywhere.upper.fill(infinity);
  PkdTreeQuery{*this, stored}.visit(levels_.size() - 1, 0, everywhere, (1u << stored.limits) - 1);
}

std::vector<SlotRun> PkdTree::slotsBetween(int k, double low, double high) const
{
  if (k > 2 || levels_.empty())
    return StoredParticles::slotsBetween(k, low, high);
  const auto axis = static_cast<std::size_t>(k);
  const double lower = (low - origin_[k]) / unit_, upper = (high - origin_[k]) / unit_;
  std::vector<SlotRun> runs;
  const auto visit = [&](const auto& self, std::size_t level, std::size_t i) -> void
  {
    const Node& node = nodes_[levels_[level].first + i];
    const std::size_t first = i * fanout;
    const std::size_t children = level == 0 ? buckets() : levels_[level - 1].count;
    const std::size_t last = std::min<std::size_t>(children, first + fanout);
    for (std::size_t child = first; child < last; ++child)
    {
      const PkdTreeQuery::Box box = PkdTreeQuery::childBox(node, child - first);
      if (box.upper[axis] < lower || box.lower[axis] > upper)
        continue;
      if (level > 0)
        self(self, level - 1, child);
      else
        addRun(runs, child * bucketSize, std::min(count_, (child + 1) * bucketSize));
    }
  };
  visit(visit, levels_.size() - 1, 0);
  return runs;
}

} // namespace mote
