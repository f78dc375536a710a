// What is under the cursor.

#include "Window.h"

#include "InteractorStyle.h"
#include "base/Failure.h"
#include "base/Text.h"
#include "stage/Calculated.h"
#include "stage/PlacedCell.h"

#include <vtkAbstractArray.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkIdTypeArray.h>
#include <vtkMath.h>
#include <vtkMoteAreaPicker.h>
#include <vtkMoteParticlePicker.h>
#include <vtkPointData.h>
#include <vtkProp3D.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

constexpr int mostFacts = 20;

/// A line of what is known of what was picked.
std::string factLine(std::string what, const std::string& value)
{
  what.resize(std::max<std::size_t>(what.size(), 13), ' ');
  return "\n " + what + " " + value + " ";
}

std::string asTuple(const double* values, int count)
{
  std::string text;
  for (int i = 0; i < count; ++i)
    text += (i > 0 ? ", " : "") + asNumber(values[i]);
  return text;
}

std::string arrayFacts(vtkDataSetAttributes* arrays, vtkIdType id, int& most,
  vtkDataSetAttributes* others = nullptr, const std::string& indent = "")
{
  std::string text;
  for (int i = 0; i < arrays->GetNumberOfArrays() && most > 0; ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    const std::string name = nameOf(array);
    if (name.empty() || name == whereArray || id >= array->GetNumberOfTuples())
      continue;
    --most;
    std::vector<std::string> values(
      static_cast<std::size_t>(std::min(9, array->GetNumberOfComponents())));
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] = valueText(array, static_cast<int>(k), id, 6);
    const bool isTwice = others && others->HasArray(name.c_str());
    text += factLine(indent + (isTwice ? "cell:" : "") + name, joined(values, ", "));
  }
  return text;
}

/// What arrays of points are at a place in a cell.
std::string factsBetween(vtkDataSet* data, const std::optional<CellWeights>& weights, int& most)
{
  std::string text;
  for (int i = 0; weights && i < data->GetPointData()->GetNumberOfArrays() && most > 0; ++i)
  {
    vtkDataArray* array = data->GetPointData()->GetArray(i);
    const std::string name = array ? nameOf(array) : "";
    if (name.empty() || name == whereArray)
      continue;
    --most;
    std::vector<double> values(
      static_cast<std::size_t>(std::min(9, array->GetNumberOfComponents())));
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] = valueBetween(*weights, array, static_cast<int>(k));
    const bool isTwice = data->GetCellData()->HasArray(name.c_str()) != 0;
    text += factLine(
      (isTwice ? "point:" : "") + name, asTuple(values.data(), static_cast<int>(values.size())));
  }
  return text;
}

/// The corner of a cell that is nearest to a place, and what it has.
std::string nearestFacts(vtkDataSet* data, vtkIdType cell, const PlacedCell& placed, int& most)
{
  const vtkIdType corner = nearestCorner(data, cell, placed.place);
  if (corner < 0 || most <= 0)
    return {};
  double at[3];
  data->GetPoint(corner, at);
  placed.placed->TransformPoint(at, at);
  return factLine("nearest point", withThousands(corner)) + factLine("  at", asTuple(at, 3)) +
         arrayFacts(data->GetPointData(), corner, most, nullptr, "  ");
}

} // namespace

//------------------------------------------------------------------------------------------------
// What is under the cursor

std::optional<Window::Hit> Window::hitAt(int x, int y)
{
  View* view = views_.at(x, y);
  vtkNew<vtkMoteParticlePicker> picker;
  picker->PickCloudsOn();
  if (!view || !picker->Pick(x, y, 0.0, view->renderer()))
    return {};
  for (std::size_t k = 0; k < stage_.parts().size(); ++k)
    if (stage_.parts()[k]->draws(picker->GetViewProp()))
    {
      const Surface* surface = stage_.parts()[k]->surface();
      const bool isCell = picker->GetCellId() >= 0;
      const vtkIdType id = surface  ? surface->cellOf(picker->GetCellId())
                           : isCell ? picker->GetCellId()
                                    : picker->GetParticleId();
      Hit hit{{static_cast<int>(k), isCell ? Picked::Kind::Cell : Picked::Kind::Particle, id}, {},
        picker->GetDistance(), picker->GetValue(), picker->GetCloudOpacity()};
      picker->GetPickPosition(hit.at.data());
      return hit;
    }
  return {};
}

