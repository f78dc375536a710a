#include "GridParts.h"

#include "DataArrayView.h"

#include "kernels/core/Vec.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace mote
{

PointSets::PointSets(vtkIdType points)
  : up_(static_cast<std::size_t>(points))
{
  std::iota(up_.begin(), up_.end(), vtkIdType(0));
}

vtkIdType PointSets::of(vtkIdType point)
{
  vtkIdType* up = &this->up(point);
  while (*up != point)
  {
    *up = this->up(*up); // the way is half as long next time
    point = *up;
    up = &this->up(point);
  }
  return point;
}

void PointSets::join(vtkIdType a, vtkIdType b)
{
  a = this->of(a);
  b = this->of(b);
  if (a != b)
    this->up(std::max(a, b)) = std::min(a, b);
}

void PointSets::joinCells(vtkUnstructuredGrid* grid)
{
  vtkCellArray* cells = grid->GetCells();
  if (!cells)
    return;
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, points);
    for (vtkIdType k = 1; k < points->GetNumberOfIds(); ++k)
      this->join(points->GetId(0), points->GetId(k));
  }
}

bool isFlatType(int type)
{
  switch (type)
  {
  case VTK_TRIANGLE:
  case VTK_TRIANGLE_STRIP:
  case VTK_POLYGON:
  case VTK_PIXEL:
  case VTK_QUAD:
  case VTK_QUADRATIC_TRIANGLE:
  case VTK_QUADRATIC_QUAD:
  case VTK_BIQUADRATIC_QUAD:
  case VTK_BIQUADRATIC_TRIANGLE:
  case VTK_LAGRANGE_TRIANGLE:
  case VTK_LAGRANGE_QUADRILATERAL:
    return true;
  default:
    return false;
  }
}

bool hangsTogether(const ArrayView& triangles, vtkIdType points)
{
  PointSets sets(points);
  const auto corner = [&](std::size_t t, int k)
  { return static_cast<vtkIdType>(triangles.value(t, k)); };
  for (std::size_t t = 0; t < triangles.count(); ++t)
    for (int k = 1; k < 3; ++k)
      sets.join(corner(t, 0), corner(t, k));
  for (std::size_t t = 1; t < triangles.count(); ++t)
    if (sets.of(corner(t, 0)) != sets.of(corner(0, 0)))
      return false;
  return true;
}

bool hasManyPoints(vtkUnstructuredGrid* grid)
{
  // Where cells share theirs, a hexahedron of eight corners comes to one point. Polyhedra name
  // their points in another place, too, where welds do not come.
  vtkCellArray* cells = grid->GetCells();
  const vtkIdType points = grid->GetNumberOfPoints();
  if (!cells || grid->GetFaces() || 6 * points <= cells->GetNumberOfConnectivityIds())
    return false;
  const ArrayView ids = DataArrayView(cells->GetConnectivityArray()).view;
  for (std::size_t i = 0; i < ids.count(); ++i)
    if (const double id = ids.value(i); !(id >= 0.0 && id < static_cast<double>(points)))
      return false; // damaged, of which others tell
  return true;
}

namespace
{

/// The points of a grid as float numbers about their middle. Cells that work out their points each
/// by themselves agree there but for the last bits of double numbers.
vtkSmartPointer<vtkPoints> pointsAsFloats(vtkPoints* points)
{
  if (points->GetDataType() != VTK_DOUBLE)
    return points;
  double bounds[6];
  points->GetBounds(bounds);
  Vec3d middle(0.0);
  for (int axis = 0; axis < 3; ++axis)
    if (const double m = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]); std::isfinite(m))
      middle[axis] = m;
  auto floats = vtkSmartPointer<vtkPoints>::New(); // float
  floats->SetNumberOfPoints(points->GetNumberOfPoints());
  auto* to = static_cast<float*>(floats->GetVoidPointer(0));
  const ArrayView from = DataArrayView(points->GetData()).view;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, from.count(), 1 << 14),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
        for (int axis = 0; axis < 3; ++axis)
          to[3 * i + std::size_t(axis)] = static_cast<float>(from.value(i, axis) - middle[axis]);
    });
  return floats;
}

} // namespace

