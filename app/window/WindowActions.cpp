#include "Window.h"

#include "InteractorStyle.h"
#include "base/Text.h"
#include "settings/Colors.h"
#include "stage/HiddenParts.h"
#include "table/Row.h"
#include "table/Script.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mote::app
{

namespace
{

/// Whether it does something in a window that shows nothing.
bool isWithoutData(Action action)
{
  using enum Action;
  for (const Action one : {Help, HelpUp, HelpDown, Open, Panel, Undo, Redo, Escape, Quit})
    if (action == one)
      return true;
  return false;
}

} // namespace

void Window::act(const Binding& binding)
{
  if (busy_ || binding.action == Action::None)
    return;
  this->recordCamera();
  std::optional<Recorder::Doing> doing;
  if (binding.row.empty() && isRecorded(binding.action))
  {
    this->note({.kind = RecordedEvent::Kind::Action, .action = binding.action});
    doing.emplace(recorder_);
  }
  if (this->isEmpty() && !isWithoutData(binding.action))
    this->say("Nothing is open yet: press Ctrl+O, or drop a file on this window");
  else if (!binding.row.empty())
    this->actOnRow(binding);
  else if (!this->actOnView(binding.action) && !this->actOnFiles(binding.action) &&
           !this->actOnPicked(binding.action) && !this->actOnRecording(binding.action))
    switch (binding.action)
    {
    case Action::ZoomIn:
      return this->zoom(1.25);
    case Action::ZoomOut:
      return this->zoom(0.8);
    case Action::Play:
      return this->play();
    case Action::Help:
      overlay_.setMessage("");
      overlay_.toggleHelp();
      break;
    case Action::HelpUp:
    case Action::HelpDown:
      overlay_.scrollHelp(binding.action == Action::HelpUp ? -8 : 8);
      break;
    case Action::Open:
      this->showOpenDialog();
      break;
    case Action::Panel:
      this->togglePanel();
      break;
    case Action::Pick:
      this->pick(false);
      break;
    case Action::PickMore:
      this->pick(true);
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
      picked_.clear();
      break;
    case Action::Quit:
      return this->leave();
    default:
      break;
    }
  // A time step is to be seen at once, and sharp once it is looked at.
  if (binding.row == "step")
    return this->renderMoving();
  this->render();
}

/// The camera as it was asked for, or as it chooses itself for what is shown now.
void Window::resetView()
{
  const Settings next = this->settingsOf(
    [&](Settings& s)
    {
      const bool orthographic = s.camera.orthographic;
      s.camera = asked_.camera;
      s.camera.orthographic = orthographic;
      // A camera that was asked for is of the projection that was asked for.
      if (orthographic != asked_.camera.orthographic)
        s.camera.camera.clear();
    });
  if (next != this->settings())
    return this->change(next);
  // The same settings look at what another time step has from another place.
  if (const Settings seen = this->settingsAsSeen(); seen != next)
    history_.add(seen);
  this->look();
}

bool Window::actOnView(Action action)
{
  switch (action)
  {
  case Action::ResetView:
    this->resetView();
    return true;
  case Action::Center:
    this->center();
    this->recordCamera();
    return true;
  default:
    return false;
  }
}

/// Changes a row of the table. Most know their next value themselves; these know the data, too.
void Window::actOnRow(const Binding& binding)
{
  const bool more = binding.action == Action::More;
  const auto coloring = [this] { return this->coloringText(); };
  const Coloring& colors = stage_.coloring();
  Settings next = this->settings();
  if (binding.row == "step")
    return this->goTo(binding.action == Action::First  ? 0
                      : binding.action == Action::Last ? input_.numberOfSteps() - 1
                                                       : step_ + (more ? 1 : -1));
  if (binding.row == "color-by")
  {
    next.color.array = binding.action == Action::NextPart ? colors.nextComponent(stage_.parts())
                                                          : colors.nextArray(stage_.parts());
    this->fitToArray(next);
    return this->change(next, coloring);
  }
  if (binding.row == "color-map")
  {
    next.color.map = colors.nextMap();
    return this->change(next, [&] { return "Colour map " + colors.mapName(); });
  }
  if (binding.row == "radius-scale")
    return this->change(this->scaledRadius(more ? 1.15 : 1.0 / 1.15),
      [this] { return "Radius x " + asNumber(this->settings().particles.radiusScale, 3); });
  if (binding.row == "orthographic")
    return this->change(this->otherProjection());
  if (binding.row == "background")
    return this->change(this->otherBackground());
  if (binding.row == "view")
  {
    const bool parallel = next.camera.orthographic;
    next.camera = CameraSettings();
    next.camera.view = binding.value;
    next.camera.zoom = asked_.camera.zoom;
    next.camera.orthographic = parallel;
    return this->change(next);
  }
  const Row* row = rowNamed(binding.row);
  row->goOn(next, asked_);
  this->change(next, [&] { return row->told ? row->told(this->settings()) : std::string(); });
}

/// Puts away what speaks of the values of another array; what was asked for comes back with its
/// own.
void Window::fitToArray(Settings& next) const
{
  const bool asked = next.color.array == arrayAsked_;
  next.color.range = asked ? asked_.color.range : std::vector<double>();
  next.picture.title = asked ? asked_.picture.title : std::nullopt;
  next.color.logarithmic =
    asked_.color.logarithmic && stage_.coloring().isAboveZero(stage_.parts(), next.color.array);
  const auto& parts = stage_.parts();
  if (std::none_of(parts.begin(), parts.end(),
        [](const auto& part) { return part->kind() == Part::Kind::Volume; }))
    return;
  if (asked)
  {
    next.selection = withPartsOf(next.selection, asked_.selection);
    next.volume.isoValues = asked_.volume.isoValues;
    next.volume.cloud = asked_.volume.cloud;
    next.volume.opacity = asked_.volume.opacity;
    return;
  }
  if (next.volume.isoArray.empty())
    next.volume.isoValues.clear();
  next.volume.cloud = "auto";
  if (std::any_of(next.volume.opacity.begin(), next.volume.opacity.end(),
        [](const OpacityPoint& point) { return !point.isShare; }))
    next.volume.opacity.clear();
}

bool Window::actOnFiles(Action action)
{
  const auto print = [this](const std::string& text, const std::string& what)
  {
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);
    this->say(what + " is printed in the terminal");
  };
  switch (action)
  {
  case Action::SavePicture:
    playing_ = false; // a picture takes rest
    this->savePicture();
    return true;
  case Action::SaveFilm:
    this->saveFilm();
    return true;
  case Action::SaveShown:
    this->saveShown();
    return true;
  case Action::RangeOfAllSteps:
    this->takeRangeOfAllSteps();
    return true;
  case Action::RangeOfView:
    this->takeRangeOfView();
    return true;
  case Action::SaveSession:
    this->saveSession(
      asked_.output.session.empty() ? this->unusedName(".json") : asked_.output.session);
    return true;
  case Action::PrintCommand:
    print(commandOf(this->pictureInForce(), this->unusedName(".png")) + "\n", "The command");
    return true;
  case Action::PrintScript:
    print(scriptOf(stage_, input_, this->pictureInForce(), this->unusedName(".png")), "The script");
    return true;
  default:
    return false;
  }
}

