#include "Coloring.h"

#include "ColorMaps.h"
#include "base/Failure.h"
#include "base/Text.h"
#include "settings/Colors.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkLookupTable.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

/// Where an array has values at or below 0 others near 0 are as a rule rounding: logarithmic
/// colours begin no lower than this share of the greatest value.
constexpr double logShare = 1e-6;

using Parts = std::vector<std::unique_ptr<Part>>;

/// The first part that has the array, or null.
const Part* holderOf(const Parts& parts, const ArrayChoice& choice)
{
  for (const auto& part : parts)
    if (arrayOf(part->data(), choice))
      return part.get();
  return nullptr;
}

std::vector<ArrayChoice> candidatesOf(const Parts& parts)
{
  std::vector<ArrayChoice> all;
  for (const auto& part : parts)
    for (const ArrayChoice& choice : rankedArrays(part->data()))
      if (std::find(all.begin(), all.end(), choice) == all.end())
        all.push_back(choice);
  return all;
}

} // namespace

Coloring::Coloring(const Settings& settings)
  : settings_(settings)
  , wanted_(settings.color.array)
{
}

void Coloring::choose(const Parts& parts)
{
  const std::string& wanted = settings_.color.array;
  if (wanted == "none")
  {
    chosen_ = true;
    return;
  }
  if (!wanted.empty())
  {
    for (const auto& part : parts)
      if (!choice_)
        choice_ = findArray(part->data(), wanted);
    if (!choice_ && !parts.empty())
    {
      if (isText(parts.front()->data(), wanted))
        throw Failure(
          "--color-by: '" + wanted + "' is text and cannot colour; an array of numbers can");
      const std::string known = listArrays(parts.front()->data());
      throw Failure("--color-by: " + parts.front()->name() + " has no array '" + wanted +
                    "'; it has " + (known.empty() ? "none at all" : known));
    }
    chosen_ = static_cast<bool>(choice_);
    return;
  }
  const std::vector<ArrayChoice> candidates = candidatesOf(parts);
  double range[2];
  for (const ArrayChoice& candidate : candidates)
    if (const Part* part = holderOf(parts, candidate);
        !choice_ && finiteRange(arrayOf(part->data(), candidate), candidate.component, range) &&
        range[0] < range[1])
      choice_ = candidate;
  // A volume is seen by an array alone, though it be the same everywhere.
  const bool isVolume = std::any_of(parts.begin(), parts.end(),
    [](const auto& part) { return part->kind() == Part::Kind::Volume; });
  if (!choice_ && isVolume && !candidates.empty())
    choice_ = candidates.front();
  // A step without particles says nothing about the arrays to come.
  chosen_ = std::any_of(parts.begin(), parts.end(),
    [](const auto& part) { return part->data()->GetNumberOfPoints() > 0; });
}

namespace
{

/// Takes a range into another one, which may be none yet.
void widen(double range[2], const double own[2])
{
  const bool first = range[0] > range[1];
  range[0] = first ? own[0] : std::min(range[0], own[0]);
  range[1] = first ? own[1] : std::max(range[1], own[1]);
}

/// Takes in what a component of vectors may be at any angle, where they turn about an axis.
void widenByTurns(
  double range[2], const Part& part, vtkDataArray* array, int component, const Settings& settings)
{
  const bool turns = settings.volume.repeatAround > 1 || !settings.volume.turns.empty();
  if (!turns || part.particles() || component < 0 || array->GetNumberOfComponents() != 3)
    return;
  const CutAxis axis =
    part.turn().degrees != 0.0 ? part.turn().axis : cutAxisOf(settings.cuts.axis);
  double lengths[2];
  constexpr double isAlong = 1.0 - 1e-9;
  if (std::abs(axis.direction[static_cast<std::size_t>(component)]) > isAlong ||
      !finiteRange(array, ArrayChoice::magnitude, lengths))
    return;
  const double all[2] = {-lengths[1], lengths[1]};
  widen(range, all);
}

} // namespace

