// The part of ParticleModel that says which particles are hidden.

#include "ParticleModel.h"

#include "kernels/core/Error.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <sstream>

namespace mote
{

namespace
{

void checkRange(double low, double high)
{
  if (low <= high)
    return;
  std::ostringstream text;
  text << "A range from " << low << " to " << high
       << " is none: its first end must not lie above its second.";
  throw Error(text.str());
}

/// The array that a range speaks of.
vtkDataArray* arrayOf(const ArrayRange& range, vtkPointSet* points)
{
  if (range.array)
    return range.array;
  if (range.name.empty())
    throw Error(std::string("There is no array for ") + range.purpose + ".");
  vtkDataArray* array = requirePointArray(points, range.name, range.purpose);
  if (range.component < -1 || range.component >= array->GetNumberOfComponents())
    throw Error("The array \"" + range.name + "\" for " + range.purpose + " has no component " +
                std::to_string(range.component) + ".");
  return array;
}

} // namespace

vtkUnsignedCharArray* ghostMarksOf(vtkPointSet* points)
{
  vtkUnsignedCharArray* marks = points ? points->GetPointGhostArray() : nullptr;
  return marks && marks->GetNumberOfValues() == points->GetNumberOfPoints() ? marks : nullptr;
}

bool ParticleModel::addRange(const ArrayRange& range)
{
  if (range.name.empty())
    throw Error("A range needs the name of a point array.");
  checkRange(range.low, range.high);
  const auto found = std::find_if(ranges_.begin(), ranges_.end(),
    [&](const auto& r) { return r.name == range.name && r.component == range.component; });
  if (found == ranges_.end())
  {
    if (ranges_.size() == mostRanges)
      throw Error("There is no room for a range of \"" + range.name +
                  "\": " + std::to_string(mostRanges) + " arrays have one already.");
    ranges_.push_back(range);
    return true;
  }
  const bool changed =
    found->low != range.low || found->high != range.high || found->parts != range.parts;
  *found = range;
  return changed;
}

bool ParticleModel::addToRange(const ArrayRange& range)
{
  checkRange(range.low, range.high);
  const auto found = std::find_if(ranges_.begin(), ranges_.end(),
    [&](const auto& r) { return r.name == range.name && r.component == range.component; });
  if (found == ranges_.end())
    return addRange(range);
  RangeParts all = found->parts;
  if (all.empty())
    all.push_back({found->low, found->high});
  all.push_back({range.low, range.high});
  std::sort(all.begin(), all.end());
  ArrayRange sum = *found;
  sum.parts.clear();
  for (const auto& part : all)
    if (!sum.parts.empty() && part[0] <= sum.parts.back()[1])
      sum.parts.back()[1] = std::max(sum.parts.back()[1], part[1]);
    else
      sum.parts.push_back(part);
  sum.low = sum.parts.front()[0];
  sum.high = sum.parts.back()[1];
  if (sum.parts.size() == 1)
    sum.parts.clear();
  return addRange(sum);
}

bool ParticleModel::removeRange(const std::string& name, int component)
{
  return std::erase_if(
           ranges_, [&](const auto& r) { return r.name == name && r.component == component; }) > 0;
}

bool ParticleModel::setPlaceRange(int k, double low, double high)
{
  checkRange(low, high);
  const bool changed = places_.low[k] != low || places_.high[k] != high;
  places_.low[k] = low;
  places_.high[k] = high;
  return changed;
}

bool ParticleModel::removeAllRanges()
{
  const bool any = !ranges_.empty() || places_.anyLimited();
  ranges_.clear();
  places_ = {};
  return any;
}

std::vector<std::string> ParticleModel::updateRanges(const std::vector<ArrayRange>& more)
{
  std::vector<std::string> news;
  if (!structure_)
    return news;
  std::vector<ValueRange> values;
  std::set<std::string> problems;
  const auto add = [&](const ArrayRange& range)
  {
    try
    {
      values.push_back(
        {arrayOf(range, input_), range.component, range.low, range.high, range.parts});
    }
    catch (const Error& error)
    {
      if (problems.insert(error.what()).second && !rangeProblems_.contains(error.what()))
        news.emplace_back(error.what());
    }
  };
  if (input_->GetNumberOfPoints() > 0)
  {
    std::for_each(ranges_.begin(), ranges_.end(), add);
    std::for_each(more.begin(), more.end(), add);
  }
  const double highestMark = meetsGhosts ? vtkDataSetAttributes::DUPLICATEPOINT : 0;
  vtkUnsignedCharArray* marks = ghostMarksOf(input_);
  if (marks && marks->GetRange()[1] > highestMark)
    values.push_back({marks, 0, 0.0, highestMark, {}});
  rangeProblems_ = problems;
  if (selection_.apply(*structure_, values, places_, [this] { return this->particles(); }))
    changed_.Modified();
  return news;
}

std::size_t ParticleModel::visible() const
{
  return structure_ ? selection_.shownCount(*structure_) : 0;
}

void ParticleModel::markVisible(unsigned char* marks) const
{
  if (structure_)
    selection_.markShown(*structure_, marks);
}

Box ParticleModel::visibleBounds() const
{
  if (!structure_)
    return {};
  return preview_ && this->visible() == preview_->particles ? preview_->whole.bounds
                                                            : selection_.shownBounds(*structure_);
}

void ParticleModel::printRanges(std::ostream& out, vtkIndent indent) const
{
  static const char* const places[] = {"Center x", "Center y", "Center z", "Radius"};
  for (const ArrayRange& range : ranges_)
  {
    out << indent << "Range of " << range.name << ", component " << range.component << ": "
        << range.low << " " << range.high << "\n";
    for (const auto& part : range.parts)
      out << indent << "  of that: " << part[0] << " " << part[1] << "\n";
  }
  for (int k = 0; k < 4; ++k)
    if (places_.isLimited(k))
      out << indent << "Range of " << places[k] << ": " << places_.low[k] << " " << places_.high[k]
          << "\n";
}

} // namespace mote