std::string Window::factsOf(const Hit& hit, int mostArrays) const
{
  const Picked& picked = hit.picked;
  const Part& part = *stage_.parts()[static_cast<std::size_t>(picked.part)];
  const std::string which =
    withThousands(picked.id) + (stage_.parts().size() > 1 ? " of " + part.name() : "");
  if (picked.kind == Picked::Kind::Cell)
  {
    std::string what;
    if (hit.cloudOpacity > 0.0)
      what =
        factLine("volume", asNumber(hit.value) + " at the most opaque place of a ray that is " +
                             asNumber(std::ceil(100.0 * hit.cloudOpacity)) + " % opaque");
    else if (const Surface* surface = part.surface();
             std::isfinite(hit.value) && !(surface && surface->mapper()->IsColoredByCells()))
    {
      // Of a volume's walls no value is known; what is no isosurface is a slice.
      const bool isIso = !surface && !stage_.shown().volume.isoValues.empty();
      what = isIso ? factLine("surface", asNumber(hit.value))
                   : factLine("here", stage_.coloring().title() + ' ' + asNumber(hit.value));
    }
    vtkDataSet* data = part.data();
    what += factLine("cell", which) + factLine("position", asTuple(hit.at.data(), 3));
    const PlacedCell placed = placedCell(part, picked.id, hit.at);
    what += factsBetween(data, placed.weights, mostArrays);
    what += arrayFacts(data->GetCellData(), picked.id, mostArrays, data->GetPointData());
    what += nearestFacts(data, picked.id, placed, mostArrays);
    return what.substr(1);
  }
  double position[3];
  part.data()->GetPoint(picked.id, position);
  return factLine("index", which).substr(1) + factLine("position", asTuple(position, 3)) +
         arrayFacts(part.data()->GetPointData(), picked.id, mostArrays);
}

//------------------------------------------------------------------------------------------------
// Picking

void Window::setUpPicking()
{
  style_->onClick = [this](bool adds)
  {
    if (busy_ || quit_)
      return;
    this->pick(adds);
    this->render();
  };
  style_->onRectangle = [this](const InteractorStyle::Rectangle& rectangle, bool isDone)
  {
    if (busy_ || quit_)
      return;
    if (!isDone)
      return this->drawRectangle(rectangle.from, rectangle.to);
    views_.marks().hideRectangle();
    if (rectangle.from != rectangle.to)
      this->pickRectangle(
        rectangle.from, rectangle.to, rectangle.isThrough || picksThrough_, rectangle.adds);
    this->render();
  };
  this->setUpGrips();
  this->setUpHover();
}

void Window::pick(bool adds)
{
  const std::array<int, 2> cursor = this->cursor();
  this->note({.kind = RecordedEvent::Kind::Action,
    .action = adds ? Action::PickMore : Action::Pick,
    .at = this->shareOf(cursor)});
  overlay_.setMessage("");
  overlay_.hideTip();
  hoverTimer_ = 0; // what is told of the picked is enough
  const std::optional<Hit> hit = this->hitAt(cursor[0], cursor[1]);
  if (!adds)
    picked_.clear();
  if (!hit)
    return this->say("There is nothing to pick under the cursor");
  picked_.toggle(hit->picked);
  if (!picked_.contains(hit->picked))
    return this->say(withThousands(static_cast<std::int64_t>(picked_.items().size())) + " picked");
  if (hit->picked.kind == Picked::Kind::Cell)
    picked_.setPlace(hit->picked, hit->at);
  overlay_.setMessage(factsOf(*hit, mostFacts), true);
  overlay_.hideHelp();
  if (messageTimer_ > 0)
    interactor_->DestroyTimer(messageTimer_);
  messageTimer_ = 0;
}

