#pragma once

#include "vtkType.h"

#include <vector>

class vtkUnstructuredGrid;

namespace mote
{

struct SurfaceTriangles;

/// For each triangle of the surface of a grid's cells a number of the part that its cell is of:
/// cells that share a point, by any number of others between, are of one part. Empty where all are
/// of one.
std::vector<vtkIdType> partsOfSurface(const SurfaceTriangles& surface, vtkUnstructuredGrid* grid);

} // namespace mote