Settings Window::otherProjection() const
{
  const std::vector<double> camera = cameraOf(stage_.renderer()->GetActiveCamera());
  return this->settingsOf(
    [&](Settings& s)
    {
      s.camera.camera =
        s.camera.orthographic ? withPerspective(camera) : withParallelProjection(camera);
      s.camera.orthographic = !s.camera.orthographic;
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
          for (Interval& interval : range.intervals)
            interval.low *= factor, interval.high *= factor;
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

std::string Window::coloringText() const
{
  if (!stage_.coloring().choice())
    return "One colour for all";
  Settings now = this->settings();
  now.selection = withPartsOf(asked_.selection, now.selection); // which stay, whatever colours
  const bool away =
    now.color.array != arrayAsked_ &&
    (now.selection != asked_.selection || now.volume.isoValues != asked_.volume.isoValues ||
      now.volume.opacity != asked_.volume.opacity || now.color.range != asked_.color.range);
  return "Coloured by " + stage_.coloring().title() +
         (away ? "; what was set for the values of " + arrayAsked_ + " is put away" : "");
}

void Window::say(const std::string& message)
{
  const double letter = 10.0 * scale_; // pixels, about
  const int columns = std::max(12, static_cast<int>(this->viewSize()[0] / letter));
  askedToLeave_.reset();
  overlay_.setMessage(" " + wrapped(message, static_cast<std::size_t>(columns)) + " ");
  this->startTimer(messageTimer_, 4000);
}

/// Zooms, or goes on in a list of keys that is longer than the view.
void Window::turnWheel(double factor)
{
  if (overlay_.scrollHelp(factor > 1.0 ? -3 : 3))
    return this->renderOverlays();
  this->zoom(factor);
}

void Window::zoom(double factor)
{
  vtkCamera* camera = stage_.renderer()->GetActiveCamera();
  if (camera->GetParallelProjection())
    camera->SetParallelScale(camera->GetParallelScale() / factor);
  else
    camera->Dolly(factor);
  stage_.renderer()->ResetCameraClippingRange();
  this->hoverAgain();
  this->renderMoving();
}

} // namespace mote::app
