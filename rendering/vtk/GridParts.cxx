#include "GridParts.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
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
  // Where cells share theirs, a hexahedron of eight corners comes to one point.
  vtkCellArray* cells = grid->GetCells();
  return cells && 5 * grid->GetNumberOfPoints() > cells->GetNumberOfConnectivityIds();
}

std::vector<vtkIdType> weldsOf(vtkUnstructuredGrid* grid, PointSets& parts)
{
  const vtkIdType count = grid->GetNumberOfPoints();
  std::vector<vtkIdType> welds(static_cast<std::size_t>(count));
  if (count == 0)
    return {};
  vtkNew<vtkPolyData> cloud; // whose points are those of the grid; its cells would be copied
  cloud->SetPoints(grid->GetPoints());
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

} // namespace mote
