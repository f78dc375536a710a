// Slices and faces of cuts that are moved with the mouse, in the view.

#include "Window.h"

#include "InteractorStyle.h"
#include "base/Text.h"

#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkRenderer.h>

namespace mote::app
{

namespace
{

/// The way that is seen at a place of the window, in pixels.
GripRay rayThrough(vtkRenderer* renderer, const std::array<int, 2>& at)
{
  double ends[2][4];
  for (int k = 0; k < 2; ++k)
  {
    renderer->SetDisplayPoint(at[0], at[1], k);
    renderer->DisplayToWorld();
    renderer->GetWorldPoint(ends[k]);
  }
  GripRay ray{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    ray.origin[k] = ends[0][k] / ends[0][3];
    ray.direction[k] = ends[1][k] / ends[1][3] - ray.origin[k];
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  double right[3];
  vtkMath::Cross(camera->GetDirectionOfProjection(), camera->GetViewUp(), right);
  vtkMath::Cross(right, ray.direction.data(), ray.up.data());
  vtkMath::Normalize(ray.up.data());
  return ray;
}

} // namespace

void Window::setUpGrips()
{
  style_->onGrab = [this](bool withAlt)
  {
    if (busy_ || quit_)
      return false;
    const std::array<int, 2> at = this->cursor();
    View* view = views_.at(at[0], at[1]);
    grip_ = view ? view->handles().at(stage_.shown(), at) : std::nullopt;
    if (grip_ || !withAlt)
      return grip_.has_value();
    const std::optional<Hit> hit = this->hitAt(at[0], at[1]);
    double bounds[6];
    stage_.bounds(bounds);
    if (hit)
      grip_ = CutGrip::at(stage_.shown(), hit->at, vtkBoundingBox(bounds).GetDiagonalLength());
    if (!grip_)
      this->say("There is no slice and no face of a cut under the cursor");
    return grip_.has_value();
  };
  style_->onDrag = [this](bool isDone) { this->dragGrip(isDone); };
}

void Window::dragGrip(bool isDone)
{
  const std::array<int, 2> at = this->cursor();
  View* view = views_.at(at[0], at[1]);
  if (!grip_ || busy_ || quit_)
    return;
  double bounds[6];
  stage_.bounds(bounds);
  const double size = vtkBoundingBox(bounds).GetDiagonalLength();
  Settings next = this->settings();
  if (const auto value =
        view ? grip_->valueAt(rayThrough(view->renderer(), at), bounds) : std::nullopt)
  {
    const double exact = shortPlace(*value, grip_->isAngle() ? 360.0 : size);
    next = grip_->moved(next, stage_.shown(), exact);
    this->say(grip_->name() + " = " + asNumber(exact));
  }
  this->takeSettings(next, !isDone);
  if (isDone)
    grip_.reset();
}

} // namespace mote::app
