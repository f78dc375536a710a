#pragma once

#include "vtkType.h"

class vtkPolyData;

namespace mote
{

struct SurfaceTriangles;

/// Cuts the polygons and strips of `surface`, whose indices are those of points, into triangles:
/// `found` gets their corners, edges and cells, the first polygon being cell `first`. Polygons with
/// corners at one place, as cells beside an axis have them, are those of the other corners.
void cutPolygons(vtkPolyData* surface, vtkIdType first, SurfaceTriangles& found);

} // namespace mote
