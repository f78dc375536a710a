#include "Window.h"

#include "InteractorStyle.h"
#include "base/Text.h"
#include "settings/Colors.h"
#include "stage/Arrays.h"
#include "stage/Picture.h"
#include "stage/Silhouettes.h"
#include "table/Row.h"
#include "table/Script.h"

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

void Window::act(const Binding& binding)
{
  if (busy_ || binding.action == Action::None)
    return;
  this->recordCamera();
  if (!this->actOnView(binding) && !this->actOnLook(binding) && !this->actOnTime(binding.action) &&
      !this->actOnFiles(binding.action))
    switch (binding.action)
    {
    case Action::ZoomIn:
      return this->zoom(1.25);
    case Action::ZoomOut:
      return this->zoom(0.8);
    case Action::Play:
      playing_ = !playing_ && input_.numberOfSteps() > 1;
      if (playing_)
      {
        history_.add(this->settings());
        return this->advance();
      }
      break;
    case Action::Help:
      overlay_.setMessage("");
      overlay_.toggleHelp();
      break;
    case Action::Pick:
      this->pick();
      break;
    case Action::Undo:
      this->goBack(true);
      break;
    case Action::Redo:
      this->goBack(false);
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

bool Window::actOnView(const Binding& binding)
{
  switch (binding.action)
  {
  case Action::ResetView:
    this->change(this->settingsOf(
      [&](Settings& s)
      {
        const bool orthographic = s.camera.orthographic;
        s.camera = asked_.camera;
        s.camera.orthographic = orthographic;
        // A camera that was asked for is of the projection that was asked for.
        if (orthographic != asked_.camera.orthographic)
          s.camera.camera.clear();
      }));
    return true;
  case Action::View:
    this->change(this->settingsOf(
      [&](Settings& s)
      {
        s.camera = {
          .view = binding.name, .zoom = asked_.camera.zoom, .orthographic = s.camera.orthographic};
      }));
    return true;
  case Action::Projection:
    this->change(this->otherProjection());
    return true;
  case Action::Center:
    this->center();
    this->recordCamera();
    return true;
  default:
    return false;
  }
}

bool Window::actOnLook(const Binding& binding)
{
  const auto to = [this](const auto& change, const std::function<std::string()>& message)
  { this->change(this->settingsOf(change), message); };
  const auto coloring = [this] { return this->coloringText(); };
  const Coloring& colors = stage_.coloring();
  switch (binding.action)
  {
  case Action::NextArray:
    to([&](Settings& s) { s.color.array = colors.nextArray(stage_.parts()); }, coloring);
    return true;
  case Action::NextComponent:
    to([&](Settings& s) { s.color.array = colors.nextComponent(stage_.parts()); }, coloring);
    return true;
  case Action::NextMap:
    to([&](Settings& s) { s.color.map = colors.nextMap(); },
      [&] { return "Colour map " + colors.mapName(); });
    return true;
  case Action::Smaller:
  case Action::Larger:
    this->change(this->scaledRadius(binding.action == Action::Larger ? 1.15 : 1.0 / 1.15),
      [this] { return "Radius x " + asNumber(this->settings().particles.radiusScale, 3); });
    return true;
  case Action::Toggle:
    this->toggle(binding.name);
    return true;
  case Action::Background:
    this->change(this->otherBackground());
    return true;
  case Action::Shadows:
    to([&](Settings& s) { s.light = withNextShadows(s.light, asked_.light); },
      [this] { return shadowsName(this->settings().light); });
    return true;
  case Action::Shading:
    to([&](Settings& s) { s.light = withNextShading(s.light); },
      [this] { return shadingName(this->settings().light); });
    return true;
  case Action::Silhouettes:
    to([&](Settings& s) { s.silhouettes = toggled(s.silhouettes, asked_.silhouettes); },
      [this] { return areOn(this->settings().silhouettes) ? "Silhouettes" : "No silhouettes"; });
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

bool Window::hasSurfaces() const
{
  const auto& parts = stage_.parts();
  return std::any_of(parts.begin(), parts.end(),
    [](const auto& part) { return part->kind() == Part::Kind::Surface; });
}

bool Window::actOnFiles(Action action)
{
  const auto print = [this](const std::string& text, const std::string& what)
  {
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);
    this->say(what + " is printed in the terminal" +
              (this->hasSurfaces() ? "; surfaces are not in it: mote render draws none" : ""));
  };
  switch (action)
  {
  case Action::SavePicture:
    playing_ = false; // a picture takes rest
    this->savePicture();
    return true;
  case Action::SaveSession:
    this->saveSession(options_.session.empty() ? this->unusedName(".json") : options_.session);
    return true;
  case Action::PrintCommand:
    print(commandOf(this->settingsInForce(), this->unusedName(".png")) + "\n", "The command");
    return true;
  case Action::PrintScript:
    print(
      scriptOf(stage_, input_, this->settingsInForce(), this->unusedName(".png")), "The script");
    return true;
  default:
    return false;
  }
}

Settings Window::otherProjection() const
{
  // What is at the focal point keeps its size.
  vtkCamera* camera = stage_.renderer()->GetActiveCamera();
  const double half = std::tan(0.5 * vtkMath::RadiansFromDegrees(usualViewAngle));
  std::vector<double> numbers = cameraOf(camera);
  const bool parallel = camera->GetParallelProjection() != 0;
  double* const eye = numbers.data();
  const double* const focus = eye + 3;
  if (parallel)
  {
    const double factor = numbers[9] / half / camera->GetDistance();
    for (int i = 0; i < 3; ++i)
      eye[i] = focus[i] + factor * (eye[i] - focus[i]);
    numbers[9] = usualViewAngle;
  }
  else
    numbers[9] =
      camera->GetDistance() * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  return this->settingsOf(
    [&](Settings& s)
    {
      s.camera.orthographic = !parallel;
      s.camera.camera = numbers;
    });
}

Settings Window::scaledRadius(double factor) const
{
  return this->settingsOf(
    [&](Settings& s)
    {
      s.particles.radiusScale *= factor;
      // Who scales all radii does not mean to see others.
      for (ShowRange& range : s.selection.ranges)
        if (range.name == "radius")
          range.low *= factor, range.high *= factor;
    });
}

Settings Window::otherBackground() const
{
  const bool light = inkOn(stage_.renderer())[0] < 0.5;
  return this->settingsOf(
    [&](Settings& s) {
      s.picture.background = light ? std::vector<Color>{} : std::vector<Color>{{1.0, 1.0, 1.0}};
    });
}

void Window::toggle(const std::string& name)
{
  const Row* row = rowNamed(name);
  this->change(this->settingsOf(
    [&](Settings& s) { row->set(s, {row->get(s).front() == "true" ? "false" : "true"}); }));
}

std::string Window::coloringText() const
{
  return stage_.coloring().choice() ? "Coloured by " + stage_.coloring().title()
                                    : "One colour for all";
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
    this->change(this->withStep(step));
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

std::string Window::unusedName(const std::string& ending) const
{
  const std::string stem =
    std::filesystem::path(this->settings().data.files.front()).stem().stem().string();
  for (int i = 1;; ++i)
  {
    char number[16];
    std::snprintf(number, sizeof number, "-%03d", i);
    if (const std::string file = stem + number + ending; !std::filesystem::exists(file))
      return file;
  }
}

void Window::savePicture()
{
  const std::string file = this->unusedName(".png");
  // A preview is for looking; what is kept is exact.
  if (previewed_ && !this->perform([&] { stage_.finishBuild(progress_); }))
    return;
  if (this->hasSurfaces())
    return this->grabPicture(file);
  // As mote render makes it, so that the printed command gives the same.
  const int* size = window_->GetSize();
  const bool done = this->perform(
    [&]
    {
      Picture picture(stage_, {size[0], size[1]});
      picture.aim(file);
      picture.write(captionOf(input_, step_, stage_.contents()), progress_);
    });
  if (done)
    this->say("Saved " + file);
}

/// Surfaces are OpenGL's, which mote render does without.
void Window::grabPicture(const std::string& file)
{
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
