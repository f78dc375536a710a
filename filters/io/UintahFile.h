#ifndef MoteUintahFile_h
#define MoteUintahFile_h

#include "StepSource.h"

namespace mote
{

/// Whether a text begins like the index.xml of a Uintah data archive (UDA).
bool looksLikeUintah(std::string_view beginning);

/// The particles of a Uintah data archive, by its index.xml: for each step a file of XML a
/// processor, which says where in a binary file the values of each variable, patch and material
/// are. Source: Uintah, src/Core/DataArchive/DataArchive.cc and
/// src/Core/Grid/Variables/Variable.cc; no archive of Uintah's own was at hand.
///
/// "material" (Int32), and every particle variable of double, float, int, long64, Point, Vector and
/// Matrix3; where a material lacks one it is not a number (0 for whole numbers). Both byte orders,
/// plain or gzip. Variables of the grid are not read. Throws FileError, also for archives of PIDX.
std::unique_ptr<StepSource> openUintah(const std::string& path);

} // namespace mote

#endif
