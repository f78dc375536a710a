#include "SurfaceSeams.h"

#include "GridParts.h"
#include "RotatedCopies.h"
#include "SurfaceCover.h"
#include "SurfaceFaces.h"
#include "SurfaceTriangles.h"

#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <functional>

namespace mote
{

SeamSurface::SeamSurface(const SurfaceTriangles& surface, vtkPoints* points)
  : faces_(std::make_unique<const SurfaceFaces>(surface, points))
{
}

SeamSurface::~SeamSurface() = default;

const SurfaceCover& SeamSurface::cover() const
{
  std::call_once(once_, [this] { cover_ = std::make_unique<const SurfaceCover>(*faces_); });
  return *cover_;
}

namespace
{

constexpr double agreement = 1e-6; // of the surface's extent

/// For each corner of a surface, where it is turned to, the corner of another, or -1.
std::vector<vtkIdType> pairs(const SurfaceFaces& from, const SurfaceFaces& to, const Mat4d& turn)
{
  std::vector<vtkIdType> met(from.corners().size(), -1);
  const double radius = agreement * std::max(from.extent(), to.extent());
  for (std::size_t i = 0; i < met.size(); ++i)
    // Which is soon told, and most of other blocks is not.
    if (const Vec3d q = transformPoint(turn, from.corners()[i]); to.isNear(q, radius))
      met[i] = to.cornerAt(q, radius);
  return met;
}

void mark(const SurfaceFaces::Face& face, std::vector<std::uint8_t>& marks)
{
  std::fill(marks.begin() + static_cast<std::ptrdiff_t>(face.first),
    marks.begin() + static_cast<std::ptrdiff_t>(face.end), std::uint8_t(1));
}

/// Marks the triangles of faces of `from`, turned, that faces of `to` with the same corners look
/// at, and calls visit(face) for these.
template <typename Visit>
void markFacing(const SurfaceFaces& from, const SurfaceFaces& to, const Mat4d& turn,
  std::vector<std::uint8_t>& marks, const Visit& visit)
{
  const std::vector<vtkIdType> after = pairs(from, to, turn);
  const Mat3d linear(turn);
  std::vector<vtkIdType> corners;
  for (const SurfaceFaces::Face& face : from.all())
  {
    from.cornersOf(face, after, corners);
    if (!corners.empty())
      to.find(corners,
        [&](const SurfaceFaces::Face& other)
        {
          // What of a whole wheel covers itself looks the same way.
          if (!(glm::dot(linear * face.normal, other.normal) < 0.0))
            return;
          mark(face, marks);
          visit(other);
        });
  }
}

} // namespace

std::vector<std::uint8_t> coveredByCopies(
  const SurfaceTriangles& surface, vtkPoints* points, const SectorCopies& copies)
{
  const std::vector<Mat4d> turns = rotatedCopies(copies.count, &copies.center.x, &copies.axis.x);
  if (turns.size() < 2 || surface.view().empty())
    return {};
  const SeamSurface own(surface, points);
  std::vector<std::uint8_t> marks(own.faces().triangles().size(), 0);
  markFacing(own.faces(), own.faces(), turns[1], marks,
    [&](const SurfaceFaces::Face& other) { mark(other, marks); });
  for (const Mat4d& turn : {turns[1], turns.back()})
    own.cover().mark(own.cover(), turn, marks);
  return marks;
}

std::vector<std::uint8_t> coveredByOther(const SeamSurface& surface, const SeamSurface& other)
{
  std::vector<std::uint8_t> marks(surface.faces().triangles().size(), 0);
  markFacing(surface.faces(), other.faces(), Mat4d(1.0), marks, [](const SurfaceFaces::Face&) {});
  if (std::find(marks.begin(), marks.end(), 0) != marks.end())
    other.cover().mark(surface.cover(), Mat4d(1.0), marks);
  return marks;
}

std::vector<std::uint8_t> flatOnFaces(const SurfaceTriangles& surface, vtkUnstructuredGrid* grid)
{
  const auto isFlat = [&](std::size_t triangle)
  { return isFlatType(grid->GetCellType(surface.cells[triangle])); };
  std::vector<std::size_t> flat;
  for (std::size_t t = 0; t < surface.cells.size(); ++t)
    if (isFlat(t))
      flat.push_back(t);
  if (flat.empty() || flat.size() == surface.cells.size())
    return {};
  // By their polygons, and by their triangles: those of curved cells are of more.
  const SurfaceFaces faces(surface, grid->GetPoints());
  using Corners = std::array<std::size_t, 4>; // ascending; of triangles the last one twice
  const auto cornersOf = [&](std::size_t first, std::size_t end)
  {
    std::vector<std::size_t> all;
    for (std::size_t t = first; t < end; ++t)
      all.insert(all.end(), faces.triangles()[t].begin(), faces.triangles()[t].end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    all.resize(std::min<std::size_t>(all.size(), 5), 0);
    return all.size() == 3   ? Corners{all[0], all[1], all[2], all[2]}
           : all.size() == 4 ? Corners{all[0], all[1], all[2], all[3]}
                             : Corners{0, 0, 0, 0}; // none
  };
  std::vector<Corners> known;
  for (const SurfaceFaces::Face& face : faces.all())
    if (!isFlat(face.first))
    {
      known.push_back(cornersOf(face.first, face.end));
      for (std::size_t t = face.first; t < face.end && face.end > face.first + 1; ++t)
        known.push_back(cornersOf(t, t + 1));
    }
  std::sort(known.begin(), known.end());
  const auto isKnown = [&](const Corners& corners)
  { return corners[0] != corners[3] && std::binary_search(known.begin(), known.end(), corners); };
  std::vector<std::uint8_t> marks(surface.cells.size(), 0);
  for (const SurfaceFaces::Face& face : faces.all())
    if (isFlat(face.first))
    {
      const bool isWhole = isKnown(cornersOf(face.first, face.end));
      for (std::size_t t = face.first; t < face.end; ++t)
        marks[t] = isWhole || isKnown(cornersOf(t, t + 1));
    }
  return marks;
}

std::vector<std::uint8_t> coveredByParts(
  const SurfaceTriangles& surface, vtkPoints* points, PointSets& parts)
{
  std::vector<vtkIdType> partOf(surface.view().count());
  for (std::size_t t = 0; t < partOf.size(); ++t)
    partOf[t] = parts.of(static_cast<vtkIdType>(surface.view().value(t, 0)));
  if (std::adjacent_find(partOf.begin(), partOf.end(), std::not_equal_to<>()) == partOf.end())
    return {};
  const SeamSurface own(surface, points);
  std::vector<std::uint8_t> marks(own.faces().triangles().size(), 0);
  own.cover().mark(own.cover(), Mat4d(1.0), marks,
    [&](std::size_t one, std::size_t other) { return partOf[one] != partOf[other]; });
  return marks;
}

} // namespace mote
