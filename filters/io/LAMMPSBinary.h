#ifndef MoteLAMMPSBinary_h
#define MoteLAMMPSBinary_h

#include "LAMMPSDump.h"
#include "TextRows.h"

#include <string>
#include <string_view>
#include <vector>

namespace mote
{

/// Whether bytes begin like a binary dump, with the name of its style or, as before 2020, without.
bool looksLikeBinaryDump(std::string_view beginning);

/// The steps of a binary dump of LAMMPS, of either byte order. Source: LAMMPS, dump_custom.cpp and
/// dump_atom.cpp, header_binary; tools/binary2txt.cpp.
///
/// Dumps without a name do not name their columns: these are taken for "id type x y z column6" and
/// so on, and positions for fractions of the box where all lie in it. A step that is cut short has
/// its damage. Throws FileError as indexLAMMPSDump() does.
LAMMPSIndex indexBinaryDump(const std::string& path, const Progress& progress);

/// Stores atoms [first, first + count) of a step. Throws FileError where the file has become
/// shorter, or `progress` asks to stop.
void readBinaryRows(const std::string& path, const LAMMPSFrame& frame, std::uint64_t first,
  std::uint64_t count, const std::vector<TextColumn>& targets, const RowsStored& stored,
  const Progress& progress);

} // namespace mote

#endif
