#include "detail/CellIntake.h"

#include "../core/Error.h"
#include "TrilinearCell.h"

#include <cmath>

namespace mote
{

namespace
{

/// Where cell `i` begins in the connectivity. Throws where the cell does not fit its type.
std::size_t checkedOffset(const HexMeshInput& input, std::size_t i, int points)
{
  const double first = input.offsets.value(i), last = input.offsets.value(i + 1);
  if (!(first >= 0.0 && last <= static_cast<double>(input.connectivity.count())))
    throw Error("The offsets of cell " + std::to_string(i) + " point outside of the connectivity.");
  if (last - first != points)
    throw Error("Cell " + std::to_string(i) + " has " +
                std::to_string(static_cast<long long>(last - first)) +
                " points where its type has " + std::to_string(points) + ".");
  return static_cast<std::size_t>(first);
}

void mirror(HexMesh::Cell& cell)
{
  for (std::size_t i = 0; i < 8; i += 2)
    std::swap(cell[i], cell[i + 1]);
}

/// Kept, where all points are in reach.
template <typename Points>
Fate reachOf(const Points& points)
{
  bool finite = true, near = true;
  for (const Vec3d& p : points)
    for (int a = 0; a < 3; ++a)
    {
      finite = finite && std::isfinite(p[a]);
      near = near && std::abs(p[a]) <= farthestPoint;
    }
  if (near)
    return Fate::Kept;
  return finite ? Fate::TooFar : Fate::NonFinite;
}

} // namespace

CellIntake::Looked CellIntake::look(std::size_t i)
{
  Looked looked;
  const double type = input_.types.value(i);
  if (type == static_cast<double>(HexCellType::Polyhedron))
    return lookAtFaces(i);
  const CollapsedCorners corners = collapsedCorners(static_cast<int>(type));
  if (corners.points == 0)
    return looked;
  const std::size_t first = checkedOffset(input_, i, corners.points);
  for (std::size_t k = 0; k < 8; ++k)
    looked.cell[k] = static_cast<std::uint32_t>(
      checkedPoint(input_.connectivity.value(first + corners.of[k]), points_.size(), i));
  // Files have wedges in both orders.
  judge(looked, type == static_cast<double>(HexCellType::Wedge));
  return looked;
}

void CellIntake::judge(Looked& looked, bool isOrderFree)
{
  HexCorners p;
  for (std::size_t k = 0; k < 8; ++k)
    p[k] = points_[looked.cell[k]];
  looked.fate = reachOf(p);
  if (looked.fate != Fate::Kept)
    return;
  const JacobianRange range = jacobianRange(p);
  looked.volume = std::abs(range.volume);
  looked.fate = Fate::ZeroVolume;
  if (looked.volume <= negligibleVolume(p))
    return;
  const bool insideOut = range.volume < 0.0, isTold = insideOut && !isOrderFree;
  const double against = insideOut ? range.largest : -range.smallest;
  if (insideOut)
    mirror(looked.cell);
  looked.fate = isTold ? Fate::Inverted : Fate::Kept;
  if (!(against > 1e-9 * looked.volume))
    return;
  std::array<std::int64_t, 8> ids;
  std::copy(looked.cell.begin(), looked.cell.end(), ids.begin());
  faced_.setCell(ids);
  placePoints();
  if (faced_.cut())
    looked.fate = isTold ? Fate::InPartsInverted : Fate::InParts;
  else
    looked.fate = isTold ? Fate::SelfCrossingInverted : Fate::SelfCrossing;
}

void CellIntake::placePoints()
{
  faced_.complete();
  faced_.places.clear();
  for (const std::int64_t id : faced_.ids())
    faced_.places.push_back(points_[static_cast<std::size_t>(id)]);
}

CellIntake::Looked CellIntake::lookAtFaces(std::size_t i)
{
  Looked looked;
  const double location = input_.faceLocations.empty() ? -1.0 : input_.faceLocations.value(i);
  if (location < 0.0)
    return looked;
  faced_.read(input_.faces, static_cast<std::size_t>(location), i, points_.size());
  placePoints();
  looked.fate = reachOf(faced_.places);
  if (looked.fate != Fate::Kept)
    return looked;
  if (const auto whole = faced_.whole())
  {
    for (std::size_t k = 0; k < 8; ++k)
      looked.cell[k] = static_cast<std::uint32_t>(faced_.ids()[(*whole)[k]]);
    judge(looked, true);
    return looked;
  }
  looked.fate = faced_.cut() ? Fate::InParts : Fate::Unfit;
  looked.volume = faced_.volume();
  return looked;
}

} // namespace mote
