#include "Ruler.h"

#include "base/Text.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkMath.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace mote::app
{

namespace
{

constexpr double textSize = 15.0, lineWidth = 2.0, edgeWidth = 5.0; // pixels, at a scale of 1

} // namespace

Ruler::Ruler(vtkRenderer* renderer)
  : renderer_(renderer)
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  vtkNew<vtkCoordinate> world;
  world->SetCoordinateSystemToWorld();
  mapper->SetTransformCoordinate(world);
  mapper->SetInputData(lines_);
  for (vtkActor2D* actor : {edge_.Get(), actor_.Get()})
  {
    actor->SetMapper(mapper);
    actor->VisibilityOff();
    renderer->AddActor2D(actor);
  }
  // So that it stands out from data of its own colour, too.
  edge_->GetProperty()->SetColor(0.09, 0.10, 0.12);
  actor_->GetProperty()->SetColor(1.0, 0.95, 0.3);
  for (const auto& text : labels_)
  {
    text->GetPositionCoordinate()->SetCoordinateSystemToViewport();
    vtkTextProperty* look = text->GetTextProperty();
    look->SetColor(1.0, 0.95, 0.3);
    look->SetBackgroundColor(0.09, 0.10, 0.12);
    look->SetBackgroundOpacity(0.82);
    look->SetJustificationToCentered();
    look->SetVerticalJustificationToBottom(); // above the line, which it does not hide
    text->VisibilityOff();
    renderer->AddActor2D(text);
  }
  labels_[2]->GetTextProperty()->SetVerticalJustificationToTop();
  this->setScale(1.0);
}

void Ruler::setScale(double scale)
{
  edge_->GetProperty()->SetLineWidth(static_cast<float>(scale * edgeWidth));
  actor_->GetProperty()->SetLineWidth(static_cast<float>(scale * lineWidth));
  for (const auto& text : labels_)
    text->GetTextProperty()->SetFontSize(static_cast<int>(std::lround(scale * textSize)));
}

Ruler::~Ruler() = default;

void Ruler::label(std::size_t number, const std::string& text, const Place& place)
{
  labels_[number]->SetInput((" " + text + " ").c_str());
  vtkNew<vtkCoordinate> world;
  world->SetCoordinateSystemToWorld();
  world->SetValue(place[0], place[1], place[2]);
  const int* at = world->GetComputedViewportValue(renderer_);
  labels_[number]->SetPosition(at[0], at[1]);
  labels_[number]->VisibilityOn();
}

/// Labels that would hide others go below those.
void Ruler::part()
{
  constexpr double gap = 3.0; // pixels
  std::vector<std::array<double, 4>> taken;
  for (const auto& text : labels_)
  {
    if (!text->GetVisibility())
      continue;
    double size[4];
    text->GetBoundingBox(renderer_, size);
    const double* at = text->GetPosition();
    std::array<double, 4> box = {
      at[0] + size[0], at[0] + size[1], at[1] + size[2], at[1] + size[3]};
    const auto hides = [&](const std::array<double, 4>& other)
    { return box[0] < other[1] && other[0] < box[1] && box[2] < other[3] && other[2] < box[3]; };
    // Below one, a label may hide another; it only ever moves down, so this ends.
    for (auto other = std::find_if(taken.begin(), taken.end(), hides); other != taken.end();
         other = std::find_if(taken.begin(), taken.end(), hides))
    {
      const double down = box[3] - (*other)[2] + gap;
      box[2] -= down;
      box[3] -= down;
    }
    text->SetPosition(at[0], box[2] - size[2]);
    taken.push_back(box);
  }
}

void Ruler::update(
  const PickedSet::Parts& parts, const PickedSet& picked, const std::vector<std::size_t>& shown)
{
  auto measured = measure(parts, picked);
  const auto& items = picked.items();
  if (measured && std::none_of(items.begin(), items.end(),
                    [&](const Picked& one)
                    { return std::find(shown.begin(), shown.end(), one.part) != shown.end(); }))
    measured.reset();
  for (const auto& text : labels_)
    text->VisibilityOff();
  for (vtkActor2D* actor : {edge_.Get(), actor_.Get()})
    actor->SetVisibility(measured.has_value());
  if (!measured)
    return;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  const auto line = [&](const Place& from, const Place& to)
  {
    const vtkIdType ends[2] = {
      points->InsertNextPoint(from.data()), points->InsertNextPoint(to.data())};
    lines->InsertNextCell(2, ends);
  };
  for (std::size_t i = 0; i < measured->distances.size(); ++i)
  {
    const Distance& distance = measured->distances[i];
    Place end = distance.from, middle = distance.from, begin = distance.to;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      end[axis] += distance.step[axis];
      middle[axis] += 0.5 * distance.step[axis];
      begin[axis] -= distance.step[axis];
    }
    line(distance.from, end);
    // What goes out on one side of the box comes in on the other.
    if (distance.isAcross)
      line(begin, distance.to);
    this->label(i, asNumber(distance.length, 5), middle);
  }
  if (measured->angle)
    this->label(2, asNumber(*measured->angle, 4) + "\u00b0", measured->distances[0].to);
  this->part();
  lines_->SetPoints(points);
  lines_->SetLines(lines);
}

} // namespace mote::app
