#include "Advice.h"

#include "Calculated.h"
#include "HiddenParts.h"
#include "Silhouettes.h"
#include "base/Text.h"

#include <vtkBoundingBox.h>
#include <vtkDataSet.h>
#include <vtkMath.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace mote::app
{

namespace
{

bool has(const Stage& stage, Part::Kind kind)
{
  return std::any_of(stage.parts().begin(), stage.parts().end(),
    [kind](const auto& part) { return part->kind() == kind; });
}

/// Takes a range into another one; `any` tells whether that has one so far.
void widen(double range[2], const double own[2], bool& any)
{
  range[0] = any ? std::min(range[0], own[0]) : own[0];
  range[1] = any ? std::max(range[1], own[1]) : own[1];
  any = true;
}

/// The least and greatest value that colours; false where none does.
bool rangeOf(const Stage& stage, double range[2])
{
  bool any = false;
  const ArrayChoice& choice = stage.coloring().choice();
  for (const auto& part : stage.parts())
  {
    double own[2];
    if (!finiteRange(arrayOf(part->data(), choice), choice.component, own))
      continue;
    widen(range, own, any);
  }
  return any;
}

/// Options that do nothing, by name.
class Idle
{
public:
  void add(bool given, const char* option)
  {
    if (given)
      options_.emplace_back(option);
  }
  /// Says so, if there are any.
  void tell(std::vector<std::string>& advice, const std::string& why) const
  {
    if (!options_.empty())
      advice.push_back(
        joined(options_, ", ") + (options_.size() > 1 ? " do" : " does") + " nothing here: " + why);
  }

private:
  std::vector<std::string> options_;
};

void adviseOnVolumes(const Stage& stage, std::vector<std::string>& advice)
{
  const VolumeSettings &volume = stage.settings().volume, &shown = stage.shown().volume;
  if (!has(stage, Part::Kind::Volume))
  {
    VolumeSettings plain;
    plain.cells = volume.cells;
    plain.cloudTolerance = volume.cloudTolerance;
    plain.edges = volume.edges; // of surfaces, too
    plain.repeatAround = volume.repeatAround;
    if (volume != plain || stage.settings().flow != FlowSettings{})
      advice.push_back("the options of volumes (mote help volume) do nothing here: there are no "
                       "cells that are shown as a volume");
    return;
  }
  const ArrayChoice& choice = stage.coloring().choice();
  for (const auto& part : stage.parts())
    if (part->kind() == Part::Kind::Volume && !part->isHidden() && !arrayOf(part->data(), choice))
      advice.push_back(part->name() + " is not shown: its volume has no " +
                       stage.coloring().title() +
                       ", which colours; --color-by names another array");
  if (shown.cloud == "off" && shown.isoValues.empty() && shown.slices->empty() &&
      shown.walls == 0.0)
    advice.push_back("--cloud off leaves nothing of a volume without isosurfaces (--iso), slices "
                     "(--slice) or walls (--walls)");
  const bool exact = volume.integrator == "cell-by-cell";
  Idle idle;
  if (shown.cloud == "off")
  {
    idle.add(!exact, "--integrator");
    idle.add(volume.sampleDistance.has_value(), "--sample-distance");
    idle.add(volume.tolerance != VolumeSettings{}.tolerance, "--tolerance");
    idle.add(volume.cloudTolerance != 0.0, "--cloud-tolerance");
    idle.add(!volume.opacity.empty(), "--opacity");
    return idle.tell(advice, "there is no cloud (--cloud)");
  }
  idle.add(exact && volume.sampleDistance, "--sample-distance");
  idle.add(!exact && volume.tolerance != VolumeSettings{}.tolerance, "--tolerance");
  idle.tell(advice, "the integrator is " + volume.integrator);
}

void adviseOnParticles(const Stage& stage, std::vector<std::string>& advice)
{
  const ParticleSettings& given = stage.settings().particles;
  const ParticleSettings plain;
  if (stage.parts().empty() || has(stage, Part::Kind::Particles))
    return;
  Idle idle;
  const auto& parts = stage.parts();
  if (std::none_of(parts.begin(), parts.end(), [](const auto& part) { return part->hasRadius(); }))
    idle.add(given.radiusScale != plain.radiusScale, "--radius-scale");
  idle.add(given.structure != plain.structure, "--structure");
  idle.add(given.form != plain.form, "--form");
  idle.tell(advice, "there are no particles");
}

void adviseOnLight(const Stage& stage, std::vector<std::string>& advice)
{
  const Settings& settings = stage.settings();
  const LightSettings& light = settings.light;
  const VolumeSettings& shown = stage.shown().volume;
  const bool hasSurfaces = !shown.isoValues.empty() || shown.walls.value_or(0.0) > 0.0 ||
                           (shown.slices && !shown.slices->empty());
  if (!has(stage, Part::Kind::Volume) || has(stage, Part::Kind::Particles) ||
      has(stage, Part::Kind::Surface) || hasSurfaces)
  {
    Idle idle;
    idle.add(light.size != LightSettings{}.size && light.shadows == "none" && !light.pathTrace,
      "--light-size");
    return idle.tell(advice, "there are no shadows");
  }
  Idle idle;
  idle.add(light.shadows != "none", "--shadows");
  idle.add(light.ambientOcclusion != "none", "--ambient-occlusion");
  idle.add(light.pathTrace, "--path-trace");
  idle.add(light.place != "auto" && !settings.volume.lit, "--light");
  idle.add(areOn(settings.silhouettes), "--silhouettes");
  idle.tell(advice, "a volume has no surface without walls, slices and isosurfaces");
}

void adviseOnColors(const Stage& stage, std::vector<std::string>& advice)
{
  const Settings& settings = stage.settings();
  const ColorSettings& color = settings.color;
  const PictureSettings& picture = settings.picture;
  Idle idle;
  if (color.array == "none")
  {
    idle.add(!color.map.empty(), "--color-map");
    idle.add(!color.range.empty(), "--range");
    idle.add(!color.percentiles.empty(), "--percentiles");
    idle.add(color.logarithmic, "--log");
    idle.add(picture.title.has_value(), "--title");
    return idle.tell(advice, "no array colours");
  }
  if (!color.typeColors.empty() && stage.coloring().legendTable() && !stage.coloring().isTyped())
    advice.push_back("--type-colors does nothing here: the colours of " + stage.coloring().title() +
                     " do not stand for types");
  if (color.map == "types" && stage.coloring().legendTable() && !stage.coloring().isTyped())
    advice.push_back("--color-map types does nothing here: " + stage.coloring().title() +
                     " does not have so few whole numbers that each could have its colour");
  if (!picture.legend)
  {
    idle.add(picture.title.has_value(), "--title");
    idle.add(picture.legendSide != PictureSettings{}.legendSide, "--legend-side");
    idle.add(!picture.legendFormat.empty(), "--legend-format");
    idle.tell(advice, "there is no legend");
  }
}

/// Of isosurfaces that do not meet the range of the values that they follow: of those that colour,
/// or of another array.
void addOfIsoValues(const Stage& stage, std::array<double, 2> range, std::string whole,
  std::vector<std::string>& advice)
{
  const VolumeSettings& volume = stage.settings().volume;
  if (!volume.isoArray.empty() && !volume.isoValues.empty())
  {
    bool any = false;
    for (const auto& part : stage.parts())
    {
      const ArrayChoice choice = findArray(part->data(), volume.isoArray);
      double own[2];
      if (part->kind() == Part::Kind::Volume &&
          finiteRange(arrayOf(part->data(), choice), choice.component, own))
        widen(range.data(), own, any);
    }
    if (!any)
      advice.push_back("--iso-array: no volume has numbers of the name " + volume.isoArray);
    if (!any)
      return;
    whole = volume.isoArray + " goes from " + asNumber(range[0]) + " to " + asNumber(range[1]);
  }
  for (const double value : volume.isoValues)
    if (value < range[0] || value > range[1])
      advice.push_back("--iso: there is no surface at " + asNumber(value) + "; " + whole);
}

void adviseOnValues(const Stage& stage, std::vector<std::string>& advice)
{
  const Settings& settings = stage.settings();
  double range[2] = {0.0, 0.0};
  const bool isVolume = has(stage, Part::Kind::Volume);
  // The range takes a look at every value.
  if ((!isVolume && !settings.color.logarithmic) || !rangeOf(stage, range))
    return;
  if (isVolume && range[0] == range[1])
    advice.push_back(stage.coloring().title() + " is " + asNumber(range[0]) +
                     " everywhere, so the volume has one colour");
  const std::string whole =
    stage.coloring().title() + " goes from " + asNumber(range[0]) + " to " + asNumber(range[1]);
  if (isVolume)
    addOfIsoValues(stage, {range[0], range[1]}, whole, advice);
  if (settings.color.logarithmic && range[0] <= 0.0)
    advice.push_back("--log: values at or below 0 have the colour of the least; " + whole);
}

/// Whether any particle or cell that could be shown has a value in the intervals; `range` is that
/// of all values. True where none has the array.
bool anyWithin(const Stage& stage, const std::string& name, const std::vector<Interval>& intervals,
  double* range)
{
  std::int64_t count = 0;
  bool any = false;
  for (const auto& part : stage.parts())
  {
    if (part->isHidden())
      continue;
    const ArrayChoice choice = findArray(part->data(), name);
    double own[2];
    vtkDataArray* array = arrayOf(part->data(), choice);
    if (const std::size_t axis = std::string("xyz").find(name);
        !array && axis < 3 && name.size() == 1)
    {
      const double* bounds = part->data()->GetBounds() + 2 * axis;
      widen(range, bounds, any);
      count += std::any_of(intervals.begin(), intervals.end(),
        [&](const Interval& interval)
        { return interval.low <= bounds[1] && interval.high >= bounds[0]; });
      continue;
    }
    if (!finiteRange(array, choice.component, own))
      continue;
    widen(range, own, any);
    if (!part->particles())
    {
      ShownCells cells;
      cells.update(part->data(), {{choice, -1, intervals}}, {});
      count += cells.count();
      continue;
    }
    for (const Interval& interval : intervals)
    {
      const double ends[2] = {interval.low, interval.high};
      count += countInRange(array, choice.component, ends);
    }
  }
  return count > 0 || !any;
}

/// What is shown of a file.
struct Shown
{
  std::string file, numbers; ///< of its data sets, as --hide-data takes them
  vtkBoundingBox box;
};

std::vector<Shown> shownOf(const Stage& stage)
{
  std::vector<Shown> all;
  for (std::size_t i = 0; i < stage.parts().size(); ++i)
  {
    double bounds[6];
    stage.parts()[i]->shownBounds(bounds);
    const std::string file = stage.fileOf(i);
    if (!vtkMath::AreBoundsInitialized(bounds))
      continue;
    if (all.empty() || all.back().file != file)
      all.push_back({file, "", {}});
    all.back().numbers += (all.back().numbers.empty() ? "" : ",") + std::to_string(i + 1);
    all.back().box.AddBounds(bounds);
  }
  return all;
}

} // namespace

std::string whatLeavesNothing(const Stage& stage)
{
  const bool isAnyShown = std::any_of(stage.parts().begin(), stage.parts().end(),
    [](const auto& part)
    { return !part->isHidden() && part->numberShown() + part->numberOfCellsShown() > 0; });
  const bool isAny = std::any_of(stage.parts().begin(), stage.parts().end(),
    [](const auto& part) { return !part->isHidden() && part->data()->GetNumberOfPoints() > 0; });
  const std::string what = stage.numberOfParticles() > 0 ? "particle" : "cell";
  const SelectionSettings& selection = stage.settings().selection;
  const bool isExpressed = isLimited(selection);
  if (isAnyShown || !isAny || (selection.ranges.empty() && !isExpressed))
    return "";
  double range[2];
  if (isExpressed && !anyWithin(stage, whereArray, {{1.0, 1.0}}, range))
  {
    const bool hasIds = !selection.hidden.empty() || !selection.only.empty();
    return "Nothing is shown: " +
           (selection.where.empty() ? "--hide-ids and --only-ids leave"
             : hasIds               ? "--where, --hide-ids and --only-ids together leave"
                                    : "--where '" + selection.where + "' leaves") +
           " no " + what;
  }
  for (const ShowRange& one : selection.ranges)
    if (!anyWithin(stage, one.name, one.intervals, range))
      return "Nothing is shown: no " + what + " has " + one.name + " in the range of --show; " +
             one.name + " goes from " + asNumber(range[0]) + " to " + asNumber(range[1]);
  return "Nothing is shown: each limit (--show, --where and their like) leaves some, and together "
         "none";
}

std::string unlikeSizes(const Stage& stage)
{
  constexpr double alike = 30.0;
  const std::vector<Shown> shown = shownOf(stage);
  if (shown.size() < 2)
    return "";
  const auto [small, large] = std::minmax_element(shown.begin(), shown.end(),
    [](const Shown& a, const Shown& b)
    { return a.box.GetDiagonalLength() < b.box.GetDiagonalLength(); });
  const double least = small->box.GetDiagonalLength(), most = large->box.GetDiagonalLength();
  if (!(least > 0.0) || most < alike * least)
    return "";
  const auto nameOf = [](const Shown& one)
  { return std::filesystem::path(one.file).filename().string(); };
  return nameOf(*large) + " is " + asNumber(most, 3) + " across and " + nameOf(*small) + " " +
         asNumber(least, 3) + ", which is hardly seen beside it at one scale: --hide-data " +
         large->numbers + " shows the small alone";
}

std::vector<std::string> adviceOnData(const Stage& stage)
{
  std::vector<std::string> advice = {
    unlikeSizes(stage), hiddenBoundaries(stage.data(), stage.settings().selection)};
  std::erase(advice, "");
  return advice;
}

std::vector<std::string> adviceOn(const Stage& stage)
{
  std::vector<std::string> advice;
  if (stage.settings().views.sideBySide && !stage.parts().empty() && stage.views().size() < 2)
    advice.emplace_back("--side-by-side does nothing here: it takes two data sets that are shown");
  adviseOnVolumes(stage, advice);
  adviseOnParticles(stage, advice);
  adviseOnLight(stage, advice);
  adviseOnColors(stage, advice);
  adviseOnValues(stage, advice);
  // Of patches that are not shown the window tells: nobody asked a picture for them.
  if (const std::string sizes = unlikeSizes(stage); !sizes.empty())
    advice.push_back(sizes);
  return advice;
}

} // namespace mote::app
