#include "WindowProgress.h"

#include "Display.h"
#include "Observe.h"
#include "base/Text.h"
#include "settings/Colors.h"

#include <vtkActor2D.h>
#include <vtkCoordinate.h>
#include <vtkImageData.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

constexpr double left = 0.3, right = 0.7, bottom = 0.47, top = 0.485;

void addBar(vtkRenderer* renderer, vtkActor2D* actor, vtkPlaneSource* plane, const Color& color,
  double opacity)
{
  vtkNew<vtkCoordinate> coordinate;
  coordinate->SetCoordinateSystemToNormalizedViewport();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  mapper->SetTransformCoordinate(coordinate);
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetOpacity(opacity);
  renderer->AddActor2D(actor);
}

void setSpan(vtkPlaneSource* plane, double to)
{
  plane->SetOrigin(left, bottom, 0.0);
  plane->SetPoint1(to, bottom, 0.0);
  plane->SetPoint2(left, top, 0.0);
}

} // namespace

WindowProgress::WindowProgress(vtkRenderWindow* window, vtkRenderer* view, vtkRenderer* above)
  : window_(window)
  , view_(view)
  , above_(above)
{
  renderer_->SetBackground(view->GetBackground());
  renderer_->SetBackground2(view->GetBackground2());
  renderer_->SetGradientBackground(view->GetGradientBackground());
  observe(view, vtkCommand::EndEvent, [this](void*) { isNew_ = true; });
  const Color ink = inkOn(view);
  vtkNew<vtkPlaneSource> groove;
  setSpan(groove, right);
  setSpan(bar_, right);
  addBar(renderer_, grooveActor_, groove, ink, 0.2);
  addBar(renderer_, barActor_, bar_, ink, 0.9);
  text_->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text_->SetPosition(0.5, 0.505);
  text_->GetTextProperty()->SetJustificationToCentered();
  this->setScale(1.0);
  text_->GetTextProperty()->SetColor(ink[0], ink[1], ink[2]);
  renderer_->AddActor2D(text_);
}

void WindowProgress::setScale(double scale)
{
  text_->GetTextProperty()->SetFontSize(static_cast<int>(std::lround(18.0 * scale)));
}

/// What was there last stays behind the bar: the view, its texts and the panel.
void WindowProgress::keepFrame()
{
  if (!isNew_)
    return;
  isNew_ = false;
  constexpr int share = 90; // of 256, of its brightness: white texts are read on it
  const int* size = window_->GetSize();
  vtkNew<vtkImageData> frame;
  frame->SetDimensions(size[0], size[1], 1);
  vtkNew<vtkUnsignedCharArray> pixels;
  if (!window_->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels))
    return;
  for (vtkIdType i = 0; i < pixels->GetNumberOfValues(); ++i)
    pixels->SetValue(i, static_cast<unsigned char>(pixels->GetValue(i) * share / 256));
  frame->GetPointData()->SetScalars(pixels);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(frame);
  renderer_->SetBackgroundTexture(texture);
  renderer_->TexturedBackgroundOn();
  for (vtkActor2D* actor : {grooveActor_.Get(), barActor_.Get()})
    actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  text_->GetTextProperty()->SetColor(1.0, 1.0, 1.0);
}

void WindowProgress::show(const std::string& what, double share)
{
  if (!shown_)
  {
    this->keepFrame();
    window_->RemoveRenderer(view_);
    window_->AddRenderer(renderer_);
    above_->DrawOff();
    shown_ = true;
  }
  setSpan(bar_, left + std::max(share, 0.004) * (right - left)); // a plane needs an area
  text_->SetInput(
    (what + "   " + asNumber(std::round(100.0 * share)) + " %   (Esc stops)").c_str());
  window_->Render();
}

void WindowProgress::hide()
{
  if (!shown_)
    return;
  window_->RemoveRenderer(renderer_);
  window_->AddRenderer(view_);
  above_->DrawOn();
  shown_ = false;
}

bool WindowProgress::wantsStop()
{
  const Request request = takeRequest(window_);
  stop_ = stop_ || request != Request::Nothing;
  quit_ = quit_ || request == Request::Quit;
  return stop_;
}

} // namespace mote::app
