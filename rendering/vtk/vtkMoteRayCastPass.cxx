#include "vtkMoteRayCastPass.h"

#include "DrawStep.h"
#include "RendererImage.h"
#include "SceneBridge.h"
#include "vtkMoteShading.h"
#include "vtkMoteSilhouettes.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"

vtkStandardNewMacro(vtkMoteRayCastPass);
vtkCxxSetSmartPointerMacro(vtkMoteRayCastPass, Shading, vtkMoteShading);
vtkCxxSetSmartPointerMacro(vtkMoteRayCastPass, Silhouettes, vtkMoteSilhouettes);

class vtkMoteRayCastPass::Internals
{
public:
  /// After the opaque step. It must come after opaque props, over which edges are blended, and
  /// before translucent ones.
  vtkNew<mote::DrawStep> step;
  vtkSmartPointer<vtkRenderPass> delegate;
  mote::RendererImages images;
  mote::MoteProps props;                     ///< of the frame being drawn
  const mote::RendererImage* last = nullptr; ///< that was drawn; null: none yet

  const mote::FrameTracer& tracer() const
  {
    static const mote::FrameTracer none{};
    return last ? last->tracer() : none;
  }
};

vtkMoteRayCastPass::vtkMoteRayCastPass()
  : Shading(vtkSmartPointer<vtkMoteShading>::New())
  , Silhouettes(vtkSmartPointer<vtkMoteSilhouettes>::New())
  , Impl(std::make_unique<Internals>())
{
  this->Impl->step->Draw = [this](vtkRenderer* renderer) { this->DrawImage(renderer); };
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSequencePass> sequence;
  vtkNew<vtkRenderPassCollection> passes;
  vtkNew<vtkOpaquePass> opaque;
  passes->AddItem(opaque);
  passes->AddItem(this->Impl->step);
  sequence->SetPasses(passes);
  steps->SetOpaquePass(sequence);
  this->Impl->delegate = steps;
}

vtkMoteRayCastPass::~vtkMoteRayCastPass() = default;

vtkMoteShading* vtkMoteRayCastPass::GetShading()
{
  return this->Shading;
}

vtkMoteSilhouettes* vtkMoteRayCastPass::GetSilhouettes()
{
  return this->Silhouettes;
}

void vtkMoteRayCastPass::SetDelegatePass(vtkRenderPass* pass)
{
  if (this->Impl->delegate == pass)
    return;
  this->Impl->delegate = pass;
  this->Modified();
}

vtkRenderPass* vtkMoteRayCastPass::GetDelegatePass()
{
  return this->Impl->delegate;
}

vtkRenderPass* vtkMoteRayCastPass::GetImagePass()
{
  return this->Impl->step;
}

void vtkMoteRayCastPass::Render(const vtkRenderState* state)
{
  this->NumberOfRenderedProps = 0;
  if (state->GetRenderer()->GetSelector())
  {
    mote::renderSelection(state);
    return;
  }
  this->Impl->props.clear();
  std::vector<vtkProp*> others;
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = state->GetPropArray()[i];
    if (auto ours = mote::motePropOf(prop))
      this->Impl->props.push_back(std::move(ours));
    else
      others.push_back(prop);
  }
  if (!this->Impl->delegate)
  {
    vtkErrorMacro("There is no delegate pass.");
    return;
  }
  vtkRenderState rest(state->GetRenderer());
  rest.SetPropArrayAndCount(others.data(), static_cast<int>(others.size()));
  rest.SetFrameBuffer(state->GetFrameBuffer());
  rest.SetRequiredKeys(state->GetRequiredKeys());
  this->Impl->delegate->Render(&rest);
  this->NumberOfRenderedProps += this->Impl->delegate->GetNumberOfRenderedProps();
}

void vtkMoteRayCastPass::DrawImage(vtkRenderer* renderer)
{
  Internals& impl = *this->Impl;
  mote::FrameSettings settings;
  settings.refinement = {this->SamplesPerPixel, this->NoiseLevel};
  settings.progressive = this->Progressive != 0;
  settings.refines = this->Refining != 0;
  settings.autoAdjust = this->AutoAdjustResolution != 0;
  settings.frameTime = this->InteractiveFrameTime;
  settings.mostDistance = this->MostDistance;
  settings.roughDrafts = this->RoughDrafts != 0;
  settings.threads = this->NumberOfThreads;
  settings.shading = this->Shading;
  settings.silhouettes = this->Silhouettes;
  mote::RendererImage& image = impl.images.of(renderer);
  impl.last = &image;
  const bool shown = image.render(this, renderer, impl.props, settings,
    [this](double done)
    {
      this->InvokeEvent(vtkCommand::ProgressEvent, &done);
      return true;
    });
  if (shown)
    this->NumberOfRenderedProps += static_cast<int>(impl.props.size());
}

void vtkMoteRayCastPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Impl->last = nullptr;
  this->Impl->images.release(window);
  if (this->Impl->delegate)
    this->Impl->delegate->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

bool vtkMoteRayCastPass::IsConverged()
{
  return !this->Impl->last || this->Impl->last->converged();
}

bool vtkMoteRayCastPass::IsPreview()
{
  return this->Impl->last && this->Impl->last->shown() && this->Impl->tracer().preview();
}

double vtkMoteRayCastPass::GetImageSampleDistance()
{
  return this->Impl->tracer().distance();
}

int vtkMoteRayCastPass::GetNumberOfSamples()
{
  return this->Impl->last && this->Impl->last->shown() ? this->Impl->tracer().samples() : 0;
}

double vtkMoteRayCastPass::GetBakedShare()
{
  return this->Impl->last ? this->Impl->tracer().bakedShare() : 1.0;
}

double vtkMoteRayCastPass::GetFinerShare()
{
  return this->Impl->tracer().finerShare();
}

double vtkMoteRayCastPass::GetNoise()
{
  return this->Impl->tracer().noise();
}

vtkTypeInt64 vtkMoteRayCastPass::GetNumberOfRays()
{
  return this->Impl->tracer().rays();
}

double vtkMoteRayCastPass::GetTraceTime()
{
  return this->Impl->tracer().seconds();
}

double vtkMoteRayCastPass::GetDisplayTime()
{
  return this->Impl->last ? this->Impl->last->displayTime() : 0.0;
}

double vtkMoteRayCastPass::GetSilhouetteTime()
{
  return this->Impl->tracer().silhouetteSeconds();
}

void vtkMoteRayCastPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SamplesPerPixel: " << this->SamplesPerPixel << "\n";
  os << indent << "NoiseLevel: " << this->NoiseLevel << "\n";
  os << indent << "Progressive: " << (this->Progressive ? "On" : "Off") << "\n";
  os << indent << "Refining: " << (this->Refining ? "On" : "Off") << "\n";
  os << indent << "AutoAdjustResolution: " << (this->AutoAdjustResolution ? "On" : "Off") << "\n";
  os << indent << "InteractiveFrameTime: " << this->InteractiveFrameTime << "\n";
  os << indent << "MostDistance: " << this->MostDistance << "\n";
  os << indent << "RoughDrafts: " << (this->RoughDrafts ? "On" : "Off") << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "Shading: " << this->Shading << "\n";
  os << indent << "Silhouettes: " << this->Silhouettes << "\n";
  os << indent << "DelegatePass: " << this->Impl->delegate << "\n";
}
