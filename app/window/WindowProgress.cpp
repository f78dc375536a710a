#include "WindowProgress.h"

#include "Display.h"
#include "base/Text.h"
#include "settings/Colors.h"

#include <vtkActor2D.h>
#include <vtkCoordinate.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

constexpr double left = 0.3, right = 0.7, bottom = 0.47, top = 0.485;

void addBar(vtkRenderer* renderer, vtkPlaneSource* plane, const Color& color, double opacity)
{
  vtkNew<vtkCoordinate> coordinate;
  coordinate->SetCoordinateSystemToNormalizedViewport();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  mapper->SetTransformCoordinate(coordinate);
  vtkNew<vtkActor2D> actor;
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

WindowProgress::WindowProgress(vtkRenderWindow* window, vtkRenderer* view)
  : window_(window)
  , view_(view)
{
  renderer_->SetBackground(view->GetBackground());
  renderer_->SetBackground2(view->GetBackground2());
  renderer_->SetGradientBackground(view->GetGradientBackground());
  const Color ink = inkOn(view);
  vtkNew<vtkPlaneSource> groove;
  setSpan(groove, right);
  setSpan(bar_, right);
  addBar(renderer_, groove, ink, 0.2);
  addBar(renderer_, bar_, ink, 0.9);
  text_->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text_->SetPosition(0.5, 0.505);
  text_->GetTextProperty()->SetJustificationToCentered();
  text_->GetTextProperty()->SetFontSize(18);
  text_->GetTextProperty()->SetColor(ink[0], ink[1], ink[2]);
  renderer_->AddActor2D(text_);
}

void WindowProgress::show(const std::string& what, double share)
{
  if (!shown_)
  {
    window_->RemoveRenderer(view_);
    window_->AddRenderer(renderer_);
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
