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

void adviseOnVolumes(const Stage& stage, std::vector<std::string>& advice)
{
  const VolumeSettings& volume = stage.settings().volume;
  VolumeSettings plain;
  plain.cells = volume.cells;
  plain.cloudTolerance = volume.cloudTolerance;
  if (volume != plain && !has(stage, Part::Kind::Volume))
    advice.push_back("the options of volumes (mote help volume) do nothing here: there are no "
                     "cells that are shown as a volume");
}

void adviseOnSurfaces(const Stage& stage, std::vector<std::string>& advice)
{
  const Settings& settings = stage.settings();
  if (!has(stage, Part::Kind::Volume) || has(stage, Part::Kind::Particles) ||
      !settings.volume.isoValues.empty())
    return;
  std::vector<std::string> idle;
  if (settings.light.shadows != "none")
    idle.emplace_back("--shadows");
  if (settings.light.ambientOcclusion != "none")
    idle.emplace_back("--ambient-occlusion");
  if (areOn(settings.silhouettes))
    idle.emplace_back("--silhouettes");
  if (!idle.empty())
    advice.push_back(joined(idle, ", ") + (idle.size() > 1 ? " do" : " does") +
                     " nothing here: a volume without isosurfaces (--iso) has no surface");
}

void adviseOnValues(const Stage& stage, std::vector<std::string>& advice)
{
  const Settings& settings = stage.settings();
  double range[2];
  // The range takes a look at every value.
  if ((settings.volume.isoValues.empty() && !settings.color.logarithmic) || !rangeOf(stage, range))
    return;
  const std::string whole =
    stage.coloring().title() + " goes from " + asNumber(range[0]) + " to " + asNumber(range[1]);
  if (has(stage, Part::Kind::Volume))
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
  adviseOnVolumes(stage, advice);
  adviseOnSurfaces(stage, advice);
  adviseOnValues(stage, advice);
  return advice;
}

} // namespace mote::app
