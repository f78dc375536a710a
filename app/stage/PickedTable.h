#pragma once

#include "PickedSet.h"

#include <string>
#include <vector>

class vtkAbstractArray;

namespace mote::app
{

/// The text of a value with so many digits, of whole numbers with all they have; 0: as many as tell
/// the number from all others. Words are as they are.
std::string valueText(vtkAbstractArray* array, int component, vtkIdType tuple, int digits);

/// What is picked as a table: what it is, its position, and the values of all arrays; of a cell
/// those of the cell, of arrays of points what they are where it was picked, or the mean over the
/// cell's points, the number of its point that is nearest to that place, and all of its points with
/// their places. It looks at the parts' data, and is good as long as these and the set stay what
/// they are.
class PickedTable
{
public:
  PickedTable() = default;
  PickedTable(const PickedSet::Parts& parts, const PickedSet& picked);

  const std::vector<std::string>& columns() const { return names_; }
  std::size_t rows() const { return picked_ ? picked_->items().size() : 0; }
  /// The text of a cell, with so many digits; 0: as many as tell the number from all others. Empty
  /// where what is picked has no such array.
  std::string cell(std::size_t row, std::size_t column, int digits) const;

  /// The points of a cell, by their numbers, and where they are seen; none of a particle.
  struct Corner
  {
    vtkIdType point;
    std::array<double, 3> place;
  };
  std::vector<Corner> corners(std::size_t row) const;

  /// Lines, cells separated by commas, with the names first; or by tabs, for spreadsheets.
  void appendLine(std::string& text, std::size_t row, char separator) const;
  void appendNames(std::string& text, char separator) const;

private:
  struct Column
  {
    std::string name;
    int component;
    bool ofCells;
    std::vector<vtkAbstractArray*> arrays; ///< of each part; null where it has none
  };
  std::string valueOf(const Picked& picked, const Column& column, int digits) const;
  void addArrays(const Part& part, std::size_t k, bool ofCells);
  void tellApart();

  const PickedSet::Parts* parts_ = nullptr;
  const PickedSet* picked_ = nullptr;
  bool hasKinds_ = false, hasParts_ = false, hasCells_ = false;
  std::vector<Column> columns_; ///< after those of names and positions
  std::vector<std::string> names_;
};

/// Writes the table as a file of comma-separated values. Throws Failure; then no file is left that
/// is not complete.
void writePicked(const PickedTable& table, const std::string& file);

/// The same as JSON, an object a row, if the file's name ends so.
std::string asJson(const PickedTable& table);

} // namespace mote::app
