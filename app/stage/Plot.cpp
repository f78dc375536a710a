#include "Plot.h"

#include "Calculated.h"

#include <DataArrayView.h>
#include <ParticleModel.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkIdList.h>
#include <vtkMoteParticleMapper.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace mote::app
{

namespace
{

int coordinateNamed(const std::string& name)
{
  return name.size() == 1 && name[0] >= 'x' && name[0] <= 'z' ? name[0] - 'x' : -1;
}

/// A value of every point, or of every cell, of a part.
class Values
{
public:
  Values(vtkDataSet* data, const std::string& name)
    : data_(data)
    , choice_(findArray(data, name))
  {
    if (vtkDataArray* array = arrayOf(data, choice_))
    {
      view_.emplace(array);
      isThere_ = array->GetNumberOfTuples() ==
                 (choice_.ofCells ? data->GetNumberOfCells() : data->GetNumberOfPoints());
      return;
    }
    place_ = coordinateNamed(name);
    isThere_ = place_ >= 0 && data->GetNumberOfPoints() > 0;
    auto* points = vtkPointSet::SafeDownCast(data);
    // Points that are made when they are asked for have no array.
    if (isThere_ && points && points->GetPoints() && points->GetPoints()->GetData() &&
        points->GetPoints()->GetData()->GetNumberOfTuples() == data->GetNumberOfPoints())
      view_.emplace(points->GetPoints()->GetData());
  }

  bool isThere() const { return isThere_; }
  bool ofCells() const { return choice_.ofCells; }

  double operator()(vtkIdType i) const
  {
    if (view_)
      return view_->view.value(static_cast<std::size_t>(i), place_ >= 0 ? place_ : component());
    double place[3];
    data_->GetPoint(i, place);
    return place[place_];
  }

  bool widen(double& least, double& most) const
  {
    double range[2];
    if (place_ >= 0)
    {
      double bounds[6];
      data_->GetBounds(bounds);
      std::copy_n(bounds + 2 * place_, 2, range);
    }
    else if (!finiteRange(arrayOf(data_, choice_), choice_.component, range))
      return false;
    least = std::min(least, range[0]);
    most = std::max(most, range[1]);
    return true;
  }

private:
  int component() const
  {
    return choice_.component == ArrayChoice::magnitude ? ArrayView::magnitude : choice_.component;
  }

  vtkDataSet* data_;
  ArrayChoice choice_;
  std::optional<DataArrayView> view_;
  int place_ = -1;
  bool isThere_ = false;
};

std::size_t countOf(vtkDataSet* data, bool ofCells)
{
  return static_cast<std::size_t>(ofCells ? data->GetNumberOfCells() : data->GetNumberOfPoints());
}

/// Which points, or cells, of a part are shown; empty for all.
std::vector<unsigned char> visibleOf(const Part& part, bool ofCells)
{
  std::vector<unsigned char> visible;
  if (part.isHidden())
    visible.resize(countOf(part.data(), ofCells));
  else if (part.particles() && !ofCells)
  {
    visible.resize(countOf(part.data(), ofCells));
    part.particles()->GetModel().markVisible(visible.data());
  }
  else if (!part.particles())
  {
    visible.resize(countOf(part.data(), ofCells), 1);
    part.cells().dropHidden(visible, ofCells);
  }
  return visible;
}

/// Which points, or cells, of a part are plotted; empty for all.
std::vector<unsigned char> chosenOf(
  const Part& part, int number, const PickedSet& picked, Plotted of, bool ofCells)
{
  if (of != Plotted::Picked)
    return of == Plotted::Visible ? visibleOf(part, ofCells) : std::vector<unsigned char>();
  vtkDataSet* data = part.data();
  std::vector<unsigned char> chosen(countOf(data, ofCells));
  vtkNew<vtkIdList> corners;
  for (const Picked& one : picked.items())
  {
    if (one.part != number)
      continue;
    const bool isCell = one.kind == Picked::Kind::Cell;
    if (isCell == ofCells)
      chosen[static_cast<std::size_t>(one.id)] = 1;
    else if (isCell)
    {
      data->GetCellPoints(one.id, corners);
      for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
        chosen[static_cast<std::size_t>(corners->GetId(i))] = 1;
    }
  }
  return chosen;
}

/// From values to numbers of bins.
struct Bins
{
  double least, scale;
  int count;

  Bins(double from, double to, int bins)
    : least(from)
    , scale(to > from ? bins / (to - from) : 0.0)
    , count(bins)
  {
  }
  /// -1 for what is not finite.
  int operator()(double value) const
  {
    if (!std::isfinite(value))
      return -1;
    return std::clamp(static_cast<int>((value - least) * scale), 0, count - 1);
  }
};

using Counts = std::vector<std::uint32_t>;

void countPart(const Values& x, const Values* y, vtkIdType count,
  const std::vector<unsigned char>& chosen, const Plot& plot,
  tbb::enumerable_thread_specific<Counts>& counts)
{
  const Bins columns(plot.least[0], plot.most[0], plot.width);
  const Bins rows(plot.least[1], plot.most[1], plot.height);
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, count, 1 << 15),
    [&](const tbb::blocked_range<vtkIdType>& range)
    {
      Counts& own = counts.local();
      for (vtkIdType i = range.begin(); i != range.end(); ++i)
      {
        if (!chosen.empty() && !chosen[static_cast<std::size_t>(i)])
          continue;
        const int column = columns(x(i));
        const int row = y ? rows((*y)(i)) : 0;
        if (column >= 0 && row >= 0)
          ++own[static_cast<std::size_t>(row) * static_cast<std::size_t>(plot.width) +
                static_cast<std::size_t>(column)];
      }
    });
}

