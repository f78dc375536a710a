#ifndef MotePointRows_h
#define MotePointRows_h

#include "Piece.h"
#include "TextRows.h"

#include "kernels/core/ScratchSpace.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

class vtkPolyData;

namespace mote
{

/// A column of words as numbers.
struct NumberedWords
{
  std::size_t column = 0;
  WordTable table;
  vtkSmartPointer<vtkDataArray> numbers; ///< Int32, one a point
};

/// Lines of a text file, one a point, and what their columns become.
struct PointRows
{
  std::uint64_t rows = 0;  ///< of all pieces
  Piece piece;             ///< which of them are read
  TextCursor::Place place; ///< of the first row
  RowFormat format;
  std::vector<std::string> columns;
  std::vector<ColumnType> types; ///< of each column; Skip where its array is not wanted
  bool mayBeText = false;        ///< what turns out to be no number
  /// Columns; their types do not matter. z is 0 where there is none.
  std::array<std::size_t, 3> coordinates = {0, 0, 0};
  static constexpr std::size_t none = std::size_t(-1);
  std::vector<ColumnGroup> arrays; ///< the columns of a group have one type

  /// Called for rows [first, first + count) of the positions, x y z of a point one after the other,
  /// from any thread; or empty.
  std::function<void(double* positions, std::uint64_t first, std::uint64_t count)> transform;

  /// Where the values are put, in place of the heap; or null. With a space there are no cells, and
  /// of text only the names of its arrays, which have no tuples.
  std::shared_ptr<ScratchSpace> space;
  /// A column of text whose words are numbered; or null.
  NumberedWords* words = nullptr;
};

/// Stores rows [first, first + count) of a step where `targets` say, the first of them at their
/// begin, and tells `stored` of it.
using RowSource = std::function<RowsResult(std::uint64_t first, std::uint64_t count,
  const std::vector<TextColumn>& targets, const RowsStored& stored)>;

/// As readPointRows() below, of rows that come from anywhere; `place` is not looked at. Words are
/// numbered where `words` asks for it, with a space or without.
void makePointRows(PointRows rows, const RowSource& source, vtkPolyData* output);

/// Makes points (double), one vertex cell a point and the arrays as point data. Integer columns
/// with a value that is no such integer become wider, or Float64. Throws FileError, and then
/// `output` must be dropped; and WriteError where a space has no more room.
void readPointRows(
  TextCursor& cursor, PointRows rows, const Progress& progress, vtkPolyData* output);

/// All words of a column, in all pieces: what numbers them must be the same for each piece.
std::set<std::string> wordsOf(
  TextCursor& cursor, const PointRows& rows, std::size_t column, const Progress& progress);

/// "type" of words: where all are names of elements their numbers in the periodic table, 0 for "X"
/// and "Xx", if that is what they mean; else their places in alphabetical order, from 1.
std::map<std::string, int> typesOf(const std::set<std::string>& words, bool areElements);

/// Makes the numbers of words those of types, in an array "type".
void addTypes(NumberedWords& words, const std::map<std::string, int>& types, vtkPolyData* output);

} // namespace mote

#endif
