#pragma once

#include "vtkBoundingBox.h"

#include <vector>

class vtkMultiProcessController;
class vtkPointSet;

namespace mote
{

/// The bounds of the points that are no ghosts; invalid where there are none.
vtkBoundingBox ownBoundsOf(vtkPointSet* points);

/// The boxes of all ranks, which must ask together.
std::vector<vtkBoundingBox> gatherBoxes(
  vtkMultiProcessController* controller, const vtkBoundingBox& own);

/// Writes down the box that a rank has all particles of, where ParaView can order it and those of
/// others from any view.
void keepBox(const vtkBoundingBox& box, vtkPointSet* points);

/// The one written down; invalid where none is.
vtkBoundingBox keptBoxOf(vtkPointSet* points);

/// Whether the ranks of ParaView, which must ask together, have boxes and ghosts, so that what
/// covers a part of a pixel may be blended in the order of the boxes.
bool canBlendInOrder(vtkPointSet* points);

} // namespace mote
