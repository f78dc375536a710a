#ifndef MotePointRows_h
#define MotePointRows_h

#include "TextRows.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace mote
{

/// Lines of a text file, one a point, and what their columns become.
struct PointRows
{
  std::uint64_t rows = 0;
  TextCursor::Place place; ///< of the first row
  std::vector<std::string> columns;
  std::vector<ColumnType> types; ///< of each column; Skip where its array is not wanted
  std::array<std::size_t, 3> coordinates = {0, 0, 0}; ///< columns; their types do not matter
  std::vector<ColumnGroup> arrays;                    ///< the columns of a group have one type

  /// Called for rows [first, first + count) of the positions, x y z of a point one after the other,
  /// from any thread; or empty.
  std::function<void(double* positions, std::uint64_t first, std::uint64_t count)> transform;
};

/// Makes points (double), one vertex cell a point and the arrays as point data. Integer columns
/// with a value that is no such integer become wider, or Float64. Throws FileError, and then
/// `output` must be dropped.
void readPointRows(
  TextCursor& cursor, PointRows rows, const Progress& progress, vtkPolyData* output);

} // namespace mote

#endif
