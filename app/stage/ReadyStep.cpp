#include "ReadyStep.h"

#include "Calculated.h"
#include "Flow.h"
#include "HiddenParts.h"
#include "base/Failure.h"
#include "settings/ErrorBudget.h"

#include <vtkActor.h>
#include <vtkDataSet.h>

#include <algorithm>

namespace mote::app
{

namespace
{

bool hasSlices(const VolumeSettings& volume)
{
  return volume.slices && !volume.slices->empty();
}

} // namespace

bool ReadyPlan::fits(const ReadyPlan& other) const
{
  const VolumeSettings &a = settings.volume, &b = other.settings.volume;
  ParticleSettings particles = settings.particles;
  particles.replicate = other.settings.particles.replicate; // images of the same structure
  const auto allowsError = [](const Settings& s) { return errorShares(s).lodError > 0.0; };
  const bool hasSurfaces = std::any_of(
    kept.begin(), kept.end(), [](const Kept& one) { return one.kind == Part::Kind::Surface; });
  // Of surfaces hidden cells are not built, but hidden parts are.
  if (hasSurfaces &&
      (settings.selection != withPartsOf(settings.selection, other.settings.selection) ||
        colored != other.colored))
    return false;
  return kept == other.kept && particles == other.settings.particles &&
         allowsError(settings) == allowsError(other.settings) && a.cells == b.cells &&
         a.structure == b.structure && a.integrator == b.integrator && a.cloud == b.cloud &&
         a.isoValues.empty() == b.isoValues.empty() && // which need a structure
         (a.isoValues.empty() || a.isoArray == b.isoArray) &&
         hasSlices(a) == hasSlices(b) && // the same
         (a.walls.value_or(0.0) > 0.0) == (b.walls.value_or(0.0) > 0.0) &&
         settings.color.array == other.settings.color.array &&
         !Flow::areOther(settings, other.settings) && this->fitsCalculations(other.settings);
}

bool ReadyPlan::fitsCalculations(const Settings& other) const
{
  return !areOtherCalculations(settings, other);
}

void ReadyStep::count()
{
  memory.clear();
  for (const NamedData& one : data.empty() ? original : data)
    addMemory(memory, one.data);
  for (const BuiltPart& part : parts)
  {
    memory.insert(memory.end(), part.memory.begin(), part.memory.end());
    if (part.drawn)
      addMemory(memory, part.drawn);
  }
  for (vtkPolyData* triangles : {flow.lines.Get(), flow.arrows.Get()})
    if (triangles)
      addMemory(memory, triangles);
}

ReadyStep makeReady(const std::vector<NamedData>& original, const ReadyPlan& plan,
  const Runner& runner, const std::vector<BuiltPart>& before, FlowFinder& finder)
{
  ReadyStep ready;
  ready.original = original;
  ready.plan = plan;
  try
  {
    KnownExpressions none;
    ready.data = withCalculated(original, plan.settings, none);
    bool fits = plan.kept.size() == ready.data.size();
    for (std::size_t i = 0; fits && i < ready.data.size(); ++i)
      fits = Part::kindOf(ready.data[i].data, plan.settings) == plan.kept[i].kind;
    std::vector<std::unique_ptr<Part>> parts;
    for (std::size_t i = 0; fits && i < ready.data.size(); ++i)
    {
      ready.parts.emplace_back();
      parts.push_back(
        std::make_unique<Part>(ready.data[i].name, ready.data[i].data, plan.settings, 0.0));
      Part& part = *parts.back();
      part.keep(plan.kept[i].radius, plan.kept[i].colored);
      if (i < before.size())
        part.offer(before[i]);
      if (part.surface())
        part.limitCells(cellLimitsOf(part.data(), plan.settings.selection, plan.colored));
      part.setTurn(turnOf(original[i], plan.settings));
    }
    const std::vector<bool> isHidden = hiddenParts(original, plan.settings.selection);
    for (std::size_t i = 0; i < parts.size(); ++i)
      parts[i]->setHidden(isHidden[i]);
    joinWalls(parts);
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      parts[i]->build(runner);
      ready.parts[i] = parts[i]->built(true);
    }
    if (const std::vector<vtkDataSet*> volumes = volumesOf(parts);
        fits && !volumes.empty() && plan.settings.volume.opacity.empty() && plan.colored)
      ready.opacity = {plan.colored, opacitiesFor(volumes, plan.colored)};
    if (fits && Flow::isAny(plan.settings))
    {
      prepareFlow(parts, original, plan.settings, plan.colored);
      ready.flow = finder.find(parts, plan.settings, runner);
    }
  }
  catch (const Failure&)
  {
    // Who shows the step finds the same, and tells it.
    ready.parts.clear();
    ready.flow = {};
    ready.opacity = {};
  }
  ready.count();
  return ready;
}

ReadyStep withOwnData(const ReadyStep& step)
{
  ReadyStep own = step;
  const auto copy = [](auto& data)
  {
    const auto from = data;
    data.TakeReference(from->NewInstance());
    data->ShallowCopy(from);
  };
  for (NamedData& one : own.original)
    copy(one.data);
  for (BuiltPart& part : own.parts)
    if (part.drawn)
      copy(part.drawn);
  for (std::size_t i = 0; i < own.data.size(); ++i)
    if (i < step.original.size() && step.data[i].data == step.original[i].data)
      own.data[i].data = own.original[i].data;
    else
      copy(own.data[i].data);
  return own;
}

} // namespace mote::app
