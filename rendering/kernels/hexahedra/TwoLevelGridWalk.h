#pragma once

// Queries of the two-level grid. Included where they are asked.

#include "CellCrossings.h"
#include "TwoLevelGrid.h"

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
  /// Whether the cell is new; from now on it is not.
  bool put(std::uint32_t cell)
  {
    std::uint32_t& box = cells_[cell * 0x9e3779b1U >> shift];
    const bool isNew = box != cell;
    box = cell;
    return isNew;
  }

private:
  static constexpr int shift = 26;
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

/// A ray's state while it goes through leaves. A span is told of in the leaf in which it begins:
/// the leaves' own parts of the ray follow one another without a gap, so that is one leaf.
template <typename Visit, typename Counts>
class LeafVisits
{
public:
  /// The leaves' parts begin at `begin`.
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

  /// Looks at a leaf's cells, and tells of the spans that begin in [from, to). False where `visit`
  /// wants no more.
  bool leaf(const std::uint32_t* cell, const std::uint32_t* end, double from, double to)
  {
    counts_.addNode();
    std::array<std::uint32_t, 16> cells;
    while (cell < end)
    {
      std::size_t count = 0;
      for (; cell < end && count < cells.size(); ++cell)
      {
        cells[count] = *cell;
        count += mailbox_.put(*cell) ? 1 : 0;
      }
      look(cells.data(), count, from);
    }
    return tell(from, to);
  }

private:
  /// When a span begins on the walk: before the walk does only by a rounding.
  double beginOf(const CellSpan& span) const { return std::max(span.tIn, begin_); }

  void look(const std::uint32_t* cells, std::size_t count, double from)
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

  bool tell(double from, double to)
  {
    std::size_t told = 0;
    for (const CellSpan& span : list_.spans())
    {
      const double t = beginOf(span);
      if (t >= to)
        break;
      ++told;
      if (from <= t && !visit_(span)) // not those that begin where nothing was kept
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
  Mailbox mailbox_;
  SpanBatch batch_;
  SpanList list_;
};

} // namespace detail

template <typename Space>
template <typename Counts>
std::uint32_t TwoLevelGrid<Space>::cellAt(const Vec3d& p, std::uint32_t hint, Counts&& counts) const
{
  const CrossingPoint point(p, size_);
  const auto holds = [&](std::uint32_t c)
  {
    counts.addCell();
    return point.isIn(*mesh_, c);
  };
  if (macros_.empty() || !std::isfinite(p.x + p.y + p.z))
    return HexMesh::noCell;
  if (hint < mesh_->cellCount() && holds(hint))
    return hint;
  const Vec3d at = space_.coordinates(p);
  if (!extent_.contains(Space::regionCoordinates(at)))
    return HexMesh::noCell;
  const std::array<int, 3> m = {
    top_.clampedAt(0, at.x), top_.clampedAt(1, at.y), top_.clampedAt(2, at.z)};
  const Macro& macro = macros_[static_cast<std::size_t>(top_.index(m[0], m[1], m[2]))];
  const Lattice l = macroLattice(m, macro);
  const std::size_t leaf = macro.leaf + static_cast<std::size_t>(l.index(l.clampedAt(0, at.x),
                                          l.clampedAt(1, at.y), l.clampedAt(2, at.z)));
  counts.addNode();
  for (std::uint32_t i = starts_[leaf]; i < starts_[leaf + 1]; ++i)
    if (holds(references_[i]))
      return references_[i];
  return HexMesh::noCell;
}

template <typename Space>
template <typename Visit, typename Keep, typename Counts>
void TwoLevelGrid<Space>::forCellsAlong(
  const HexRay& ray, const Visit& visit, const Keep& keep, Counts&& counts) const
{
  double tIn = ray.tMin, tOut = ray.tMax;
  const typename Space::Ray path = space_.ray(ray);
  if (macros_.empty() || !extent_.clip(path, tIn, tOut))
    return;
  detail::LeafVisits<Visit, std::remove_reference_t<Counts>> visits(
    *mesh_, ray, tIn, visit, counts);
  typename Space::Walk outer(space_, path, top_, tIn, tOut);
  do
  {
    if (outer.isOutside())
      continue;
    const auto m =
      static_cast<std::size_t>(top_.index(outer.at()[0], outer.at()[1], outer.at()[2]));
    const Macro& macro = macros_[m];
    const std::size_t last = m + 1 < macros_.size() ? macros_[m + 1].leaf : leaves();
    if (starts_[macro.leaf] == starts_[last] || (!ranges_.empty() && !keep(ranges_[m])))
      continue;
    const Lattice l = macroLattice(outer.at(), macro);
    typename Space::Walk inner(space_, path, l, outer.tIn(), outer.tOut());
    do
    {
      const std::size_t leaf =
        macro.leaf + static_cast<std::size_t>(l.index(inner.at()[0], inner.at()[1], inner.at()[2]));
      if (starts_[leaf] < starts_[leaf + 1] &&
          !visits.leaf(&references_[starts_[leaf]], &references_[0] + starts_[leaf + 1],
            inner.tIn(), inner.tOut()))
        return;
    } while (inner.next());
  } while (outer.next());
}

} // namespace mote
