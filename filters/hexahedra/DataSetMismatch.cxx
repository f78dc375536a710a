#include "DataSetMismatch.h"

#include "DataSetParts.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>

namespace mote
{

namespace
{

using Range = tbb::blocked_range<vtkIdType>;

/// The first i below `count` with isWrong(i), or `count`. In parallel.
template <class Wrong>
vtkIdType firstWrong(vtkIdType count, const Wrong& isWrong)
{
  return tbb::parallel_reduce(
    Range(0, count, 1 << 16), count,
    [&](const Range& range, vtkIdType first)
    {
      for (vtkIdType i = range.begin(); i < std::min(range.end(), first); ++i)
        if (isWrong(i))
          return i;
      return first;
    },
    [](vtkIdType a, vtkIdType b) { return std::min(a, b); });
}

/// What is wrong with cells over so many points.
template <class Array>
std::string mismatchOf(Array* offsets, Array* connectivity, vtkIdType points)
{
  const vtkIdType cells = offsets->GetNumberOfValues() - 1;
  const vtkIdType size = connectivity->GetNumberOfValues();
  const auto* const begin = offsets->GetPointer(0);
  const auto* const ids = connectivity->GetPointer(0);
  const auto isBadEnd = [&](vtkIdType c)
  { return begin[c] < 0 || begin[c] > begin[c + 1] || begin[c + 1] > size; };
  if (const vtkIdType cell = firstWrong(cells, isBadEnd); cell < cells)
    return "cell " + std::to_string(cell) + " has no place in the list of the cells' points";
  const vtkIdType at =
    firstWrong(size, [&](vtkIdType i) { return ids[i] < 0 || ids[i] >= points; });
  if (at == size)
    return {};
  const auto* const after = std::upper_bound(begin, begin + cells + 1, at);
  return "cell " + std::to_string(after - begin - 1) + " names the point " +
         std::to_string(ids[at]) + ", and there are " + std::to_string(points) + " points";
}

std::string mismatchOf(vtkCellArray* cells, vtkIdType points)
{
  if (!cells || cells->GetNumberOfCells() == 0)
    return {};
  return cells->IsStorage64Bit()
           ? mismatchOf(cells->GetOffsetsArray64(), cells->GetConnectivityArray64(), points)
           : mismatchOf(cells->GetOffsetsArray32(), cells->GetConnectivityArray32(), points);
}

/// What is wrong with the faces of polyhedra over so many points.
std::string mismatchOf(
  vtkIdTypeArray* faces, vtkIdTypeArray* locations, vtkIdType cells, vtkIdType points)
{
  if (const vtkIdType count = locations->GetNumberOfValues(); count != cells)
    return "there are " + std::to_string(count) + " places of faces for " + std::to_string(cells) +
           " cells";
  const vtkIdType* const of = faces->GetPointer(0);
  const vtkIdType size = faces->GetNumberOfValues();
  const auto isBad = [&](vtkIdType cell)
  {
    vtkIdType at = locations->GetValue(cell);
    if (at < 0)
      return false;
    if (at >= size)
      return true;
    const vtkIdType count = of[at++];
    for (vtkIdType face = 0; face < count; ++face)
    {
      if (at >= size || of[at] > size - at - 1)
        return true;
      const vtkIdType* const begin = of + at + 1;
      at += 1 + std::max<vtkIdType>(0, of[at]);
      if (std::any_of(begin, of + at, [=](vtkIdType id) { return id < 0 || id >= points; }))
        return true;
    }
    return false;
  };
  const vtkIdType cell = firstWrong(cells, isBad);
  return cell == cells
           ? ""
           : "cell " + std::to_string(cell) + " has faces that are not in the list of faces, or " +
               "that name points that are not there";
}

std::string mismatchOf(vtkPolyData* data)
{
  // In the order of the cells' numbers.
  for (vtkCellArray* cells :
    {data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips()})
    if (const std::string found = mismatchOf(cells, data->GetNumberOfPoints()); !found.empty())
      return found;
  return {};
}

std::string asText(const int dimensions[3])
{
  return std::to_string(dimensions[0]) + " x " + std::to_string(dimensions[1]) + " x " +
         std::to_string(dimensions[2]) + " points";
}

std::string mismatchOf(vtkRectilinearGrid* grid)
{
  const int* dimensions = grid->GetDimensions();
  vtkDataArray* const along[3] = {
    grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates()};
  for (int k = 0; k < 3; ++k)
    if (const vtkIdType count = along[k] ? along[k]->GetNumberOfTuples() : 0;
        count != dimensions[k])
      return "the grid has " + asText(dimensions) + ", and " + std::to_string(count) + " " +
             "XYZ"[k] + " coordinates";
  return {};
}

std::string mismatchOf(vtkStructuredGrid* grid)
{
  int dimensions[3];
  grid->GetDimensions(dimensions);
  const vtkIdType wanted = vtkIdType{dimensions[0]} * dimensions[1] * dimensions[2];
  const vtkIdType count = grid->GetNumberOfPoints();
  return count == wanted ? ""
                         : "the grid has " + asText(dimensions) + ", and places for " +
                             std::to_string(count) + " of them";
}

bool hasPolyhedra(vtkUnstructuredGrid* grid)
{
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    if (grid->GetCellType(i) == VTK_POLYHEDRON)
      return true;
  return false;
}

std::string mismatchOf(vtkDataSet* data)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    const std::string found = mismatchOf(grid->GetCells(), grid->GetNumberOfPoints());
    vtkIdTypeArray *const faces = grid->GetFaces(), *const locations = grid->GetFaceLocations();
    // Readers of pieces leave empty lists, and lose the faces of polyhedra.
    const bool hasFaces =
      faces && locations && faces->GetNumberOfValues() + locations->GetNumberOfValues() > 0;
    if (!hasFaces && hasPolyhedra(grid))
      return "the faces of polyhedra are missing";
    return found.empty() && hasFaces
             ? mismatchOf(faces, locations, grid->GetNumberOfCells(), grid->GetNumberOfPoints())
             : found;
  }
  if (auto* surface = vtkPolyData::SafeDownCast(data))
    return mismatchOf(surface);
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
    return mismatchOf(grid);
  if (auto* grid = vtkStructuredGrid::SafeDownCast(data))
    return mismatchOf(grid);
  return {};
}

} // namespace

std::string mismatchOf(vtkDataObject* object)
{
  for (const DataSetPart& part : partsOf(object))
    if (const std::string found = mismatchOf(part.data); !found.empty())
      return found;
  return {};
}

} // namespace mote