/// The values in the view are those of the data that are there now; those of a place on a mesh
/// are not known there.
void Window::tellPickedAgain()
{
  if (!overlay_.tellsPicked())
    return;
  const Picked* last = picked_.last();
  const bool isThere = last && last->kind == Picked::Kind::Particle;
  overlay_.setMessage(isThere ? factsOf({*last, {}, 0.0, 0.0, 0.0}, mostFacts) : "", isThere);
}

void Window::drawRectangle(const std::array<int, 2>& from, const std::array<int, 2>& to)
{
  const int left = window_->GetSize()[0] - this->viewSize()[0];
  overlay_.hideTip();
  views_.marks().showRectangle(from[0] - left, from[1], to[0] - left, to[1]);
  this->renderOverlays();
}

/// Adds what a view shows in a rectangle.
void Window::addWithin(View& view, const std::array<int, 2>& from, const std::array<int, 2>& to,
  bool isThrough, std::vector<Picked>& found)
{
  const int* origin = view.renderer()->GetOrigin();
  const int* size = view.renderer()->GetSize();
  const int left = std::max(std::min(from[0], to[0]), origin[0]);
  const int right = std::min(std::max(from[0], to[0]), origin[0] + size[0] - 1);
  if (left > right)
    return;
  vtkNew<vtkMoteAreaPicker> picker;
  picker->SetThrough(isThrough);
  picker->PickCellsOn();
  picker->SetNumberOfThreads(asked_.data.threads);
  picker->Pick(left, from[1], right, to[1], view.renderer());
  for (int i = 0; i < picker->GetNumberOfProps(); ++i)
    for (std::size_t k = 0; k < stage_.parts().size(); ++k)
      if (const Part& part = *stage_.parts()[k]; part.draws(picker->GetProp(i)))
      {
        vtkIdTypeArray* cells = picker->GetCells(i);
        vtkIdTypeArray* ids = cells ? cells : picker->GetParticles(i);
        for (vtkIdType p = 0; p < ids->GetNumberOfValues(); ++p)
        {
          const vtkIdType id = ids->GetValue(p);
          found.push_back({static_cast<int>(k), kindOfPicks(part),
            part.surface() ? part.surface()->cellOf(id) : id});
        }
      }
  const bool hasOthers = std::any_of(view.parts().begin(), view.parts().end(),
    [&](std::size_t k) { return !stage_.parts()[k]->particles(); });
  if (hasOthers && isThrough)
    this->addAll(view, {left, right, std::min(from[1], to[1]), std::max(from[1], to[1])}, found);
}

/// Adds all cells that are shown and whose middle lies in the rectangle.
void Window::addAll(
  View& view, const std::array<int, 4>& rectangle, std::vector<Picked>& found) const
{
  const auto [left, right, bottom, top] = rectangle;
  vtkRenderer* renderer = view.renderer();
  const auto isIn = [&](const double place[3])
  {
    renderer->SetWorldPoint(place[0], place[1], place[2], 1.0);
    renderer->WorldToDisplay();
    const double* at = renderer->GetDisplayPoint();
    return at[0] >= left && at[0] < right + 1 && at[1] >= bottom && at[1] < top + 1 &&
           at[2] > 0.0 && at[2] < 1.0;
  };
  for (const std::size_t k : view.parts())
  {
    const Part& part = *stage_.parts()[k];
    vtkDataSet* data = part.data();
    const vtkIdType count = kindOfPicks(part) == Picked::Kind::Cell ? data->GetNumberOfCells() : 0;
    vtkUnsignedCharArray* isVisible = part.cells().mask();
    const auto placements = part.placements();
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (isVisible && isVisible->GetValue(i) == 0)
        continue;
      double place[3], bounds[6];
      data->GetCellBounds(i, bounds);
      for (int axis = 0; axis < 3; ++axis)
        place[axis] = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
      if (std::any_of(placements.begin(), placements.end(),
            [&](const auto& placed) { return isIn(placed->TransformDoublePoint(place)); }))
        found.push_back({static_cast<int>(k), Picked::Kind::Cell, i});
    }
  }
}

