#pragma once

// How a ray visits leaves. Only for TwoLevelGridWalk.h and HexBvhWalk.h.

#include "CellCrossings.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory_resource>
#include <vector>

namespace mote
{

namespace detail
{

/// The cells that a ray has looked at, as far as they are remembered: forgetting costs a test.
class Mailbox
{
public:
  Mailbox() { cells_.fill(HexMesh::noCell); }
  bool has(std::uint32_t cell) const { return cells_[box(cell)] == cell; }
  /// Whether the cell is new; from now on it is not.
  bool put(std::uint32_t cell)
  {
    const bool isNew = !has(cell);
    cells_[box(cell)] = cell;
    return isNew;
  }

private:
  static constexpr int shift = 24;
  static std::uint32_t box(std::uint32_t cell) { return cell * 0x9e3779b1U >> shift; }
  std::array<std::uint32_t, (1U << (32 - shift))> cells_;
};

/// Spans that a ray will enter, ordered by tIn and then by cell, each of them once.
class SpanList
{
public:
  SpanList() { spans_.reserve(kept); }

  void add(const CellSpan& span)
  {
    std::size_t at = spans_.size();
    while (at > 0 && isBefore(span, spans_[at - 1]))
      --at;
    if (at > 0 && !isBefore(spans_[at - 1], span))
      return;
    spans_.insert(spans_.begin() + static_cast<std::ptrdiff_t>(at), span);
  }
  const auto& spans() const { return spans_; }
  void dropFirst(std::size_t count)
  {
    spans_.erase(spans_.begin(), spans_.begin() + static_cast<std::ptrdiff_t>(count));
  }

private:
  static constexpr std::size_t kept = 32;
  static bool isBefore(const CellSpan& a, const CellSpan& b)
  {
    return a.tIn != b.tIn ? a.tIn < b.tIn : a.cell < b.cell;
  }

  std::array<std::byte, kept * sizeof(CellSpan) + 64> memory_;
  std::pmr::monotonic_buffer_resource pool_{memory_.data(), memory_.size()};
  std::pmr::vector<CellSpan> spans_{&pool_};
};

/// A ray's state while it goes through leaves: those of a grid, in which its parts follow one
/// another without a gap, and in one of which a span begins and is told of; or those of a
/// hierarchy, in the order in which it enters them.
///
/// A leaf is looked at some steps after the ray has come to it. Meanwhile what it refers to is on
/// its way from memory, one thing after another: where its references are, they, the cells'
/// corners, the points. In large meshes waiting for them would take most of the time.
template <typename Visit, typename Counts>
class LeafVisits
{
public:
  /// The parts begin at `begin`.
  LeafVisits(
    const HexMesh& mesh, const HexRay& ray, double begin, const Visit& visit, Counts& counts)
    : mesh_(mesh)
    , ray_(ray)
    , begin_(begin)
    , line_(ray.origin, ray.direction)
    , visit_(visit)
    , counts_(counts)
  {
  }

  /// The ray comes to the leaf of a grid with references[starts[0]] up to references[starts[1] -
  /// 1], and is in it from `from` to `to`. Tells of the spans that begin in the leaf that it came
  /// to some steps before; false where `visit` wants no more.
  bool leaf(const std::uint32_t* starts, const std::uint32_t* references, double from, double to)
  {
    __builtin_prefetch(starts);
    return step({starts, references, references, from, to});
  }
  /// The ray comes to the leaf of a hierarchy. No leaf that it comes to later has spans that begin
  /// before `t`; up to there it tells of those of a leaf before this one, as above.
  bool leaf(const std::uint32_t* first, std::uint32_t count, double t)
  {
    __builtin_prefetch(first);
    return step({nullptr, first, first + count, -never, t});
  }
  /// Tells of the last leaves' spans, and of what else begins before `t`.
  void finish(double t)
  {
    for (int i = 0; i < stages; ++i)
      if (!step({}))
        return;
    tell({nullptr, nullptr, nullptr, -never, t});
  }

private:
  static constexpr double never = std::numeric_limits<double>::infinity();
  static constexpr int stages = 4;
  struct Leaf
  {
    const std::uint32_t* starts = nullptr; ///< of the references, while they are not known
    const std::uint32_t *first = nullptr, *last = nullptr; ///< references
    double from = 0.0, to = 0.0;
  };

  /// Each leaf under way comes a step further.
  bool step(const Leaf& leaf)
  {
    const auto behind = [&](int count) -> Leaf&
    { return leaves_[(came_ - static_cast<unsigned>(count)) % leaves_.size()]; };
    ++came_;
    behind(0) = leaf;
    find(behind(1));
    fetchCells(behind(2));
    fetchPoints(behind(3));
    const Leaf& now = behind(4);
    return now.first == now.last || (look(now), tell(now));
  }

  static void find(Leaf& leaf)
  {
    if (leaf.starts == nullptr)
      return;
    leaf.last = leaf.first + leaf.starts[1];
    leaf.first += leaf.starts[0];
    __builtin_prefetch(leaf.first);
  }
  void fetchCells(const Leaf& leaf) const
  {
    for (const std::uint32_t* cell = leaf.first; cell < leaf.last; ++cell)
      __builtin_prefetch(&mesh_.cell(*cell));
  }
  void fetchPoints(const Leaf& leaf) const
  {
    for (const std::uint32_t* cell = leaf.first; cell < leaf.last; ++cell)
      if (!mailbox_.has(*cell))
        for (const std::uint32_t point : mesh_.cell(*cell))
          __builtin_prefetch(&mesh_.point(point));
  }

  /// When a span begins on the walk: before the walk does only by a rounding.
  double beginOf(const CellSpan& span) const { return std::max(span.tIn, begin_); }

  /// Finds the spans of the cells that are new.
  void look(const Leaf& leaf)
  {
    if (leaf.starts != nullptr)
      counts_.addNode();
    std::array<std::uint32_t, 16> cells;
    for (const std::uint32_t* cell = leaf.first; cell < leaf.last;)
    {
      std::size_t count = 0;
      for (; cell < leaf.last && count < cells.size(); ++cell)
      {
        cells[count] = *cell;
        count += mailbox_.put(*cell) ? 1 : 0;
      }
      test(cells.data(), count, leaf.from);
    }
  }

  void test(const std::uint32_t* cells, std::size_t count, double from)
  {
    for (std::size_t done = 0; done < count;)
    {
      batch_.clear();
      done += line_.addSpans(mesh_, cells + done, count - done, ray_.tMin, ray_.tMax, batch_);
      for (const CellSpan& span : batch_)
        if (from <= beginOf(span))
          list_.add(span);
    }
    for (std::size_t i = 0; i < count; ++i)
      counts_.addCell();
  }

  bool tell(const Leaf& leaf)
  {
    std::size_t told = 0;
    for (const CellSpan& span : list_.spans())
    {
      const double t = beginOf(span);
      if (t >= leaf.to)
        break;
      ++told;
      if (leaf.from <= t && !visit_(span)) // not those that begin where nothing was kept
        return false;
    }
    list_.dropFirst(told);
    return true;
  }

  const HexMesh& mesh_;
  const HexRay& ray_;
  const double begin_;
  const CrossingLine line_;
  const Visit& visit_;
  Counts& counts_;
  std::array<Leaf, 8> leaves_; ///< the last ones that the ray came to
  unsigned came_ = stages;
  Mailbox mailbox_;
  SpanBatch batch_;
  SpanList list_;
};

} // namespace detail

} // namespace mote
