#ifndef MoteFoamMesh_h
#define MoteFoamMesh_h

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

namespace mote
{

/// The folders (polyMesh) that the files of an OpenFOAM mesh lie in: that of its points, and that
/// of all others.
struct FoamMesh
{
  std::string points, faces;
  auto operator<=>(const FoamMesh&) const = default;
};

/// What checkFoamMesh() finds of a mesh.
struct FoamMeshFacts
{
  /// How many points there are, or faces if they are more: no field has more values in a place.
  std::int64_t places = 0;
  bool hasPlainPoints = true; ///< whose file holds what it says, which any reader can read
};

/// A file of a mesh as the reader finds it: under its own name, or else packed, with .gz behind it.
std::optional<std::string> findFoamFile(const std::string& folder, const std::string& name);

/// Throws FileError where the faces, owners and neighbours of a mesh do not fit together, so that
/// VTK 9.1's reader would crash or take very long, and where a file that is packed, with .gz, is
/// damaged. What that reader finds itself is left to it.
FoamMeshFacts checkFoamMesh(const FoamMesh& mesh);

/// Throws FileError where entries of a file of OpenFOAM lie in one another more than a hundred
/// deep. What is no file of OpenFOAM passes.
void checkFoamDepth(const std::string& path);

/// The same for a file of a time's folder, and where VTK 9.1's reader would take memory for lists
/// that the file has no room for, or would crash by what a field has on the boundary. A list of a
/// single value has at most `places` of a field, and as many as positions of a cloud (a file in
/// lagrangian/CLOUD).
void checkFoamFile(const std::string& path, std::int64_t places);

} // namespace mote

#endif
