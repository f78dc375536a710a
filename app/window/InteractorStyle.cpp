#include "InteractorStyle.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

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

} // namespace mote::app
