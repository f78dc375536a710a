#ifndef MoteAtomEyeFile_h
#define MoteAtomEyeFile_h

#include "StepSource.h"

namespace mote
{

/// Whether a text begins like a file of AtomEye.
bool looksLikeAtomEye(std::string_view beginning);

/// AtomEye CFG, standard and extended: one step of fractions of a box. Source: J. Li, AtomEye,
/// "standard CFG format" and "extended CFG format".
///
/// Positions are Cartesian, in the file's basic length (mostly Angstrom); "mass" (Float64), "type"
/// from the names of the elements, "v" where there are velocities, and the auxiliary values under
/// their names. Throws FileError.
std::unique_ptr<StepSource> openAtomEye(const std::string& path);

} // namespace mote

#endif
