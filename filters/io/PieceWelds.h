#pragma once

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkUnstructuredGrid;

namespace mote
{

/// A grid that was put together of pieces, with one point where pieces have a copy each: cells of
/// two pieces are neighbours then. `ends` has, piece by piece, the number of points up to its end.
///
/// Points are copies where their coordinates are the same to the last bit. Where a piece has
/// several in one place, as on the two sides of a thin wall, the first is that of the first in
/// another piece and so on; in pieces that have not as many there they stay apart.
vtkSmartPointer<vtkUnstructuredGrid> welded(
  vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& ends);

} // namespace mote
