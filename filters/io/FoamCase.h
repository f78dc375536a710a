#ifndef MoteFoamCase_h
#define MoteFoamCase_h

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
/// system, that of the folder above. Looks at folders and at what the files of the mesh say of
/// themselves. Throws FileError where there is no mesh, and where the mesh is damaged so that VTK
/// 9.1's reader would crash or run for very long.
FoamCase foamCaseOf(const std::string& fileName);

/// The files of the fields of the time that is nearest to this one.
std::vector<std::string> foamFieldsOf(const FoamCase& which, double time);
/// All files of the time that is nearest to this one, or else of the first, those of clouds of
/// particles with them.
std::vector<std::string> foamFilesOf(const FoamCase& which, std::optional<double> time);

} // namespace mote

#endif
