#include "CellCrossings.h"

#include "detail/CellFaces.h"

#include <algorithm>
#include <utility>

// This file must be compiled without contraction to fused multiply-adds, see CellFaces.cpp.

namespace mote
{

namespace
{

/// Parallel to nothing that meshes are usually made of.
const Vec3d askedDirection(0.8391, 0.3241, 0.4372);

} // namespace

CrossingLine::CrossingLine(const Vec3d& origin, const Vec3d& direction)
{
  const Vec3d size = glm::abs(direction);
  const int kz = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  int kx = (kz + 1) % 3, ky = (kz + 2) % 3;
  if (direction[kz] < 0.0) // so that leaving is counter-clockwise
    std::swap(kx, ky);
  frame_ = {{origin[kx], origin[ky], origin[kz]}, kx, ky, kz, direction[kx] / direction[kz],
    direction[ky] / direction[kz], 1.0 / direction[kz]};
}

FacePoint CrossingLine::facePoint(
  const HexMesh& mesh, std::size_t cell, std::uint8_t face, int leaving) const
{
  CellFrame frame;
  for (const std::uint8_t i : faceCorners[face])
  {
    const Vec3d& point = mesh.point(mesh.cell(cell)[i]);
    frame.add(i, point, frame_.at(point));
  }
  return facePointOf(frame, face, leaving);
}

CrossingPoint::CrossingPoint(const Vec3d& point, double size)
  : line_(point, askedDirection)
  , at_(1e-14 * size)
{
}

bool CrossingPoint::isIn(const HexMesh& mesh, std::size_t cell) const
{
  CellIntervals intervals;
  return line_.intersect(mesh, cell, intervals) && isIn(intervals);
}

bool CrossingPoint::isIn(const HexCorners& corners) const
{
  CellIntervals intervals;
  return line_.intersect(corners, intervals) && isIn(intervals);
}

bool CrossingPoint::isIn(const CellIntervals& intervals) const
{
  return std::any_of(intervals.begin(), intervals.end(),
    [this](const CellInterval& i) { return i.in <= at_ && at_ < i.out; });
}

} // namespace mote
