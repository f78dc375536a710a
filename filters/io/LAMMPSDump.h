#ifndef MoteLAMMPSDump_h
#define MoteLAMMPSDump_h

#include "FileError.h"
#include "TextCursor.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mote
{

/// The simulation box: the parallelepiped origin + a, b, c. Lengths are in the dump's own units.
///
/// Sources: the LAMMPS manual, pages "dump" and "Howto triclinic". What a triclinic dump gives as
/// bounds are those of the box that encloses the cell; these are the cell's own.
struct LAMMPSBox
{
  bool known = false;
  std::array<double, 3> origin = {0, 0, 0};
  /// cell[0] is a, cell[1] is b, cell[2] is c.
  std::array<std::array<double, 3>, 3> cell = {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
  bool general = false; ///< "abc origin": a need not lie along x, nor b in the xy plane
  std::string boundary; ///< "pp pp fm"; empty in dumps older than the flags
};

/// Rows of a binary dump that stand together: from a byte on, the first of them so many atoms into
/// the step.
struct LAMMPSChunk
{
  std::uint64_t offset = 0;
  std::uint64_t first = 0;
  bool isSwapped = false; ///< of the other byte order
};

/// One time step: its header, and where its rows of atoms are.
struct LAMMPSFrame
{
  std::int64_t timestep = 0;
  std::optional<double> time; ///< ITEM: TIME, in the units' own time unit
  std::string units;          ///< ITEM: UNITS ("lj", "metal"), which holds for the rest of a file
  std::uint64_t atoms = 0;
  LAMMPSBox box;
  std::shared_ptr<const std::vector<std::string>>
    columns;                     ///< never null; "id type xs ys zs" if old
  std::uint64_t columnsLine = 0; ///< the line ITEM: ATOMS
  TextCursor::Place start;       ///< of the header
  TextCursor::Place rows;
  std::shared_ptr<const std::vector<LAMMPSChunk>> chunks; ///< of a binary dump; else null
  bool hasComments = false;                               ///< of #, behind the values of a row
  /// Of data files: rows of id, vx, vy, vz and what else velocityColumns counts.
  std::optional<TextCursor::Place> velocities;
  std::size_t velocityColumns = 0;
  std::optional<FileError> damage; ///< why this step cannot be read
};

struct LAMMPSIndex
{
  std::vector<LAMMPSFrame> frames; ///< in file order
  std::string warning;             ///< about damage that belongs to no listed frame; or empty
};

/// Whether bytes begin like a LAMMPS dump, of text or binary, or like a LAMMPS data file.
bool looksLikeLAMMPSDump(std::string_view beginning);

/// Reads a whole file once, headers by parsing and atoms by counting lines. The number of atoms of
/// an undamaged frame has been compared with the lines that are there, so that space for them can
/// be trusted to make sense.
///
/// A damaged frame is listed with its damage and does not hide those around it. Throws FileError
/// when the file cannot be opened, is no LAMMPS text dump, has no frame at all, or when `progress`
/// asks to stop.
///
/// A LAMMPS data file is one step, see LAMMPSData.h.
///
/// With the index of the same file before it grew only its last frame and what follows are read; a
/// file that is another there is read as a whole.
LAMMPSIndex indexLAMMPSDump(
  const std::string& path, const Progress& progress, const LAMMPSIndex* before = nullptr);

} // namespace mote

#endif
