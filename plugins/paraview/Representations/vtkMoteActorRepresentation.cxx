#include "vtkMoteActorRepresentation.h"

#include "PointParts.h"
#include "RankBoxes.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPVRenderView.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"

vtkMoteActorRepresentation::vtkMoteActorRepresentation() = default;
vtkMoteActorRepresentation::~vtkMoteActorRepresentation() = default;

int vtkMoteActorRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // ranks without data
  return 1;
}

bool vtkMoteActorRepresentation::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
    return false;
  this->Actor->SetMapper(this->GetMapper());
  renderView->GetRenderer()->AddActor(this->Actor);
  renderView->RegisterPropForHardwareSelection(this, this->Actor);
  return this->Superclass::AddToView(view);
}

bool vtkMoteActorRepresentation::RemoveFromView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
    return false;
  renderView->GetRenderer()->RemoveActor(this->Actor);
  renderView->UnRegisterPropForHardwareSelection(this, this->Actor);
  return this->Superclass::RemoveFromView(view);
}

int vtkMoteActorRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* input = inputs[0]->GetNumberOfInformationObjects() == 1
                           ? vtkDataObject::GetData(inputs[0], 0)
                           : nullptr;
  this->Drawn = this->Collect(mote::pointSetsOf(input));
  return this->Superclass::RequestData(request, inputs, outputs);
}

vtkDataObject* vtkMoteActorRepresentation::GetRenderedDataObject(int)
{
  return this->Drawn;
}

int vtkMoteActorRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
    return 0;
  if (!this->Drawn)
    this->Drawn = this->Collect({});
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    vtkPVView::SetPiece(inInfo, this, this->Drawn);
    this->TellBounds(inInfo, outInfo);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->Connect(vtkPVRenderView::GetPieceProducer(inInfo, this));
    this->FollowColors();
  }
  return 1;
}

/// IceT clips to the bounds, and orders ranks by them.
void vtkMoteActorRepresentation::TellBounds(vtkInformation* inInfo, vtkInformation* outInfo)
{
  const double reach = this->GetReach();
  vtkBoundingBox box = mote::ownBoundsOf(this->Drawn);
  if (box.IsValid())
    box.Inflate(reach);
  vtkNew<vtkMatrix4x4> matrix;
  this->Actor->GetMatrix(matrix);
  // What a ghost covers is not drawn, so that boxes without the radii tell the order.
  const mote::RankFacts ranks = mote::factsOfRanks(this->Drawn);
  this->HaveBoxesAndGhosts = ranks.haveBoxes && ranks.haveGhosts;
  mote::tellBounds(inInfo, this, box,
    ranks.haveBoxes ? mote::keptBoxOf(this->Drawn) : mote::withoutOverlap(box), matrix);
  if (this->HaveBoxesAndGhosts || this->IsTranslucent())
    outInfo->Set(vtkPVRenderView::NEED_ORDERED_COMPOSITING(), 1);
}

void vtkMoteActorRepresentation::Connect(vtkAlgorithmOutput* piece)
{
  this->GetMapper()->SetInputConnection(piece);
}

bool vtkMoteActorRepresentation::IsTranslucent()
{
  vtkMapper* mapper = this->GetMapper();
  vtkScalarsToColors* colors = mapper->GetScalarVisibility() ? mapper->GetLookupTable() : nullptr;
  return this->Actor->GetProperty()->GetOpacity() < 1.0 || (colors && !colors->IsOpaque());
}

/// Which array colours: ParaView tells it as the array to process.
void vtkMoteActorRepresentation::FollowColors()
{
  vtkMapper* mapper = this->GetMapper();
  auto* input = vtkPointSet::SafeDownCast(mapper->GetInputDataObject(0, 0));
  vtkInformation* info = this->GetInputArrayInformation(0);
  const char* name = info && info->Has(vtkDataObject::FIELD_NAME())
                       ? info->Get(vtkDataObject::FIELD_NAME())
                       : nullptr;
  const bool ofCells =
    info && info->Has(vtkDataObject::FIELD_ASSOCIATION()) &&
    info->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  vtkFieldData* from = !input    ? nullptr
                       : ofCells ? static_cast<vtkFieldData*>(input->GetCellData())
                                 : input->GetPointData();
  const bool isColored = name && *name && from && from->HasArray(name);
  mapper->SetScalarVisibility(isColored);
  if (!isColored)
    return;
  mapper->SetScalarMode(
    ofCells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  mapper->SelectColorArray(name);
  mapper->SetUseLookupTableScalarRange(1);
}

void vtkMoteActorRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->Actor->SetVisibility(visible);
}

void vtkMoteActorRepresentation::SetLookupTable(vtkScalarsToColors* colors)
{
  this->GetMapper()->SetLookupTable(colors);
}

void vtkMoteActorRepresentation::SetMapScalars(int map)
{
  this->GetMapper()->SetColorMode(map ? VTK_COLOR_MODE_MAP_SCALARS : VTK_COLOR_MODE_DIRECT_SCALARS);
}

void vtkMoteActorRepresentation::SetOrientation(double x, double y, double z)
{
  this->Actor->SetOrientation(x, y, z);
}

void vtkMoteActorRepresentation::SetOrigin(double x, double y, double z)
{
  this->Actor->SetOrigin(x, y, z);
}

void vtkMoteActorRepresentation::SetPosition(double x, double y, double z)
{
  this->Actor->SetPosition(x, y, z);
}

void vtkMoteActorRepresentation::SetScale(double x, double y, double z)
{
  this->Actor->SetScale(x, y, z);
}

void vtkMoteActorRepresentation::SetPickable(int pickable)
{
  this->Actor->SetPickable(pickable);
}

void vtkMoteActorRepresentation::SetAmbientColor(double r, double g, double b)
{
  this->Actor->GetProperty()->SetAmbientColor(r, g, b);
}

void vtkMoteActorRepresentation::SetDiffuseColor(double r, double g, double b)
{
  this->Actor->GetProperty()->SetDiffuseColor(r, g, b);
}

void vtkMoteActorRepresentation::SetSpecularColor(double r, double g, double b)
{
  this->Actor->GetProperty()->SetSpecularColor(r, g, b);
}

void vtkMoteActorRepresentation::SetOpacity(double opacity)
{
  this->Actor->GetProperty()->SetOpacity(opacity);
}

void vtkMoteActorRepresentation::SetAmbient(double share)
{
  this->Actor->GetProperty()->SetAmbient(share);
}

void vtkMoteActorRepresentation::SetDiffuse(double share)
{
  this->Actor->GetProperty()->SetDiffuse(share);
}

void vtkMoteActorRepresentation::SetSpecular(double share)
{
  this->Actor->GetProperty()->SetSpecular(share);
}

void vtkMoteActorRepresentation::SetSpecularPower(double power)
{
  this->Actor->GetProperty()->SetSpecularPower(power);
}

void vtkMoteActorRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper:\n";
  this->GetMapper()->PrintSelf(os, indent.GetNextIndent());
}
