#include "WindowProps.h"

#include "settings/Colors.h"
#include "stage/SimulationBox.h"

#include <vtkActor.h>
#include <vtkAxesActor.h>
#include <vtkCaptionActor2D.h>
#include <vtkCellArray.h>
#include <vtkDataSet.h>
#include <vtkLookupTable.h>
#include <vtkOrientationMarkerWidget.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

namespace mote::app
{

namespace
{

/// The twelve edges.
vtkSmartPointer<vtkPolyData> edgesOf(const SimulationBox& box)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (int corner = 0; corner < 8; ++corner)
  {
    points->InsertNextPoint(cornerOf(box, corner).data());
    for (int v = 0; v < 3; ++v)
      if (!((corner >> v) & 1))
      {
        const vtkIdType edge[2] = {corner, corner | (1 << v)};
        lines->InsertNextCell(2, edge);
      }
  }
  auto edges = vtkSmartPointer<vtkPolyData>::New();
  edges->SetPoints(points);
  edges->SetLines(lines);
  return edges;
}

} // namespace

WindowProps::WindowProps(Stage& stage)
  : stage_(stage)
  , legend_(stage.renderer())
{
  vtkNew<vtkPolyDataMapper> mapper;
  box_->SetMapper(mapper);
  box_->PickableOff();
  box_->GetProperty()->LightingOff();
  box_->GetProperty()->SetLineWidth(1.0);
  box_->UseBoundsOff();
  stage.renderer()->AddActor(box_);

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
  corner_->SetViewport(0.0, 0.045, 0.13 + unseen * left, 0.225);
}

void WindowProps::update()
{
  SimulationBox box{};
  bool given = false;
  for (const auto& part : stage_.parts())
    if (const auto own = simulationBoxOf(part->data()); own && !given)
    {
      box = replicated(*own, stage_.settings().particles.replicate);
      given = true;
    }
  if (!given)
  {
    double bounds[6];
    stage_.bounds(bounds);
    box = boxOfBounds(bounds);
  }
  static_cast<vtkPolyDataMapper*>(box_->GetMapper())->SetInputData(edgesOf(box));
  const PictureSettings& picture = stage_.settings().picture;
  box_->SetVisibility(picture.box && !stage_.parts().empty());
  const bool axes = picture.axes && !stage_.parts().empty();
  if (corner_->GetInteractor() && corner_->GetEnabled() != static_cast<int>(axes))
    corner_->SetEnabled(axes);
  legend_.set(stage_.coloring().legendTable(), stage_.coloring().title(), picture);
  this->setInk(inkOn(stage_.renderer()));
}

void WindowProps::setInk(const Color& ink)
{
  const double* ground = stage_.renderer()->GetBackground();
  double quiet[3];
  for (int i = 0; i < 3; ++i)
    quiet[i] = 0.6 * ink[i] + 0.4 * ground[i];
  box_->GetProperty()->SetColor(quiet);
  legend_.setInk(ink);
  for (vtkCaptionActor2D* caption : {axes_->GetXAxisCaptionActor2D(),
         axes_->GetYAxisCaptionActor2D(), axes_->GetZAxisCaptionActor2D()})
  {
    caption->GetTextActor()->SetTextScaleModeToNone();
    vtkTextProperty* text = caption->GetCaptionTextProperty();
    text->SetFontSize(14);
    text->ItalicOff();
    text->BoldOff();
    text->ShadowOff();
    caption->GetCaptionTextProperty()->SetColor(ink[0], ink[1], ink[2]);
  }
}

} // namespace mote::app
