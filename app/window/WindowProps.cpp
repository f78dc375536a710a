#include "WindowProps.h"

#include "settings/Colors.h"

#include <vtkAxesActor.h>
#include <vtkCaptionActor2D.h>
#include <vtkLookupTable.h>
#include <vtkOrientationMarkerWidget.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <cmath>

namespace mote::app
{

namespace
{

constexpr double share = 0.13; // of the view's width: the axes' part

} // namespace

WindowProps::WindowProps(Stage& stage)
  : stage_(stage)
  , legend_(stage.renderer())
{
  axes_->SetShaftTypeToCylinder();
  axes_->SetTotalLength(1.0, 1.0, 1.0);
  axes_->SetCylinderRadius(0.04);
  axes_->SetConeRadius(0.35);
  corner_->SetOrientationMarker(axes_);
  this->setInk(inkOn(stage.renderer()));
}

WindowProps::~WindowProps()
{
  corner_->SetInteractor(nullptr);
}

void WindowProps::attach(vtkRenderWindowInteractor* interactor)
{
  corner_->SetInteractor(interactor);
  corner_->SetDefaultRenderer(stage_.renderer());
  this->placeAxes();
  corner_->SetEnabled(1);
  corner_->InteractiveOff();
  this->update();
}

void WindowProps::placeAxes()
{
  // Shares of the view. VTK looks where that lies when these numbers change, and not otherwise.
  constexpr double unseen = 1e-6;
  const double left = stage_.renderer()->GetViewport()[0];
  corner_->SetViewport(0.0, 0.045, share + unseen * left, 0.225);
  this->showAxes();
}

/// Where there is room for their letters.
void WindowProps::showAxes()
{
  constexpr double least = 64.0; // pixels
  const bool axes = stage_.settings().picture.axes && !stage_.parts().empty() &&
                    share * stage_.renderer()->GetSize()[0] > least;
  if (corner_->GetInteractor() && corner_->GetEnabled() != static_cast<int>(axes))
    corner_->SetEnabled(axes);
}

void WindowProps::update()
{
  const PictureSettings& picture = stage_.settings().picture;
  this->showAxes();
  legend_.set(stage_.coloring().legendTable(), stage_.coloring().title(), picture);
  this->setInk(inkOn(stage_.renderer()));
}

void WindowProps::setScale(double scale)
{
  scale_ = scale;
  this->setInk(inkOn(stage_.renderer()));
}

void WindowProps::setInk(const Color& ink)
{
  legend_.setInk(ink);
  for (vtkCaptionActor2D* caption : {axes_->GetXAxisCaptionActor2D(),
         axes_->GetYAxisCaptionActor2D(), axes_->GetZAxisCaptionActor2D()})
  {
    caption->GetTextActor()->SetTextScaleModeToNone();
    vtkTextProperty* text = caption->GetCaptionTextProperty();
    text->SetFontSize(static_cast<int>(std::lround(14.0 * scale_)));
    text->ItalicOff();
    text->BoldOff();
    text->ShadowOff();
    caption->GetCaptionTextProperty()->SetColor(ink[0], ink[1], ink[2]);
  }
}

} // namespace mote::app
