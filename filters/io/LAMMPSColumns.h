#ifndef MoteLAMMPSColumns_h
#define MoteLAMMPSColumns_h

#include "LAMMPSDump.h"
#include "TextRows.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace mote
{

/// The column that gives one coordinate of the atoms' positions.
struct LAMMPSCoordinate
{
  std::size_t column = 0;
  bool scaled = false; ///< a fraction of the cell, not a length
};

/// What the columns of a frame mean.
struct LAMMPSLayout
{
  std::array<LAMMPSCoordinate, 3> coordinates;
  std::vector<ColumnGroup> arrays; ///< all columns but those of the coordinates, in file order
  std::string missing;             ///< the first coordinate without a column: "z"; or empty
};

/// Finds the coordinates (for each axis the first there is of x, xu, xs, xsu) and the arrays.
///
/// With `combine`, columns that follow one another and belong together become one array with a
/// component each: vx vy vz is "v" (and so for f, mu, omega, angmom, tq), c_s[1] c_s[2] c_s[3] is
/// "c_s", whatever the number of components. Without it every column is an array.
LAMMPSLayout layoutOf(const std::vector<std::string>& columns, bool combine);

/// The type that a column should be read as, going by its name and its first value in the frame.
///
/// id and mol are Int64; type, proc, procp1 and the image flags ix iy iz Int32; element and
/// typelabel String. Other columns are Float64, save that one that LAMMPS does not name itself, or
/// "type", is String where its first value is no number.
ColumnType typeOf(const std::string& column, const std::string& firstValue);

/// Turns positions as they were read into Cartesian ones, in place.
class LAMMPSPlacement
{
public:
  /// Throws FileError where a scaled coordinate has no box, or not the other two beside it in a
  /// general triclinic one.
  LAMMPSPlacement(const LAMMPSFrame& frame, const LAMMPSLayout& layout, const std::string& path);

  bool needed() const { return m_scaled[0] || m_scaled[1] || m_scaled[2]; }

  /// `positions` holds x y z of an atom one after the other.
  void apply(double* positions, std::uint64_t first, std::uint64_t count) const;

private:
  void applyGeneral(double* position) const;

  LAMMPSBox m_box;
  std::array<bool, 3> m_scaled;
};

} // namespace mote

#endif
