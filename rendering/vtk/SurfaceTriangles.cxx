#include "SurfaceTriangles.h"

#include "CollapsedCells.h"
#include "FaceOrder.h"
#include "GridParts.h"
#include "OutwardFaces.h"
#include "PolygonTriangles.h"
#include "QuadsOnTriangles.h"

#include "kernels/core/Error.h"
#include "kernels/core/Vec.h"
#include "kernels/hexahedra/HangingFaces.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkGeometryFilter.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkThreshold.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mote
{

namespace
{

// VTK 9.1's own numbers of points and cells are wrong where cells are not linear.
const char* const pointIds = "MotePointIds";
const char* const cellIds = "MoteCellIds";
const char* const visibleCells = "MoteVisibleCells";

vtkSmartPointer<vtkIdTypeArray> numbers(const char* name, vtkIdType first, vtkIdType count)
{
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName(name);
  ids->SetNumberOfValues(count);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + count, first);
  return ids;
}

vtkIdTypeArray* idsOf(vtkDataSetAttributes* data, const char* name)
{
  return vtkIdTypeArray::SafeDownCast(data->GetArray(name));
}

/// VTK's filters do not look.
void checkIndices(vtkCellArray* cells, vtkIdType points)
{
  if (!cells || cells->GetNumberOfConnectivityIds() == 0)
    return;
  double range[2];
  cells->GetConnectivityArray()->GetRange(range);
  if (range[0] < 0.0 || range[1] >= static_cast<double>(points))
    throw Error("A cell has point " +
                std::to_string(static_cast<long long>(range[0] < 0.0 ? range[0] : range[1])) +
                ", but there are " + std::to_string(points) + " points.");
}

SurfaceTriangles trianglesOf(vtkPolyData* surface)
{
  SurfaceTriangles found;
  found.thin = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  vtkCellArray* polygons = surface->GetPolys();
  if (surface->GetNumberOfPolys() + surface->GetNumberOfStrips() == 0)
    return found;
  const vtkIdType points = surface->GetNumberOfPoints();
  checkIndices(polygons, points);
  checkIndices(surface->GetStrips(), points);
  if (surface->GetNumberOfStrips() > 0 || polygons->IsHomogeneous() != 3)
  {
    cutPolygons(surface, found.thin, found);
    return found;
  }
  found.corners = DataArrayView(polygons->GetConnectivityArray());
  if (found.thin > 0) // cells are counted over all kinds, triangles after lines
  {
    found.cells.resize(static_cast<std::size_t>(surface->GetNumberOfPolys()));
    std::iota(found.cells.begin(), found.cells.end(), found.thin);
  }
  return found;
}

vtkIdType cellOf(const SurfaceTriangles& found, std::size_t triangle)
{
  return found.cells.empty() ? static_cast<vtkIdType>(triangle) : found.cells[triangle];
}

/// Leaves out triangles for which isOut(triangle).
template <typename IsOut>
void drop(SurfaceTriangles& found, const IsOut& isOut)
{
  const std::size_t count = found.corners.view.empty() ? 0 : found.view().count();
  vtkNew<vtkIdTypeArray> corners;
  std::vector<vtkIdType> cells;
  std::vector<std::uint8_t> edges;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (isOut(i))
      continue;
    for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
      corners->InsertNextValue(static_cast<vtkIdType>(found.corners.view.value(k)));
    cells.push_back(cellOf(found, i));
    if (!found.edges.empty())
      edges.push_back(found.edges[i]);
  }
  if (cells.size() == count)
    return;
  found.corners = DataArrayView(corners);
  found.cells = std::move(cells);
  found.edges = std::move(edges);
}

/// Leaves out triangles of cells that have one of the marks. vtkPolyData::RemoveGhostCells() keeps
/// the hidden ones, in VTK 9.1.
void dropMarked(vtkUnsignedCharArray* ghosts, int marks, SurfaceTriangles& found)
{
  drop(found,
    [&](std::size_t triangle)
    {
      const vtkIdType cell = cellOf(found, triangle);
      return cell < ghosts->GetNumberOfValues() && (ghosts->GetValue(cell) & marks) != 0;
    });
}

void copyGhosts(vtkDataSetAttributes* from, vtkDataSetAttributes* to)
{
  if (vtkDataArray* ghosts = from->GetArray(vtkDataSetAttributes::GhostArrayName()))
    to->AddArray(ghosts);
}

/// The cells that are visible; `isVisible` has no name that the arrays of cells have.
vtkSmartPointer<vtkPointSet> visibleOf(vtkPointSet* shape, vtkUnsignedCharArray* isVisible)
{
  vtkNew<vtkUnsignedCharArray> named;
  named->ShallowCopy(isVisible);
  named->SetName(visibleCells);
  shape->GetCellData()->AddArray(named);
  vtkNew<vtkThreshold> threshold;
  threshold->SetInputData(shape);
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, visibleCells);
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  threshold->SetUpperThreshold(1.0);
  threshold->Update();
  return threshold->GetOutput();
}

