#include "vtkMoteSilhouettePass.h"

#include "DrawStep.h"
#include "FilmDisplay.h"
#include "SceneBridge.h"
#include "SilhouetteTracer.h"
#include "WindowDepth.h"
#include "vtkMoteRayCastPass.h"
#include "vtkMoteSilhouettes.h"

#include "vtkBoundingBox.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLState.h"
#include "vtkPropCollection.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkVolumetricPass.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <vector>

vtkStandardNewMacro(vtkMoteSilhouettePass);
vtkCxxSetSmartPointerMacro(vtkMoteSilhouettePass, Silhouettes, vtkMoteSilhouettes);

class vtkMoteSilhouettePass::Internals
{
public:
  vtkNew<mote::DrawStep> step;
  vtkSmartPointer<vtkRenderPass> delegate;
  bool drawn = false; ///< by the step, in this frame
  mote::WindowDepthReader reader;
  mote::FilmDisplay display;
  mote::Film nothing; ///< that the lines are drawn over
  mote::SilhouetteFilm film;
  unsigned long version = 0;
  std::string reported; ///< last problem, so that it is told once and not every frame
  double seconds = 0.0;

  void findSilhouettes(vtkRenderer* renderer, vtkMoteSilhouettes* silhouettes);
  void draw(vtkRenderer* renderer, vtkMoteSilhouettes* silhouettes);
};

namespace
{

/// The particles of Mote that a renderer shows.
mote::Scene particlesOf(vtkRenderer* renderer)
{
  mote::Scene scene;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator next;
  props->InitTraversal(next);
  while (vtkProp* prop = props->GetNextProp(next))
    if (const auto ours = prop->GetVisibility() ? mote::motePropOf(prop) : nullptr)
      ours->describe(scene, 0);
  return scene;
}

double diagonalOf(vtkRenderer* renderer)
{
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  const vtkBoundingBox box(bounds);
  return box.IsValid() ? box.GetDiagonalLength() : 0.0;
}

} // namespace

void vtkMoteSilhouettePass::Internals::findSilhouettes(
  vtkRenderer* renderer, vtkMoteSilhouettes* silhouettes)
{
  const auto start = std::chrono::steady_clock::now();
  const mote::WindowDepth depth = this->reader.read(renderer);
  const mote::Camera camera = mote::cameraOf(
    renderer, double(depth.width) / std::max(1, depth.height), depth.width, depth.height);
  const double step = mote::stepOf(silhouettes, particlesOf(renderer), diagonalOf(renderer));
  this->film.clear();
  this->film.add(mote::depthImageOf(depth.distances.data(), depth.width, depth.height, camera),
    silhouettes->MakeOptions(step));
  if (this->nothing.width() != depth.width || this->nothing.height() != depth.height)
  {
    this->nothing.resize(depth.width, depth.height);
    std::fill_n(this->nothing.color(), 4 * this->nothing.pixels(), 0.0f);
    std::fill_n(
      this->nothing.depth(), this->nothing.pixels(), std::numeric_limits<float>::infinity());
  }
  this->seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void vtkMoteSilhouettePass::Internals::draw(vtkRenderer* renderer, vtkMoteSilhouettes* silhouettes)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  int width = 0, height = 0, x = 0, y = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &x, &y);
  if (!window || width < 1 || height < 1)
    return;
  // After the steps of a pass OpenGL's viewport need not be the renderer's.
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglViewport keepViewport(state);
  const vtkOpenGLState::ScopedglScissor keepScissor(state);
  state->vtkglViewport(x, y, width, height);
  state->vtkglScissor(x, y, width, height);
  this->findSilhouettes(renderer, silhouettes);
  const double* color = silhouettes->GetColor();
  const mote::SilhouetteLayer lines{
    &this->film, {float(color[0]), float(color[1]), float(color[2])}};
  this->display.draw(
    renderer, this->nothing, lines, {}, ++this->version, mote::FilmDisplay::Way::Over);
}

vtkMoteSilhouettePass::vtkMoteSilhouettePass()
  : Silhouettes(vtkSmartPointer<vtkMoteSilhouettes>::New())
  , Impl(std::make_unique<Internals>())
{
  this->Silhouettes->EnabledOn();
  this->Impl->step->Draw = [this](vtkRenderer* renderer) { this->DrawSilhouettes(renderer); };
  // The last step before the overlay's.
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSequencePass> sequence;
  vtkNew<vtkRenderPassCollection> passes;
  vtkNew<vtkVolumetricPass> volumes;
  passes->AddItem(volumes);
  passes->AddItem(this->Impl->step);
  sequence->SetPasses(passes);
  steps->SetVolumetricPass(sequence);
  this->Impl->delegate = steps;
}

vtkMoteSilhouettePass::~vtkMoteSilhouettePass() = default;

vtkMoteSilhouettes* vtkMoteSilhouettePass::GetSilhouettes()
{
  return this->Silhouettes;
}

void vtkMoteSilhouettePass::SetDelegatePass(vtkRenderPass* pass)
{
  if (this->Impl->delegate == pass)
    return;
  this->Impl->delegate = pass;
  this->Modified();
}

vtkRenderPass* vtkMoteSilhouettePass::GetDelegatePass()
{
  return this->Impl->delegate;
}

vtkRenderPass* vtkMoteSilhouettePass::GetLinePass()
{
  return this->Impl->step;
}

void vtkMoteSilhouettePass::Render(const vtkRenderState* state)
{
  Internals& impl = *this->Impl;
  this->NumberOfRenderedProps = 0;
  impl.seconds = 0.0;
  vtkRenderer* renderer = state->GetRenderer();
  if (renderer->GetSelector())
  {
    // Without lines: what is selected by its colour must keep it.
    mote::renderSelection(state);
    return;
  }
  if (!impl.delegate)
  {
    vtkErrorMacro("There is no delegate pass.");
    return;
  }
  auto* rays = vtkMoteRayCastPass::SafeDownCast(impl.delegate);
  if (rays && this->DepthSource == AUTOMATIC)
  {
    const vtkSmartPointer<vtkMoteSilhouettes> own = rays->GetSilhouettes();
    rays->SetSilhouettes(this->Silhouettes);
    rays->Render(state);
    rays->SetSilhouettes(own);
  }
  else
  {
    impl.drawn = false;
    impl.delegate->Render(state);
    if (!impl.drawn)
      this->DrawSilhouettes(renderer);
  }
  this->NumberOfRenderedProps = impl.delegate->GetNumberOfRenderedProps();
}

void vtkMoteSilhouettePass::DrawSilhouettes(vtkRenderer* renderer)
{
  Internals& impl = *this->Impl;
  impl.drawn = true;
  if (!this->Silhouettes || !this->Silhouettes->GetEnabled())
    return;
  std::string problem;
  try
  {
    impl.draw(renderer, this->Silhouettes);
  }
  catch (const std::exception& error)
  {
    problem = error.what();
  }
  if (!problem.empty() && problem != impl.reported)
    vtkErrorMacro(<< problem);
  impl.reported = problem;
}

double vtkMoteSilhouettePass::GetSilhouetteTime()
{
  return this->Impl->seconds;
}

void vtkMoteSilhouettePass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Impl->display.release(window);
  this->Impl->reader.release(window);
  if (this->Impl->delegate)
    this->Impl->delegate->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkMoteSilhouettePass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DepthSource: " << (this->DepthSource == AUTOMATIC ? "Automatic" : "DepthBuffer")
     << "\n";
  os << indent << "Silhouettes: " << this->Silhouettes << "\n";
  os << indent << "DelegatePass: " << this->Impl->delegate << "\n";
}
