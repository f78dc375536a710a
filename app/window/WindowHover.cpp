// What is told of what lies under a cursor that rests.

#include "Window.h"

#include "InteractorStyle.h"
#include "Observe.h"

#include <vtkCommand.h>

namespace mote::app
{

namespace
{

constexpr unsigned long hoverAfter = 500; // ms that the cursor rests
constexpr int fewFacts = 7;

} // namespace

void Window::setUpHover()
{
  constexpr float first = 20.0f; // before the panel, which keeps its events
  observe(
    interactor_, vtkCommand::MouseMoveEvent, [this](void*) { this->moveCursor(); }, first);
  observe(
    interactor_, vtkCommand::LeaveEvent, [this](void*) { this->leaveWindow(); }, first);
}

void Window::leaveWindow()
{
  hoverTimer_ = 0;
  if (busy_ || quit_ || !overlay_.hasTip())
    return;
  overlay_.hideTip();
  this->renderOverlays();
}

void Window::moveCursor()
{
  if (busy_ || quit_)
    return;
  const bool wasTold = overlay_.hasTip();
  overlay_.hideTip();
  const int left = window_->GetSize()[0] - this->viewSize()[0];
  const bool isInView = interactor_->GetEventPosition()[0] >= left;
  if (isInView && style_->GetState() == VTKIS_NONE && !style_->drawsRectangle())
    this->startTimer(hoverTimer_, hoverAfter);
  else
    hoverTimer_ = 0;
  if (wasTold)
    this->renderOverlays();
}

/// What is under the cursor is told anew, as it may be another thing now.
void Window::hoverAgain()
{
  if (!overlay_.hasTip())
    return;
  overlay_.hideTip();
  this->startTimer(hoverTimer_, hoverAfter);
}

void Window::hover()
{
  const int* cursor = interactor_->GetEventPosition();
  const int left = window_->GetSize()[0] - this->viewSize()[0];
  if (playing_ || overlay_.hasHelp() || style_->GetState() != VTKIS_NONE || cursor[0] < left)
    return;
  const std::optional<Hit> hit = this->hitAt(cursor[0], cursor[1]);
  if (!hit)
    return;
  overlay_.setTip(factsOf(*hit, fewFacts), cursor[0] - left, cursor[1], this->viewSize());
  this->renderOverlays();
}

/// A frame in which the view itself waits for its own turn.
void Window::renderOverlays()
{
  views_.setUpPasses([](vtkMoteRayCastPass* pass) { pass->RefiningOff(); });
  this->render();
  views_.setUpPasses([](vtkMoteRayCastPass* pass) { pass->RefiningOn(); });
}

} // namespace mote::app
