#include "ValuesOverTime.h"

#include "Arrays.h"
#include "Ids.h"
#include "Part.h"
#include "Plot.h"
#include "base/OutputFile.h"
#include "settings/Values.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace mote::app
{

namespace
{

std::atomic<std::uint64_t> made{0};

} // namespace

ValuesOverTime::ValuesOverTime(std::unique_ptr<Input> input, Followed followed,
  const Settings& settings, const std::weak_ptr<StepCache>& cache)
  : followed_(std::move(followed))
  , number_(++made)
  , read_(static_cast<std::size_t>(input->numberOfSteps()))
  , reader_(std::move(input), settings, cache,
      [this](int step, const std::vector<NamedData>& data)
      {
        Step found = this->look(data);
        const std::lock_guard lock(mutex_);
        for (const auto& [name, values] : found)
          if (const auto [first, isNew] = firstOf_.emplace(name, step); !isNew)
            first->second = std::min(first->second, step);
        read_[static_cast<std::size_t>(step)] = std::move(found);
        ++stepsRead_;
      })
{
}

ValuesOverTime::Step ValuesOverTime::look(const std::vector<NamedData>& data) const
{
  Step step;
  for (std::size_t k = 0; k < data.size(); ++k)
    if (Part::isMesh(data[k].data))
      this->lookAtCells(k, data[k].data, step);
    else
      this->lookAtParticles(k, data[k].data, step);
  return step;
}

void ValuesOverTime::lookAtParticles(std::size_t set, vtkDataSet* particles, Step& step) const
{
  vtkDataArray* ids = idArrayOf(particles);
  const auto wanted = followed_.ids.of(static_cast<int>(set) + 1);
  std::vector<std::pair<vtkIdType, Particle>> found;
  for (vtkIdType i = 0; i < particles->GetNumberOfPoints(); ++i)
    if (const std::int64_t id = idOf(ids, i); holds(wanted, id))
      found.push_back({i, {set, id}});
  for (const auto& [i, particle] : found)
  {
    double place[3];
    particles->GetPoint(i, place);
    for (std::size_t axis = 0; axis < 3; ++axis)
      step[std::string(1, "xyz"[axis])][particle] = place[axis];
  }
  for (const std::string& name : numbersOf(particles, false))
  {
    const ArrayChoice choice = findArray(particles, name);
    vtkDataArray* array = arrayOf(particles, choice);
    if (!array || array == ids || array->GetNumberOfTuples() != particles->GetNumberOfPoints())
      continue;
    for (const auto& [i, particle] : found)
      step[name][particle] = valueOf(array, choice.component, i);
  }
}

void ValuesOverTime::lookAtCells(std::size_t set, vtkDataSet* mesh, Step& step) const
{
  for (const PlaceInCell& place : followed_.places)
  {
    // Of a mesh that has become another one nothing is known.
    const bool isThere = place.set == set && place.cell < mesh->GetNumberOfCells() &&
                         std::all_of(place.weights.begin(), place.weights.end(),
                           [&](const auto& one) { return one.first < mesh->GetNumberOfPoints(); });
    if (!isThere)
      continue;
    const Particle key{set, place.cell};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      double at = 0.0;
      for (const auto& [point, weight] : place.weights)
        at += weight * mesh->GetPoint(point)[axis];
      step[std::string(1, "xyz"[axis])][key] = at;
    }
    for (const bool ofCells : {false, true})
      for (const std::string& name : numbersOf(mesh, ofCells))
      {
        const ArrayChoice choice = findArray(mesh, name);
        if (vtkDataArray* array = choice.ofCells == ofCells ? arrayOf(mesh, choice) : nullptr)
          step[name][key] = ofCells ? valueOf(array, choice.component, place.cell)
                                    : valueBetween(place.weights, array, choice.component);
      }
  }
}

int ValuesOverTime::stepsRead() const
{
  const std::lock_guard lock(mutex_);
  return stepsRead_;
}

bool ValuesOverTime::isRead(int step) const
{
  const std::lock_guard lock(mutex_);
  return read_[static_cast<std::size_t>(step)].has_value();
}

std::vector<std::string> ValuesOverTime::names() const
{
  const std::lock_guard lock(mutex_);
  std::vector<std::string> names = {"x", "y", "z"};
  std::vector<std::pair<int, std::string>> others; // whatever was read first
  for (const auto& [name, step] : firstOf_)
    if (std::find(names.begin(), names.end(), name) == names.end())
      others.emplace_back(step, name);
  std::sort(others.begin(), others.end());
  for (const auto& [step, name] : others)
    names.push_back(name);
  return names;
}

std::vector<ValuesOverTime::Curve> ValuesOverTime::curves(const std::string& name) const
{
  const std::lock_guard lock(mutex_);
  std::set<Particle> particles; // also those without this value: colours are those of paths
  for (const auto& step : read_)
    if (step && step->contains("x"))
      for (const auto& [particle, value] : step->at("x"))
        particles.insert(particle);
  std::vector<Curve> curves;
  for (const Particle& particle : particles)
  {
    Curve curve{particle.first, particle.second, {}};
    for (const auto& step : read_)
    {
      const bool isKnown = step && step->contains(name) && step->at(name).contains(particle);
      curve.values.push_back(
        isKnown ? step->at(name).at(particle) : std::numeric_limits<double>::quiet_NaN());
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

void ValuesOverTime::write(const std::string& file, const std::vector<double>& times) const
{
  const std::vector<std::string> names = this->names();
  std::vector<std::vector<Curve>> all;
  for (const std::string& name : names)
    all.push_back(this->curves(name));
  std::string text = "step,time,id";
  for (const std::string& name : names)
    text += "," + name;
  text += "\n";
  const std::size_t steps = all.front().empty() ? 0 : all.front().front().values.size();
  const bool hasSets = !all.front().empty() && all.front().back().set > 0;
  for (std::size_t s = 0; s < steps; ++s)
    for (std::size_t p = 0; p < all.front().size(); ++p)
    {
      const Curve& where = all.front()[p];
      if (std::isnan(where.values[s]))
        continue; // it is not there
      text += std::to_string(s + 1) + "," + (s < times.size() ? exactText(times[s]) : "") + "," +
              (hasSets ? std::to_string(where.set + 1) + "/" : "") + std::to_string(where.id);
      for (const std::vector<Curve>& curves : all)
        text += "," + (std::isnan(curves[p].values[s]) ? "" : exactText(curves[p].values[s]));
      text += "\n";
    }
  writeText(file, text);
}

} // namespace mote::app
