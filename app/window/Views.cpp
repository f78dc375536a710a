#include "Views.h"

#include "settings/Colors.h"
#include "stage/Framing.h"
#include "stage/SideBySide.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProp3D.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace mote::app
{

namespace
{

constexpr int nameSize = 16, nameMargin = 9; // pixels, at a scale of 1

/// A line in pixels of a view.
void makeDivider(vtkActor2D* divider)
{
  vtkNew<vtkPoints> ends;
  ends->SetNumberOfPoints(2);
  vtkNew<vtkCellArray> lines;
  const vtkIdType numbers[2] = {0, 1};
  lines->InsertNextCell(2, numbers);
  vtkNew<vtkPolyData> line;
  line->SetPoints(ends);
  line->SetLines(lines);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(line);
  divider->SetMapper(mapper);
  divider->VisibilityOff();
}

void placeDivider(vtkActor2D* divider, const std::array<int, 2>& from, const std::array<int, 2>& to)
{
  auto* mapper = static_cast<vtkPolyDataMapper2D*>(divider->GetMapper());
  vtkPoints* ends = mapper->GetInput()->GetPoints();
  ends->SetPoint(0, from[0], from[1], 0.0);
  ends->SetPoint(1, to[0], to[1], 0.0);
  ends->Modified();
}

/// The least and the greatest of what passes tell.
std::array<double, 2> extremes(
  const std::vector<vtkMoteRayCastPass*>& passes, double (vtkMoteRayCastPass::*of)())
{
  std::vector<double> values;
  for (vtkMoteRayCastPass* pass : passes)
    values.push_back((pass->*of)());
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  return {*least, *greatest};
}

} // namespace

Views::Views(Stage& stage, vtkRenderWindow* window)
  : stage_(stage)
  , window_(window)
  , whole_(stage.renderer())
{
  for (Column& column : column_)
  {
    column.renderer->SetActiveCamera(stage.renderer()->GetActiveCamera());
    column.renderer->AutomaticLightCreationOff();
    column.renderer->InteractiveOff(); // the mouse turns the stage's camera
    vtkTextProperty* look = column.title->GetTextProperty();
    look->SetFontSize(nameSize);
    look->SetJustificationToCentered();
    look->SetVerticalJustificationToTop();
    column.title->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
    column.title->VisibilityOff();
    stage.renderer()->AddActor2D(column.title);
  }
  for (const auto& divider : dividers_)
  {
    makeDivider(divider);
    stage.renderer()->AddActor2D(divider);
  }
  ground_->SetInteractive(0);
}

Views::~Views() = default;

//------------------------------------------------------------------------------------------------
// What is where

void Views::follow(const ParticlePaths* paths)
{
  const auto views = stage_.views();
  this->setColumns(views.size() > 1 ? views.size() : 0);
  this->move(views);
  if (!this->isSideBySide())
    return whole_.show(stage_, views.front(), paths);
  whole_.show(stage_, {}, nullptr);
  for (std::size_t i = 0; i < columns_; ++i)
  {
    column_[i].view.show(stage_, views[i], paths);
    column_[i].title->SetInput(stage_.viewName(views[i]).c_str());
  }
}

/// Has so many renderers below the stage's own.
void Views::setColumns(std::size_t count)
{
  if (count == columns_)
    return;
  for (const auto& column : column_)
    window_->RemoveRenderer(column.renderer);
  window_->RemoveRenderer(ground_);
  columns_ = count;
  if (count > 0)
  {
    window_->SetNumberOfLayers(std::max(2, window_->GetNumberOfLayers()));
    window_->AddRenderer(ground_);
  }
  for (std::size_t i = 0; i < count; ++i)
    window_->AddRenderer(column_[i].renderer);
  stage_.renderer()->SetLayer(count > 0 ? 1 : 0);
  for (std::size_t i = 0; i < column_.size(); ++i)
    column_[i].title->SetVisibility(i < count);
  for (const auto& divider : dividers_)
    divider->VisibilityOff(); // until they are laid
  this->takePasses();
}

/// Puts the data where they are shown.
void Views::move(const std::vector<std::vector<std::size_t>>& views)
{
  for (std::size_t i = 0; i < column_.size(); ++i)
  {
    std::vector<vtkProp*> wanted;
    if (i < columns_)
      for (vtkProp* prop : stage_.propsOf(views[i]))
        wanted.push_back(prop);
    if (wanted == column_[i].props)
      continue;
    for (vtkProp* prop : column_[i].props)
      column_[i].renderer->RemoveViewProp(prop);
    for (vtkProp* prop : wanted)
      column_[i].renderer->AddViewProp(prop);
    column_[i].props = wanted;
  }
  std::vector<std::size_t> all(stage_.parts().size());
  std::iota(all.begin(), all.end(), 0);
  for (vtkProp* prop : stage_.propsOf(all))
    if (this->isSideBySide())
      stage_.renderer()->RemoveViewProp(prop);
    else if (!stage_.renderer()->HasViewProp(prop))
      stage_.renderer()->AddViewProp(prop);
}

View* Views::at(int x, int y)
{
  for (View* view : this->shown())
    if (view->renderer()->IsInViewport(x, y))
      return view;
  return nullptr;
}

std::vector<View*> Views::shown()
{
  if (!this->isSideBySide())
    return {&whole_};
  std::vector<View*> views;
  for (std::size_t i = 0; i < columns_; ++i)
    views.push_back(&column_[i].view);
  return views;
}

bool Views::offerHandles(bool on)
{
  if (std::exchange(offersHandles_, on) == on)
    return false;
  bool isOther = whole_.offerHandles(stage_, on);
  for (Column& column : column_)
    isOther = column.view.offerHandles(stage_, on) || isOther;
  return isOther;
}

void Views::forgetMarks()
{
  for (View* view : this->shown())
    view->marks().forget();
}

//------------------------------------------------------------------------------------------------
// Where the views lie

/// Of all views in pixels of the window: left, right, bottom, top.
std::array<int, 4> Views::area() const
{
  const int* size = window_->GetSize();
  const double left = stage_.renderer()->GetViewport()[0];
  return {static_cast<int>(std::lround(left * size[0])), size[0], 0, size[1]};
}

std::array<int, 2> Views::size() const
{
  const auto [left, right, bottom, top] = this->area();
  if (!this->isSideBySide())
    return {right - left, top - bottom};
  const SideBySide sides(stage_, columns_, {right - left, top - bottom}, true);
  return {sides.width, sides.height};
}

void Views::lay()
{
  const auto [left, right, bottom, top] = this->area();
  const std::array<int, 2> size = {right - left, top - bottom};
  const SideBySide sides(stage_, columns_, size, true);
  const double whole = std::max(1, right), height = std::max(1, size[1]);
  ground_->SetViewport(stage_.renderer()->GetViewport());
  for (std::size_t i = 0; i < columns_; ++i)
  {
    const int from = sides.left(i), low = sides.bottom(i), high = low + sides.height;
    column_[i].renderer->SetViewport(
      (left + from) / whole, low / height, (left + from + sides.width) / whole, high / height);
    column_[i].title->SetPosition((from + 0.5 * sides.width) / std::max(1, size[0]),
      (high - this->pixels(nameMargin)) / height);
  }
  std::size_t next = 0;
  const auto divide = [&](const std::array<int, 2>& one, const std::array<int, 2>& other)
  {
    dividers_[next]->VisibilityOn();
    placeDivider(dividers_[next++], one, other);
  };
  for (int column = 1; column < sides.columns; ++column)
  {
    const int x = sides.left(static_cast<std::size_t>(column));
    divide({x, 0}, {x, sides.top});
  }
  for (int row = 1; row < sides.rows; ++row)
  {
    const int y = sides.top - row * sides.height;
    divide({sides.first, y}, {sides.right(), y});
  }
  for (; next < dividers_.size(); ++next)
    dividers_[next]->VisibilityOff();
}

int Views::heightOfNames() const
{
  return this->isSideBySide() ? this->pixels(2 * nameMargin + nameSize) : 0;
}

void Views::setScale(double scale)
{
  scale_ = scale;
  whole_.setScale(scale);
  for (Column& column : column_)
  {
    column.view.setScale(scale);
    column.title->GetTextProperty()->SetFontSize(this->pixels(nameSize));
  }
  if (this->isSideBySide())
    this->lay();
}

/// Light and background are the stage's.
void Views::copyLook(vtkRenderer* to) const
{
  vtkRenderer* stage = stage_.renderer();
  to->SetBackground(stage->GetBackground());
  to->SetBackground2(stage->GetBackground2());
  to->SetGradientBackground(stage->GetGradientBackground());
  to->RemoveAllLights();
  vtkCollectionSimpleIterator next;
  stage->GetLights()->InitTraversal(next);
  while (vtkLight* light = stage->GetLights()->GetNextLight(next))
    to->AddLight(light);
}

void Views::update(const PickedSet& picked)
{
  whole_.update(stage_, picked);
  if (!this->isSideBySide())
    return;
  if (const auto views = stage_.views(); views.size() == columns_)
    this->move(views); // data that came without a word
  this->lay();
  this->copyLook(ground_);
  const Color ink = inkOn(stage_.renderer());
  for (std::size_t i = 0; i < columns_; ++i)
  {
    this->copyLook(column_[i].renderer);
    column_[i].view.update(stage_, picked);
    column_[i].title->GetTextProperty()->SetColor(ink[0], ink[1], ink[2]);
  }
  for (const auto& divider : dividers_)
    divider->GetProperty()->SetColor(dividerInk(stage_.renderer()).data());
  // One camera sees all that lies together, and cuts nothing off in any view.
  double bounds[6];
  stage_.bounds(bounds);
  stage_.renderer()->ResetCameraClippingRange(bounds);
  for (std::size_t i = 0; i < columns_; ++i)
    this->placeCamera(column_[i]);
}

void Views::placeCamera(Column& column)
{
  vtkCamera* shared = stage_.renderer()->GetActiveCamera();
  const auto aside = stage_.asideOf(column.view.parts());
  const bool isOwn = aside != std::array<double, 3>();
  if (isOwn && (aside != column.aside || shared->GetMTime() != column.copied))
    moveAside(column.camera, shared, aside);
  column.aside = aside;
  column.copied = shared->GetMTime();
  vtkCamera* wanted = isOwn ? column.camera.Get() : shared;
  if (column.renderer->GetActiveCamera() != wanted)
    column.renderer->SetActiveCamera(wanted);
  if (isOwn)
    column.renderer->ResetCameraClippingRange();
}

std::array<double, 3> Views::asideOf(const View* view) const
{
  for (std::size_t i = 0; i < columns_; ++i)
    if (&column_[i].view == view)
      return column_[i].aside;
  return {};
}

//------------------------------------------------------------------------------------------------
// Passes

std::vector<vtkMoteRayCastPass*> Views::passes() const
{
  std::vector<vtkMoteRayCastPass*> passes;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, columns_); ++i)
    passes.push_back(pass_[i]);
  return passes;
}

