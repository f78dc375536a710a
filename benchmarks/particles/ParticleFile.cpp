#include "ParticleInput.h"

#include <kernels/core/Error.h>

#include <vtkAlgorithm.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkMoteReaderTable.h>
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
  std::vector<vtkSmartPointer<vtkDoubleArray>> copies;

  /// Float and double as they are, other types as a copy in double.
  ArrayView view(vtkDataArray* array)
  {
    const auto count = static_cast<std::size_t>(array->GetNumberOfTuples());
    const int components = array->GetNumberOfComponents();
    if (array->HasStandardMemoryLayout() && array->GetDataType() == VTK_FLOAT)
      return {static_cast<const float*>(array->GetVoidPointer(0)), count, components};
    if (!array->HasStandardMemoryLayout() || array->GetDataType() != VTK_DOUBLE)
    {
      copies.push_back(vtkSmartPointer<vtkDoubleArray>::New());
      copies.back()->DeepCopy(array);
      array = copies.back();
    }
    return {static_cast<const double*>(array->GetVoidPointer(0)), count, components};
  }
};

vtkSmartPointer<vtkDataObject> readLastStep(const std::string& fileName)
{
  std::string error;
  const vtkSmartPointer<vtkAlgorithm> reader = vtkMoteReaderTable::MakeReader(fileName, error);
  if (!reader)
    throw Error(error);
  const std::vector<double> times = vtkMoteReaderTable::GetTimeSteps(reader, error);
  if (!error.empty())
    throw Error(error);
  const vtkSmartPointer<vtkDataObject> data =
    times.empty() ? vtkMoteReaderTable::Read(reader, error)
                  : vtkMoteReaderTable::Read(reader, times.back(), error);
  if (!data)
    throw Error(error);
  return data;
}

} // namespace

ParticleInput readParticles(const std::string& fileName)
{
  const auto particles = std::make_shared<FileParticles>();
  particles->data = readLastStep(fileName);
  auto* points = vtkPointSet::SafeDownCast(particles->data);
  if (points == nullptr || points->GetNumberOfPoints() == 0)
    throw Error("The file \"" + fileName + "\" holds no particles.");

  ParticleInput input;
  input.set.positions = particles->view(points->GetPoints()->GetData());
  if (vtkDataArray* radii = arrayNamed(points->GetPointData(), "radius"))
    input.set.radii = particles->view(radii);
  else if (vtkDataArray* diameters = arrayNamed(points->GetPointData(), "diameter"))
  {
    input.set.radii = particles->view(diameters);
    input.set.radiusScale = 0.5;
  }
  else
    input.set.radius = 0.5 * estimateSpacing(input.set);
  input.owner = particles;
  return input;
}

} // namespace mote::bench
