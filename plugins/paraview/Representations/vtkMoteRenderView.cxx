#include "vtkMoteRenderView.h"

#include "vtkMoteAreaLight.h"
#include "vtkMoteRayCastPass.h"
#include "vtkMoteShading.h"
#include "vtkMoteSilhouettes.h"

#include "vtkLight.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVSynchronizedRenderer.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkMoteRenderView);

namespace
{

/// The share of the longest side that rays of ambient occlusion go where nothing else is said, as
/// in mote::occlusionReach().
constexpr double reachOfBounds = 0.1;

} // namespace

vtkMoteRenderView::vtkMoteRenderView()
{
  // Around the pass stay ParaView's own camera pass and the compositing of ranks.
  this->SynchronizedRenderers->SetRenderPass(this->Pass);
  this->Pass->GetSilhouettes()->SetThresholdModeToRadii();
  this->Pass->GetSilhouettes()->SetThreshold(10.0);
  this->Light->SetLightTypeToCameraLight();
  this->Light->SetPosition(-0.5, 0.6, 0.62);
  this->Light->SetIntensity(0.8);
  this->Fill->SetLightTypeToHeadlight();
  this->Fill->SetIntensity(0.28);
  this->SetUseFXAA(false);
}

vtkMoteRenderView::~vtkMoteRenderView() = default;

void vtkMoteRenderView::SetSamplesPerPixel(int samples)
{
  this->Pass->SetSamplesPerPixel(samples);
}

void vtkMoteRenderView::SetAmbientOcclusion(int how)
{
  this->Pass->GetShading()->SetAmbientOcclusion(how);
}

void vtkMoteRenderView::SetAmbientOcclusionReach(double reach)
{
  this->OcclusionReach = reach;
  this->Pass->GetShading()->SetAmbientOcclusionReach(reach);
}

void vtkMoteRenderView::SetPathTracing(int on)
{
  this->Pass->GetShading()->SetMode(on ? vtkMoteShading::PATH_TRACED : vtkMoteShading::LOCAL);
}

void vtkMoteRenderView::SetCloudTolerance(double tolerance)
{
  this->Pass->GetShading()->SetCloudTolerance(tolerance);
}

double vtkMoteRenderView::GetTraceTime()
{
  return this->Pass->GetTraceTime();
}

void vtkMoteRenderView::SetMoteShadows(int on)
{
  if (this->HasShadows == (on != 0))
    return;
  this->HasShadows = on != 0;
  vtkRenderer* renderer = this->GetRenderer();
  for (vtkLight* light : {static_cast<vtkLight*>(this->Light), this->Fill.Get()})
    if (this->HasShadows)
      renderer->AddLight(light);
    else
      renderer->RemoveLight(light);
  this->SetUseLightKit(!this->HasShadows);
}

void vtkMoteRenderView::SetMoteLightSize(double degrees)
{
  this->Light->SetSize(degrees);
}

void vtkMoteRenderView::AboutToRenderOnLocalProcess(bool interactive)
{
  // The kit would light the shadows from all sides; its own property may have come later.
  if (this->HasShadows && this->GetUseLightKit())
    this->SetUseLightKit(false);
  // By itself each rank would take a tenth of what it has.
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (this->OcclusionReach <= 0.0 && controller && controller->GetNumberOfProcesses() > 1 &&
      this->GeometryBounds.IsValid())
    this->Pass->GetShading()->SetAmbientOcclusionReach(
      reachOfBounds * this->GeometryBounds.GetMaxLength());
  this->Superclass::AboutToRenderOnLocalProcess(interactive);
}

void vtkMoteRenderView::SetSilhouettes(int on)
{
  this->Pass->GetSilhouettes()->SetEnabled(on != 0);
}

void vtkMoteRenderView::SetSilhouetteThreshold(double radii)
{
  this->Pass->GetSilhouettes()->SetThreshold(radii);
}

void vtkMoteRenderView::SetSilhouetteThickness(double pixels)
{
  this->Pass->GetSilhouettes()->SetThickness(pixels);
}

void vtkMoteRenderView::SetSilhouetteColor(double r, double g, double b)
{
  this->Pass->GetSilhouettes()->SetColor(r, g, b);
}

void vtkMoteRenderView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Pass:\n";
  this->Pass->PrintSelf(os, indent.GetNextIndent());
}
