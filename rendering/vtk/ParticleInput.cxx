#include "ParticleInput.h"

#include "vtkMoteParticleMapper.h"

#include "kernels/core/Error.h"

#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{

namespace
{

vtkDataArray* requireScalar(vtkPointSet* points, const std::string& name, const char* what)
{
  vtkDataArray* array = points->GetPointData()->GetArray(name.c_str());
  if (!array)
    throw Error("There is no point array \"" + name + "\" to take " + what +
                " from; there are: " + arrayNames(points->GetPointData()) + ".");
  if (array->GetNumberOfComponents() != 1)
    throw Error("The array \"" + name + "\" has " + std::to_string(array->GetNumberOfComponents()) +
                " components; " + what + " needs one.");
  return array;
}

vtkDataArray* findByLowerName(vtkPointData* data, const std::string& wanted)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (array && array->GetName() && array->GetNumberOfComponents() == 1 &&
        vtksys::SystemTools::LowerCase(array->GetName()) == wanted)
      return array;
  }
  return nullptr;
}

/// NaN differs from itself: as radii NaN and infinity are unfit alike.
void addRadius(InputKey& key, double radius)
{
  key.push_back(std::isnan(radius) ? std::numeric_limits<double>::infinity() : radius);
}

} // namespace

std::string arrayNames(vtkPointData* data)
{
  std::string names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    if (const char* name = data->GetArrayName(i))
      names += (names.empty() ? "" : ", ") + std::string(name);
  return names.empty() ? "none" : names;
}

vtkDataArray* findRadiusArray(vtkPointSet* points, const RadiusChoice& choice, bool& half)
{
  half = false;
  switch (choice.mode)
  {
  case vtkMoteParticleMapper::RADIUS_BY_ARRAY:
    return requireScalar(points, choice.radiusArray, "radii");
  case vtkMoteParticleMapper::RADIUS_BY_TYPE:
    return requireScalar(points, choice.typeArray, "types");
  case vtkMoteParticleMapper::RADIUS_AUTOMATIC:
    if (vtkDataArray* radius = findByLowerName(points->GetPointData(), "radius"))
      return radius;
    half = true;
    return findByLowerName(points->GetPointData(), "diameter");
  default:
    return nullptr;
  }
}

ParticleInput makeParticleInput(vtkPointSet* points, const RadiusChoice& choice)
{
  ParticleInput input;
  if (!points->GetPoints() || points->GetNumberOfPoints() == 0)
    return input;
  input.positions = DataArrayView(points->GetPoints()->GetData());
  input.set.positions = input.positions.view;
  input.set.radiusScale = choice.scale;

  bool half = false;
  vtkDataArray* array = findRadiusArray(points, choice, half);
  if (array && choice.mode == vtkMoteParticleMapper::RADIUS_BY_TYPE)
  {
    const DataArrayView types(array);
    input.typeRadii.resize(types.view.count());
    for (std::size_t i = 0; i < types.view.count(); ++i)
    {
      const auto found = choice.typeRadii.find(static_cast<int>(types.view.value(i)));
      input.typeRadii[i] = found == choice.typeRadii.end() ? choice.radius : found->second;
    }
    input.set.radii = ArrayView(input.typeRadii.data(), input.typeRadii.size(), 1);
  }
  else if (array)
  {
    input.radii = DataArrayView(array);
    input.set.radii = input.radii.view;
    input.set.radiusScale *= half ? 0.5 : 1.0;
  }
  else
  {
    const bool constant = choice.mode == vtkMoteParticleMapper::RADIUS_CONSTANT;
    input.set.radius = constant ? choice.radius : 0.5 * estimateSpacing(input.set.positions);
    input.commonRadius = input.set.radius * choice.scale;
  }
  return input;
}

void addArray(InputKey& key, vtkDataArray* array)
{
  key.push_back(array ? static_cast<double>(array->GetMTime()) : -1.0);
}

void addChoice(InputKey& key, const RadiusChoice& choice, vtkDataArray* radii, bool half)
{
  const bool byType = choice.mode == vtkMoteParticleMapper::RADIUS_BY_TYPE;
  key.insert(key.end(), {double(choice.mode), double(half)});
  addRadius(key, choice.scale);
  if (byType || choice.mode == vtkMoteParticleMapper::RADIUS_CONSTANT)
    addRadius(key, choice.radius);
  addArray(key, radii);
  if (byType)
    for (const auto& [type, radius] : choice.typeRadii)
    {
      key.push_back(type);
      addRadius(key, radius);
    }
}

ParticleStructureKind structureOf(const char* name)
{
  const std::vector<std::string>& names = particleStructureNames();
  const auto found = name && *name ? std::find(names.begin(), names.end(), name) : names.begin();
  if (found != names.end())
    return static_cast<ParticleStructureKind>(found - names.begin());
  std::string known;
  for (const std::string& n : names)
    known += (known.empty() ? "" : ", ") + n;
  throw Error(std::string("There is no structure \"") + name + "\"; there are: " + known + ".");
}

void buildStructure(std::shared_ptr<ParticleStructure>& structure, const ParticleSet& particles,
  const ParticleStructureOptions& options, const Progress& progress)
{
  // One that somebody else still looks at stays as it is.
  std::shared_ptr<ParticleStructure> used = structure.use_count() == 1 ? structure : nullptr;
  structure = nullptr;
  structure = makeParticleStructure(particles, options, progress, std::move(used));
}

std::string leftOutSentence(const ParticleStatistics& s)
{
  std::string text;
  if (s.badPositions > 0)
    text += std::to_string(s.badPositions) + " with a position that is not finite";
  if (s.badRadii > 0)
    text += (text.empty() ? "" : " and ") + std::to_string(s.badRadii) +
            " with a radius that is not a finite number above zero";
  return text;
}

} // namespace mote
