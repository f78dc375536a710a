#ifndef MoteLocatorQueries_h
#define MoteLocatorQueries_h

#include "LocatorStructure.h"

#include "vtkGenericCell.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkDataSet;
class vtkPolyData;

namespace mote
{

/// The caller's cell, or one made for the call where there is none.
struct UsedCell
{
  explicit UsedCell(vtkGenericCell* given)
    : made(given ? nullptr : vtkSmartPointer<vtkGenericCell>::New())
    , cell(given ? given : made.Get())
  {
  }

  vtkSmartPointer<vtkGenericCell> made;
  vtkGenericCell* cell;
};

/// VTK's parametric coordinates of `p` in a cell of one of the HexCellTypes, and the interpolation
/// weights of its points (null if not wanted), by the cell's trilinear map; of a polyhedron, that
/// of the mesh's cell `part`.
void evaluate(const HexMesh& mesh, std::uint32_t part, vtkGenericCell* cell, const Vec3d& p,
  double pcoords[3], double* weights);

/// The input's cells that the line from `from` to `to` passes, each once, in the order of entry.
std::vector<vtkIdType> cellsAlong(
  const LocatorStructure& structure, const Vec3d& from, const Vec3d& to);

/// The first face of a cell on a line, at from + t (to - from): the cell is the one entered there,
/// or the one left where none is. HexMesh::noCell where there is no face on the way.
struct FaceHit
{
  std::uint32_t cell = HexMesh::noCell;
  double t = 0.0;
};
FaceHit firstFace(const LocatorStructure& structure, const Vec3d& from, const Vec3d& to);

/// The cell of `data` that is closest to `p`, within `radius`, by the distances that VTK's cells
/// tell; -1 for none. `scratch` is overwritten.
struct ClosestCell
{
  vtkIdType cell = -1; ///< the input's
  Vec3d point{0.0};
  double distance2 = 0.0;
  int subId = 0;
  bool inside = false;
};
ClosestCell closestCell(const LocatorStructure& structure, vtkDataSet* data, const Vec3d& p,
  double radius, vtkGenericCell* scratch);

/// Lines around what the structure covers.
void outline(const LocatorStructure& structure, vtkPolyData* lines);

} // namespace mote

#endif
