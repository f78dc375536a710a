#ifndef MoteLegacyCheck_h
#define MoteLegacyCheck_h

#include <string>

namespace mote
{

/// Throws FileError where a VTK legacy file holds something other than points, grids, meshes
/// or blocks of these (OtherFormat), ends too early (Truncated) or breaks the rules of its
/// format (Malformed): words that are no keywords, types that there are not, text that is no
/// number, cells that do not fill their list, dimensions that the file has no room for. VTK 9.1's
/// readers crash then, or take memory for what is not there.
void checkLegacyVTK(const std::string& path);

} // namespace mote

#endif