/// What a part's values are of.
std::string itemsOf(const Part& part, bool ofCells)
{
  return ofCells ? "cells" : part.particles() ? "particles" : "points";
}

} // namespace

Plot plotOf(const std::vector<std::unique_ptr<Part>>& parts, const PickedSet& picked,
  const PlotChoice& choice, int width, int height)
{
  const bool isPair = !choice.names[1].empty();
  Plot plot;
  plot.least.fill(HUGE_VAL);
  plot.most.fill(-HUGE_VAL);
  std::vector<std::array<std::optional<Values>, 2>> values(parts.size());
  bool isAny = false;
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    auto& [x, y] = values[k];
    x.emplace(parts[k]->data(), choice.names[0]);
    if (isPair)
      y.emplace(parts[k]->data(), choice.names[1]);
    const bool isThere = x->isThere() && (!y || (y->isThere() && y->ofCells() == x->ofCells())) &&
                         x->widen(plot.least[0], plot.most[0]) &&
                         (!y || y->widen(plot.least[1], plot.most[1]));
    if (!isThere)
      x.reset();
    isAny = isAny || isThere;
    const std::string what = isThere ? itemsOf(*parts[k], x->ofCells()) : plot.what;
    plot.what = plot.what.empty() || plot.what == what ? what : "values";
  }
  if (!isAny)
    return {};
  plot.width = width;
  plot.height = isPair ? height : 1;
  const auto bins = static_cast<std::size_t>(plot.width) * static_cast<std::size_t>(plot.height);
  tbb::enumerable_thread_specific<Counts> counts([bins] { return Counts(bins); });
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (const auto& [x, y] = values[k]; x)
    {
      vtkDataSet* data = parts[k]->data();
      countPart(*x, y ? &*y : nullptr,
        x->ofCells() ? data->GetNumberOfCells() : data->GetNumberOfPoints(),
        chosenOf(*parts[k], static_cast<int>(k), picked, choice.of, x->ofCells()), plot, counts);
    }
  plot.counts.resize(bins);
  for (const Counts& own : counts)
    std::transform(own.begin(), own.end(), plot.counts.begin(), plot.counts.begin(), std::plus<>());
  for (const std::uint32_t count : plot.counts)
  {
    plot.highest = std::max(plot.highest, count);
    plot.total += count;
  }
  return plot;
}

namespace
{

/// What ranges of the array that colours a volume leave of its values.
std::vector<Interval> shownOfVolume(
  const Interval& values, const std::string& name, const SelectionSettings& selection)
{
  std::vector<Interval> shown = {values};
  const auto keep = [&](const std::vector<Interval>& intervals)
  {
    std::vector<Interval> kept;
    for (const Interval& one : shown)
      for (const Interval& other : intervals)
        if (const Interval both = {std::max(one.low, other.low), std::min(one.high, other.high)};
            both.low <= both.high)
          kept.push_back(both);
    shown = kept;
  };
  for (const ShowRange& range : selection.ranges)
    if (range.name == name)
      keep(range.intervals);
  if (!selection.range.empty() && (selection.array.empty() || selection.array == name))
    keep({{selection.range[0], selection.range[1]}});
  return shown;
}

} // namespace

void makeRoom(double range[2])
{
  if (range[0] != range[1])
    return;
  const double margin = range[0] == 0.0 ? 0.5 : 0.5 * std::abs(range[0]);
  range[0] -= margin;
  range[1] += margin;
}

bool rangeOfShown(const std::vector<std::unique_ptr<Part>>& parts, const ArrayChoice& choice,
  const SelectionSettings& selection, double range[2])
{
  Interval all = {HUGE_VAL, -HUGE_VAL};
  const auto include = [&](double low, double high)
  {
    all.low = std::min(all.low, low);
    all.high = std::max(all.high, high);
  };
  for (const auto& part : parts)
  {
    const std::string name = asText(part->data(), choice);
    const Values values(part->data(), name);
    if (part->isHidden() || !values.isThere())
      continue;
    if (Interval own = {HUGE_VAL, -HUGE_VAL};
        part->kind() == Part::Kind::Volume && values.widen(own.low, own.high))
    {
      for (const Interval& shown : shownOfVolume(own, name, selection))
        include(shown.low, shown.high);
      continue;
    }
    const std::vector<unsigned char> visible = visibleOf(*part, values.ofCells());
    for (std::size_t i = 0; i < countOf(part->data(), values.ofCells()); ++i)
      if (visible.empty() || visible[i])
        if (const double value = values(static_cast<vtkIdType>(i)); std::isfinite(value))
          include(value, value);
  }
  range[0] = all.low;
  range[1] = all.high;
  return all.low <= all.high;
}

std::vector<std::string> numbersOf(vtkDataSet* data, bool ofCells)
{
  std::vector<std::string> names;
  vtkDataSetAttributes* arrays = ofCells ? static_cast<vtkDataSetAttributes*>(data->GetCellData())
                                         : static_cast<vtkDataSetAttributes*>(data->GetPointData());
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = arrays->GetArray(i);
    const std::string name = nameOf(array);
    if (name.empty() || name == whereArray)
      continue;
    const int components = array->GetNumberOfComponents();
    for (int c = components > 1 ? ArrayChoice::magnitude : 0; c < components; ++c)
      names.push_back(asText(data, {name, c, ofCells}));
  }
  return names;
}

std::vector<std::string> plottable(const std::vector<std::unique_ptr<Part>>& parts)
{
  std::vector<std::string> names;
  const auto add = [&](const std::string& name)
  {
    if (std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  };
  for (const auto& part : parts)
    for (const bool ofCells : {false, true})
      for (const std::string& name : numbersOf(part->data(), ofCells))
        add(name);
  for (const char* place : {"x", "y", "z"})
    add(place);
  return names;
}

} // namespace mote::app
