#include "CollapsedCell.h"

#include "kernels/hexahedra/HexMesh.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace mote
{

namespace
{

using Trihedron = std::array<int, 4>; // a corner and the ends of its edges, counter-clockwise

/// What there is to know about a type of cell; numbers are those of VTK's points.
struct CellShape
{
  CollapsedCorners collapsed;
  std::span<const Trihedron> trihedra; ///< corners with three edges
  double regular = 1.0;                ///< by which a regular cell's scaled Jacobian becomes 1
};

constexpr Trihedron hexahedron[] = {{0, 1, 3, 4}, {1, 2, 0, 5}, {2, 3, 1, 6}, {3, 0, 2, 7},
  {4, 7, 5, 0}, {5, 4, 6, 1}, {6, 5, 7, 2}, {7, 6, 4, 3}};
constexpr Trihedron voxel[] = {{0, 1, 2, 4}, {1, 3, 0, 5}, {3, 2, 1, 7}, {2, 0, 3, 6}, {4, 6, 5, 0},
  {5, 4, 7, 1}, {7, 5, 6, 3}, {6, 7, 4, 2}};
// In the order of vtkWedge's own coordinates, in which the first triangle faces outwards.
constexpr Trihedron wedge[] = {
  {0, 2, 1, 3}, {2, 1, 0, 5}, {1, 0, 2, 4}, {3, 4, 5, 0}, {5, 3, 4, 2}, {4, 5, 3, 1}};
constexpr Trihedron pyramid[] = {{0, 1, 3, 4}, {1, 2, 0, 4}, {2, 3, 1, 4}, {3, 0, 2, 4}};
constexpr Trihedron tetrahedron[] = {{0, 1, 2, 3}, {1, 2, 0, 3}, {2, 0, 1, 3}, {3, 1, 0, 2}};

const CellShape* shapeOf(int type)
{
  static const CellShape hexahedra{collapsedCorners(VTK_HEXAHEDRON), hexahedron};
  static const CellShape voxels{collapsedCorners(VTK_VOXEL), voxel};
  static const CellShape wedges{collapsedCorners(VTK_WEDGE), wedge, 2.0 / std::sqrt(3.0)};
  static const CellShape pyramids{collapsedCorners(VTK_PYRAMID), pyramid, std::sqrt(2.0)};
  static const CellShape tetrahedra{collapsedCorners(VTK_TETRA), tetrahedron, std::sqrt(2.0)};
  switch (type)
  {
  case VTK_HEXAHEDRON:
    return &hexahedra;
  case VTK_VOXEL:
    return &voxels;
  case VTK_WEDGE:
    return &wedges;
  case VTK_PYRAMID:
    return &pyramids;
  case VTK_TETRA:
    return &tetrahedra;
  default:
    return nullptr;
  }
}

} // namespace

std::array<double, 8> trilinearWeights(const Vec3d& rst)
{
  const double r = rst.x, s = rst.y, t = rst.z, u = 1.0 - r, v = 1.0 - s, w = 1.0 - t;
  return {u * v * w, r * v * w, r * s * w, u * s * w, u * v * t, r * v * t, r * s * t, u * s * t};
}

double jacobianAt(const CollapsedCell& cell, const Vec3d& rst)
{
  const double r = rst.x, s = rst.y, t = rst.z, u = 1.0 - r, v = 1.0 - s, w = 1.0 - t;
  const auto& c = cell.corners;
  const Vec3d along =
    v * w * (c[1] - c[0]) + s * w * (c[2] - c[3]) + v * t * (c[5] - c[4]) + s * t * (c[6] - c[7]);
  const Vec3d across =
    u * w * (c[3] - c[0]) + r * w * (c[2] - c[1]) + u * t * (c[7] - c[4]) + r * t * (c[6] - c[5]);
  const Vec3d up =
    u * v * (c[4] - c[0]) + r * v * (c[5] - c[1]) + r * s * (c[6] - c[2]) + u * s * (c[7] - c[3]);
  return glm::dot(along, glm::cross(across, up));
}

std::array<double, 8> CollapsedCell::cornerVolumes() const
{
  static const double low = 0.5 - 0.5 / std::sqrt(3.0);
  std::array<double, 8> volumes{};
  for (int k = 0; k < 8; ++k)
  {
    const Vec3d at(k & 1 ? 1.0 - low : low, k & 2 ? 1.0 - low : low, k & 4 ? 1.0 - low : low);
    const double part = 0.125 * jacobianAt(*this, at);
    const auto weights = trilinearWeights(at);
    for (int i = 0; i < 8; ++i)
      volumes[i] += part * weights[i];
  }
  return volumes;
}

double volumeOf(const std::array<double, 8>& cornerVolumes)
{
  return std::accumulate(cornerVolumes.begin(), cornerVolumes.end(), 0.0);
}

CellQuality qualityOf(const CollapsedCell& cell, double volume)
{
  const CellShape& shape = *shapeOf(cell.type);
  std::array<int, 8> place{}; // of VTK's points among the corners
  for (int i = 0; i < 8; ++i)
    place[shape.collapsed.of[i]] = i;
  const auto at = [&](int point) { return cell.corners[place[point]]; };
  double least = std::numeric_limits<double>::max(), shortest = least, longest = 0.0;
  // Files have wedges in both orders.
  const double side = cell.type == VTK_WEDGE && volume < 0.0 ? -1.0 : 1.0;
  bool flat = false;
  for (const auto& [corner, a, b, c] : shape.trihedra)
  {
    const Vec3d edges[3] = {at(a) - at(corner), at(b) - at(corner), at(c) - at(corner)};
    double product = 1.0;
    for (const Vec3d& edge : edges)
    {
      const double length = glm::length(edge);
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
      product *= length;
    }
    flat = flat || product == 0.0;
    if (product > 0.0)
      least = std::min(least, side * glm::dot(edges[0], glm::cross(edges[1], edges[2])) / product);
  }
  CellQuality quality;
  quality.scaledJacobian = flat ? std::min(0.0, least) : shape.regular * least;
  quality.aspectRatio = longest / shortest;
  quality.zeroVolume = std::abs(volume) <= 1e-14 * longest * longest * longest;
  quality.inverted = !quality.zeroVolume && quality.scaledJacobian < 0.0;
  return quality;
}

CellReader::CellReader(vtkDataSet* data)
  : data_(data)
  , ghosts_(data->GetCellGhostArray())
{
  // What a data set makes when it is first asked is made now.
  if (data->GetNumberOfCells() > 0)
  {
    double point[3];
    data->GetCellPoints(0, ids_);
    data->GetCellType(0);
    if (data->GetNumberOfPoints() > 0)
      data->GetPoint(0, point);
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (grid && grid->GetFaces() && grid->GetFaceLocations())
    grid_.emplace(GridArrays(grid));
}

CellReader::CellReader(const CellReader& other)
  : data_(other.data_)
  , ghosts_(other.ghosts_)
  , grid_(other.grid_)
{
}

CellReader::~CellReader() = default;

CellReader::Answer CellReader::read(vtkIdType cell, CollapsedCell& into)
{
  constexpr int hidden = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  if (ghosts_ && (ghosts_->GetValue(cell) & hidden) != 0)
    return Answer::Hidden;
  into.type = data_->GetCellType(cell);
  if (into.type == VTK_POLYHEDRON && grid_)
    return readFaces(cell);
  const CellShape* shape = shapeOf(into.type);
  if (!shape)
    return Answer::OtherType;
  data_->GetCellPoints(cell, ids_);
  if (ids_->GetNumberOfIds() != shape->collapsed.points)
    return Answer::OtherType;
  bool finite = true;
  for (int i = 0; i < 8; ++i)
  {
    into.ids[i] = ids_->GetId(shape->collapsed.of[i]);
    data_->GetPoint(into.ids[i], &into.corners[i].x);
    for (int k = 0; k < 3; ++k)
      finite = finite && std::isfinite(into.corners[i][k]);
  }
  return finite ? Answer::Taken : Answer::NonFinite;
}

CellReader::Answer CellReader::readFaces(vtkIdType cell)
{
  const HexMeshInput cells = grid_->input();
  const double location = cells.faceLocations.value(static_cast<std::size_t>(cell));
  if (location < 0.0)
    return Answer::OtherType;
  faced_.read(cells.faces, static_cast<std::size_t>(location), static_cast<std::size_t>(cell),
    static_cast<std::size_t>(data_->GetNumberOfPoints()));
  faced_.complete();
  faced_.places.clear();
  for (const std::int64_t id : faced_.ids())
  {
    Vec3d& p = faced_.places.emplace_back();
    data_->GetPoint(id, &p.x);
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return Answer::NonFinite;
  }
  parts_.clear();
  const auto take = [&](const FacedCell::Part& part)
  {
    parts_.push_back({VTK_POLYHEDRON, {}, faced_.cornersOf(part)});
    for (std::size_t i = 0; i < 8; ++i)
      parts_.back().ids[i] = part[i] == faced_.middlePlace() ? -1 : faced_.ids()[part[i]];
  };
  if (const auto whole = faced_.whole())
    take(*whole);
  else if (faced_.cut())
    std::for_each(faced_.parts().begin(), faced_.parts().end(), take);
  return parts_.empty() ? Answer::OtherType : Answer::InParts;
}

} // namespace mote
