#ifndef MoteGridSeams_h
#define MoteGridSeams_h

#include "vtkType.h"

#include <array>
#include <vector>

class vtkStructuredGrid;

namespace mote
{

/// Where a structured grid meets itself: the last points along an axis lie on the first ones, as
/// those of a grid around a body do (O), or a side is folded back onto itself, as in the wake of a
/// profile (C). For each point the one that stands for it, the least of its place; empty where all
/// stand for themselves.
///
/// Points count as one where they are a millionth of the grid's size from one another, a thousandth
/// of a cell, and all arrays have one value there, to a millionth of the largest on these sides: an
/// angle that goes from 0 to 360 degrees keeps them apart, and so does what jumps across a thin
/// plate. A side that is folded onto itself as a whole stays: it may be such a plate.
std::vector<vtkIdType> seamsOf(vtkStructuredGrid* grid, const std::array<vtkIdType, 3>& along);

} // namespace mote

#endif