std::vector<vtkIdType> weldsOf(vtkUnstructuredGrid* grid, PointSets& parts)
{
  const vtkIdType count = grid->GetNumberOfPoints();
  std::vector<vtkIdType> welds(static_cast<std::size_t>(count));
  if (count == 0)
    return {};
  vtkNew<vtkPolyData> cloud; // whose points are those of the grid; its cells would be copied
  cloud->SetPoints(pointsAsFloats(grid->GetPoints()));
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(cloud);
  locator->BuildLocator();
  locator->MergePoints(0.0, welds.data());

  struct Point
  {
    vtkIdType place, part, id;
  };
  std::vector<Point> shared; // at the place of another, which has the lesser number
  std::vector<std::uint8_t> isShared(welds.size(), 0);
  for (vtkIdType i = 0; i < count; ++i)
    if (const vtkIdType place = welds[static_cast<std::size_t>(i)]; place != i)
      isShared[static_cast<std::size_t>(i)] = isShared[static_cast<std::size_t>(place)] = 1;
  for (vtkIdType i = 0; i < count; ++i)
    if (isShared[static_cast<std::size_t>(i)])
      shared.push_back({welds[static_cast<std::size_t>(i)], parts.of(i), i});
  if (shared.empty())
    return {};
  tbb::parallel_sort(shared.begin(), shared.end(),
    [](const Point& a, const Point& b)
    { return std::tie(a.place, a.part, a.id) < std::tie(b.place, b.part, b.id); });
  bool isWelded = false;
  for (auto first = shared.begin(); first != shared.end();)
  {
    const auto end =
      std::find_if(first, shared.end(), [&](const Point& p) { return p.place != first->place; });
    const bool isWall = std::adjacent_find(first, end,
                          [](const Point& a, const Point& b) { return a.part == b.part; }) != end;
    vtkIdType least = first->id;
    for (auto p = first; p != end; ++p)
      least = std::min(least, p->id);
    for (auto p = first; p != end; ++p)
      welds[static_cast<std::size_t>(p->id)] = isWall ? p->id : least;
    isWelded = isWelded || !isWall;
    first = end;
  }
  return isWelded ? welds : std::vector<vtkIdType>();
}

vtkSmartPointer<vtkCellArray> weldedCells(
  vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& welds)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->DeepCopy(grid->GetCells());
  vtkDataArray* points = cells->GetConnectivityArray();
  for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
    points->SetComponent(
      i, 0, static_cast<double>(welds[static_cast<std::size_t>(points->GetComponent(i, 0))]));
  return cells;
}

bool haveOneValue(vtkDataArray* array, const std::vector<vtkIdType>& welds)
{
  const ArrayView values = DataArrayView(array).view;
  if (values.empty() || values.count() != welds.size())
    return true; // nobody looks at it
  using Range = tbb::blocked_range<std::size_t>;
  const Range all(0, welds.size(), 1 << 14);
  for (int c = 0; c < values.components(); ++c)
  {
    const double largest = tbb::parallel_reduce(
      all, 0.0,
      [&](const Range& range, double most)
      {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
          if (const double value = std::abs(values.value(i, c)); std::isfinite(value))
            most = std::max(most, value);
        return most;
      },
      [](double a, double b) { return std::max(a, b); });
    const double rounding = 4.0 * std::numeric_limits<float>::epsilon() * largest;
    const auto areOne = [&](std::size_t i)
    {
      const double own = values.value(i, c), at = values.value(std::size_t(welds[i]), c);
      return own == at || std::abs(own - at) <= rounding || (std::isnan(own) && std::isnan(at));
    };
    if (!tbb::parallel_reduce(
          all, true,
          [&](const Range& range, bool isOne)
          {
            for (std::size_t i = range.begin(); i < range.end() && isOne; ++i)
              isOne = areOne(i);
            return isOne;
          },
          [](bool a, bool b) { return a && b; }))
      return false;
  }
  return true;
}

} // namespace mote
