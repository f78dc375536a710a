#include "vtkMoteParticlePicker.h"

#include "PixelPicker.h"
#include "SceneBridge.h"

#include "kernels/tracing/CloudPicking.h"
#include "kernels/tracing/Picking.h"

#include "vtkAssemblyPath.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>

vtkStandardNewMacro(vtkMoteParticlePicker);

namespace
{

vtkSmartPointer<vtkAssemblyPath> pathTo(const mote::MoteProp& found)
{
  auto path = vtkSmartPointer<vtkAssemblyPath>::New();
  path->AddNode(found.prop(), found.prop()->GetMatrix());
  return path;
}

} // namespace

vtkMoteParticlePicker::vtkMoteParticlePicker() = default;
vtkMoteParticlePicker::~vtkMoteParticlePicker() = default;

int vtkMoteParticlePicker::Pick(double x, double y, double z, vtkRenderer* renderer)
{
  this->Initialize();
  this->Renderer = renderer;
  this->SelectionPoint[0] = x;
  this->SelectionPoint[1] = y;
  this->SelectionPoint[2] = z;
  this->ParticleId = this->CellId = -1;
  this->Value = vtkMath::Nan();
  this->Distance = this->CloudOpacity = 0.0;
  std::fill_n(this->PickNormal, 3, 0.0);
  if (!renderer || !renderer->GetActiveCamera())
  {
    vtkErrorMacro("Picking needs a renderer with a camera.");
    return 0;
  }
  this->InvokeEvent(vtkCommand::StartPickEvent, nullptr);
  try
  {
    this->CastRay(x, y, this->GetPickFromList() ? this->GetPickList() : renderer->GetViewProps());
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
  }
  const bool picked = this->ParticleId >= 0 || this->CellId >= 0;
  if (picked)
    this->InvokeEvent(vtkCommand::PickEvent, nullptr);
  this->InvokeEvent(vtkCommand::EndPickEvent, nullptr);
  return picked ? 1 : 0;
}

void vtkMoteParticlePicker::CastRay(double x, double y, vtkPropCollection* props)
{
  mote::MoteProps pickable = mote::pickableProps(props);
  const mote::Scene scene = mote::sceneOf(this->Renderer, pickable);

  const int* size = this->Renderer->GetSize();
  const int* corner = this->Renderer->GetOrigin();
  if (size[0] < 1 || size[1] < 1)
    return;
  const mote::CameraRays rays(
    mote::cameraOf(this->Renderer, double(size[0]) / size[1], size[0], size[1]), size[0], size[1]);
  // Display coordinates name pixels; a pixel's ray goes through its centre.
  const double px = x - corner[0] + 0.5, py = y - corner[1] + 0.5;
  const mote::PixelPicker picker(scene, rays, this->PickClouds != 0);
  const auto [hit, cloud] = picker.at(px, py, mote::CloudPicker::Wanted::All);
  if (cloud)
  {
    this->SetPath(pathTo(*pickable[static_cast<std::size_t>(cloud->object)]));
    this->CellId = static_cast<vtkIdType>(cloud->cell);
    this->Value = cloud->value;
    this->Distance = cloud->t;
    this->CloudOpacity = cloud->opacity;
    std::copy_n(&cloud->position[0], 3, this->PickPosition);
    return;
  }
  if (!hit)
    return;
  const mote::MoteProp& found = *pickable[static_cast<std::size_t>(hit->object)];
  this->SetPath(pathTo(found));
  (found.picksCells() ? this->CellId : this->ParticleId) = static_cast<vtkIdType>(hit->id);
  this->Value = found.pickedValue(*hit);
  this->Distance = hit->t;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->PickPosition[axis] = hit->position[axis];
    this->PickNormal[axis] = hit->normal[axis];
  }
}

void vtkMoteParticlePicker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ParticleId: " << this->ParticleId << "\n";
  os << indent << "CellId: " << this->CellId << "\n";
  os << indent << "PickClouds: " << (this->PickClouds ? "On\n" : "Off\n");
  os << indent << "CloudOpacity: " << this->CloudOpacity << "\n";
  os << indent << "Value: " << this->Value << "\n";
  os << indent << "Distance: " << this->Distance << "\n";
}
