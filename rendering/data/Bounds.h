#pragma once

#include "kernels/core/Box.h"

#include "vtkMath.h"

namespace mote
{

/// A box as VTK has bounds; uninitialized ones where it is empty.
inline void copyBounds(const Box& box, double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  for (int axis = 0; axis < 3 && !box.empty(); ++axis)
  {
    bounds[2 * axis] = box.lower[axis];
    bounds[2 * axis + 1] = box.upper[axis];
  }
}

} // namespace mote
