#pragma once

// Queries of the hierarchy. Included where they are asked.

#include "CellCrossings.h"
#include "HexBvh.h"

#include <algorithm>
#include <memory_resource>
#include <utility>
#include <vector>

namespace mote
{

namespace detail
{

/// Nodes that a ray will enter and spans that it will pass, the one with the least t on top.
class WalkQueue
{
public:
  struct Entry
  {
    double t;
    double tOut; ///< of a span
    std::uint32_t id;
    bool isSpan;
    std::uint8_t inFace, outFace; ///< of a span
  };

  /// Of equal t, nodes come first, as they may hold spans with that t, and then the lower numbers.
  static bool isLater(const Entry& a, const Entry& b)
  {
    if (a.t != b.t)
      return a.t > b.t;
    return a.isSpan != b.isSpan ? a.isSpan : a.id > b.id;
  }

  WalkQueue() { heap_.reserve(kept); }
  void push(const Entry& entry)
  {
    heap_.push_back(entry);
    std::push_heap(heap_.begin(), heap_.end(), isLater);
  }
  /// Whether the entry comes before all others, and need not be put among them.
  bool isNext(const Entry& entry) const { return heap_.empty() || isLater(heap_.front(), entry); }
  /// Takes the entry with the least t; false where there is none.
  bool next(Entry& entry)
  {
    if (heap_.empty())
      return false;
    std::pop_heap(heap_.begin(), heap_.end(), isLater);
    entry = heap_.back();
    heap_.pop_back();
    return true;
  }

private:
  static constexpr std::size_t kept = 128;
  std::array<std::byte, kept * sizeof(Entry) + 64> memory_;
  std::pmr::monotonic_buffer_resource pool_{memory_.data(), memory_.size()};
  std::pmr::vector<Entry> heap_{&pool_};
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
  const CrossingLine line(ray.origin, ray.direction);
  detail::WalkQueue queue;
  using Entry = detail::WalkQueue::Entry;
  const auto meets = [&](std::uint32_t n, Entry& entry)
  {
    counts.addNode();
    entry = {ray.tMin, ray.tMax, n, false, noFace, noFace};
    return (ranges_.empty() || keep(ranges_[n])) &&
           nodes_[n].region.clip(path, entry.t, entry.tOut);
  };
  SpanBatch batch;
  /// Tests a leaf's cells.
  const auto open = [&](const Node& leaf)
  {
    for (std::uint32_t done = 0; done < leaf.count;)
    {
      batch.clear();
      done += static_cast<std::uint32_t>(line.addSpans(
        *mesh_, &cells_[leaf.first + done], leaf.count - done, ray.tMin, ray.tMax, batch));
      for (const CellSpan& s : batch)
        queue.push({s.tIn, s.tOut, s.cell, true, s.inFace, s.outFace});
    }
    for (std::uint32_t i = 0; i < leaf.count; ++i)
      counts.addCell();
  };
  Entry entry;
  bool more = meets(0, entry);
  while (more)
  {
    if (entry.isSpan)
    {
      if (!visit(CellSpan{entry.id, entry.t, entry.tOut, entry.inFace, entry.outFace}))
        return;
    }
    else if (const Node& node = nodes_[entry.id]; node.count > 0)
      open(node);
    else
    {
      Entry first, second;
      const bool hasFirst = meets(node.first, first), hasSecond = meets(node.first + 1, second);
      if (hasFirst && hasSecond)
      {
        if (detail::WalkQueue::isLater(first, second))
          std::swap(first, second);
        queue.push(second);
      }
      if (hasFirst || hasSecond)
      {
        entry = hasFirst || !hasSecond ? first : second;
        if (queue.isNext(entry))
          continue;
        queue.push(entry);
      }
    }
    more = queue.next(entry);
  }
}

} // namespace mote
