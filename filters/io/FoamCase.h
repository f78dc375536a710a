#ifndef MoteFoamCase_h
#define MoteFoamCase_h

#include "FoamMesh.h"

#include <optional>
#include <string>
#include <vector>

namespace mote
{

/// Where an OpenFOAM case lies, and in which form.
struct FoamCase
{
  std::string folder;
  bool isDecomposed = false; ///< it is read from its folders processor0, processor1...
};

/// The case that a file belongs to: that in whose folder it lies, or, for a file in the folder
/// system, that of the folder above. Looks at folders alone. Throws FileError where there is no
/// mesh.
FoamCase foamCaseOf(const std::string& fileName);

/// The meshes of all regions, of a decomposed case of all processors, at the time that is nearest
/// to this one, or else at the first. A mesh that moves has new points in the folder of a time, one
/// whose cells change all files.
std::vector<FoamMesh> foamMeshesOf(const FoamCase& which, std::optional<double> time);

/// The files of the fields of the time that is nearest to this one.
std::vector<std::string> foamFieldsOf(const FoamCase& which, double time);
/// All files of the time that is nearest to this one, or else of the first, those of clouds of
/// particles with them.
std::vector<std::string> foamFilesOf(const FoamCase& which, std::optional<double> time);

} // namespace mote

#endif
