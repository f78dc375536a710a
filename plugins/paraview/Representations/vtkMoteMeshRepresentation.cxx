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

void vtkMoteMeshRepresentation::Connect(vtkAlgorithmOutput* piece)
{
  this->Superclass::Connect(piece);
  // A ghost that light goes through would hide what this rank has behind it.
  this->Mapper->SetMeetsGhosts(this->HaveBoxesAndGhosts && !this->IsTranslucent());
}

void vtkMoteMeshRepresentation::SetSamplesPerPixel(int samples)
{
  this->Mapper->SetSamplesPerPixel(samples);
}

void vtkMoteMeshRepresentation::SetPixelsOfError(double pixels)
{
  this->Mapper->SetPixelsOfError(pixels);
}
