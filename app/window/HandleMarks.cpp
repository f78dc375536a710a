#include "HandleMarks.h"

#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkPoints.h>
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

constexpr double ink[3] = {0.05, 0.75, 0.95}, rim[3] = {1.0, 1.0, 1.0};
constexpr double markSize = 11.0, rimSize = 15.0; // pixels across
constexpr double nearMark = 10.0, nearLine = 5.0; // pixels, where they are taken hold of

} // namespace

HandleMarks::HandleMarks(vtkRenderer* renderer)
  : renderer_(renderer)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines_);
  outlines_->SetMapper(mapper);
  outlines_->ForceTranslucentOn(); // after what is traced; no ray ends at them
  outlines_->PickableOff();
  outlines_->UseBoundsOff();
  outlines_->VisibilityOff();
  outlines_->GetProperty()->LightingOff();
  outlines_->GetProperty()->SetColor(ink[0], ink[1], ink[2]);
  renderer->AddActor(outlines_);
  vtkNew<vtkCoordinate> world;
  world->SetCoordinateSystemToWorld();
  for (vtkActor2D* marks : {rims_.Get(), marks_.Get()})
  {
    vtkNew<vtkPolyDataMapper2D> flat;
    flat->SetInputData(middles_);
    flat->SetTransformCoordinate(world);
    marks->SetMapper(flat);
    const double* color = marks == rims_ ? rim : ink;
    marks->GetProperty()->SetColor(color[0], color[1], color[2]);
    marks->VisibilityOff();
    renderer->AddActor2D(marks);
  }
  this->setScale(1.0);
}

void HandleMarks::setScale(double scale)
{
  scale_ = scale;
  outlines_->GetProperty()->SetLineWidth(static_cast<float>(2.0 * scale));
  rims_->GetProperty()->SetPointSize(static_cast<float>(rimSize * scale));
  marks_->GetProperty()->SetPointSize(static_cast<float>(markSize * scale));
}

bool HandleMarks::update(const Stage& stage, const std::vector<std::size_t>& parts)
{
  const std::string& when = stage.settings().picture.handles;
  const bool isOn = !parts.empty() && (when == "on" || (when == "auto" && isOffered_));
  const bool wasOn = !handles_.empty();
  handles_.clear();
  double bounds[6];
  stage.bounds(bounds);
  if (isOn)
    handles_ = cutHandles(stage.shown(), bounds);
  vtkNew<vtkPoints> corners, middles;
  vtkNew<vtkCellArray> lines, vertices;
  for (vtkPoints* points : {corners.Get(), middles.Get()})
    points->SetDataTypeToDouble();
  for (const CutHandle& handle : handles_)
  {
    const vtkIdType middle = middles->InsertNextPoint(handle.middle.data());
    vertices->InsertNextCell(1, &middle);
    for (const auto& outline : handle.outlines)
    {
      lines->InsertNextCell(static_cast<int>(outline.size()));
      for (const CutHandle::Place& place : outline)
        lines->InsertCellPoint(corners->InsertNextPoint(place.data()));
    }
  }
  lines_->SetPoints(corners);
  lines_->SetLines(lines);
  middles_->SetPoints(middles);
  middles_->SetVerts(vertices);
  for (vtkProp* prop :
    {static_cast<vtkProp*>(outlines_), static_cast<vtkProp*>(rims_), static_cast<vtkProp*>(marks_)})
    prop->SetVisibility(!handles_.empty());
  return wasOn || !handles_.empty();
}

std::array<double, 2> HandleMarks::inWindow(const CutHandle::Place& place) const
{
  renderer_->SetWorldPoint(place[0], place[1], place[2], 1.0);
  renderer_->WorldToDisplay();
  const double* at = renderer_->GetDisplayPoint();
  return {at[0], at[1]};
}

std::optional<CutHandle::Place> HandleMarks::nearOutline(
  const CutHandle& handle, const std::array<int, 2>& place) const
{
  for (const auto& outline : handle.outlines)
    for (std::size_t i = 1; i < outline.size(); ++i)
    {
      const auto a = this->inWindow(outline[i - 1]), b = this->inWindow(outline[i]);
      const double along[2] = {b[0] - a[0], b[1] - a[1]};
      const double from[2] = {place[0] - a[0], place[1] - a[1]};
      const double length2 = along[0] * along[0] + along[1] * along[1];
      const double t = length2 > 0.0
                         ? std::clamp((along[0] * from[0] + along[1] * from[1]) / length2, 0.0, 1.0)
                         : 0.0;
      if (std::hypot(from[0] - t * along[0], from[1] - t * along[1]) > nearLine * scale_)
        continue;
      CutHandle::Place at{};
      for (std::size_t k = 0; k < 3; ++k)
        at[k] = outline[i - 1][k] + t * (outline[i][k] - outline[i - 1][k]);
      return at;
    }
  return {};
}

std::optional<CutGrip> HandleMarks::at(const Settings& shown, const std::array<int, 2>& place) const
{
  for (const CutHandle& handle : handles_)
    if (const auto at = this->inWindow(handle.middle);
        std::hypot(place[0] - at[0], place[1] - at[1]) <= nearMark * scale_)
      return handle.heldAt(shown, handle.middle);
  for (const CutHandle& handle : handles_)
    if (const auto held = this->nearOutline(handle, place))
      return handle.heldAt(shown, *held);
  return {};
}

} // namespace mote::app
