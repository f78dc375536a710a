#include "OutwardFaces.h"

#include "SurfaceTriangles.h"

#include "kernels/core/Vec.h"

#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <utility>

namespace mote
{

namespace
{

Vec3d placeOf(vtkUnstructuredGrid* grid, vtkIdType point)
{
  Vec3d place;
  grid->GetPoint(point, &place[0]);
  return place;
}

/// Whether faces of the cell look inwards, by VTK's order of its corners.
bool isInsideOut(vtkUnstructuredGrid* grid, vtkIdType cell, vtkIdList* corners)
{
  const auto mean = [&](std::initializer_list<vtkIdType> some)
  {
    Vec3d sum(0.0);
    for (const vtkIdType corner : some)
    {
      Vec3d at;
      grid->GetPoint(corners->GetId(corner), &at[0]);
      sum += at;
    }
    return sum / static_cast<double>(some.size());
  };
  const auto volume = [](const Vec3d& a, const Vec3d& b, const Vec3d& c)
  { return glm::dot(glm::cross(a, b), c); };
  const int type = grid->GetCellType(cell);
  if (type != VTK_TETRA && type != VTK_HEXAHEDRON && type != VTK_WEDGE && type != VTK_PYRAMID)
    return false;
  grid->GetCellPoints(cell, corners);
  const vtkIdType wanted = type == VTK_TETRA     ? 4
                           : type == VTK_PYRAMID ? 5
                           : type == VTK_WEDGE   ? 6
                                                 : 8;
  if (corners->GetNumberOfIds() < wanted)
    return false; // a damaged cell
  const Vec3d first = mean({0});
  if (type == VTK_TETRA)
    return volume(mean({1}) - first, mean({2}) - first, mean({3}) - first) < 0.0;
  if (type == VTK_WEDGE) // its first triangle looks outwards
    return volume(mean({1}) - first, mean({2}) - first, mean({3, 4, 5}) - mean({0, 1, 2})) > 0.0;
  if (type == VTK_PYRAMID)
    return volume(mean({2}) - first, mean({3}) - mean({1}), mean({4}) - mean({0, 1, 2, 3})) < 0.0;
  return volume(mean({1, 2, 5, 6}) - mean({0, 3, 4, 7}), mean({2, 3, 6, 7}) - mean({0, 1, 4, 5}),
           mean({4, 5, 6, 7}) - mean({0, 1, 2, 3})) < 0.0;
}

/// Which faces of a cell look inwards.
struct Inwards
{
  enum
  {
    None,
    All,
    Some ///< those that do not look away from `middle`
  } which = None;
  Vec3d middle{0.0};

  bool has(const Vec3d& a, const Vec3d& b, const Vec3d& c) const
  {
    return which == All ||
           (which == Some && glm::dot(glm::cross(b - a, c - a), (a + b + c) / 3.0 - middle) < 0.0);
  }
};

/// Of a polyhedron. Where nearly all faces look one way, as seen from the middle, all do: one that
/// does not may be bent.
Inwards inwardsOf(vtkUnstructuredGrid* grid, vtkIdType polyhedron)
{
  vtkNew<vtkIdList> faces; // number of faces, then for each number of corners and corners
  grid->GetFaceStream(polyhedron, faces);
  Inwards inwards;
  double count = 0.0;
  const auto forFaces = [&](const auto& visit)
  {
    for (vtkIdType at = 1; at < faces->GetNumberOfIds(); at += faces->GetId(at) + 1)
      visit(at + 1, faces->GetId(at));
  };
  forFaces(
    [&](vtkIdType first, vtkIdType corners)
    {
      for (vtkIdType k = first; k < first + corners; ++k, ++count)
        inwards.middle += placeOf(grid, faces->GetId(k));
    });
  if (count == 0.0)
    return inwards;
  inwards.middle /= count;
  double sum = 0.0, all = 0.0; // of the volumes of pyramids from the middle
  forFaces(
    [&](vtkIdType first, vtkIdType corners)
    {
      double volume = 0.0;
      const Vec3d a = placeOf(grid, faces->GetId(first)) - inwards.middle;
      for (vtkIdType k = first + 1; k + 1 < first + corners; ++k)
        volume += glm::dot(a, glm::cross(placeOf(grid, faces->GetId(k)) - inwards.middle,
                                placeOf(grid, faces->GetId(k + 1)) - inwards.middle));
      sum += volume;
      all += std::abs(volume);
    });
  constexpr double nearlyAll = 0.9;
  inwards.which = sum > nearlyAll * all    ? Inwards::None
                  : sum < -nearlyAll * all ? Inwards::All
                                           : Inwards::Some;
  return inwards;
}

} // namespace

void turnOutwards(vtkUnstructuredGrid* grid, vtkIdTypeArray* corners, SurfaceTriangles& surface)
{
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, surface.cells.size(), 4096),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      vtkNew<vtkIdList> ofCell;
      vtkIdType last = -1;
      Inwards inwards;
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        if (std::exchange(last, surface.cells[i]) != surface.cells[i])
        {
          inwards.which = Inwards::None;
          if (grid->GetCellType(last) == VTK_POLYHEDRON)
            inwards = inwardsOf(grid, last);
          else if (isInsideOut(grid, last, ofCell))
            inwards.which = Inwards::All;
        }
        vtkIdType* of = corners->GetPointer(3 * static_cast<vtkIdType>(i));
        if (inwards.which == Inwards::None ||
            !inwards.has(placeOf(grid, of[0]), placeOf(grid, of[1]), placeOf(grid, of[2])))
          continue;
        std::swap(of[1], of[2]);
        if (surface.edges.empty())
          continue;
        std::uint8_t& sides = surface.edges[i]; // the first and the last have changed places
        sides = static_cast<std::uint8_t>((sides & 2U) | (sides & 1U) << 2 | (sides & 4U) >> 2);
      }
    });
}

} // namespace mote
