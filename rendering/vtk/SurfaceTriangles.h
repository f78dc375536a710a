#pragma once

#include "DataArrayView.h"
#include "SurfaceSeams.h"

#include <cstdint>
#include <vector>

class vtkPointSet;
class vtkUnsignedCharArray;

namespace mote
{

/// The triangles of a data set's surface: polygons are cut into triangles, of cells with a volume
/// the faces that no other cell shares are taken.
struct SurfaceTriangles
{
  DataArrayView corners;        ///< three indices of the data set's points each, one after another
  std::vector<vtkIdType> cells; ///< the data set's cell of each; empty: triangles are cells
  /// Which sides of each triangle are edges of its polygon: bit k from corner k on. Empty: all.
  std::vector<std::uint8_t> edges;
  vtkIdType thin = 0; ///< lines and vertices
  vtkIdType flat = 0; ///< polygons and strips that have no triangle

  /// Three indices a tuple.
  ArrayView view() const;
};

/// Of all cells, or of those alone for which `isVisible` is not 0: as if the others were not there.
/// Of cells with a volume without the faces that copies of a sector cover, or other parts of the
/// grid. Polygons that are ghosts, copies of what another rank has, are left out but `withGhosts`.
/// Throws Error where a cell has a point that the data set has not.
SurfaceTriangles surfaceTrianglesOf(vtkPointSet* data, vtkUnsignedCharArray* isVisible = nullptr,
  const SectorCopies& copies = {}, bool withGhosts = false);

/// Leaves out the triangles that are marked; none where there are no marks.
void dropTriangles(SurfaceTriangles& triangles, const std::vector<std::uint8_t>& marks);

} // namespace mote
