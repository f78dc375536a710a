#include "Selection.h"

#include "Calculated.h"
#include "HiddenParts.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/Text.h"

#include <vtkDataSet.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

constexpr std::size_t mostArrays = 4;

/// Which of x, y, z, radius; -1 for arrays.
int builtInNamed(const std::string& name)
{
  const std::vector<std::string> names = {"x", "y", "z", "radius"};
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

/// What a name means: of particles an array of points.
ArrayChoice arrayNamed(const Part& part, const std::string& text)
{
  const ArrayChoice choice = findArray(part.data(), text);
  return choice.ofCells && part.particles() ? ArrayChoice{} : choice;
}

/// Whether a part has the array of --where.
bool isExpressed(const Part& part)
{
  return arrayOf(part.data(), {whereArray, 0, part.particles() == nullptr}) != nullptr;
}

} // namespace

Selection::Selection(const Settings& settings)
  : settings_(settings)
{
  this->followSettings();
}

void Selection::followSettings()
{
  if (!known_.empty() && followed_ == settings_.selection)
    return;
  followed_ = settings_.selection;
  whereKnown_ = false;
  known_.assign(followed_.ranges.size() + 1, false);
  warned_.assign(followed_.ranges.size() + 1, false);
}

void Selection::require(bool found, std::size_t range, const std::string& name, const Part& part,
  const std::string& option)
{
  if (found)
    known_[range] = true;
  else if (!known_[range])
    throw Failure(option + ": " + part.name() + " has no array '" + name + "'; it has " +
                  (option != "--show"  ? ""
                    : part.particles() ? "x, y, z, radius as drawn, and "
                                       : "x, y, z, and ") +
                  listArrays(part.data()));
  else if (!warned_[range])
  {
    warned_[range] = true;
    Messages::warn(
      option + ": a time step has no array '" + name + "', so it is shown without that range");
  }
}

namespace
{

/// Throws Failure for a name that no data set has, nor had at another time step: `known`.
void requireNamed(const std::vector<std::string>& names, const std::vector<NamedData>& data,
  const std::string& option, std::set<std::string>& known)
{
  for (const std::string& name : names)
  {
    const bool isThere = std::any_of(
      data.begin(), data.end(), [&](const NamedData& one) { return isNamed(one, name); });
    if (!isThere && known.count(name) == 0 && !data.empty())
    {
      std::vector<std::string> all;
      for (const NamedData& one : data)
        all.push_back(partName(one));
      throw Failure(option + ": there is no part '" + name + "'; there is " + joined(all, ", "));
    }
    known.insert(name);
  }
}

} // namespace

/// What --hide-data, --hide-part and --show-part ask for.
void Selection::hideData(const Parts& parts, const std::vector<NamedData>& data)
{
  const std::vector<int>& hidden = settings_.selection.hiddenData;
  mostParts_ = std::max(mostParts_, parts.size());
  for (const int number : hidden)
    if (!parts.empty() && static_cast<std::size_t>(number) > mostParts_)
      throw Failure("--hide-data: there is no data set " + std::to_string(number) + ", but " +
                    std::to_string(mostParts_));
  requireNamed(settings_.selection.hiddenParts, data, "--hide-part", knownParts_);
  requireNamed(settings_.selection.shownParts, data, "--show-part", knownParts_);
  const std::vector<bool> isHidden = hiddenParts(data, settings_.selection);
  for (std::size_t i = 0; i < parts.size() && i < data.size(); ++i)
    parts[i]->setHidden(isHidden[i]);
  joinWalls(parts);
}

void Selection::apply(
  const Parts& parts, const ArrayChoice& colored, const std::vector<NamedData>& data)
{
  this->followSettings();
  this->hideData(parts, data);
  const Part* first = nullptr; // with particles: an empty step says nothing about arrays
  for (const auto& part : parts)
  {
    part->showAll();
    if (!first && part->data()->GetNumberOfPoints() > 0)
      first = part.get();
  }
  if (!first)
    return;
  this->applyRanges(parts, *first);
  if (!settings_.selection.range.empty())
    this->applyRange(parts, colored, *first);
  this->limitCells(parts, colored);
  for (const auto& part : parts)
    part->applyRanges();
}

void Selection::limitCells(const Parts& parts, const ArrayChoice& colored) const
{
  for (const auto& part : parts)
    if (!part->particles())
      part->limitCells(cellLimitsOf(part->data(), settings_.selection, colored));
}

/// What --where, --hide-ids and --only-ids ask for; returns the array that it takes, if any.
std::vector<ArrayChoice> Selection::applyExpression(const Parts& parts)
{
  if (!isLimited(settings_.selection))
    return {};
  const ArrayChoice holds = {whereArray, 0, false};
  std::vector<ArrayChoice> arrays;
  bool isFound = false;
  for (const auto& part : parts)
  {
    isFound = isFound || isExpressed(*part);
    if (!part->particles() || !isExpressed(*part))
      continue;
    part->limit(holds, {{1.0, 1.0}});
    arrays = {holds};
  }
  if (!isFound && !whereKnown_ && !settings_.selection.where.empty())
    throw Failure("--where: '" + settings_.selection.where + "' is not of what is shown");
  whereKnown_ = true;
  return arrays;
}

/// What --show asks for.
void Selection::applyRanges(const Parts& parts, const Part& first)
{
  const std::vector<ShowRange>& ranges = settings_.selection.ranges;
  std::vector<ArrayChoice> arrays = this->applyExpression(parts);
  for (std::size_t i = 0; i < ranges.size(); ++i)
  {
    const ShowRange& range = ranges[i];
    const int place = builtInNamed(range.name);
    const bool isRadius = place == 3;
    bool found = place >= 0 && !isRadius;
    if (place >= 0 && range.intervals.size() > 1)
      throw Failure(
        "--show: " + range.name + " takes one range, from LO to HI; arrays take several");
    for (const auto& part : parts)
    {
      if (!part->particles()) // limitCells() does what it asks for
      {
        found = found || findArray(part->data(), range.name);
        continue;
      }
      const ArrayChoice choice = place >= 0 ? ArrayChoice{} : arrayNamed(*part, range.name);
      if (choice && std::find(arrays.begin(), arrays.end(), choice) == arrays.end())
        arrays.push_back(choice);
      if (arrays.size() > mostArrays)
        throw Failure("--show takes at most four arrays of particles, besides x, y, z and radius; "
                      "--where, --hide-ids and --only-ids together are one of them");
      if (place >= 0)
        part->limitPlace(place, range.intervals.front().low, range.intervals.front().high);
      else if (choice)
        part->limit(choice, range.intervals);
      found = found || choice || isRadius;
    }
    this->require(found, i + 1, range.name, first, "--show");
  }
}

/// What --show-range and --show-by ask for.
void Selection::applyRange(const Parts& parts, const ArrayChoice& colored, const Part& first)
{
  const SelectionSettings& wanted = settings_.selection;
  const bool isColored = wanted.array.empty();
  bool found = false;
  for (const auto& part : parts)
  {
    const ArrayChoice choice = isColored ? colored : arrayNamed(*part, wanted.array);
    found = found || arrayOf(part->data(), choice);
    part->setVisible(choice, wanted.range.data());
  }
  if (!found && isColored && !known_[0])
    throw Failure("--show-range needs an array: name one with --show-by");
  this->require(found, 0, isColored ? colored.name : wanted.array, first,
    isColored ? "--show-range" : "--show-by");
}

} // namespace mote::app
