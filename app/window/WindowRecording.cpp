// What is done in the window is recorded, and played.

#include "Window.h"

#include "InteractorStyle.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/Text.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace mote::app
{

namespace
{

using Kind = RecordedEvent::Kind;

} // namespace

//------------------------------------------------------------------------------------------------
// Recording

void Window::startRecording(const std::string& file)
{
  if (!file.empty())
    recorder_.start(file, this->settings(), this->state());
}

/// What keys and the panel's section of recordings do.
bool Window::actOnRecording(Action action)
{
  if (action == Action::Record)
    this->toggleRecording();
  else if (action == Action::PlayRecording)
    this->togglePlaying();
  else
    return this->changeKeyFrames(action);
  return true;
}

void Window::toggleRecording()
{
  const std::string file = this->settings().output.record;
  if (recorder_.isOn())
  {
    this->noteRest();
    recorder_.stop();
    // What was recorded is what is played, unless another one is chosen; another goes elsewhere.
    Settings next = this->settings();
    next.output.play = file;
    next.output.record.clear();
    stage_.apply(next);
    return this->say("Recorded in " + file);
  }
  Settings next = this->settings();
  if (file.empty())
    next.output.record = this->unusedName(".rec");
  else if (std::filesystem::exists(file))
    throw Failure(file + " is there already: choose another name for the recording");
  next.output.play.clear(); // which may be any file now
  checkRecordingOutput(next);
  next.output.play = this->settings().output.play;
  picked_.clear(); // recordings have none at their beginning
  next.marks.picked.clear();
  stage_.apply(next);
  this->startRecording(next.output.record);
  this->noteRest();
  this->say("Recording in " + next.output.record);
}

/// Begins with the settings that the recording begins with.
void Window::togglePlaying()
{
  if (player_)
    return this->endPlaying();
  const OutputSettings& own = this->settings().output;
  const std::string file = own.play;
  if (file.empty())
    throw Failure("name a recording to be played, or record one first");
  if (recorder_.isOn() && file == own.record)
    throw Failure(file + " is being recorded: stop that first");
  Settings next = settingsToPlay(file, {}, false);
  next.output.play = file;
  next.output.record = own.record;
  next.output.playSpeed = own.playSpeed;
  next.output.file = own.file;
  next.output.session = own.session;
  next.picture.size = this->settings().picture.size;
  this->change(next);
  if (this->settings().data.files != next.data.files)
    return; // which was told
  picked_.clear();
  this->takePlayer(file, {});
  this->playWindow(player_->recording.window);
  this->nameWindow();
  this->startPlaying();
}

WindowState Window::state() const
{
  const int* size = window_->GetSize();
  return {{size[0], size[1]}, this->viewSize(), panelOn_, playing_};
}

/// Settings that are about to be followed, or of a camera that was moved.
void Window::note(Kind how, const Settings& next)
{
  if (recorder_.isOn())
    recorder_.note(beforeHold_ && how != Kind::Refused ? Kind::Drag : how, next);
}

/// An action that is about to be done.
void Window::note(RecordedEvent event)
{
  if (!recorder_.isOn())
    return;
  this->noteRest();
  recorder_.note(std::move(event));
}

/// How things look by now.
void Window::noteRest()
{
  if (!recorder_.isOn() || busy_ || beforeHold_ || this->isEmpty())
    return;
  recorder_.noteSeen(this->settings(), this->settingsInForce());
}

/// A place in pixels of the window as shares of the view.
std::array<double, 2> Window::shareOf(const std::array<int, 2>& place) const
{
  const std::array<int, 2> view = this->viewSize();
  const int left = window_->GetSize()[0] - view[0];
  return {(place[0] - left + 0.5) / std::max(1, view[0]), (place[1] + 0.5) / std::max(1, view[1])};
}

std::array<int, 2> Window::placeOf(const std::array<double, 2>& share) const
{
  const std::array<int, 2> view = this->viewSize();
  const int left = window_->GetSize()[0] - view[0];
  const auto pixel = [](double part, int size)
  { return static_cast<int>(std::floor(std::clamp(part, -10.0, 10.0) * size)); };
  return {left + pixel(share[0], view[0]), pixel(share[1], view[1])};
}

std::array<int, 2> Window::cursor() const
{
  const int* at = interactor_->GetEventPosition();
  return {at[0], at[1]};
}

//------------------------------------------------------------------------------------------------
// Playing

/// What is to be played, which the window's title tells from the first.
void Window::takePlayer(const std::string& file, const std::vector<std::string>& data)
{
  if (file.empty())
    return;
  player_ = std::make_unique<Player>();
  player_->recording = readRecording(file, data);
  player_->file = file;
  player_->speed = this->settings().output.playSpeed;
}

void Window::startPlaying()
{
  if (!player_)
    return;
  player_->start = std::chrono::steady_clock::now();
  this->startTimer(recordTimer_, player_->wait());
}

void Window::playNext()
{
  if (!player_)
    return;
  if (player_->isDone())
    return this->endPlaying();
  const RecordedEvent& event = player_->recording.events[player_->next++];
  try
  {
    this->playEvent(event);
  }
  catch (const Failure& failure)
  {
    this->say(failure.what());
  }
  if (quit_)
    return;
  this->render();
  if (player_) // else it was stopped meanwhile
    this->startTimer(recordTimer_, player_->wait());
}

/// While a recording is played keys wait: Escape stops it.
bool Window::takePlayersKey(Action action)
{
  if (!player_ || action == Action::Quit || action == Action::None)
    return false;
  if (action == Action::Escape)
    this->endPlaying();
  else
  {
    this->say("Playing " + player_->file + ": Escape stops it");
    this->render();
  }
  return true;
}

/// Tells that it is over; or where it was stopped.
void Window::endPlaying()
{
  const std::unique_ptr<Player> done = std::move(player_);
  playing_ = false;
  this->endHold();
  this->nameWindow();
  const auto counts = [](std::size_t n, const char* what)
  { return counted(static_cast<std::int64_t>(n), what); };
  if (done->strayed > 0)
    Messages::warn(done->file + ": " + counts(done->strayed, "step") +
                   " led elsewhere than when this was recorded; the data or this version of mote "
                   "are others");
  this->say(done->isDone() ? "Played " + done->file
                           : "Stopped after " + counts(done->next, "step") + " of " + done->file);
  this->render();
}

void Window::playEvent(const RecordedEvent& event)
{
  Settings next = this->settings();
  const bool isThere = event.changes.areIn(next);
  event.changes.apply(next);
  switch (event.kind)
  {
  case Kind::Change:
    this->recordCamera();
    if (event.changes.empty())
      return history_.add(this->settingsAsSeen());
    return this->change(next);
  case Kind::Drag:
    if (!beforeHold_)
      beforeHold_ = this->settingsAsSeen();
    this->follow(next);
    return this->renderMoving();
  case Kind::Release:
    return this->endHold();
  case Kind::Camera:
    setCamera(stage_.renderer()->GetActiveCamera(), next.camera.camera);
    stage_.renderer()->ResetCameraClippingRange();
    return this->recordCamera();
  case Kind::Did:
    player_->strayed += !isThere;
    [[fallthrough]];
  case Kind::Refused:
  case Kind::Pass:
    if (!isThere)
      this->follow(next);
    return;
  case Kind::Window:
    return this->playWindow(event.window);
  case Kind::Open:
    return this->open({event.files, event.adds});
  case Kind::Rectangle:
    return this->pickRectangle(
      this->placeOf(event.at), this->placeOf(event.to), event.isThrough, event.adds);
  case Kind::Action:
    return this->playAction(event);
  case Kind::Seen:
  case Kind::End:
    return;
  }
}

void Window::playAction(const RecordedEvent& event)
{
  const bool adds = event.action == Action::PickMore;
  if (adds || event.action == Action::Pick)
  {
    const std::array<int, 2> at = this->placeOf(event.at);
    interactor_->SetEventPosition(at[0], at[1]);
    return this->pick(adds);
  }
  Binding binding;
  binding.action = event.action;
  this->act(binding);
}

void Window::playWindow(const WindowState& state)
{
  const int* size = window_->GetSize();
  if (state.size[0] > 0 && (size[0] != state.size[0] || size[1] != state.size[1]))
    window_->SetSize(state.size[0], state.size[1]);
  panelOn_ = state.panel;
  playing_ = state.isPlaying;
}

} // namespace mote::app
