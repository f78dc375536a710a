#include "WindowProps.h"

#include "Colors.h"
#include "SimulationBox.h"

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
#include <vtkScalarBarActor.h>
#include <vtkSphereSource.h>
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
    double position[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      position[axis] = box.origin[axis];
      for (int v = 0; v < 3; ++v)
        position[axis] += ((corner >> v) & 1) * box.vectors[v][axis];
    }
    points->InsertNextPoint(position);
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

void setUpText(vtkTextProperty* property, int size)
{
  property->SetFontFamilyToArial();
  property->SetFontSize(size);
  property->BoldOff();
  property->ItalicOff();
  property->ShadowOff();
}

} // namespace

WindowProps::WindowProps(Scene& scene)
  : scene_(scene)
{
  for (vtkActor* lines : {box_.Get(), mark_.Get()})
  {
    vtkNew<vtkPolyDataMapper> mapper;
    lines->SetMapper(mapper);
    lines->PickableOff();
    lines->GetProperty()->LightingOff();
    lines->GetProperty()->SetLineWidth(1.0);
    lines->UseBoundsOff();
    scene.renderer()->AddActor(lines);
  }
  mark_->VisibilityOff();
  mark_->GetProperty()->SetRepresentationToWireframe();
  mark_->GetProperty()->SetColor(1.0, 1.0, 1.0);

  legend_->SetUnconstrainedFontSize(true);
  legend_->SetMaximumWidthInPixels(90);
  legend_->SetWidth(0.07);
  legend_->SetHeight(0.5);
  legend_->SetPosition(0.91, 0.25);
  legend_->SetBarRatio(0.25);
  legend_->SetNumberOfLabels(5);
  legend_->SetLabelFormat("%-.4g");
  legend_->SetVerticalTitleSeparation(10);
  setUpText(legend_->GetTitleTextProperty(), 17);
  setUpText(legend_->GetLabelTextProperty(), 15);
  setUpText(legend_->GetAnnotationTextProperty(), 15);
  legend_->VisibilityOff();
  scene.renderer()->AddActor2D(legend_);

  axes_->SetShaftTypeToCylinder();
  axes_->SetTotalLength(1.0, 1.0, 1.0);
  axes_->SetCylinderRadius(0.04);
  axes_->SetConeRadius(0.35);
  corner_->SetOrientationMarker(axes_);
  this->setInk(inkOn(scene.renderer()));
}

WindowProps::~WindowProps() { corner_->SetInteractor(nullptr); }

void WindowProps::attach(vtkRenderWindowInteractor* interactor)
{
  corner_->SetInteractor(interactor);
  corner_->SetDefaultRenderer(scene_.renderer());
  corner_->SetViewport(0.0, 0.045, 0.13, 0.225);
  corner_->SetEnabled(1);
  corner_->InteractiveOff();
}

void WindowProps::update(const ViewOptions& options)
{
  SimulationBox box{};
  bool given = false;
  for (const auto& part : scene_.parts())
    if (const auto own = simulationBoxOf(part->data()); own && !given)
    {
      box = *own;
      given = true;
    }
  if (!given)
  {
    double bounds[6];
    scene_.bounds(bounds);
    box = boxOfBounds(bounds);
  }
  static_cast<vtkPolyDataMapper*>(box_->GetMapper())->SetInputData(edgesOf(box));
  box_->SetVisibility(boxOn_);
  vtkLookupTable* table = scene_.coloring().legendTable();
  legend_->SetLookupTable(table);
  legend_->SetVisibility(legendOn_ && table);
  legend_->SetTitle(options.title.value_or(scene_.coloring().title()).c_str());
}

void WindowProps::toggleBox()
{
  boxOn_ = !boxOn_;
  box_->SetVisibility(boxOn_);
}

void WindowProps::toggleLegend()
{
  legendOn_ = !legendOn_;
  legend_->SetVisibility(legendOn_ && scene_.coloring().legendTable());
}

void WindowProps::toggleAxes() { corner_->SetEnabled(!corner_->GetEnabled()); }

void WindowProps::setInk(const Color& ink)
{
  box_->GetProperty()->SetColor(ink[0], ink[1], ink[2]);
  box_->GetProperty()->SetOpacity(0.6);
  for (vtkTextProperty* text : {legend_->GetTitleTextProperty(), legend_->GetLabelTextProperty(),
         legend_->GetAnnotationTextProperty()})
    text->SetColor(ink[0], ink[1], ink[2]);
  for (vtkCaptionActor2D* caption : {axes_->GetXAxisCaptionActor2D(),
         axes_->GetYAxisCaptionActor2D(), axes_->GetZAxisCaptionActor2D()})
  {
    setUpText(caption->GetCaptionTextProperty(), 15);
    caption->GetCaptionTextProperty()->SetColor(ink[0], ink[1], ink[2]);
  }
}

void WindowProps::mark(const double center[3], double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(center[0], center[1], center[2]);
  sphere->SetRadius(1.04 * radius);
  sphere->SetThetaResolution(16);
  sphere->SetPhiResolution(9);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  static_cast<vtkPolyDataMapper*>(mark_->GetMapper())->SetInputData(sphere->GetOutput());
  mark_->VisibilityOn();
}

void WindowProps::unmark() { mark_->VisibilityOff(); }

} // namespace mote::app
