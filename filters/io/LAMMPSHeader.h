#ifndef MoteLAMMPSHeader_h
#define MoteLAMMPSHeader_h

#include "LAMMPSDump.h"

#include <string>
#include <string_view>

namespace mote
{

/// The lower-triangular cell from the bounds of the box around it, which are the first two numbers
/// of each row, and the tilts xy, xz, yz, which are the third (LAMMPS manual, Howto triclinic).
void setTilted(LAMMPSBox& box, const double (&rows)[3][3]);

/// Parses the items from the beginning of a frame to "ITEM: ATOMS", after which the rows begin.
class LAMMPSHeader
{
public:
  /// `frame` brings the units and columns of the frame before, and receives what is read.
  LAMMPSHeader(TextCursor& cursor, LAMMPSFrame& frame)
    : m_cursor(cursor)
    , m_frame(frame)
  {
  }

  /// False at the end of the file. Throws FileError for whatever is not as it should be.
  bool read();

  bool hasTimestep() const { return m_hasTimestep; } ///< whether read got as far as that

private:
  void readItem(std::string_view item);
  void readTimestep();
  void readAtomCount();
  void readBox(std::string_view item);
  void readColumns(std::string_view names);

  std::string_view value(const char* what);
  void numbers(double* values, std::size_t count, const char* what);
  [[noreturn]] void refuse(const std::string& sentence) const;

  TextCursor& m_cursor;
  LAMMPSFrame& m_frame;
  bool m_hasTimestep = false;
  bool m_hasCount = false;
  bool m_hasAtoms = false;
};

} // namespace mote

#endif
