#ifndef MoteFoamMesh_h
#define MoteFoamMesh_h

#include <string>

namespace mote
{

/// Throws FileError where the faces, owners and neighbours of an OpenFOAM mesh (a folder polyMesh)
/// do not fit together, so that VTK 9.1's reader would crash or take very long, and where a file
/// that is packed, with .gz, is damaged. What that reader finds itself is left to it.
void checkFoamMesh(const std::string& folder);

/// Throws FileError where a file of OpenFOAM is a field whose part on the boundary is damaged in a
/// way that VTK 9.1's reader would crash by.
void checkFoamField(const std::string& path);

/// Throws FileError where entries of a file of OpenFOAM lie in one another more than a hundred
/// deep.
void checkFoamDepth(const std::string& path);

} // namespace mote

#endif
