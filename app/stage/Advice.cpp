#include "Advice.h"

#include "Silhouettes.h"
#include "base/Text.h"

#include <algorithm>

namespace mote::app
{

namespace
{

bool has(const Stage& stage, Part::Kind kind)
{
  return std::any_of(stage.parts().begin(), stage.parts().end(),
    [kind](const auto& part) { return part->kind() == kind; });
}

/// What hides particles and values of volumes leaves surfaces whole.
void adviseOnSurfaces(const Stage& stage, std::vector<std::string>& advice)
{
  const SelectionSettings& selection = stage.settings().selection;
  const bool isLimiting = !selection.ranges.empty() || !selection.range.empty() ||
                          !selection.where.empty() || !selection.hidden.empty() ||
                          !selection.only.empty();
  if (isLimiting && has(stage, Part::Kind::Surface))
    advice.emplace_back("--show, --where and their like hide no triangles: surfaces stay whole");
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
    range[0] = any ? std::min(range[0], own[0]) : own[0];
    range[1] = any ? std::max(range[1], own[1]) : own[1];
    any = true;
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
  const VolumeSettings& volume = stage.settings().volume;
  if (!has(stage, Part::Kind::Volume))
  {
    VolumeSettings plain;
    plain.cells = volume.cells;
    plain.cloudTolerance = volume.cloudTolerance;
    if (volume != plain)
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
  if (!volume.cloud && volume.isoValues.empty())
    advice.push_back("--no-cloud leaves nothing of a volume without isosurfaces (--iso)");
  const bool exact = volume.integrator == "cell-by-cell";
  Idle idle;
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
  idle.add(given.radiusScale != plain.radiusScale, "--radius-scale");
  idle.add(given.structure != plain.structure, "--structure");
  idle.add(given.form != plain.form, "--form");
  idle.tell(advice, "there are no particles");
}

void adviseOnLight(const Stage& stage, std::vector<std::string>& advice)
{
  const Settings& settings = stage.settings();
  const LightSettings& light = settings.light;
  if (!has(stage, Part::Kind::Volume) || has(stage, Part::Kind::Particles) ||
      !settings.volume.isoValues.empty())
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
  idle.tell(advice, "a volume without isosurfaces (--iso) has no surface");
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
    idle.add(color.logarithmic, "--log");
    idle.add(picture.title.has_value(), "--title");
    return idle.tell(advice, "no array colours");
  }
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
    for (const double value : settings.volume.isoValues)
      if (value < range[0] || value > range[1])
        advice.push_back("--iso: there is no surface at " + asNumber(value) + "; " + whole);
  if (settings.color.logarithmic && range[0] <= 0.0)
    advice.push_back("--log: values at or below 0 have the colour of the least; " + whole);
}

} // namespace

std::vector<std::string> adviceOn(const Stage& stage)
{
  std::vector<std::string> advice;
  if (stage.settings().views.sideBySide && !stage.parts().empty() && stage.views().size() < 2)
    advice.emplace_back("--side-by-side does nothing here: it takes two data sets that are shown");
  adviseOnVolumes(stage, advice);
  adviseOnSurfaces(stage, advice);
  adviseOnParticles(stage, advice);
  adviseOnLight(stage, advice);
  adviseOnColors(stage, advice);
  adviseOnValues(stage, advice);
  return advice;
}

} // namespace mote::app
