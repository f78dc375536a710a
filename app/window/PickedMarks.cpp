#include "PickedMarks.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkDataSet.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

constexpr double ink[3] = {1.0, 0.16, 0.86}; // in no colour map of ours
constexpr float larger = 1.04f;              // than what is marked
constexpr double leastPixels = 5.0;          // radius
/// How far marks stand before what they mark, in radii: a pixel's depth is the nearest of all of
/// its rays, and would stand before a mark at the sphere's slopes.
constexpr double before = 0.4;

} // namespace

PickedMarks::PickedMarks(vtkRenderer* renderer)
  : renderer_(renderer)
{
  veilMapper_->SetInputData(centers_);
  veilMapper_->SetScaleArray("radius");
  veilMapper_->ScalarVisibilityOff();
  veils_->SetMapper(veilMapper_);
  vtkNew<vtkPolyDataMapper> edgeMapper;
  edgeMapper->SetInputData(lines_);
  edges_->SetMapper(edgeMapper);
  for (vtkActor* marks : {veils_.Get(), edges_.Get()})
  {
    // Translucent props come after what is traced, and no ray ends at them.
    marks->ForceTranslucentOn();
    marks->GetProperty()->SetColor(ink[0], ink[1], ink[2]);
    marks->GetProperty()->SetAmbient(0.5);
    marks->GetProperty()->SetDiffuse(0.5);
    marks->PickableOff();
    marks->UseBoundsOff();
    marks->VisibilityOff();
    renderer->AddActor(marks);
  }
  veils_->GetProperty()->SetOpacity(0.75);
  edges_->GetProperty()->LightingOff();
  edges_->GetProperty()->SetLineWidth(2.0);
  vtkNew<vtkPolyDataMapper2D> rectangleMapper;
  rectangleMapper->SetInputData(frame_);
  rectangle_->SetMapper(rectangleMapper);
  rectangle_->GetProperty()->SetColor(ink[0], ink[1], ink[2]);
  rectangle_->GetProperty()->SetLineWidth(1.5);
  rectangle_->VisibilityOff();
  renderer->AddActor2D(rectangle_);
}

PickedMarks::~PickedMarks() = default;

void PickedMarks::update(const PickedSet::Parts& parts, const PickedSet& picked)
{
  if (isOld_ || version_ != picked.version())
  {
    this->gather(parts, picked);
    isOld_ = false;
    version_ = picked.version();
    cameraTime_ = 0;
  }
  const vtkMTimeType now = renderer_->GetActiveCamera()->GetMTime();
  if (veils_->GetVisibility() && now != cameraTime_)
    this->setSizes();
  cameraTime_ = now;
}

void PickedMarks::setParts(const std::vector<std::size_t>& parts)
{
  isOld_ = isOld_ || parts != marked_;
  marked_ = parts;
}

void PickedMarks::gather(const PickedSet::Parts& parts, const PickedSet& picked)
{
  radii_.clear();
  vtkNew<vtkPoints> places, corners;
  places->SetDataTypeToDouble();
  corners->SetDataTypeToDouble();
  lines_->Initialize();
  lines_->SetPoints(corners);
  lines_->SetLines(vtkNew<vtkCellArray>());
  for (const PickedPlace& one : placesOf(parts, picked, marked_))
    if (one.isCell)
      this->addCell(edgesOf(parts[one.part]->data(), one.id, one.placed));
    else
    {
      places->InsertNextPoint(one.at.data());
      radii_.push_back(static_cast<float>(one.radius));
    }
  this->setCenters(places);
}

void PickedMarks::setCenters(vtkPoints* places)
{
  // The mapper takes floats: places count from the first one.
  double origin[3] = {0.0, 0.0, 0.0};
  if (places->GetNumberOfPoints() > 0)
    places->GetPoint(0, origin);
  const vtkIdType count = places->GetNumberOfPoints();
  offsets_.resize(static_cast<std::size_t>(count));
  vtkNew<vtkCellArray> vertex; // without a cell nothing is drawn
  vertex->InsertNextCell(static_cast<int>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    double place[3];
    places->GetPoint(i, place);
    vtkMath::Subtract(place, origin, offsets_[static_cast<std::size_t>(i)].data());
    vertex->InsertCellPoint(i);
  }
  veils_->SetPosition(origin);
  centers_->Initialize();
  vtkNew<vtkPoints> centers;
  centers->SetNumberOfPoints(count);
  centers_->SetPoints(centers);
  centers_->SetVerts(vertex);
  vtkNew<vtkFloatArray> radii;
  radii->SetName("radius");
  radii->SetNumberOfValues(count);
  centers_->GetPointData()->AddArray(radii);
  veils_->SetVisibility(!radii_.empty());
  edges_->SetVisibility(lines_->GetNumberOfLines() > 0);
}

void PickedMarks::addCell(const std::vector<CellEdge>& edges)
{
  for (const CellEdge& edge : edges)
  {
    vtkIdType ends[2];
    for (std::size_t i = 0; i < 2; ++i)
      ends[i] = lines_->GetPoints()->InsertNextPoint(edge[i].data());
    lines_->GetLines()->InsertNextCell(2, ends);
  }
}

/// Sizes and places for the present view: however far away, a mark has some pixels.
void PickedMarks::setSizes()
{
  auto* radii = vtkFloatArray::SafeDownCast(centers_->GetPointData()->GetArray("radius"));
  vtkCamera* camera = renderer_->GetActiveCamera();
  const double rows = std::max(1, renderer_->GetSize()[1]);
  const double half = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  double eye[3], toEye[3];
  vtkMath::Subtract(camera->GetPosition(), veils_->GetPosition(), eye);
  camera->GetDirectionOfProjection(toEye);
  vtkMath::MultiplyScalar(toEye, -1.0);
  for (std::size_t i = 0; i < radii_.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    std::array<double, 3> place = offsets_[i];
    double pixel = 2.0 * camera->GetParallelScale() / rows;
    if (!camera->GetParallelProjection())
    {
      vtkMath::Subtract(eye, place.data(), toEye);
      pixel = 2.0 * half / rows * vtkMath::Normalize(toEye);
    }
    const auto least = static_cast<float>(leastPixels * pixel);
    radii->SetValue(id, std::max(larger * radii_[i], least));
    for (std::size_t axis = 0; axis < 3; ++axis)
      place[axis] += before * radii->GetValue(id) * toEye[axis];
    centers_->GetPoints()->SetPoint(id, place.data());
  }
  radii->Modified();
  centers_->GetPoints()->Modified();
}

void PickedMarks::showRectangle(double x0, double y0, double x1, double y1)
{
  vtkNew<vtkPoints> corners;
  corners->InsertNextPoint(x0, y0, 0.0);
  corners->InsertNextPoint(x1, y0, 0.0);
  corners->InsertNextPoint(x1, y1, 0.0);
  corners->InsertNextPoint(x0, y1, 0.0);
  vtkNew<vtkCellArray> sides;
  const vtkIdType round[5] = {0, 1, 2, 3, 0};
  sides->InsertNextCell(5, round);
  frame_->SetPoints(corners);
  frame_->SetLines(sides);
  rectangle_->VisibilityOn();
}

void PickedMarks::hideRectangle()
{
  rectangle_->VisibilityOff();
}

} // namespace mote::app
