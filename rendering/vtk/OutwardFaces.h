#pragma once

class vtkIdTypeArray;
class vtkUnstructuredGrid;

namespace mote
{

struct SurfaceTriangles;

/// Turns the triangles of faces so that they look out of their cells: files have wedges in both
/// orders, mirrored meshes have all cells inside out, and polyhedra may have their faces as they
/// come. `corners` has three of each triangle of `surface`, whose own are not looked at; triangles
/// of a face follow one another.
void turnOutwards(vtkUnstructuredGrid* grid, vtkIdTypeArray* corners, SurfaceTriangles& surface);

} // namespace mote
