#include "CellCrossings.h"

#include "CellFaces.h"

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
  kz_ = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  kx_ = (kz_ + 1) % 3;
  ky_ = (kz_ + 2) % 3;
  if (direction[kz_] < 0.0) // so that leaving is counter-clockwise
    std::swap(kx_, ky_);
  origin_ = {origin[kx_], origin[ky_], origin[kz_]};
  shearX_ = direction[kx_] / direction[kz_];
  shearY_ = direction[ky_] / direction[kz_];
  inverse_ = 1.0 / direction[kz_];
}

template <typename Corner>
bool CrossingLine::intersectCorners(const Corner& corner, CellIntervals& intervals) const
{
  CellFrame frame;
  for (unsigned i = 0; i < 8; ++i)
  {
    const Vec3d p = inFrame(corner(i));
    frame.add(i, p.x, p.y, p.z);
  }
  Crossings crossings;
  findCrossings(frame, crossings);
  intervals.count = 0;
  for (int i = 0; i < crossings.count; ++i)
    crossings.of[static_cast<std::size_t>(i)].t *= inverse_;
  return crossings.count > 0 && toIntervals(crossings, intervals);
}

bool CrossingLine::intersect(const HexMesh& mesh, std::size_t cell, CellIntervals& intervals) const
{
  const HexMesh::Cell& ids = mesh.cell(cell);
  return intersectCorners([&](unsigned i) { return &mesh.point(ids[i]).x; }, intervals);
}

bool CrossingLine::intersect(const HexCorners& corners, CellIntervals& intervals) const
{
  return intersectCorners([&](unsigned i) { return &corners[i].x; }, intervals);
}

FacePoint CrossingLine::facePoint(
  const HexMesh& mesh, std::size_t cell, std::uint8_t face, int leaving) const
{
  CellFrame frame;
  for (const std::uint8_t i : faceCorners[face])
  {
    const Vec3d p = inFrame(&mesh.point(mesh.cell(cell)[i]).x);
    frame.add(i, p.x, p.y, p.z);
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
