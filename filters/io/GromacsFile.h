#ifndef MoteGromacsFile_h
#define MoteGromacsFile_h

#include "StepSource.h"

namespace mote
{

/// GROMACS .gro: frames of a title, the number of atoms, a line an atom in columns of fixed width,
/// and the box. Source: the GROMACS manual, file formats, gro.
///
/// Positions in nm; "id" (Int64, counted anew where the file's five digits do not suffice),
/// "residue" (Int32), "residue_name" (text), "type" from the names of the atoms, "v" in nm/ps where
/// the file has velocities. The time of a frame is what its title says behind "t=", in ps, if all
/// frames say so and ascend; else 0, 1, 2 and so on. Throws FileError.
std::unique_ptr<StepSource> openGromacs(const std::string& path, const Progress& progress);

} // namespace mote

#endif