bool Coloring::percentilesOf(
  vtkDataArray* array, const std::vector<double>& percentiles, double range[2]) const
{
  if (!array)
    return false;
  constexpr std::size_t mostKnown = 16;
  auto found = std::find_if(known_.begin(), known_.end(),
    [&](const Percentiles& one)
    {
      return one.array == array && one.time == array->GetMTime() &&
             one.component == choice_.component && one.of == percentiles;
    });
  if (found == known_.end())
  {
    Percentiles one;
    one.of = percentiles;
    one.array = array;
    one.time = array->GetMTime();
    one.component = choice_.component;
    one.isAny = percentileRange(array, choice_.component, percentiles, one.range);
    if (known_.size() >= mostKnown)
      known_.erase(known_.begin());
    found = known_.insert(known_.end(), one);
  }
  if (found->isAny)
    std::copy_n(found->range, 2, range);
  return found->isAny;
}

bool Coloring::rangeOfMost(const Parts& parts, double range[2]) const
{
  constexpr double most = 1.0 / 3.0; // of the range that is theirs where nothing is said
  double whole[2] = {1.0, 0.0};
  range[0] = 1.0, range[1] = 0.0;
  for (const auto& part : parts)
  {
    vtkDataArray* array = arrayOf(part->data(), choice_);
    double own[2];
    if (!finiteRange(array, choice_.component, own))
      continue;
    widen(whole, own);
    if (this->percentilesOf(array, percentilesOfMost(), own))
      widen(range, own);
  }
  return range[0] < range[1] && range[1] - range[0] < most * (whole[1] - whole[0]);
}

bool Coloring::updateRange(const Parts& parts)
{
  for (const auto& part : parts)
  {
    double range[2];
    vtkDataArray* array = arrayOf(part->data(), choice_);
    if (!finiteRange(array, choice_.component, range))
      continue;
    widenByTurns(range, *part, array, choice_.component, settings_);
    widen(seen_.whole, range);
    if (settings_.color.logarithmic && range[0] <= 0.0)
      if (const double least = leastPositive(array, choice_.component); least > 0.0)
        seen_.leastPositive =
          seen_.leastPositive > 0.0 ? std::min(least, seen_.leastPositive) : least;
    if (!percentiles_.empty() && this->percentilesOf(array, percentiles_, range))
      widen(seen_.trimmed, range);
  }
  return seen_.whole[0] <= seen_.whole[1];
}

bool Coloring::updateTypes(const Parts& parts)
{
  const Part* holder = holderOf(parts, choice_);
  if (settings_.color.map != "types" &&
      !(settings_.color.map.empty() && isTypes(holder->data(), choice_)))
    return false;
  this->updateNames(parts);
  if (!this->findTypes(parts, mostTypeColors))
    return false;
  const bool isPalette = settings_.color.map == "types" || names_.empty();
  typeColors_ = isPalette ? std::vector<Color>() : elementColors(types_, names_);
  if (typeColors_.empty())
    typeColors_ = typeColors(types_.size());
  if (typeColors_.size() < types_.size())
    return false; // so many were asked for
  for (const auto& [type, color] : settings_.color.typeColors)
    if (const auto at = std::find(types_.begin(), types_.end(), type); at != types_.end())
      typeColors_[static_cast<std::size_t>(at - types_.begin())] = color;
  return true;
}

/// Finds the types; false where there are more, or others than integers.
bool Coloring::findTypes(const Parts& parts, std::size_t limit)
{
  if (!settings_.color.range.empty())
  {
    const double first = std::ceil(settings_.color.range[0]),
                 last = std::floor(settings_.color.range[1]);
    types_.clear();
    if (!(last - first < static_cast<double>(limit)) || std::abs(first) > 1e6)
      return false;
    for (int type = static_cast<int>(first); type <= last; ++type)
      types_.push_back(type);
    return !types_.empty();
  }
  // Those that are named come first, then those that earlier time steps have.
  std::vector<int> all = settings_.color.types;
  for (const int type : types_)
    if (std::find(all.begin(), all.end(), type) == all.end())
      all.push_back(type);
  types_ = all;
  constexpr int greatestSpan = 4096;
  for (const auto& part : parts)
    if (vtkDataArray* array = arrayOf(part->data(), choice_); array && array->GetNumberOfTuples())
      countable_ =
        countable_ && collectTypes(array, choice_.component, limit, greatestSpan, types_);
  return countable_ && !types_.empty();
}

