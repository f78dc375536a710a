#include "CellSelection.h"

#include "CellCorners.h"
#include "DataArrayView.h"

#include "kernels/core/Error.h"

#include "vtkUnsignedCharArray.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <functional>
#include <string>

namespace mote
{

CellSelection::CellSelection(vtkDataSet* data)
  : data_(data)
  , isVisible_(vtkSmartPointer<vtkUnsignedCharArray>::New())
  , visible_(data->GetNumberOfCells())
{
  isVisible_->SetNumberOfValues(visible_);
  std::fill_n(isVisible_->GetPointer(0), visible_, 1);
}

CellSelection::~CellSelection() = default;

vtkUnsignedCharArray* CellSelection::isVisible() const
{
  return visible_ < data_->GetNumberOfCells() ? isVisible_.Get() : nullptr;
}

/// valueOf(corners, cell) is the value of a cell, asked for by several threads with corners of
/// their own.
template <typename ValueOf>
void CellSelection::hide(const Intervals& intervals, const ValueOf& valueOf)
{
  CellCorners::prepare(data_);
  unsigned char* const isVisible = isVisible_->GetPointer(0);
  using Range = tbb::blocked_range<vtkIdType>;
  visible_ = tbb::parallel_reduce(
    Range(0, data_->GetNumberOfCells(), 1 << 12), vtkIdType(0),
    [&](const Range& range, vtkIdType count)
    {
      CellCorners corners(data_);
      for (vtkIdType c = range.begin(); c != range.end(); ++c)
        if (isVisible[c] != 0)
        {
          const double value = valueOf(corners, c);
          isVisible[c] = std::any_of(intervals.begin(), intervals.end(),
            [&](const auto& one) { return value >= one.first && value <= one.second; });
          count += isVisible[c];
        }
      return count;
    },
    std::plus<>());
  isVisible_->Modified();
}

void CellSelection::limit(
  vtkDataArray* array, int component, bool ofCells, const Intervals& intervals)
{
  const vtkIdType wanted = ofCells ? data_->GetNumberOfCells() : data_->GetNumberOfPoints();
  if (array->GetNumberOfTuples() != wanted)
    throw Error("There are " + std::to_string(array->GetNumberOfTuples()) + " values for " +
                std::to_string(wanted) + (ofCells ? " cells." : " points."));
  const DataArrayView values(array);
  const auto valueAt = [&](vtkIdType i)
  { return values.view.value(static_cast<std::size_t>(i), component); };
  if (ofCells)
    this->hide(intervals, [&](CellCorners&, vtkIdType cell) { return valueAt(cell); });
  else
    this->hide(
      intervals, [&](CellCorners& corners, vtkIdType cell) { return corners.mean(cell, valueAt); });
}

void CellSelection::limitPlace(int axis, const Intervals& intervals)
{
  this->hide(
    intervals, [axis](CellCorners& corners, vtkIdType cell) { return corners.middle(cell, axis); });
}

} // namespace mote
