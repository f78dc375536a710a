// Where slices meet the faces of cells.

#include "SliceSurface.h"

#include "TrilinearCell.h"
#include "detail/CellFaces.h"

#include <cmath>

namespace mote
{

namespace
{

/// Which faces of a cell, as bits, are faces of the input's cell.
unsigned ownFaces(const HexMesh& mesh, std::uint32_t cell)
{
  const HexMesh::Cell& corners = mesh.cell(cell);
  unsigned faces = 0;
  for (unsigned face = 0; face < 6; ++face)
  {
    const auto at = [&](int i) { return corners[faceCorners[face][i]]; };
    const bool isCollapsed =
      (at(0) == at(1) && at(2) == at(3)) || (at(1) == at(2) && at(3) == at(0));
    bool isInner = false;
    for (int i = 0; i < 4; ++i)
      isInner = isInner || at(i) >= mesh.pointCount();
    faces |= unsigned{!isCollapsed && !isInner} << face;
  }
  return faces;
}

/// The values at a cell's corners of its coordinate r, s or t.
CornerValues coordinateValues(int coordinate)
{
  constexpr int corner[8][3] = {
    {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  CornerValues values;
  for (std::size_t i = 0; i < 8; ++i)
    values[i] = corner[i][coordinate];
  return values;
}

} // namespace

void SliceSurface::edges(const std::uint64_t* slots, const Vec3d* points, const Vec3d* ways,
  int count, EdgeSeen* found) const
{
  static const CornerValues coordinates[3] = {
    coordinateValues(0), coordinateValues(1), coordinateValues(2)};
  const HexMesh& mesh = meshOf(*structure_);
  std::uint32_t last = HexMesh::noCell;
  TrilinearCell shape{HexCorners{}};
  unsigned faces = 0;
  Vec3d rst(0.5);
  for (int k = 0; k < count; ++k)
  {
    if (cellOf(slots[k]) != last)
    {
      last = cellOf(slots[k]);
      shape = TrilinearCell(mesh, last);
      faces = ownFaces(mesh, last);
      rst = Vec3d(0.5);
    }
    const Frame& frame = frameOf(slots[k]);
    if (!shape.coordinates(meshPoint(frame, points[k]), rst, rst))
      continue;
    rst = glm::clamp(rst, Vec3d(0.0), Vec3d(1.0));
    const Vec3d normal = glm::normalize(normalAt(frame, points[k]));
    for (int c = 0; c < 3; ++c)
    {
      // How the coordinate grows within the slice.
      Vec3d grows = shape.gradient(coordinates[c], rst);
      const double inAll = glm::dot(grows, grows);
      if (frame.shape.kind == SliceShape::Kind::Unrolled)
        grows = unrolled(frame, points[k], grows);
      grows -= glm::dot(grows, normal) * normal;
      const double rate = glm::dot(grows, grows);
      if (!(rate > 1e-12 * inAll)) // faces that lie in the slice have no edge there
        continue;
      for (const int end : {0, 1})
        if (faces >> (4 - 2 * c + end) & 1)
        {
          const double way = end == 0 ? rst[c] : 1.0 - rst[c];
          found[k].take(
            (end == 0 ? -way : way) / rate * grows, glm::cross(normal, grows), ways[k], way);
        }
    }
  }
}

/// A gradient at the mesh's point, as it is on the plane that the cylinder was rolled out onto.
Vec3d SliceSurface::unrolled(const Frame& frame, const Vec3d& point, const Vec3d& gradient)
{
  const double angle = glm::dot(point - frame.shape.point, frame.axes[1]) / frame.shape.radius;
  const Vec3d own = gradient * frame.axes;
  return frame.axes * Vec3d(0.0, std::cos(angle) * own.y - std::sin(angle) * own.x, own.z);
}

} // namespace mote
