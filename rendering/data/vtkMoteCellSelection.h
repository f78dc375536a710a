/**
 * @class   vtkMoteCellSelection
 * @brief   which cells of a data set lie in ranges of several values
 *
 * A cell is visible where it lies in all limits. Arrays of cells tell a cell's value; of arrays of
 * points, and of coordinates, it is the mean over the cell's points. Mappers take the result by
 * SetVisibleCells():
 *
 *     selection.SetDataSet(data)
 *     selection.AddInterval(2.0, 5.0)
 *     selection.Limit("speed", 0, False)
 *     mapper.SetVisibleCells(selection.GetVisibleCells())
 */

#ifndef vtkMoteCellSelection_h
#define vtkMoteCellSelection_h

#include "MoteRenderingDataModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For the data set

#include <memory>  // For the selection
#include <string>  // For names
#include <utility> // For intervals
#include <vector>  // For intervals

class vtkDataSet;
class vtkUnsignedCharArray;

namespace mote
{
class CellSelection;
} // namespace mote

class MOTERENDERINGDATA_EXPORT vtkMoteCellSelection : public vtkObject
{
public:
  static vtkMoteCellSelection* New();
  vtkTypeMacro(vtkMoteCellSelection, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Begins with all cells of a data set, which is to stay as it is.
   */
  void SetDataSet(vtkDataSet* data);

  /**
   * From and to, both included: one more interval of the next limit.
   */
  void AddInterval(double low, double high);

  //@{
  /**
   * Hides the cells whose value of an array's component (-1: of its magnitude), or whose middle's
   * x, y or z (axis 0, 1 or 2), lies in none of the intervals that were added since the last limit.
   * What is not a number lies nowhere. Reports an error and returns false where there is no data
   * set, or no such array of numbers.
   */
  bool Limit(const std::string& array, int component, bool ofCells);
  bool LimitPlace(int axis);
  //@}

  /** One value for each cell, 0 for what is hidden; null where nothing is. */
  vtkUnsignedCharArray* GetVisibleCells();
  /** How many cells those are that are not hidden. */
  vtkIdType GetNumberOfVisibleCells();

protected:
  vtkMoteCellSelection();
  ~vtkMoteCellSelection() override;

private:
  vtkMoteCellSelection(const vtkMoteCellSelection&) = delete;
  void operator=(const vtkMoteCellSelection&) = delete;

  vtkSmartPointer<vtkDataSet> DataSet;
  std::unique_ptr<mote::CellSelection> Selection;
  std::vector<std::pair<double, double>> Intervals;
};

#endif
