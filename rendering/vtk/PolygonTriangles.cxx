#include "PolygonTriangles.h"

#include "SurfaceTriangles.h"

#include "kernels/core/Vec.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace mote
{

namespace
{

/// Finds which sides of triangles are edges of their polygons: those that no other triangle of the
/// polygon has the other way round. Triangles of a polygon follow one another.
void findEdges(SurfaceTriangles& found)
{
  const ArrayView& corners = found.corners.view;
  const std::size_t count = found.cells.size();
  const auto corner = [&](std::size_t i, std::size_t k) { return corners.value(3 * i + k % 3); };
  using Side = std::pair<double, double>;
  std::vector<Side> sides;
  found.edges.assign(count, 0);
  for (std::size_t first = 0, end = 0; first < count; first = end)
  {
    while (end < count && found.cells[end] == found.cells[first])
      ++end;
    sides.clear();
    for (std::size_t i = first; i < end; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        sides.emplace_back(corner(i, k), corner(i, k + 1));
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = first; i < end; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        if (!std::binary_search(sides.begin(), sides.end(), Side(corner(i, k + 1), corner(i, k))))
          found.edges[i] |= static_cast<std::uint8_t>(1U << k);
  }
}

/// The corners of a polygon that do not lie where the one before lies, as far as numbers that were
/// rounded tell.
std::vector<vtkIdType> distinctCorners(vtkPoints* points, vtkIdType count, const vtkIdType* all)
{
  std::vector<double> lengths; // from the corner before to each
  for (vtkIdType k = 0; k < count; ++k)
  {
    Vec3d from, to;
    points->GetPoint(all[k == 0 ? count - 1 : k - 1], &from[0]);
    points->GetPoint(all[k], &to[0]);
    lengths.push_back(glm::distance(from, to));
  }
  const double least = 1e-5 * *std::max_element(lengths.begin(), lengths.end());
  std::vector<vtkIdType> corners;
  for (std::size_t k = 0; k < lengths.size(); ++k)
    if (lengths[k] > least)
      corners.push_back(all[k]);
  return corners;
}

/// Corners of the triangles of a polygon; none where it is not one.
std::vector<vtkIdType> trianglesOf(vtkPoints* points, const std::vector<vtkIdType>& corners)
{
  if (corners.size() <= 3)
    return corners.size() == 3 ? corners : std::vector<vtkIdType>();
  vtkNew<vtkPolygon> polygon;
  for (const vtkIdType corner : corners)
    polygon->GetPoints()->InsertNextPoint(points->GetPoint(corner));
  polygon->GetPointIds()->SetNumberOfIds(static_cast<vtkIdType>(corners.size()));
  std::iota(polygon->GetPointIds()->begin(), polygon->GetPointIds()->end(), 0);
  vtkNew<vtkIdList> places;
  std::vector<vtkIdType> triangles;
  if (polygon->Triangulate(places) != 0)
    for (const vtkIdType place : *places)
      triangles.push_back(corners[static_cast<std::size_t>(place)]);
  return triangles;
}

/// Cuts those polygons anew of which VTK's filter has lost triangles, for corners that lie at one
/// place; `cells` counts polygons from 0 on, in ascending order.
void mendPolygons(vtkPolyData* surface, SurfaceTriangles& found)
{
  vtkCellArray* polygons = surface->GetPolys();
  const vtkIdType count = polygons->GetNumberOfCells();
  std::vector<vtkIdType> cut(static_cast<std::size_t>(surface->GetNumberOfCells()), 0);
  for (const vtkIdType cell : found.cells)
    ++cut[static_cast<std::size_t>(cell)];
  const auto isShort = [&](vtkIdType cell)
  { return cell < count && cut[static_cast<std::size_t>(cell)] < polygons->GetCellSize(cell) - 2; };
  vtkIdType cell = 0;
  while (cell < count && !isShort(cell))
    ++cell;
  if (cell == count)
    return;
  vtkNew<vtkIdTypeArray> corners;
  std::vector<vtkIdType> cells;
  std::size_t next = 0; // of the triangles as they are
  for (cell = 0; cell < static_cast<vtkIdType>(cut.size()); ++cell)
  {
    std::vector<vtkIdType> mended;
    if (isShort(cell))
    {
      vtkIdType size = 0;
      const vtkIdType* all = nullptr;
      polygons->GetCellAtId(cell, size, all);
      mended = trianglesOf(surface->GetPoints(), distinctCorners(surface->GetPoints(), size, all));
    }
    const std::size_t end = next + static_cast<std::size_t>(cut[static_cast<std::size_t>(cell)]);
    if (mended.empty())
      for (std::size_t i = 3 * next; i < 3 * end; ++i)
        mended.push_back(static_cast<vtkIdType>(found.corners.view.value(i)));
    next = end;
    for (const vtkIdType corner : mended)
      corners->InsertNextValue(corner);
    cells.insert(cells.end(), mended.size() / 3, cell);
  }
  found.corners = DataArrayView(corners);
  found.cells = std::move(cells);
}

} // namespace

void cutPolygons(vtkPolyData* surface, vtkIdType first, SurfaceTriangles& found)
{
  vtkNew<vtkPolyData> faces;
  faces->SetPoints(surface->GetPoints());
  faces->SetPolys(surface->GetPolys());
  faces->SetStrips(surface->GetStrips());
  const vtkIdType count = faces->GetNumberOfCells();
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("MoteCellIds");
  numbers->SetNumberOfValues(count);
  std::iota(numbers->GetPointer(0), numbers->GetPointer(0) + count, 0);
  faces->GetCellData()->AddArray(numbers);
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(faces);
  filter->Update();
  vtkPolyData* triangles = filter->GetOutput();
  found.corners = DataArrayView(triangles->GetPolys()->GetConnectivityArray());
  auto* const cells =
    vtkIdTypeArray::SafeDownCast(triangles->GetCellData()->GetArray(numbers->GetName()));
  if (cells)
    found.cells.assign(cells->GetPointer(0), cells->GetPointer(0) + triangles->GetNumberOfPolys());
  mendPolygons(faces, found);
  std::vector<vtkIdType> met = found.cells; // triangles of a cell follow one another
  met.erase(std::unique(met.begin(), met.end()), met.end());
  found.flat = count - static_cast<vtkIdType>(met.size());
  for (vtkIdType& cell : found.cells)
    cell += first;
  findEdges(found);
}

} // namespace mote
