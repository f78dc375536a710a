#include "../DataFile.h"
#include "ParticleInput.h"

#include <kernels/core/Error.h>

#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cctype>

namespace mote::bench
{

namespace
{

vtkDataArray* arrayNamed(vtkPointData* arrays, const std::string& wanted)
{
  for (int k = 0; k < arrays->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* array = arrays->GetArray(k);
    if (array == nullptr || array->GetName() == nullptr || array->GetNumberOfComponents() != 1)
      continue;
    std::string name = array->GetName();
    std::transform(name.begin(), name.end(), name.begin(),
      [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (name == wanted)
      return array;
  }
  return nullptr;
}

/// What one input's views look at.
struct FileParticles
{
  vtkSmartPointer<vtkDataObject> data;
  ArrayViews views;
};

} // namespace

ParticleInput readParticles(const std::string& fileName)
{
  const auto particles = std::make_shared<FileParticles>();
  particles->data = readLastStep(fileName);
  auto* points = vtkPointSet::SafeDownCast(particles->data);
  if (points == nullptr || points->GetNumberOfPoints() == 0)
    throw Error("The file \"" + fileName + "\" holds no particles.");

  ParticleInput input;
  input.set.positions = particles->views.of(points->GetPoints()->GetData());
  if (vtkDataArray* radii = arrayNamed(points->GetPointData(), "radius"))
    input.set.radii = particles->views.of(radii);
  else if (vtkDataArray* diameters = arrayNamed(points->GetPointData(), "diameter"))
  {
    input.set.radii = particles->views.of(diameters);
    input.set.radiusScale = 0.5;
  }
  else
    input.set.radius = 0.5 * estimateSpacing(input.set);
  input.owner = particles;
  return input;
}

} // namespace mote::bench
