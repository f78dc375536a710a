#include "InteractorStyle.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include <cstdlib>
#include <utility>

namespace mote::app
{

vtkStandardNewMacro(InteractorStyle);

void InteractorStyle::OnKeyPress()
{
  const char* key = this->Interactor->GetKeySym();
  if (key && this->onKey)
    this->onKey((this->Interactor->GetControlKey() ? "Control+" : "") + std::string(key));
}

void InteractorStyle::OnMouseWheelForward()
{
  if (this->onZoom)
    this->onZoom(1.15);
}

void InteractorStyle::OnMouseWheelBackward()
{
  if (this->onZoom)
    this->onZoom(1.0 / 1.15);
}

//------------------------------------------------------------------------------------------------
// Clicks and rectangles

std::array<int, 2> InteractorStyle::cursor() const
{
  const int* at = this->Interactor->GetEventPosition();
  return {at[0], at[1]};
}

/// Hands shake: a click need not stay on its pixel.
bool InteractorStyle::isNearPress() const
{
  constexpr int most = 3; // pixels
  const std::array<int, 2> now = this->cursor();
  return std::abs(now[0] - pressed_[0]) <= most && std::abs(now[1] - pressed_[1]) <= most;
}

bool InteractorStyle::beginRectangle(bool isThrough)
{
  if (!this->Interactor->GetControlKey() || draws_ || this->State != VTKIS_NONE)
    return false;
  draws_ = true;
  isThrough_ = isThrough;
  adds_ = this->Interactor->GetShiftKey() != 0;
  pressed_ = this->cursor();
  return true;
}

bool InteractorStyle::endRectangle(bool isThrough)
{
  if (!draws_ || isThrough != isThrough_)
    return false;
  draws_ = false;
  const bool isClick = this->isNearPress();
  if (this->onRectangle)
    this->onRectangle({pressed_, isClick ? pressed_ : this->cursor(), isThrough_, adds_}, true);
  if (isClick && this->onClick)
    this->onClick(true);
  return true;
}

void InteractorStyle::OnLeftButtonDown()
{
  if (this->beginRectangle(false))
    return;
  if (this->State == VTKIS_NONE && !this->Interactor->GetShiftKey() && onGrab &&
      onGrab(this->Interactor->GetAltKey() != 0))
  {
    holds_ = true;
    return;
  }
  pressed_ = this->cursor();
  mayBeClick_ = true;
  this->Superclass::OnLeftButtonDown();
}

void InteractorStyle::OnLeftButtonUp()
{
  if (this->endRectangle(false))
    return;
  if (std::exchange(holds_, false))
    return onDrag(true);
  const bool isClick = mayBeClick_ && this->isNearPress();
  mayBeClick_ = false;
  this->Superclass::OnLeftButtonUp();
  if (isClick && this->onClick)
    this->onClick(this->Interactor->GetShiftKey() != 0);
}

void InteractorStyle::OnRightButtonDown()
{
  if (!this->beginRectangle(true))
    this->Superclass::OnRightButtonDown();
}

void InteractorStyle::OnRightButtonUp()
{
  if (!this->endRectangle(true))
    this->Superclass::OnRightButtonUp();
}

/// Ctrl and the left button roll the view in VTK; here the middle one does.
void InteractorStyle::OnMiddleButtonDown()
{
  this->Superclass::OnMiddleButtonDown();
  if (!this->Interactor->GetControlKey())
    return;
  this->EndPan();
  this->StartSpin();
}

void InteractorStyle::OnMiddleButtonUp()
{
  if (this->State == VTKIS_SPIN)
    this->EndSpin();
  this->Superclass::OnMiddleButtonUp();
}

void InteractorStyle::OnMouseMove()
{
  if (draws_)
  {
    if (this->onRectangle)
      this->onRectangle({pressed_, this->cursor(), isThrough_, adds_}, false);
    return;
  }
  if (holds_)
    return onDrag(false);
  if (mayBeClick_ && this->isNearPress())
    return;
  mayBeClick_ = false;
  this->Superclass::OnMouseMove();
}

} // namespace mote::app
