#pragma once

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

namespace mote
{

/// The points of a data set's cells, for one thread.
class CellCorners
{
public:
  /// Makes what VTK makes when it is first asked; to be called before several threads ask.
  static void prepare(vtkDataSet* data)
  {
    if (data->GetNumberOfCells() > 0)
      data->GetCellPoints(0, vtkNew<vtkIdList>());
  }

  explicit CellCorners(vtkDataSet* data)
    : data_(data)
  {
  }

  vtkIdList* of(vtkIdType cell)
  {
    data_->GetCellPoints(cell, corners_);
    return corners_;
  }

  /// The mean over a cell's points of valueOf(point); not a number for a cell without points.
  template <typename ValueOf>
  double mean(vtkIdType cell, const ValueOf& valueOf)
  {
    this->of(cell);
    const vtkIdType count = corners_->GetNumberOfIds();
    double sum = 0.0;
    for (vtkIdType i = 0; i < count; ++i)
      sum += valueOf(corners_->GetId(i));
    return sum / static_cast<double>(count);
  }

  /// A coordinate of its middle: the mean over its points.
  double middle(vtkIdType cell, int axis)
  {
    return this->mean(cell,
      [&](vtkIdType point)
      {
        double place[3];
        data_->GetPoint(point, place);
        return place[axis];
      });
  }

private:
  vtkDataSet* data_;
  vtkNew<vtkIdList> corners_;
};

} // namespace mote
