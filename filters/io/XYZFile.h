#ifndef MoteXYZFile_h
#define MoteXYZFile_h

#include "TextCursor.h"
#include "TextRows.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mote
{

/// One frame of an XYZ file.
struct XYZFrame
{
  std::uint64_t atoms = 0;
  std::string comment;
  std::uint64_t commentLine = 0;
  TextCursor::Place rows;
  double time = 0; ///< see vtkMoteXYZReader
};

/// The box of the particles, as the comment of an extended file tells it.
struct XYZBox
{
  std::array<double, 9> vectors = {}; ///< one after the other
  std::array<double, 3> origin = {};
  std::string boundary; ///< "pp pp ff": periodic along the first two vectors, as LAMMPS says it
};

/// The columns of a frame.
struct XYZLayout
{
  std::vector<std::string> columns;
  std::vector<ColumnType> types;
  std::array<std::size_t, 3> coordinates = {1, 2, 3};
  std::vector<ColumnGroup> arrays;
  std::string species; ///< the array of element names; empty if there is none
};

/// Finds the frames of an XYZ file and makes sure that every one has its lines. Throws FileError
/// for a file that cannot be opened, has other content, or ends within a frame.
std::vector<XYZFrame> indexXYZ(const std::string& path, const Progress& progress);

/// What the columns are, from the comment of an extended file, else from the values of the first
/// row. Throws FileError for a description that makes no sense or has no positions.
XYZLayout xyzLayout(
  const std::string& path, const XYZFrame& frame, const std::vector<std::string>& firstRow);

/// What Lattice, Origin and pbc of a comment say; none where there is no Lattice of nine finite
/// numbers. A box is periodic where nothing else is said.
std::optional<XYZBox> xyzBox(const std::string& comment);

} // namespace mote

#endif
