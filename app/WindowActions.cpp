#include "Window.h"

#include "Arrays.h"
#include "Colors.h"
#include "InteractorStyle.h"
#include "Text.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkMoteImageWriter.h>
#include <vtkMoteParticlePicker.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace mote::app
{

void Window::act(Action action)
{
  if (busy_ || action == Action::None)
    return;
  if (!this->actOnView(action) && !this->actOnLook(action) && !this->actOnTime(action))
    switch (action)
    {
    case Action::ZoomIn:
      return this->zoom(1.25);
    case Action::ZoomOut:
      return this->zoom(0.8);
    case Action::Play:
      playing_ = !playing_ && input_.numberOfSteps() > 1;
      if (playing_)
        return this->advance();
      break;
    case Action::Help:
      overlay_.setMessage("");
      overlay_.toggleHelp();
      break;
    case Action::Pick:
      this->pick();
      break;
    case Action::Save:
      playing_ = false; // a picture takes rest
      this->savePicture();
      break;
    case Action::Escape:
      playing_ = false;
      overlay_.hideHelp();
      overlay_.setMessage("");
      props_.unmark();
      break;
    case Action::Quit:
      return this->quit();
    default:
      break;
    }
  this->render();
}

bool Window::actOnView(Action action)
{
  switch (action)
  {
  case Action::ResetView:
    this->look(options_.view);
    return true;
  case Action::ViewPlusX:
    this->look("+x");
    return true;
  case Action::ViewMinusX:
    this->look("-x");
    return true;
  case Action::ViewPlusY:
    this->look("+y");
    return true;
  case Action::ViewMinusY:
    this->look("-y");
    return true;
  case Action::ViewPlusZ:
    this->look("+z");
    return true;
  case Action::ViewMinusZ:
    this->look("-z");
    return true;
  case Action::Projection:
    this->toggleProjection();
    return true;
  case Action::Center:
    this->center();
    return true;
  default:
    return false;
  }
}

bool Window::actOnLook(Action action)
{
  switch (action)
  {
  case Action::NextArray:
    stage_.coloring().nextArray(stage_.parts());
    this->sayColoring();
    return true;
  case Action::NextComponent:
    stage_.coloring().nextComponent(stage_.parts());
    this->sayColoring();
    return true;
  case Action::NextMap:
    stage_.coloring().nextMap(stage_.parts());
    props_.update(options_);
    this->say("Colour map " + stage_.coloring().mapName());
    return true;
  case Action::Smaller:
    this->scaleRadius(1.0 / 1.15);
    return true;
  case Action::Larger:
    this->scaleRadius(1.15);
    return true;
  case Action::Box:
    props_.toggleBox();
    return true;
  case Action::Legend:
    props_.legend().toggle();
    return true;
  case Action::Axes:
    props_.toggleAxes();
    return true;
  case Action::Background:
    this->toggleBackground();
    return true;
  case Action::Shadows:
    stage_.lighting().nextShadows();
    this->say(stage_.lighting().shadowsName());
    return true;
  case Action::Shading:
    stage_.nextShading();
    this->say(stage_.lighting().shadingName());
    return true;
  case Action::Silhouettes:
    stage_.silhouettes()->SetEnabled(!stage_.silhouettes()->GetEnabled());
    this->say(stage_.silhouettes()->GetEnabled() ? "Silhouettes" : "No silhouettes");
    return true;
  default:
    return false;
  }
}

bool Window::actOnTime(Action action)
{
  switch (action)
  {
  case Action::PreviousStep:
    this->goTo(step_ - 1);
    return true;
  case Action::NextStep:
    this->goTo(step_ + 1);
    return true;
  case Action::FirstStep:
    this->goTo(0);
    return true;
  case Action::LastStep:
    this->goTo(input_.numberOfSteps() - 1);
    return true;
  default:
    return false;
  }
}

void Window::toggleProjection()
{
  vtkCamera* camera = stage_.renderer()->GetActiveCamera();
  // What is at the focal point keeps its size.
  const double half = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  if (!camera->GetParallelProjection())
    camera->SetParallelScale(camera->GetDistance() * half);
  else
    camera->Dolly(camera->GetDistance() * half / camera->GetParallelScale());
  camera->SetParallelProjection(!camera->GetParallelProjection());
  stage_.renderer()->ResetCameraClippingRange();
}

void Window::sayColoring()
{
  props_.update(options_);
  this->say(
    stage_.coloring().choice() ? "Coloured by " + stage_.coloring().title() : "One colour for all");
}

void Window::say(const std::string& message)
{
  overlay_.setMessage(" " + message + " ");
  this->startTimer(messageTimer_, 4000);
}

void Window::goTo(int step)
{
  playing_ = false;
  if (step < 0 || step >= input_.numberOfSteps())
    this->say(input_.numberOfSteps() == 1 ? "There is one time step only"
              : step < 0                  ? "This is the first time step"
                                          : "This is the last time step");
  else
    this->load(step);
}

void Window::zoom(double factor)
{
  vtkCamera* camera = stage_.renderer()->GetActiveCamera();
  if (camera->GetParallelProjection())
    camera->SetParallelScale(camera->GetParallelScale() / factor);
  else
    camera->Dolly(factor);
  stage_.renderer()->ResetCameraClippingRange();
  this->renderMoving();
}

void Window::scaleRadius(double factor)
{
  radiusScale_ *= factor;
  stage_.setRadiusScale(radiusScale_);
  if (this->buildAgain())
    this->say("Radius x " + asNumber(radiusScale_, 3));
}

namespace
{

/// A line of what is known of what was picked.
std::string factLine(std::string what, const std::string& value)
{
  what.resize(std::max<std::size_t>(what.size(), 12), ' ');
  return "\n " + what + " " + value + " ";
}

std::string asTuple(const double* values, int count)
{
  std::string text;
  for (int i = 0; i < count; ++i)
    text += (i > 0 ? ", " : "") + asNumber(values[i]);
  return text;
}

} // namespace

void Window::pick()
{
  const int* cursor = interactor_->GetEventPosition();
  vtkNew<vtkMoteParticlePicker> picker;
  props_.unmark();
  overlay_.setMessage("");
  if (!picker->Pick(cursor[0], cursor[1], 0.0, stage_.renderer()))
    return this->say("There is neither a particle nor an iso-surface under the cursor");
  for (const auto& part : stage_.parts())
  {
    if (part->prop() != picker->GetViewProp())
      continue;
    double center[3], at[3];
    picker->GetPickPosition(at);
    if (picker->GetCellId() >= 0)
      overlay_.setMessage(
        factLine("iso-surface", asNumber(picker->GetValue())).substr(1) +
        factLine("cell", withThousands(picker->GetCellId()) + " of " + part->name()) +
        factLine("position", asTuple(at, 3)));
    else
    {
      part->data()->GetPoint(picker->GetParticleId(), center);
      props_.mark(center, std::sqrt(vtkMath::Distance2BetweenPoints(center, at)));
      overlay_.setMessage(this->particleFacts(*part, picker->GetParticleId()));
    }
    overlay_.hideHelp();
    if (messageTimer_ > 0)
      interactor_->DestroyTimer(messageTimer_);
    messageTimer_ = 0;
  }
}

std::string Window::particleFacts(const Part& part, vtkIdType id) const
{
  double position[3];
  part.data()->GetPoint(id, position);
  std::string text = factLine("particle", withThousands(id) + " of " + part.name()).substr(1);
  text += factLine("position", asTuple(position, 3));
  vtkPointData* arrays = part.data()->GetPointData();
  for (int i = 0; i < std::min(20, arrays->GetNumberOfArrays()); ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    if (!array || !array->GetName() || id >= array->GetNumberOfTuples())
      continue;
    if (auto* numbers = vtkDataArray::SafeDownCast(array))
      text += factLine(array->GetName(),
        asTuple(numbers->GetTuple(id), std::min(9, numbers->GetNumberOfComponents())));
    else if (auto* words = vtkStringArray::SafeDownCast(array))
      text += factLine(array->GetName(), words->GetValue(id));
  }
  return text;
}

void Window::center()
{
  const int* cursor = interactor_->GetEventPosition();
  vtkNew<vtkMoteParticlePicker> picker;
  if (!picker->Pick(cursor[0], cursor[1], 0.0, stage_.renderer()))
    return this->say("There is no particle under the cursor");
  double at[3], focus[3], position[3];
  picker->GetPickPosition(at);
  vtkCamera* camera = stage_.renderer()->GetActiveCamera();
  camera->GetFocalPoint(focus);
  camera->GetPosition(position);
  for (int i = 0; i < 3; ++i)
    position[i] += at[i] - focus[i];
  camera->SetFocalPoint(at);
  camera->SetPosition(position);
  stage_.renderer()->ResetCameraClippingRange();
}

void Window::toggleBackground()
{
  const bool light = inkOn(stage_.renderer())[0] < 0.5;
  setBackground(
    stage_.renderer(), light ? std::vector<Color>{} : std::vector<Color>{{1.0, 1.0, 1.0}});
  props_.setInk(inkOn(stage_.renderer()));
  overlay_.setInk(inkOn(stage_.renderer()));
}

void Window::savePicture()
{
  const std::string stem = std::filesystem::path(options_.files.front()).stem().stem().string();
  std::string file;
  for (int i = 1; file.empty() || std::filesystem::exists(file); ++i)
  {
    char number[16];
    std::snprintf(number, sizeof number, "-%03d.png", i);
    file = stem + number;
  }
  // A preview is for looking; what is kept is exact.
  if (previewed_ && !this->perform([&] { stage_.finishBuild(progress_); }))
    return;
  overlay_.setVisible(false);
  do
    this->render();
  while (traced_ && !pass_->IsConverged() && !inputWaits(window_));
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window_);
  image->SetInputBufferTypeToRGB();
  image->ReadFrontBufferOff();
  image->ShouldRerenderOff();
  vtkNew<vtkMoteImageWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(file.c_str());
  const bool written = writer->Write() != 0;
  overlay_.setVisible(true);
  this->say(written ? "Saved " + file : writer->GetErrorMessage());
}

} // namespace mote::app