/// Gives triangles the points of their own cells again.
void unweld(vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& welds, vtkIdTypeArray* corners,
  const std::vector<vtkIdType>& cells)
{
  vtkNew<vtkIdList> ofCell;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    grid->GetCellPoints(cells[i], ofCell);
    vtkIdType* const of = corners->GetPointer(3 * static_cast<vtkIdType>(i));
    for (vtkIdType k = 0; k < ofCell->GetNumberOfIds(); ++k)
      if (const vtkIdType own = ofCell->GetId(k), weld = welds[static_cast<std::size_t>(own)];
          weld != own)
        std::replace(of, of + 3, weld, own);
  }
}

/// The cells of a data set that are visible, with ghosts and their numbers; where cells have
/// `welds` in common, with the points that these stand for.
vtkSmartPointer<vtkPointSet> shapeOf(
  vtkPointSet* data, vtkUnsignedCharArray* isVisible, const std::vector<vtkIdType>& welds)
{
  vtkSmartPointer<vtkPointSet> shape;
  shape.TakeReference(data->NewInstance());
  shape->CopyStructure(data);
  if (!welds.empty())
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
    vtkUnstructuredGrid::SafeDownCast(shape)->SetCells(
      grid->GetCellTypesArray(), weldedCells(grid, welds));
  }
  copyGhosts(data->GetCellData(), shape->GetCellData());
  copyGhosts(data->GetPointData(), shape->GetPointData());
  shape->GetPointData()->AddArray(numbers(pointIds, 0, data->GetNumberOfPoints()));
  shape->GetCellData()->AddArray(numbers(cellIds, 0, data->GetNumberOfCells()));
  return isVisible ? visibleOf(shape, isVisible) : shape;
}

/// Triangles of the faces, in points and cells of `data`; where cells have `welds` in common these
/// are not between them.
SurfaceTriangles trianglesOfFaces(
  vtkPointSet* data, vtkUnsignedCharArray* isVisible, const std::vector<vtkIdType>& welds = {})
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  vtkSmartPointer<vtkPointSet> shape = shapeOf(data, isVisible, welds);
  auto* cellsOfShape = vtkUnstructuredGrid::SafeDownCast(shape);
  const bool isCollapsed = cellsOfShape && hasCollapsedCells(cellsOfShape);
  SurfaceTriangles found;
  if (isCollapsed)
    found = surfaceOfCollapsedCells(cellsOfShape);
  else
  {
    vtkNew<vtkGeometryFilter> filter;
    filter->SetInputData(shape);
    filter->Update();
    shape = filter->GetOutput();
    found = trianglesOf(filter->GetOutput());
  }
  const vtkIdType count =
    found.corners.view.empty() ? 0 : static_cast<vtkIdType>(found.view().count());
  const vtkIdTypeArray* points = idsOf(shape->GetPointData(), pointIds);
  const vtkIdTypeArray* cells = idsOf(shape->GetCellData(), cellIds);
  if (count == 0 || !points || !cells)
    return found;
  const bool own = found.cells.empty();
  found.cells.resize(static_cast<std::size_t>(count));
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(3 * count);
  const ArrayView& old = found.corners.view;
  for (vtkIdType i = 0; i < 3 * count; ++i)
    corners->SetValue(
      i, points->GetValue(static_cast<vtkIdType>(old.value(static_cast<std::size_t>(i)))));
  for (vtkIdType i = 0; i < count; ++i)
  {
    vtkIdType& cell = found.cells[static_cast<std::size_t>(i)];
    cell = cells->GetValue(own ? i : cell);
  }
  if (!isCollapsed)
    sortFaces(corners, found);
  if (!welds.empty())
    unweld(grid, welds, corners, found.cells);
  if (grid && !isCollapsed)
    turnOutwards(grid, corners, found);
  found.corners = DataArrayView(corners);
  return found;
}

void append(const SurfaceTriangles& more, SurfaceTriangles& all)
{
  vtkNew<vtkIdTypeArray> corners;
  for (const SurfaceTriangles* one : {&std::as_const(all), &more})
    for (std::size_t i = 0; i < 3 * one->cells.size(); ++i)
      corners->InsertNextValue(static_cast<vtkIdType>(one->corners.view.value(i)));
  // Where one has no edges all sides of its triangles are.
  if (!all.edges.empty() || !more.edges.empty())
  {
    all.edges.resize(all.cells.size(), 7);
    all.edges.insert(all.edges.end(), more.edges.begin(), more.edges.end());
    all.edges.resize(all.cells.size() + more.cells.size(), 7);
  }
  all.corners = DataArrayView(corners);
  all.cells.insert(all.cells.end(), more.cells.begin(), more.cells.end());
  all.thin += more.thin;
  all.flat += more.flat;
}