void Coloring::updateNames(const Parts& parts)
{
  std::vector<std::pair<vtkDataSet*, unsigned long>> present;
  for (const auto& part : parts)
    present.emplace_back(part->data(), part->data()->GetMTime());
  if (present != named_)
    for (const auto& part : parts)
      dataNames_.merge(typeNamesOf(part->data(), choice_));
  named_ = present;
  names_ = settings_.color.typeNames;
  names_.insert(dataNames_.begin(), dataNames_.end());
}

void Coloring::forget()
{
  seen_ = {};
  types_.clear();
  countable_ = true;
  dataNames_.clear();
  named_.clear();
}

void Coloring::followSettings()
{
  if (settings_.color.array != wanted_)
    this->startAnew();
  if (settings_.color.percentiles == percentiles_)
    return;
  percentiles_ = settings_.color.percentiles;
  seen_.trimmed[0] = 1.0, seen_.trimmed[1] = 0.0;
}

void Coloring::startAnew()
{
  wanted_ = settings_.color.array;
  choice_ = {};
  chosen_ = false;
  explained_ = false;
  this->forget();
}

void Coloring::include(const Parts& parts)
{
  this->followSettings();
  for (const auto& part : parts)
    addCoordinate(part->data(), settings_.color.array);
  if (!chosen_)
    this->choose(parts);
  const Part* holder = holderOf(parts, choice_);
  // A step without particles is explained by the range that others have.
  explained_ = holder && !isColors(arrayOf(holder->data(), choice_)) &&
               (this->updateRange(parts) || !settings_.color.range.empty());
  typed_ = explained_ && this->updateTypes(parts);
}

void Coloring::offer(const Parts& parts, const UsualOpacity::Found& opacity)
{
  usual_.offer(volumesOf(parts), opacity);
}

UsualOpacity::Found Coloring::usualOpacity(const Parts& parts) const
{
  return usual_.foundOf(volumesOf(parts));
}

void Coloring::apply(const Parts& parts)
{
  this->include(parts);
  if (const Part* holder = holderOf(parts, choice_))
    title_ = describe(holder->data(), choice_);
  this->makeTable(typed_);
  const std::vector<vtkDataSet*> volumes = volumesOf(parts);
  opacity_ = settings_.volume.opacity;
  if (opacity_.empty() && !volumes.empty())
    opacity_ = usual_.of(volumes, choice_);
  for (const auto& part : parts)
    part->setColors(choice_, table_, opacity_);
}

namespace
{

/// Has the legend of a table say that there are values beyond its range, which have the colours of
/// its ends.
void markOutliers(vtkLookupTable* table, const double whole[2])
{
  double color[4];
  if (whole[0] < table->GetRange()[0])
  {
    table->GetTableValue(0, color);
    table->SetBelowRangeColor(color);
    table->UseBelowRangeColorOn();
  }
  if (whole[1] > table->GetRange()[1])
  {
    table->GetTableValue(table->GetNumberOfTableValues() - 1, color);
    table->SetAboveRangeColor(color);
    table->UseAboveRangeColorOn();
  }
  table->BuildSpecialColors();
}

} // namespace

void Coloring::makeTable(bool types)
{
  double range[2] = {this->range()[0], this->range()[1]};
  if (!settings_.color.range.empty())
    std::copy_n(settings_.color.range.begin(), 2, range);
  if (!(range[0] <= range[1]))
    range[0] = 0.0, range[1] = 1.0;
  if (settings_.color.logarithmic && explained_)
  {
    if (!(range[1] > 0.0))
      throw Failure("--log needs values above zero; those of " + title_ + " go from " +
                    asNumber(range[0]) + " to " + asNumber(range[1]));
    if (range[0] <= 0.0 && settings_.color.range.empty())
      range[0] = std::max(seen_.leastPositive, logShare * range[1]);
    if (!(range[0] > 0.0))
      throw Failure("--log needs a --range above zero, not " + asNumber(range[0]) + " to " +
                    asNumber(range[1]));
  }
  if (!types && range[0] == range[1])
  {
    // One value everywhere: put it in the middle.
    const double margin = range[0] == 0.0 ? 0.5 : 0.5 * std::abs(range[0]);
    range[0] -= settings_.color.logarithmic ? 0.5 * margin : margin;
    range[1] += margin;
  }
  const bool named = !settings_.color.map.empty() && settings_.color.map != "types";
  auto table = types ? makeTypeMap(types_, typeColors_)
                     : makeColorMap(named ? settings_.color.map : "viridis", range,
                         settings_.color.logarithmic);
  if (!types && settings_.color.reversed)
    reverse(table);
  if (!types && settings_.color.range.empty() && !percentiles_.empty())
    markOutliers(table, seen_.whole);
  if (Color none = {0.0, 0.0, 0.0}; parseColor(settings_.volume.nanColor, none))
    table->SetNanColor(none[0], none[1], none[2], 1.0);
  if (choice_.component == ArrayChoice::magnitude)
    table->SetVectorModeToMagnitude();
  else
    table->SetVectorModeToComponent();
  table->SetVectorComponent(std::max(0, choice_.component));
  // A new table has the legend drawn anew, which a drag of another range must not pay for.
  const TypeNames names = types ? names_ : TypeNames();
  if (table_ && isTypeTable_ == types && legendNames_ == names && areAlike(table_, table))
    return;
  table_ = table;
  isTypeTable_ = types;
  legendNames_ = names;
  legendTable_ = types ? makeTypeLegend(types_, typeColors_, names) : table_;
}

