#include "vtkMoteVolumeRepresentation.h"

#include "RankBoxes.h"
#include "vtkMoteLinearCells.h"
#include "vtkMoteVolumeMapper.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkAppendFilter.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h" // which the superclass holds
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

vtkStandardNewMacro(vtkMoteVolumeRepresentation);

vtkMoteVolumeRepresentation::vtkMoteVolumeRepresentation()
  : Grid(vtkSmartPointer<vtkUnstructuredGrid>::New())
{
  this->Volume->SetMapper(this->Mapper);
  // Without an input mappers of volumes say that they reach from -1 to 1, which a view would be
  // reset to before its first picture.
  this->Volume->UseBoundsOff();
  this->Volume->SetProperty(this->Property);
}

vtkMoteVolumeRepresentation::~vtkMoteVolumeRepresentation() = default;

int vtkMoteVolumeRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // ranks without data
  return 1;
}

bool vtkMoteVolumeRepresentation::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
    return false;
  renderView->GetRenderer()->AddVolume(this->Volume);
  renderView->RegisterPropForHardwareSelection(this, this->Volume);
  return this->Superclass::AddToView(view);
}

bool vtkMoteVolumeRepresentation::RemoveFromView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
    return false;
  renderView->GetRenderer()->RemoveVolume(this->Volume);
  renderView->UnRegisterPropForHardwareSelection(this, this->Volume);
  return this->Superclass::RemoveFromView(view);
}

int vtkMoteVolumeRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkDataObject* input = inputs[0]->GetNumberOfInformationObjects() == 1
                           ? vtkDataObject::GetData(inputs[0], 0)
                           : nullptr;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkNew<vtkAppendFilter> append;
    const auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
      if (auto* part = vtkUnstructuredGrid::SafeDownCast(it->GetCurrentDataObject()))
        append->AddInputData(part);
    if (append->GetNumberOfInputConnections(0) > 0)
      append->Update();
    this->Grid->ShallowCopy(append->GetOutput());
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(input))
    this->Grid->ShallowCopy(grid);
  const auto cells = vtk::TakeSmartPointer(vtkMoteLinearCells::Of(this->Grid));
  this->Grid = vtkUnstructuredGrid::SafeDownCast(cells);
  return this->Superclass::RequestData(request, inputs, outputs);
}

vtkDataObject* vtkMoteVolumeRepresentation::GetRenderedDataObject(int)
{
  return this->Grid;
}

int vtkMoteVolumeRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
    return 0;
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    vtkPVView::SetPiece(inInfo, this, this->Grid);
    vtkBoundingBox bounds;
    if (this->Grid->GetNumberOfPoints() > 0)
      bounds.SetBounds(this->Grid->GetBounds());
    vtkPVRenderView::SetRequiresDistributedRendering(inInfo, this, true);
    mote::tellBounds(inInfo, this, bounds, mote::withoutOverlap(bounds));
    outInfo->Set(vtkPVRenderView::NEED_ORDERED_COMPOSITING(), 1);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->Mapper->SetInputConnection(vtkPVRenderView::GetPieceProducer(inInfo, this));
    this->Volume->UseBoundsOn();
    this->FollowArray();
    // The mapper would complain of ranks without cells.
    auto* grid = vtkDataSet::SafeDownCast(this->Mapper->GetInputDataObject(0, 0));
    this->Volume->SetVisibility(this->GetVisibility() && grid && grid->GetNumberOfCells() > 0);
  }
  return 1;
}

/// Which array is seen: ParaView tells it as the array to process.
void vtkMoteVolumeRepresentation::FollowArray()
{
  vtkInformation* info = this->GetInputArrayInformation(0);
  if (!info || !info->Has(vtkDataObject::FIELD_NAME()))
    return;
  const bool ofCells =
    info->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  this->Mapper->SetScalarMode(
    ofCells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  this->Mapper->SelectScalarArray(info->Get(vtkDataObject::FIELD_NAME()));
}

void vtkMoteVolumeRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->Volume->SetVisibility(visible);
}

void vtkMoteVolumeRepresentation::SetIntegratorName(const char* name)
{
  this->Mapper->SetIntegratorName(name);
}

void vtkMoteVolumeRepresentation::SetTolerance(double tolerance)
{
  this->Mapper->SetTolerance(tolerance);
}

void vtkMoteVolumeRepresentation::SetCloudTolerance(double tolerance)
{
  this->Mapper->SetCloudTolerance(tolerance);
}

void vtkMoteVolumeRepresentation::SetSamplesPerPixel(int samples)
{
  this->Mapper->SetSamplesPerPixel(samples);
}

void vtkMoteVolumeRepresentation::SetShade(int shade)
{
  this->Property->SetShade(shade);
}

void vtkMoteVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