void Window::pickRectangle(
  const std::array<int, 2>& from, const std::array<int, 2>& to, bool isThrough, bool adds)
{
  this->note({.kind = RecordedEvent::Kind::Rectangle,
    .at = this->shareOf(from),
    .to = this->shareOf(to),
    .isThrough = isThrough,
    .adds = adds});
  std::vector<Picked> found;
  for (View* view : views_.shown())
    this->addWithin(*view, from, to, isThrough, found);
  if (!adds)
    picked_.clear();
  picked_.add(found);
  const auto count = static_cast<std::int64_t>(found.size());
  const bool isParticles = std::all_of(found.begin(), found.end(),
    [](const Picked& one) { return one.kind == Picked::Kind::Particle; });
  const std::string many = isParticles ? "particle" : "cell";
  this->say(found.empty()
              ? "There is nothing to pick in the rectangle"
              : counted(count, many.c_str()) + " in the rectangle" +
                  (isThrough ? ", with those that others hide" : "") +
                  (adds ? "; " + withThousands(static_cast<std::int64_t>(picked_.items().size())) +
                            " picked"
                        : ""));
}

//------------------------------------------------------------------------------------------------
// What is done with the picked

bool Window::actOnPicked(Action action)
{
  const std::string hidden = picked_.counts();
  const auto ids = [this] { return picked_.ids(stage_.parts()); };
  switch (action)
  {
  case Action::HidePicked:
    if (this->requirePicked())
    {
      this->showOnly(
        [&](SelectionSettings& s) { s.hidden = s.hidden.with(ids()); }, "Hid " + hidden);
      picked_.clear();
    }
    return true;
  case Action::OnlyPicked:
    if (this->requirePicked())
      this->showOnly([&](SelectionSettings& s) { s.only = ids(); }, "Only " + hidden);
    return true;
  case Action::ShowHidden:
    this->showOnly(
      [](SelectionSettings& s) { s.hidden = s.only = {}; }, "Nothing is hidden by its id");
    return true;
  case Action::PathsOfPicked:
    this->changePaths();
    return true;
  case Action::PlotOverTime:
    this->plotOverTime();
    return true;
  case Action::SaveOverTime:
    this->saveOverTime();
    return true;
  case Action::SavePlot:
  case Action::SavePlotSvg:
  case Action::SaveCounts:
    this->savePlot(action == Action::SavePlot      ? "-plot.png"
                   : action == Action::SavePlotSvg ? "-plot.svg"
                                                   : "-plot.csv");
    return true;
  case Action::CopyPicked:
    if (this->requirePicked())
      this->copyPicked();
    return true;
  case Action::SavePickedData:
    if (this->requirePicked())
      this->savePickedData();
    return true;
  case Action::SavePicked:
  case Action::SavePickedJson:
    if (this->requirePicked())
      this->savePicked(action == Action::SavePicked ? "-picked.csv" : "-picked.json");
    return true;
  default:
    return false;
  }
}

bool Window::requirePicked()
{
  if (picked_.items().empty())
    this->say("Nothing is picked: click on it first, or drag a rectangle with Ctrl");
  return !picked_.items().empty();
}

void Window::showOnly(
  const std::function<void(SelectionSettings&)>& change, const std::string& told)
{
  this->change(this->settingsOf([&](Settings& s) { change(s.selection); }), [&] { return told; });
}

void Window::center()
{
  const int* cursor = interactor_->GetEventPosition();
  const std::optional<Hit> hit = this->hitAt(cursor[0], cursor[1]);
  if (!hit)
    return this->say("There is no particle under the cursor");
  double focus[3], position[3];
  vtkCamera* camera = stage_.renderer()->GetActiveCamera();
  camera->GetFocalPoint(focus);
  camera->GetPosition(position);
  std::array<double, 3> at = hit->at;
  const auto aside = views_.asideOf(views_.at(cursor[0], cursor[1]));
  for (std::size_t i = 0; i < 3; ++i)
  {
    at[i] -= aside[i];
    position[i] += at[i] - focus[i];
  }
  camera->SetFocalPoint(at.data());
  camera->SetPosition(position);
  stage_.renderer()->ResetCameraClippingRange();
}

} // namespace mote::app
