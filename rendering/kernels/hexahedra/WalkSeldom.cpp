// What a walk from cell to cell asks of CrossingLine's faces, where signs of edges do not tell.
//
// This file must be compiled without contraction to fused multiply-adds, as CellWalkSimd.cpp, whose
// numbers it computes once more.

#include "detail/WalkTask.h"

#include <bit>
#include <cmath>

namespace mote
{

namespace
{

/// A ray's parts in a cell. Faces that a ray passes twice count where they are on the boundary and
/// the view knows of them; what lies between two such passes of other faces is taken for the cell's
/// own, and so does not exist for the cell behind.
CellIntervals intervalsOf(const WalkTask& task, std::uint32_t cell, const CellFrame& frame)
{
  CellIntervals intervals;
  intersectFrame(frame, 1.0, intervals);
  const bool isFoldable = task.view->isFoldable(cell);
  int count = 0;
  for (const CellInterval& part : intervals)
  {
    CellInterval* const last =
      count > 0 ? &intervals.of[static_cast<std::size_t>(count - 1)] : nullptr;
    const bool goesOn =
      last != nullptr && last->outFace == part.inFace &&
      !(isFoldable && task.cells->adjacency().next(cell, part.inFace) == HexMesh::noCell);
    if (goesOn)
    {
      last->out = part.out;
      last->outFace = part.outFace;
    }
    else
      intervals.of[static_cast<std::size_t>(count++)] = part;
  }
  intervals.count = count;
  return intervals;
}

/// The faces with this winding, a bit each.
unsigned facesOf(const Windings& windings, int winding)
{
  unsigned faces = 0;
  for (unsigned f = 0; f < 6; ++f)
    faces |= (windings.of(f) == winding ? 1U : 0U) << f;
  return faces;
}

} // namespace

CellFrame walkFrame(const WalkTask& task, std::size_t ray, std::uint32_t cell)
{
  const WalkRays& rays = task.rays;
  const HexMesh::Cell& ids = task.cells->mesh().cell(cell);
  CellFrame frame;
  for (unsigned i = 0; i < 8; ++i)
  {
    const WalkCells::Point& p = task.cells->points()[ids[i]];
    const float at[3] = {p.x, p.y, p.z};
    const float z = at[task.axis];
    const float x = at[(task.axis + 1) % 3] - rays.x[ray], dx = rays.dx[ray] * z;
    const float y = at[(task.axis + 2) % 3] - rays.y[ray], dy = rays.dy[ray] * z;
    const double u = x - dx, v = y - dy;
    // Turned, so that leaving is counter-clockwise.
    frame.add(i, {p.x, p.y, p.z},
      task.isBackwards ? Vec3d(v, u, task.depth(z)) : Vec3d(u, v, task.depth(z)));
  }
  return frame;
}

std::uint8_t seldomExit(const WalkTask& task, std::size_t ray, std::uint32_t cell, float z)
{
  const CellFrame frame = walkFrame(task, ray, cell);
  const unsigned exits = facesOf(windingsOf(frame), 1);
  if (std::has_single_bit(exits) && !task.view->isFoldable(cell))
    return static_cast<std::uint8_t>(std::countr_zero(exits));
  const CellIntervals intervals = intervalsOf(task, cell, frame);
  const CellInterval* nearest = nullptr;
  for (const CellInterval& part : intervals)
    if (!nearest || std::abs(part.in - z) < std::abs(nearest->in - z))
      nearest = &part;
  if (nearest)
    return nearest->outFace;
  return exits != 0 ? static_cast<std::uint8_t>(std::countr_zero(exits)) : noFace;
}

void addSeldomEntries(WalkTask& task, std::size_t ray, const WalkView::Face& face)
{
  const auto [cell, f] = face.face;
  const CellFrame frame = walkFrame(task, ray, cell);
  const auto add = [&]
  {
    const FacePoint point = facePointOf(frame, f, -1);
    const HexMesh::Cell& ids = task.cells->mesh().cell(cell);
    const double value =
      point.value([&](std::size_t i) { return double(task.cells->points()[ids[i]].value); });
    double z = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
      z += point.weights[i] * frame.z[point.corners[i]];
    task.entries.add(ray, static_cast<float>(z), static_cast<float>(value), cell);
  };
  int found = windingsOf(frame).of(f) == -1 ? 1 : 0;
  if (found == 0 && face.isFoldable)
    for (const CellInterval& part : intervalsOf(task, cell, frame))
      found += part.inFace == f;
  for (; found > 0; --found)
    add();
}

} // namespace mote
