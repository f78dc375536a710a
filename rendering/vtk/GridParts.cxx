#include "GridParts.h"

#include "SurfaceTriangles.h"

#include "kernels/core/ArrayView.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace mote
{

namespace
{

/// Points in sets, which are joined.
class PointSets
{
public:
  explicit PointSets(vtkIdType points)
    : up_(static_cast<std::size_t>(points))
  {
    std::iota(up_.begin(), up_.end(), vtkIdType(0));
  }

  /// The least point of the set.
  vtkIdType of(vtkIdType point)
  {
    vtkIdType* up = &this->up(point);
    while (*up != point)
    {
      vtkIdType* above = &this->up(*up);
      *up = *above; // the way is half as long next time
      point = *up;
      up = &this->up(point);
    }
    return point;
  }

  void join(vtkIdType a, vtkIdType b)
  {
    a = this->of(a);
    b = this->of(b);
    if (a != b)
      this->up(std::max(a, b)) = std::min(a, b);
  }

private:
  vtkIdType& up(vtkIdType point) { return up_[static_cast<std::size_t>(point)]; }

  std::vector<vtkIdType> up_;
};

/// Where all are of one set: empty.
std::vector<vtkIdType> setsOf(const ArrayView& triangles, PointSets& sets)
{
  std::vector<vtkIdType> found(triangles.count());
  for (std::size_t t = 0; t < found.size(); ++t)
    found[t] = sets.of(static_cast<vtkIdType>(triangles.value(t, 0)));
  if (std::adjacent_find(found.begin(), found.end(), std::not_equal_to<>()) == found.end())
    found.clear();
  return found;
}

} // namespace

std::vector<vtkIdType> partsOfSurface(const SurfaceTriangles& surface, vtkUnstructuredGrid* grid)
{
  const ArrayView triangles = surface.view();
  // Of most grids the surface itself hangs together, and has far fewer points.
  PointSets sets(grid->GetNumberOfPoints());
  for (std::size_t t = 0; t < triangles.count(); ++t)
    for (int k = 1; k < 3; ++k)
      sets.join(static_cast<vtkIdType>(triangles.value(t, 0)),
        static_cast<vtkIdType>(triangles.value(t, k)));
  if (setsOf(triangles, sets).empty())
    return {};
  vtkCellArray* cells = grid->GetCells();
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, points);
    for (vtkIdType k = 1; k < points->GetNumberOfIds(); ++k)
      sets.join(points->GetId(0), points->GetId(k));
  }
  return setsOf(triangles, sets);
}

} // namespace mote