void Views::setUpPasses(const std::function<void(vtkMoteRayCastPass*)>& set)
{
  for (const auto& pass : pass_)
    set(pass);
}

void Views::takePasses()
{
  stage_.renderer()->SetPass(this->isSideBySide() ? nullptr : pass_[0].Get());
  for (std::size_t i = 0; i < column_.size(); ++i)
    column_[i].renderer->SetPass(i < columns_ ? pass_[i].Get() : nullptr);
}

bool Views::isConverged() const
{
  const auto all = this->passes();
  return std::all_of(all.begin(), all.end(), [](auto* pass) { return pass->IsConverged(); });
}

bool Views::isPreview() const
{
  const auto all = this->passes();
  return std::any_of(all.begin(), all.end(), [](auto* pass) { return pass->IsPreview(); });
}

double Views::traceTime() const
{
  double sum = 0.0;
  for (vtkMoteRayCastPass* pass : this->passes())
    sum += pass->GetTraceTime();
  return sum;
}

double Views::silhouetteTime() const
{
  double sum = 0.0;
  for (vtkMoteRayCastPass* pass : this->passes())
    sum += pass->GetSilhouetteTime();
  return sum;
}

int Views::numberOfSamples() const
{
  int least = pass_[0]->GetNumberOfSamples();
  for (vtkMoteRayCastPass* pass : this->passes())
    least = std::min(least, pass->GetNumberOfSamples());
  return least;
}

double Views::finerShare() const
{
  return extremes(this->passes(), &vtkMoteRayCastPass::GetFinerShare)[0];
}

double Views::bakedShare() const
{
  return extremes(this->passes(), &vtkMoteRayCastPass::GetBakedShare)[0];
}

double Views::imageSampleDistance() const
{
  return extremes(this->passes(), &vtkMoteRayCastPass::GetImageSampleDistance)[1];
}

double Views::noise() const
{
  return extremes(this->passes(), &vtkMoteRayCastPass::GetNoise)[1];
}

} // namespace mote::app
