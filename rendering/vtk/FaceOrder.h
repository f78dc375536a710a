#pragma once

class vtkIdTypeArray;

namespace mote
{

struct SurfaceTriangles;

/// Sorts faces by their cells and corners. VTK's filter gives them in an order that depends on its
/// threads, and where a ray meets the edge of two faces the first one is seen: pictures would not
/// be the same each time. `corners` has three of each triangle of `surface`, whose own are not
/// looked at.
void sortFaces(vtkIdTypeArray* corners, SurfaceTriangles& surface);

} // namespace mote
