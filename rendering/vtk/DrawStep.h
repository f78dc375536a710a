#pragma once

#include "vtkCameraPass.h"
#include "vtkHardwareSelector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderPass.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <functional>

namespace mote
{

/// A step of a render pass that calls a function: a place among VTK's own steps.
class DrawStep : public vtkRenderPass
{
public:
  static DrawStep* New() { VTK_STANDARD_NEW_BODY(DrawStep); }
  vtkTypeMacro(DrawStep, vtkRenderPass);

  std::function<void(vtkRenderer*)> Draw;

  void Render(const vtkRenderState* state) override
  {
    this->NumberOfRenderedProps = 0;
    if (this->Draw)
      this->Draw(state->GetRenderer());
  }

private:
  DrawStep() = default;
};

/// Serves a renderer's selector, which a renderer with a pass leaves to the pass: all props, Mote's
/// too, are drawn one by one with the colours that the selector gives them.
inline void renderSelection(const vtkRenderState* state)
{
  vtkNew<vtkCameraPass> camera;
  vtkNew<DrawStep> step;
  step->Draw = [state](vtkRenderer* renderer)
  { renderer->GetSelector()->Render(renderer, state->GetPropArray(), state->GetPropArrayCount()); };
  camera->SetDelegatePass(step);
  camera->Render(state);
}

} // namespace mote
