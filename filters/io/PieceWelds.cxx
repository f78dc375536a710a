#include "PieceWelds.h"

#include "DataParts.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <tbb/parallel_sort.h>

namespace mote
{

namespace
{

/// The bits of coordinates: these have an order even where they are no numbers.
using Place = std::array<std::uint64_t, 3>;

std::vector<Place> placesOf(vtkUnstructuredGrid* grid)
{
  std::vector<Place> places(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    double at[3];
    grid->GetPoint(static_cast<vtkIdType>(i), at);
    for (int c = 0; c < 3; ++c)
      places[i][c] = std::bit_cast<std::uint64_t>(at[c] + 0.0); // -0 is 0
  }
  return places;
}

/// The point that stands for each, which is itself or one of an earlier piece.
std::vector<vtkIdType> pointsFor(
  const std::vector<Place>& places, const std::vector<vtkIdType>& ends)
{
  std::vector<vtkIdType> order(places.size()), points(places.size());
  std::iota(order.begin(), order.end(), 0);
  std::iota(points.begin(), points.end(), 0);
  tbb::parallel_sort(order.begin(), order.end(),
    [&](vtkIdType a, vtkIdType b)
    { return places[a] != places[b] ? places[a] < places[b] : a < b; });
  const auto pieceOf = [&](vtkIdType point)
  { return std::upper_bound(ends.begin(), ends.end(), point) - ends.begin(); };
  for (auto begin = order.begin(); begin != order.end();)
  {
    const auto end = std::find_if(
      begin, order.end(), [&](vtkIdType point) { return places[point] != places[*begin]; });
    // Within a place the points of a piece follow one another, those of the first piece first.
    const auto lengthFrom = [&](auto at)
    {
      return std::find_if(
               at, end, [&](vtkIdType point) { return pieceOf(point) != pieceOf(*at); }) -
             at;
    };
    const auto first = end - begin > 1 ? lengthFrom(begin) : 1;
    for (auto at = begin + first; at < end;)
    {
      const auto length = lengthFrom(at);
      for (std::ptrdiff_t i = 0; i < length && length == first; ++i)
        points[at[i]] = begin[i];
      at += length;
    }
    begin = end;
  }
  return points;
}

/// A damaged file may have cells of points that it has not; what they are told of stays wrong.
vtkIdType numberOf(vtkIdType point, const std::vector<vtkIdType>& numbers)
{
  return point >= 0 && point < static_cast<vtkIdType>(numbers.size()) ? numbers[point] : point;
}

/// The cells with other points.
vtkSmartPointer<vtkCellArray> withPoints(vtkCellArray* cells, const std::vector<vtkIdType>& numbers)
{
  auto changed = vtkSmartPointer<vtkCellArray>::New();
  changed->DeepCopy(cells);
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, points);
    for (vtkIdType& point : *points)
      point = numberOf(point, numbers);
    changed->ReplaceCellAtId(cell, points);
  }
  return changed;
}

/// Streams of faces, each with its count of faces and each of these with its count of points.
vtkSmartPointer<vtkIdTypeArray> withPoints(
  vtkIdTypeArray* faces, const std::vector<vtkIdType>& numbers)
{
  if (!faces)
    return nullptr;
  auto changed = vtkSmartPointer<vtkIdTypeArray>::New();
  changed->DeepCopy(faces);
  const vtkIdType count = changed->GetNumberOfValues();
  vtkIdType* values = changed->GetPointer(0);
  for (vtkIdType i = 0; i < count;)
    for (vtkIdType left = values[i++]; left > 0 && i < count; --left)
      for (vtkIdType points = values[i++]; points > 0 && i < count; --points, ++i)
        values[i] = numberOf(values[i], numbers);
  return changed;
}

} // namespace

vtkSmartPointer<vtkUnstructuredGrid> welded(
  vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& ends)
{
  if (ends.size() < 2 || grid->GetNumberOfCells() == 0 || ends.back() != grid->GetNumberOfPoints())
    return grid;
  const std::vector<vtkIdType> points = pointsFor(placesOf(grid), ends);
  vtkNew<vtkIdList> kept;
  std::vector<vtkIdType> numbers(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    numbers[i] = points[i] == static_cast<vtkIdType>(i)
                   ? kept->InsertNextId(static_cast<vtkIdType>(i))
                   : numbers[points[i]];
  if (kept->GetNumberOfIds() == grid->GetNumberOfPoints())
    return grid;
  const auto some = pointsOf(grid, kept);
  auto whole = vtkSmartPointer<vtkUnstructuredGrid>::New();
  whole->SetPoints(some->GetPoints());
  whole->GetPointData()->ShallowCopy(some->GetPointData());
  whole->SetCells(grid->GetCellTypesArray(), withPoints(grid->GetCells(), numbers),
    grid->GetFaceLocations(), withPoints(grid->GetFaces(), numbers));
  whole->GetCellData()->ShallowCopy(grid->GetCellData());
  whole->GetFieldData()->ShallowCopy(grid->GetFieldData());
  return whole;
}

} // namespace mote