/// The same without faces that finer ones cover. Of a grid that has both, flat cells but for those
/// that lie on faces of cells with a volume: VTK leaves out these faces, and flat cells look either
/// way.
SurfaceTriangles trianglesOfMixed(
  vtkUnstructuredGrid* grid, vtkUnsignedCharArray* isVisible, const std::vector<vtkIdType>& welds)
{
  const vtkIdType count = grid->GetNumberOfCells();
  vtkNew<vtkUnsignedCharArray> isFlat, isOther;
  bool has[2] = {false, false}; // others, and flat ones
  for (vtkUnsignedCharArray* one : {isFlat.Get(), isOther.Get()})
    one->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const bool flat = isFlatType(grid->GetCellType(i));
    const int visible = !isVisible || isVisible->GetValue(i) != 0 ? 1 : 0;
    isFlat->SetValue(i, static_cast<unsigned char>(flat ? visible : 0));
    isOther->SetValue(i, static_cast<unsigned char>(flat ? 0 : visible));
    has[flat] = true;
  }
  if (!has[0])
    return trianglesOfFaces(grid, isVisible, welds);
  SurfaceTriangles found = trianglesOfFaces(grid, has[1] ? isOther.Get() : isVisible, welds);
  found.flat = 0; // faces without an area, which nobody misses
  const DataArrayView points(grid->GetPoints()->GetData());
  dropTriangles(found, hangingFaces({found.view(), points.view, found.edges, welds}));
  dropTriangles(found, quadsOnTriangles(found, grid, isVisible, welds));
  if (!has[1])
    return found;
  append(trianglesOfFaces(grid, isFlat), found);
  if (!found.cells.empty() && !isFlatType(grid->GetCellType(found.cells.front())))
    found.thin = 0; // likewise, beside cells with a volume
  dropTriangles(found, flatOnFaces(found, grid));
  return found;
}

/// The same of a grid, but for faces between its parts, whether these have the same points there or
/// others.
SurfaceTriangles trianglesOfParts(vtkUnstructuredGrid* grid, vtkUnsignedCharArray* isVisible)
{
  checkIndices(grid->GetCells(), grid->GetNumberOfPoints());
  std::optional<PointSets> parts;
  const auto findParts = [&]
  {
    parts.emplace(grid->GetNumberOfPoints());
    parts->joinCells(grid);
  };
  std::vector<vtkIdType> welds; // without which every cell may show all of its faces
  if (hasManyPoints(grid))
  {
    findParts();
    welds = weldsOf(grid, *parts);
  }
  SurfaceTriangles found = trianglesOfMixed(grid, isVisible, welds);
  if (!parts && !hangsTogether(found.view(), grid->GetNumberOfPoints()))
    findParts();
  if (parts)
    dropTriangles(found, coveredByParts(found, grid->GetPoints(), *parts));
  return found;
}

} // namespace

void dropTriangles(SurfaceTriangles& triangles, const std::vector<std::uint8_t>& marks)
{
  if (!marks.empty())
    drop(triangles, [&](std::size_t triangle) { return marks[triangle] != 0; });
}

ArrayView SurfaceTriangles::view() const
{
  if (corners.view.empty())
    return {};
  return {corners.view.data(), corners.view.type(), corners.view.count() / 3, 3};
}

SurfaceTriangles surfaceTrianglesOf(
  vtkPointSet* data, vtkUnsignedCharArray* isVisible, const SectorCopies& copies, bool withGhosts)
{
  auto* surface = vtkPolyData::SafeDownCast(data);
  if (!surface)
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
    SurfaceTriangles found =
      grid ? trianglesOfParts(grid, isVisible) : trianglesOfFaces(data, isVisible);
    if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
      found.flat = structured->GetDataDimension() == 3 ? 0 : found.flat;
    dropTriangles(found, coveredByCopies(found, data->GetPoints(), copies));
    return found;
  }
  SurfaceTriangles found = trianglesOf(surface);
  if (vtkUnsignedCharArray* ghosts = surface->GetCellGhostArray())
    dropMarked(ghosts,
      vtkDataSetAttributes::HIDDENCELL | (withGhosts ? 0 : vtkDataSetAttributes::DUPLICATECELL),
      found);
  if (isVisible)
    drop(found,
      [&](std::size_t triangle) { return isVisible->GetValue(cellOf(found, triangle)) == 0; });
  return found;
}

} // namespace mote
