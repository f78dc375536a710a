#pragma once

#include "MoteRenderingDataModule.h" // For export macro

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <utility>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkUnsignedCharArray;

namespace mote
{

/// Which cells of a data set lie in ranges of several values: those that lie in all of them. Arrays
/// of cells tell a cell's value; of arrays of points, and of coordinates, it is the mean over the
/// cell's points.
class MOTERENDERINGDATA_EXPORT CellSelection
{
public:
  /// All cells, until a limit is set.
  explicit CellSelection(vtkDataSet* data);
  ~CellSelection();

  /// From and to, both included; a value may lie in any of them.
  using Intervals = std::vector<std::pair<double, double>>;

  /// Hides the cells whose value of a component, or ArrayView::magnitude, lies in none. What is not
  /// a number lies nowhere. In parallel. Throws Error where the array has not one value for each
  /// cell or point.
  void limit(vtkDataArray* array, int component, bool ofCells, const Intervals& intervals);
  /// The same by a coordinate of the cell's middle: 0, 1, 2 for x, y, z.
  void limitPlace(int axis, const Intervals& intervals);

  vtkIdType numberVisible() const { return visible_; }
  /// One value for each cell, 0 for what is hidden; null where nothing is.
  vtkUnsignedCharArray* isVisible() const;

private:
  template <typename ValueOf>
  void hide(const Intervals& intervals, const ValueOf& valueOf);

  vtkDataSet* data_;
  vtkSmartPointer<vtkUnsignedCharArray> isVisible_;
  vtkIdType visible_ = 0;
};

} // namespace mote
