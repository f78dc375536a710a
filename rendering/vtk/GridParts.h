#pragma once

#include "kernels/core/ArrayView.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <vector>

class vtkCellArray;
class vtkDataArray;
class vtkUnstructuredGrid;

namespace mote
{

/// Points in sets, which are joined.
class PointSets
{
public:
  explicit PointSets(vtkIdType points); ///< each a set of its own

  vtkIdType of(vtkIdType point); ///< the least point of its set
  void join(vtkIdType a, vtkIdType b);
  void joinCells(vtkUnstructuredGrid* grid); ///< the points of each cell

private:
  vtkIdType& up(vtkIdType point) { return up_[static_cast<std::size_t>(point)]; }

  std::vector<vtkIdType> up_;
};

/// Whether cells of a type are surfaces.
bool isFlatType(int type);

/// Whether triangles of a surface are of one set by the points that they share, of so many.
bool hangsTogether(const ArrayView& triangles, vtkIdType points);

/// Whether a grid has so many points that many cells must have their own, as those of discontinuous
/// values have.
bool hasManyPoints(vtkUnstructuredGrid* grid);

/// For each point of a grid the one that stands for it where cells of different parts, which are
/// `parts`, have points at one place, up to the rounding of float numbers about the middle of all:
/// the least of these. Where two points of one part are at a place, as on both sides of a thin
/// wall, all there stand for themselves. Empty where all do.
std::vector<vtkIdType> weldsOf(vtkUnstructuredGrid* grid, PointSets& parts);

/// The cells of a grid with the points that stand for theirs.
vtkSmartPointer<vtkCellArray> weldedCells(
  vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& welds);

/// Whether an array has one value for the points at each place, up to the rounding of float numbers
/// as large as its largest one.
bool haveOneValue(vtkDataArray* array, const std::vector<vtkIdType>& welds);

} // namespace mote