std::string Coloring::nextArray(const Parts& parts) const
{
  const std::vector<ArrayChoice> candidates = candidatesOf(parts);
  const auto same = [&](const ArrayChoice& c)
  { return c.name == choice_.name && c.ofCells == choice_.ofCells; };
  const auto present = std::find_if(candidates.begin(), candidates.end(), same);
  ArrayChoice next;
  if (!choice_ || present == candidates.end())
    next = candidates.empty() ? ArrayChoice{} : candidates.front();
  else if (present + 1 != candidates.end())
    next = present[1];
  const Part* holder = holderOf(parts, next);
  return holder ? asText(holder->data(), next) : "none";
}

int Coloring::componentCount(const Parts& parts) const
{
  const Part* holder = holderOf(parts, choice_);
  return holder ? arrayOf(holder->data(), choice_)->GetNumberOfComponents() : 0;
}

std::string Coloring::nextComponent(const Parts& parts) const
{
  const Part* holder = holderOf(parts, choice_);
  if (!holder)
    return settings_.color.array;
  const int components = arrayOf(holder->data(), choice_)->GetNumberOfComponents();
  ArrayChoice next = choice_;
  if (components > 1)
    next.component =
      choice_.component + 1 < components ? choice_.component + 1 : ArrayChoice::magnitude;
  return asText(holder->data(), next);
}

bool Coloring::isAboveZero(const Parts& parts, const std::string& array) const
{
  for (const auto& part : parts)
  {
    const ArrayChoice choice = findArray(part->data(), array);
    double range[2];
    if (finiteRange(arrayOf(part->data(), choice), choice.component, range) && range[1] > 0.0)
      return true;
  }
  return false;
}

std::string Coloring::nextMap() const
{
  const auto& names = colorMapNames();
  const std::string shown = this->mapName().empty() ? names.front() : this->mapName();
  const auto present = std::find(names.begin(), names.end(), shown);
  return present == names.end() || present + 1 == names.end() ? names.front() : present[1];
}

ColorSettings Coloring::inForce(const Parts& parts) const
{
  ColorSettings all = settings_.color;
  const Part* holder = holderOf(parts, choice_);
  if (!chosen_ || (!holder && choice_))
    return all;
  all.array = holder ? asText(holder->data(), choice_) : "none";
  // What another look at these parts would not find is said outright.
  if (!explained_ || !all.range.empty())
    return all;
  Settings present = settings_;
  present.color.array = all.array; // as it will be asked for
  Coloring fresh(present);
  fresh.include(parts);
  if (typed_ && fresh.types_ != types_)
    all.types = types_;
  const double* range = this->range();
  if (!typed_ && range[0] < range[1] && !std::equal(range, range + 2, fresh.range()))
  {
    all.range = {table_->GetRange()[0], table_->GetRange()[1]};
    all.percentiles.clear();
  }
  return all;
}

vtkLookupTable* Coloring::table() const
{
  return explained_ ? table_ : nullptr;
}

vtkLookupTable* Coloring::legendTable() const
{
  return explained_ ? legendTable_ : nullptr;
}

} // namespace mote::app
