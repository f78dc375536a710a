#pragma once

// Queries of the hierarchy. Included where they are asked.

#include "CellCrossings.h"
#include "HexBvh.h"
#include "LeafVisits.h"

#include <algorithm>
#include <limits>
#include <memory_resource>
#include <utility>
#include <vector>

namespace mote
{

namespace detail
{

/// Nodes that a ray will enter, in order. Most come to lie near the front, so that moving a few
/// entries is faster than a heap.
class NodeQueue
{
public:
  NodeQueue() { entries_.reserve(kept); }
  void push(std::uint32_t node, double t)
  {
    entries_.push_back({t, node});
    for (std::size_t i = entries_.size() - 1; i > 0 && entries_[i - 1].t < t; --i)
      std::swap(entries_[i - 1], entries_[i]);
  }
  /// Takes the entry with the least t; false where there is none.
  bool pop(std::uint32_t& node)
  {
    if (entries_.empty())
      return false;
    node = entries_.back().node;
    entries_.pop_back();
    return true;
  }
  /// Nothing that is to come begins before.
  double least() const
  {
    return entries_.empty() ? std::numeric_limits<double>::infinity() : entries_.back().t;
  }

private:
  struct Entry
  {
    double t;
    std::uint32_t node;
  };
  static constexpr std::size_t kept = 128;
  std::array<std::byte, kept * sizeof(Entry) + 64> memory_;
  std::pmr::monotonic_buffer_resource pool_{memory_.data(), memory_.size()};
  std::pmr::vector<Entry> entries_{&pool_}; ///< the last one first
};

} // namespace detail

template <typename Space>
template <typename Counts>
std::uint32_t HexBvh<Space>::cellAt(const Vec3d& p, std::uint32_t hint, Counts&& counts) const
{
  const CrossingPoint point(p, size_);
  const auto holds = [&](std::uint32_t c)
  {
    counts.addCell();
    return point.isIn(*mesh_, c);
  };
  if (nodes_.empty() || !std::isfinite(p.x + p.y + p.z))
    return HexMesh::noCell;
  if (hint < mesh_->cellCount() && holds(hint))
    return hint;
  const Vec3d at = Space::regionCoordinates(space_.coordinates(p));
  std::array<std::byte, 512> memory;
  std::pmr::monotonic_buffer_resource pool{memory.data(), memory.size()};
  std::pmr::vector<std::uint32_t> stack{&pool};
  stack.reserve(96);
  stack.push_back(0);
  while (!stack.empty())
  {
    const Node& node = nodes_[stack.back()];
    stack.pop_back();
    counts.addNode();
    if (!node.region.contains(at))
      continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      if (holds(cells_[i]))
        return cells_[i];
    if (node.count == 0)
    {
      stack.push_back(node.first + 1);
      stack.push_back(node.first);
    }
  }
  return HexMesh::noCell;
}

template <typename Space>
template <typename Visit, typename Keep, typename Counts>
void HexBvh<Space>::forCellsAlong(
  const HexRay& ray, const Visit& visit, const Keep& keep, Counts&& counts) const
{
  if (nodes_.empty())
    return;
  const typename Space::Ray path = space_.ray(ray);
  detail::LeafVisits<Visit, std::remove_reference_t<Counts>> visits(
    *mesh_, ray, ray.tMin, visit, counts);
  detail::NodeQueue queue;
  const auto meets = [&](std::uint32_t n, double& t)
  {
    counts.addNode();
    t = ray.tMin;
    double tOut = ray.tMax;
    if ((!ranges_.empty() && !keep(ranges_[n])) || !nodes_[n].region.clip(path, t, tOut))
      return false;
    if (nodes_[n].count == 0)
      __builtin_prefetch(&nodes_[nodes_[n].first]);
    return true;
  };
  std::uint32_t n = 0;
  double t;
  bool more = meets(n, t);
  while (more)
  {
    const Node& node = nodes_[n];
    if (node.count > 0)
    {
      if (!visits.leaf(&cells_[node.first], node.count, queue.least()))
        return;
      more = queue.pop(n);
      continue;
    }
    double first, second;
    const bool hasFirst = meets(node.first, first), hasSecond = meets(node.first + 1, second);
    if (!hasFirst && !hasSecond)
    {
      more = queue.pop(n);
      continue;
    }
    const bool isSecondNext = !hasFirst || (hasSecond && second < first);
    if (hasFirst && hasSecond)
      queue.push(isSecondNext ? node.first : node.first + 1, std::max(first, second));
    const std::uint32_t nearer = isSecondNext ? node.first + 1 : node.first;
    t = isSecondNext ? second : first;
    if (t <= queue.least())
    {
      n = nearer;
      continue;
    }
    queue.push(nearer, t);
    more = queue.pop(n);
  }
  visits.finish(ray.tMax);
}

} // namespace mote
