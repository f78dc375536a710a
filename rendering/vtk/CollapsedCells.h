#pragma once

class vtkUnstructuredGrid;

namespace mote
{

struct SurfaceTriangles;

/// Whether a grid of hexahedra, voxels, wedges, pyramids and tetrahedra alone, without ghosts, has
/// cells that name a point twice: hexahedra about an axis or a pole, whose faces there are
/// triangles. VTK 9.1's filter of surfaces loses these.
bool hasCollapsedCells(vtkUnstructuredGrid* grid);

/// The surface of such a grid, in its points and cells; its triangles look outwards. Throws Error
/// as HexMesh does.
SurfaceTriangles surfaceOfCollapsedCells(vtkUnstructuredGrid* grid);

} // namespace mote
