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

/// A cell's corners about a ray, in float as SIMD has them.
struct FloatCorners
{
  float x[8], y[8], z[8];

  FloatCorners(const WalkTask& task, std::size_t ray, std::uint32_t cell)
  {
    const WalkRays& rays = task.rays;
    const HexMesh::Cell& ids = task.cells->mesh().cell(cell);
    for (std::size_t i = 0; i < 8; ++i)
    {
      const WalkCells::Point& p = task.cells->points()[ids[i]];
      const float at[3] = {p.x, p.y, p.z};
      z[i] = at[task.axis];
      x[i] = at[(task.axis + 1) % 3] - rays.x[ray];
      y[i] = at[(task.axis + 2) % 3] - rays.y[ray];
      x[i] -= rays.dx[ray] * z[i];
      y[i] -= rays.dy[ray] * z[i];
    }
  }
};

/// As the walk finds them: edges of which the two products are equal are not passed.
Windings windingsOf(const WalkTask& task, const FloatCorners& c)
{
  unsigned up = 0, down = 0;
  for (unsigned e = 0; e < 12; ++e)
  {
    const std::size_t i = edgeCorners[e][0], j = edgeCorners[e][1];
    const float p = c.x[i] * c.y[j], q = c.x[j] * c.y[i];
    up |= (c.y[i] <= 0.0f && c.y[j] > 0.0f && p > q ? 1U : 0U) << e;
    down |= (c.y[i] > 0.0f && c.y[j] <= 0.0f && p < q ? 1U : 0U) << e;
  }
  return task.isBackwards ? Windings(down, up) : Windings(up, down);
}

/// As CrossingLine has them, turned so that leaving is counter-clockwise.
CellFrame frameOf(const WalkTask& task, const FloatCorners& c, std::uint32_t cell)
{
  const HexMesh::Cell& ids = task.cells->mesh().cell(cell);
  CellFrame frame;
  for (unsigned i = 0; i < 8; ++i)
  {
    const WalkCells::Point& p = task.cells->points()[ids[i]];
    frame.add(i, {p.x, p.y, p.z},
      task.isBackwards ? Vec3d(c.y[i], c.x[i], -c.z[i]) : Vec3d(c.x[i], c.y[i], c.z[i]));
  }
  return frame;
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

WalkFaces seldomFaces(WalkTask& task, std::size_t ray, std::uint32_t cell, float z)
{
  const FloatCorners corners(task, ray, cell);
  const Windings windings = windingsOf(task, corners);
  const unsigned exits = facesOf(windings, 1), entries = facesOf(windings, -1);
  const CellFrame frame = frameOf(task, corners, cell);
  // Faces of the boundary that the ray may pass twice: with corners on all sides of it.
  unsigned folded = cornerBits.mixedFaces[frame.right] & cornerBits.mixedFaces[frame.above];
  folded &= facesOf(windings, 0);
  for (unsigned f = 0; f < 6; ++f)
    if (task.cells->adjacency().next(cell, f) != HexMesh::noCell)
      folded &= ~(1U << f);
  if (std::has_single_bit(exits) && std::has_single_bit(entries) && folded == 0)
    return {static_cast<std::uint8_t>(std::countr_zero(entries)),
      static_cast<std::uint8_t>(std::countr_zero(exits))};
  ++task.fallbacks;
  const CellIntervals intervals = intervalsOf(task, cell, frame);
  const CellInterval* nearest = nullptr;
  for (const CellInterval& part : intervals)
    if (!nearest || std::abs(part.in - z) < std::abs(nearest->in - z))
      nearest = &part;
  if (nearest)
    return {nearest->inFace, nearest->outFace};
  return {noFace, exits != 0 ? static_cast<std::uint8_t>(std::countr_zero(exits)) : noFace};
}

void addSeldomEntries(WalkTask& task, std::size_t ray, const WalkView::Face& face)
{
  const auto [cell, f] = face.face;
  const FloatCorners corners(task, ray, cell);
  const CellFrame frame = frameOf(task, corners, cell);
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
  int found = windingsOf(task, corners).of(f) == -1 ? 1 : 0;
  if (found == 0 && face.isFoldable)
    for (const CellInterval& part : intervalsOf(task, cell, frame))
      found += part.inFace == f;
  for (; found > 0; --found)
    add();
}

} // namespace mote
