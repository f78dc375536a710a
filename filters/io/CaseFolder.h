#ifndef MoteCaseFolder_h
#define MoteCaseFolder_h

#include <string>

namespace mote
{

/// The file that stands for all that a folder holds: the index.xml of a Uintah data archive, or the
/// system/controlDict of an OpenFOAM case. For other paths the path itself.
std::string fileOfFolder(const std::string& path);

} // namespace mote

#endif
