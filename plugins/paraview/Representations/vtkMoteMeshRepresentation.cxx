#include "vtkMoteMeshRepresentation.h"

#include "vtkMoteMeshMapper.h"

#include "vtkAppendFilter.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkMoteMeshRepresentation);

vtkMoteMeshRepresentation::vtkMoteMeshRepresentation() = default;
vtkMoteMeshRepresentation::~vtkMoteMeshRepresentation() = default;

vtkMapper* vtkMoteMeshRepresentation::GetMapper()
{
  return this->Mapper;
}

vtkSmartPointer<vtkPointSet> vtkMoteMeshRepresentation::Collect(
  const std::vector<vtkPointSet*>& parts)
{
  if (parts.empty())
    return vtkSmartPointer<vtkPolyData>::New();
  if (parts.size() == 1)
  {
    const auto own = vtk::TakeSmartPointer(parts.front()->NewInstance());
    own->ShallowCopy(parts.front());
    return own;
  }
  vtkNew<vtkAppendFilter> append;
  for (vtkPointSet* part : parts)
    append->AddInputData(part);
  append->Update();
  return append->GetOutput();
}

void vtkMoteMeshRepresentation::SetSamplesPerPixel(int samples)
{
  this->Mapper->SetSamplesPerPixel(samples);
}

void vtkMoteMeshRepresentation::SetPixelsOfError(double pixels)
{
  this->Mapper->SetPixelsOfError(pixels);
}
