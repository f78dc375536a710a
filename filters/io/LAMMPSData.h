#ifndef MoteLAMMPSData_h
#define MoteLAMMPSData_h

#include "LAMMPSDump.h"

namespace mote
{

/// Whether text begins like a LAMMPS data file, which read_data reads and write_data writes.
bool looksLikeLAMMPSData(std::string_view beginning);

/// The one time step of a LAMMPS data file: its box, its atoms with columns by their style, and its
/// velocities. The step, its units and the style are those that the comments tell; without a style
/// the columns are told by their number, and by whether the third holds integers.
///
/// Source: the LAMMPS manual, page "read_data". Throws FileError for what is no such file, has no
/// atoms or fewer than it says, is of a style that is not known, or when `progress` asks to stop.
LAMMPSFrame readLAMMPSDataHeader(const std::string& path, const Progress& progress);

} // namespace mote

#endif
