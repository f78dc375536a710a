#pragma once

#include "vtkType.h"

#include <cstdint>
#include <vector>

class vtkPoints;

namespace mote
{

struct SurfaceTriangles;

/// Which triangles of the surface of cells with a volume are no walls, as smaller faces lie on the
/// other side of the same place: 1 for those of both sides; empty for none. Meshes that are refined
/// here and there have them, such as octrees: the face of a coarse cell meets four of finer cells,
/// with points that the coarse cell has not ("hanging nodes").
///
/// All corners of the larger face are corners of smaller ones, which look at it, lie within it, and
/// come to its area, up to a tenth: points that hang may follow a curved boundary. Thus the two
/// sides of a thin wall, whose points are not the same but at its rim, stay. `welds` are those of
/// weldsOf(), or empty.
std::vector<std::uint8_t> hangingFaces(
  const SurfaceTriangles& surface, vtkPoints* points, const std::vector<vtkIdType>& welds = {});

} // namespace mote
