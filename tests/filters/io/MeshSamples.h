#ifndef MoteMeshSamples_h
#define MoteMeshSamples_h

#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkStructuredGrid;
class vtkUnstructuredGrid;

/// Small meshes as the programs of engineers write them. They all are a box of 3 x 2 x 2 cells of
/// size 1, with the point array p = x + 10 y + 100 z, the cell array q, a cell's number from 0, and
/// the cell array U = (time, q, 0).
namespace samples
{

constexpr std::array<int, 3> cells = {3, 2, 2};

vtkSmartPointer<vtkUnstructuredGrid> box(double time = 0.0);

/// The same as a structured grid; left-handed, its first axis points the other way.
vtkSmartPointer<vtkStructuredGrid> structuredBox(bool isLeftHanded = false);

/// How an OpenFOAM case is written.
struct Foam
{
  bool isBinary = false;
  int processor =
    -1; ///< 0 or 1: of a case that is decomposed, the half with the inlet, or the other
  bool isMoving = false; ///< at the time 0.5 the mesh is written anew, 1 further along x
  bool hasCloud = false; ///< at the time 0.5 there are the particles spray, with d and rho
};

/// Writes a case into a folder: a mesh with the patches inlet, outlet and walls, and at the times
/// 0 and 0.5 the fields p (a cell's number + time) and U, which is uniform at the time 0. Returns
/// the name of its .foam file.
std::string writeFoam(const std::string& folder, const Foam& how = {});

/// Writes two such boxes, one behind the other, as a case that is decomposed for two processors.
std::string writeDecomposedFoam(const std::string& folder, bool isBinary);

/// Writes an EnSight Gold case of two steps, at 0 and 0.5: the box as the part fluid, and its faces
/// at the least x as the part inlet, with the fields p and U. Returns the .case file.
std::string writeEnSight(const std::string& folder, bool isBinary);

/// Writes an EnSight Gold case of two steps, at 0 and 0.5, that lie in one file: a triangle in the
/// part all, with the field p. Returns the .case file.
std::string writeEnSightSteps(const std::string& folder, bool isBinary);

/// Writes a CGNS file of two steps, at 0 and 0.5: an unstructured zone fluid with the patches inlet
/// and walls, and beside it a structured zone rotor; the field q of cells.
void writeCGNS(const std::string& file);

} // namespace samples

#endif
