#ifndef MoteGadgetFile_h
#define MoteGadgetFile_h

#include "StepSource.h"

namespace mote
{

/// Gadget's six kinds of particles, from 0: gas, halo, disk, bulge, stars and boundary.
const std::map<int, std::string>& gadgetTypeNames();

/// Whether bytes begin like a binary snapshot, with blocks that have names or without.
bool looksLikeGadget(std::string_view beginning);

/// Gadget-1 and -2 binary snapshots, of either byte order, plain or gzip, single or double
/// precision. Source: V. Springel, User guide for GADGET-2, section 6.
///
/// "type" (Int32), "id" (Int64), "v" and "mass"; of gas "u" and "rho", where the file has them,
/// which are not a number for other particles. The time is the header's. Without names only the
/// blocks up to the density are known, in their usual order. The first file of a snapshot that is
/// spread over several, snap_007.0 or snap_007.0.gadget, stands for all. Throws FileError.
std::unique_ptr<StepSource> openGadget(const std::string& path);

} // namespace mote

#endif
