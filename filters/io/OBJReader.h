#ifndef MoteOBJReader_h
#define MoteOBJReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;

namespace mote
{

/// A vtkOBJReader that reads what VTK 9.1's loses or answers with a crash: faces of which some have
/// texture coordinates or normals and others none, colours of vertices, coordinates far from the
/// origin, damaged files (see readOBJ()), and gzip.
///
/// Output: vtkPolyData with the vertices in their order, in double where float would move them by
/// more than a millionth of the mesh's size, and vertices with a second normal once more behind
/// them; polygons, lines and vertices. Point data: "Normals" where all faces have them, "RGB" (0 to
/// 255). Cell data, where there are two or more of a kind: "MaterialIds", "GroupIds", "ObjectIds",
/// in the order in which the file first names them, with field data such as "MaterialNames".
/// Texture coordinates and curves are not read.
vtkSmartPointer<vtkAlgorithm> makeOBJReader(const std::string& fileName);

} // namespace mote

#endif
