#pragma once

// Queries of the two-level grid. Included where they are asked.

#include "CellCrossings.h"
#include "LeafVisits.h"
#include "TwoLevelGrid.h"

namespace mote
{

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
      if (!visits.leaf(&starts_[leaf], &references_[0], inner.tIn(), inner.tOut()))
        return;
    } while (inner.next());
  } while (outer.next());
  visits.finish(ray.tMin);
}

} // namespace mote
