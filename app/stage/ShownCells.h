#pragma once

#include "Arrays.h"
#include "settings/Settings.h"

#include <vtkSmartPointer.h>
#include <vtkTimeStamp.h>
#include <vtkUnsignedCharArray.h>

#include <vector>

namespace mote::app
{

/// What hides cells: values outside of all intervals of an array, or of a coordinate.
struct CellLimit
{
  ArrayChoice choice;
  int place = -1; ///< 0, 1, 2 for x, y, z
  std::vector<Interval> intervals;
  bool operator==(const CellLimit&) const = default;
};

/// All that the settings ask for and the data have the arrays for. `colored` is the array that
/// colours. Throws Failure as findArray() does.
std::vector<CellLimit> cellLimitsOf(
  vtkDataSet* data, const SelectionSettings& selection, const ArrayChoice& colored);

/// Which cells of a part are shown. A cell has the value of arrays of cells, and of arrays of
/// points and of coordinates the mean over its points.
class ShownCells
{
public:
  /// Finds them, where data or limits are not those of the last time. The array `within`, if any,
  /// is shown or hidden within cells.
  void update(vtkDataSet* data, const std::vector<CellLimit>& limits, const ArrayChoice& within);

  /// One value a cell, 0 for those that all but `within` hides; null where nothing is hidden.
  vtkUnsignedCharArray* mask() const { return mask_; }
  const std::vector<CellLimit>& limits() const { return limits_; }
  bool isUpToDate() const { return data_ != nullptr; } ///< after update()
  /// Changes with what is shown; 0 before update().
  vtkMTimeType time() const { return changed_.GetMTime(); }
  /// How many are shown: by their means of `within`.
  vtkIdType count() const { return count_; }

  /// Sets to 0 the marks of cells that are hidden, or of points of which no cell is shown and of
  /// those that `within` hides.
  void dropHidden(std::vector<unsigned char>& marks, bool ofCells) const;

private:
  vtkSmartPointer<vtkDataSet> data_;
  vtkMTimeType dataTime_ = 0;
  vtkTimeStamp changed_;
  std::vector<CellLimit> limits_;
  ArrayChoice within_;
  vtkSmartPointer<vtkUnsignedCharArray> mask_, shown_;
  vtkIdType count_ = 0;
};

} // namespace mote::app
