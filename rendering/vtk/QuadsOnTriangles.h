#pragma once

#include <cstdint>
#include <vector>

#include "vtkType.h"

class vtkUnsignedCharArray;
class vtkUnstructuredGrid;

namespace mote
{

struct SurfaceTriangles;

/// Which triangles of a grid's surface are those of a quadrilateral that two triangles of cells on
/// the other side make up, as where a hexahedron meets tetrahedra without a pyramid between: 1 for
/// them; empty for none. VTK 9.1's filter of surfaces takes away these two triangles and keeps the
/// quadrilateral, which is no wall either. `welds` are those of weldsOf(), or empty.
std::vector<std::uint8_t> quadsOnTriangles(const SurfaceTriangles& surface,
  vtkUnstructuredGrid* grid, vtkUnsignedCharArray* isVisible, const std::vector<vtkIdType>& welds);

} // namespace mote
