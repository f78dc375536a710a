#pragma once

#include "vtkBoundingBox.h"

#include <vector>

class vtkInformation;
class vtkMatrix4x4;
class vtkMultiProcessController;
class vtkPVDataRepresentation;
class vtkPointSet;

namespace mote
{

/// The bounds of the points that are no ghosts, or of a surface's cells that are none; invalid
/// where there are none.
vtkBoundingBox ownBoundsOf(vtkPointSet* points);

/// The boxes of all ranks, which must ask together.
std::vector<vtkBoundingBox> gatherBoxes(
  vtkMultiProcessController* controller, const vtkBoundingBox& own);

/// The box of this rank of ParaView, cut where it overlaps those of others: pieces of a mesh have
/// uneven sides, and ParaView finds no order of boxes that overlap. All ranks must ask together.
vtkBoundingBox withoutOverlap(const vtkBoundingBox& own);

/// Tells a view where a representation is, after its matrix, and by which box ParaView orders the
/// ranks. Boxes that are not valid stand for no data.
void tellBounds(vtkInformation* info, vtkPVDataRepresentation* representation,
  const vtkBoundingBox& bounds, const vtkBoundingBox& order, vtkMatrix4x4* matrix = nullptr);

/// Writes down the box that a rank has all particles of, or all polygons, which reach out of it.
void keepBox(const vtkBoundingBox& box, vtkPointSet* points);

/// The one written down; invalid where none is.
vtkBoundingBox keptBoxOf(vtkPointSet* points);

/// What all ranks of ParaView together have; one rank has neither.
struct RankFacts
{
  bool haveBoxes = false;  ///< that were written down, and nothing has moved out of since
  bool haveGhosts = false; ///< any of them
};

/// All ranks must ask together.
RankFacts factsOfRanks(vtkPointSet* points);

} // namespace mote
