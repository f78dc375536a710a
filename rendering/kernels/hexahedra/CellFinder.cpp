#include "detail/CellFinder.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mote
{

namespace
{

/// More than these are seldom met by a square of 256 pixels, and to look at them all would take
/// longer than to ask the structure.
constexpr std::size_t mostFound = 4096, mostCandidates = 512;

/// Latest cells to keep where the structure is asked.
constexpr std::size_t kept = 12;

/// How far outside a cell, in its own coordinates, a point of its faces may be found by rounding.
constexpr double ofRounding = 1e-9;

} // namespace

void CellFinder::add(std::uint32_t cell, const HexCorners& corners)
{
  const Box box = boundsOf(corners);
  for (int axis = 0; axis < 3; ++axis)
  {
    // Rounded outwards, by twice what float may err.
    const double low = box.lower[axis] - middle_[axis], high = box.upper[axis] - middle_[axis];
    lower_[axis].push_back(static_cast<float>(low - 1.2e-7 * std::abs(low)));
    upper_[axis].push_back(static_cast<float>(high + 1.2e-7 * std::abs(high)));
  }
  candidates_.push_back({cell, TrilinearCell(corners)});
}

/// Forgets all candidates; others come from this box.
void CellFinder::clear(const Box& box)
{
  candidates_.clear();
  for (int axis = 0; axis < 3; ++axis)
  {
    lower_[axis].clear();
    upper_[axis].clear();
  }
  last_ = 0;
  middle_ = box.center();
}

void CellFinder::gather(const Box& box, const std::function<bool(const HexCorners&)>& mayHold)
{
  clear(box);
  found_.clear();
  withStructure(
    structure_, [&](const auto& s) { s.gatherWithin(box.expanded(1e-9 * size_), found_); });
  std::sort(found_.begin(), found_.end());
  found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
  isGathered_ = found_.size() <= mostFound;
  for (std::size_t i = 0; isGathered_ && i < found_.size(); ++i)
  {
    const HexCorners corners = mesh_.corners(found_[i]);
    const Box own = boundsOf(corners);
    if (glm::any(glm::lessThan(own.upper, box.lower)) ||
        glm::any(glm::greaterThan(own.lower, box.upper)) || !mayHold(corners) ||
        !isShown_(found_[i]))
      continue;
    add(found_[i], corners);
    isGathered_ = candidates_.size() <= mostCandidates;
  }
}

/// Whether a point that lies in its bounds lies in a cell.
bool CellFinder::holds(std::size_t candidate, const Vec3d& p)
{
  Candidate& c = candidates_[candidate];
  Vec3d rst = c.rst;
  if (!c.shape.settles(p, rst))
    return CrossingPoint(p, size_).isIn(c.shape.corners());
  const Vec3d from = glm::abs(rst - Vec3d(0.5));
  if (!(std::max({from.x, from.y, from.z}) <= 0.5 + ofRounding))
    return false;
  c.rst = rst;
  return true;
}

std::uint32_t CellFinder::at(const Vec3d& p)
{
  const Vec3f q(p - middle_);
  const auto mayHold = [&](std::size_t k)
  {
    return (lower_[0][k] <= q.x) & (q.x <= upper_[0][k]) & (lower_[1][k] <= q.y) &
           (q.y <= upper_[1][k]) & (lower_[2][k] <= q.z) & (q.z <= upper_[2][k]);
  };
  const std::size_t count = candidates_.size();
  if (last_ < count && mayHold(last_) && holds(last_, p))
    return candidates_[last_].cell;
  for (std::size_t first = 0; first < count; first += 16)
  {
    // Without a branch, so that many are compared at a time.
    std::array<std::uint8_t, 16> may{};
    const std::size_t end = std::min<std::size_t>(16, count - first);
    unsigned any = 0;
    for (std::size_t k = 0; k < end; ++k)
    {
      may[k] = mayHold(first + k);
      any |= may[k];
    }
    for (std::size_t k = 0; any && k < end; ++k)
      if (may[k] && first + k != last_ && holds(first + k, p))
      {
        last_ = first + k;
        return candidates_[last_].cell;
      }
  }
  return isGathered_ ? HexMesh::noCell : inStructure(p);
}

std::uint32_t CellFinder::inStructure(const Vec3d& p)
{
  const std::uint32_t cell = cellAt(structure_, p);
  if (cell == HexMesh::noCell || !isShown_(cell))
    return HexMesh::noCell;
  if (candidates_.size() >= kept) // all of them, rather than to tell which is the oldest
    clear({p, p});
  add(cell, mesh_.corners(cell));
  last_ = candidates_.size() - 1;
  return cell;
}

} // namespace mote
