#include "ShownCells.h"

#include "Calculated.h"

#include <CellCorners.h>
#include <CellSelection.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>

#include <algorithm>

namespace mote::app
{

namespace
{

CellSelection::Intervals pairsOf(const std::vector<Interval>& intervals)
{
  CellSelection::Intervals pairs;
  for (const auto& [low, high] : intervals)
    pairs.emplace_back(low, high);
  return pairs;
}

void apply(const CellLimit& limit, vtkDataSet* data, CellSelection& selection)
{
  if (limit.place >= 0)
    return selection.limitPlace(limit.place, pairsOf(limit.intervals));
  static_assert(ArrayChoice::magnitude == ArrayView::magnitude);
  selection.limit(arrayOf(data, limit.choice), limit.choice.component, limit.choice.ofCells,
    pairsOf(limit.intervals));
}

vtkSmartPointer<vtkUnsignedCharArray> copyOf(vtkUnsignedCharArray* array)
{
  vtkSmartPointer<vtkUnsignedCharArray> copy;
  if (array)
  {
    copy = vtkSmartPointer<vtkUnsignedCharArray>::New();
    copy->DeepCopy(array);
  }
  return copy;
}

} // namespace

std::vector<CellLimit> cellLimitsOf(
  vtkDataSet* data, const SelectionSettings& selection, const ArrayChoice& colored)
{
  std::vector<CellLimit> limits;
  const auto add = [&](const ArrayChoice& choice, const std::vector<Interval>& intervals)
  {
    if (arrayOf(data, choice))
      limits.push_back({choice, -1, intervals});
  };
  if (isLimited(selection))
    add({whereArray, 0, true}, {{1.0, 1.0}});
  for (const ShowRange& range : selection.ranges)
  {
    const bool isPlace = range.name == "x" || range.name == "y" || range.name == "z";
    if (isPlace)
      limits.push_back({{}, range.name[0] - 'x', range.intervals});
    else
      add(findArray(data, range.name), range.intervals);
  }
  if (selection.range.size() == 2)
    add(selection.array.empty() ? colored : findArray(data, selection.array),
      {{selection.range[0], selection.range[1]}});
  return limits;
}

void ShownCells::update(
  vtkDataSet* data, const std::vector<CellLimit>& limits, const ArrayChoice& within)
{
  if (data == data_ && data->GetMTime() == dataTime_ && limits == limits_ && within == within_)
    return;
  const auto isWithin = [&](const CellLimit& limit)
  { return limit.place < 0 && limit.choice == within; };
  CellSelection selection(data);
  for (const CellLimit& limit : limits)
    if (!isWithin(limit))
      apply(limit, data, selection);
  const bool hasWithin = std::any_of(limits.begin(), limits.end(), isWithin);
  mask_ = selection.isVisible();
  if (hasWithin)
    mask_ = copyOf(mask_);
  for (const CellLimit& limit : limits)
    if (isWithin(limit))
      apply(limit, data, selection);
  shown_ = selection.isVisible();
  count_ = selection.numberVisible();
  data_ = data;
  dataTime_ = data->GetMTime();
  changed_.Modified();
  limits_ = limits;
  within_ = within;
}

void ShownCells::dropHidden(std::vector<unsigned char>& marks, bool ofCells) const
{
  if (!data_ || !shown_)
    return;
  const vtkIdType cells = shown_->GetNumberOfValues();
  if (ofCells)
  {
    for (vtkIdType c = 0; c < cells; ++c)
      if (shown_->GetValue(c) == 0)
        marks[static_cast<std::size_t>(c)] = 0;
    return;
  }
  std::vector<unsigned char> isOfShown(marks.size());
  CellCorners corners(data_);
  for (vtkIdType c = 0; c < cells; ++c)
    if (!mask_ || mask_->GetValue(c) != 0)
    {
      vtkIdList* points = corners.of(c);
      for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
        isOfShown[static_cast<std::size_t>(points->GetId(i))] = 1;
    }
  for (const CellLimit& limit : limits_)
    if (vtkDataArray* array =
          limit.choice == within_ && !limit.choice.ofCells ? arrayOf(data_, limit.choice) : nullptr)
      for (std::size_t p = 0; p < marks.size(); ++p)
      {
        const double value = valueOf(array, limit.choice.component, static_cast<vtkIdType>(p));
        if (std::none_of(limit.intervals.begin(), limit.intervals.end(),
              [&](const Interval& one) { return value >= one.low && value <= one.high; }))
          isOfShown[p] = 0;
      }
  for (std::size_t p = 0; p < marks.size(); ++p)
    marks[p] = marks[p] != 0 && isOfShown[p] != 0 ? 1 : 0;
}

} // namespace mote::app
