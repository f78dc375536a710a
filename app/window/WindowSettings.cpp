// How the window's settings change: by keys, by undoing, by moving the camera.

#include "Window.h"

#include "base/Failure.h"
#include "base/Text.h"
#include "settings/Colors.h"
#include "stage/Advice.h"
#include "stage/Silhouettes.h"
#include "table/Row.h"
#include "table/Session.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <algorithm>

namespace mote::app
{

Settings Window::settingsOf(const std::function<void(Settings&)>& change) const
{
  Settings next = this->settings();
  change(next);
  return next;
}

Settings Window::withStep(int step) const
{
  return this->settingsOf(
    [&](Settings& s)
    {
      s.data.time.reset();
      s.data.step = std::to_string(step + 1);
    });
}

void Window::change(const Settings& next, const std::function<std::string()>& message)
{
  const Settings before = this->settings();
  if (next != before)
  {
    const Settings seen = this->settingsAsSeen();
    if (!this->follow(next, RecordedEvent::Kind::Change))
      return;
    history_.add(seen);
  }
  std::string text = message ? message() : "";
  // What does nothing is told when it is chosen.
  const auto known = adviceBefore_;
  adviceBefore_ = adviceOn(stage_);
  if (const std::string nothing = whatLeavesNothing(stage_); !nothing.empty())
    adviceBefore_.push_back(nothing);
  for (const std::string& sentence : adviceBefore_)
    if (std::find(known.begin(), known.end(), sentence) == known.end())
      text += (text.empty() ? "" : ". ") + sentence;
  if (!text.empty())
    this->say(text);
}

/// Shows what other settings ask for; where that fails, what was there before. False then.
bool Window::follow(const Settings& next, RecordedEvent::Kind how)
{
  const Settings before = this->settings();
  this->hoverAgain();
  this->note(how, next);
  const auto show = [&](const Settings& wanted)
  {
    const DataSettings present = this->settings().data;
    if (input_.files() != wanted.data.files)
      return this->readFiles(wanted);
    const bool rebuild = stage_.apply(wanted);
    if (present != wanted.data)
      this->load(input_.chosenStep(wanted));
    else if (rebuild)
    {
      stage_.build(progress_);
      stage_.applyColors();
    }
  };
  const bool done = this->perform(
    [&]
    {
      try
      {
        show(next);
      }
      catch (...)
      {
        // Whoever interrupted the new wants the old back, unless it was to leave.
        if (!bar_.wantsQuit())
        {
          bar_.reset();
          show(before);
        }
        throw;
      }
    });
  if (!done)
    this->note(RecordedEvent::Kind::Refused, this->settings());
  const bool isOther = before.data.files != next.data.files;
  // Images, copies and what is rolled out would come up outside of a view that nobody chose.
  const bool isWider = before.particles.replicate != next.particles.replicate ||
                       before.volume.repeatAround != next.volume.repeatAround ||
                       before.volume.unroll != next.volume.unroll;
  if (done && (isOther || before.camera != next.camera || (isWider && next.camera.camera.empty())))
    this->look();
  overlay_.followBackground();
  const std::size_t viewsBefore = views_.shown().size();
  this->followProps();
  if (viewsBefore != views_.shown().size() && next.camera.camera.empty() && done)
    this->look();
  this->planCache();
  picked_.keepWhatIs(stage_.parts());
  views_.forgetMarks();
  this->startFollowing();
  this->followPaths();
  this->updateScale();
  return done;
}

/// The settings for the history. A camera that chose itself is said outright where it would choose
/// another place by now, such as at another time step.
Settings Window::settingsAsSeen() const
{
  Settings seen = this->settings();
  if (seen.camera.camera.empty() && seen != lookedAt_)
    seen.camera.camera = camera_;
  return seen;
}

void Window::recordCamera()
{
  if (this->viewNow() == view_)
    return;
  history_.add(this->settingsAsSeen());
  Settings now = this->settings();
  now.camera.camera = cameraOf(stage_.renderer()->GetActiveCamera());
  stage_.apply(now);
  this->rememberView();
  this->note(RecordedEvent::Kind::Camera, now);
}

namespace
{

/// The options in which two settings differ: ": where, show"; nothing where there are too many, or
/// the files are others.
std::string differenceOf(const Settings& a, const Settings& b)
{
  constexpr std::size_t most = 3;
  std::vector<std::string> names;
  for (const Row& row : settingsTable())
    if (row.get(a) != row.get(b))
      names.push_back(row.name);
  if (a.keyFrames != b.keyFrames)
    names.emplace_back("key frames");
  // The same camera may be said outright on one side, and be chosen on the other.
  if (names.size() > 1)
    std::erase(names, "camera");
  return names.empty() || names.size() > most || a.data.files != b.data.files
           ? ""
           : ": " + joined(names, ", ");
}

} // namespace

void Window::goBack(bool undo)
{
  panel_.forgetRefused();
  const Settings seen = this->settingsAsSeen();
  const auto next = undo ? history_.undo(seen) : history_.redo(seen);
  const std::string what = next ? differenceOf(seen, *next) : "";
  if (!next)
    this->say(undo ? "There is nothing to undo" : "There is nothing to redo");
  else if (this->follow(*next, RecordedEvent::Kind::Did))
    this->say((undo ? "Undone" : "Redone") + what);
}

Settings Window::settingsInForce()
{
  Settings all = stage_.settingsInForce();
  all.marks.picked = picked_.words(stage_.parts());
  all.picture.size = this->viewSize();
  all.data.time.reset();
  all.data.step = input_.numberOfSteps() > 1 ? std::to_string(step_ + 1) : "last";
  return all;
}

/// What makes the picture that the window saves.
Settings Window::pictureInForce()
{
  Settings all = this->settingsInForce();
  all.picture.size = this->savedSize();
  all.silhouettes = scaled(all.silhouettes, this->savedScale());
  return all;
}

void Window::saveSession(const std::string& file)
{
  writeSession(this->settingsInForce(), file);
  kept_.keep(this->settings());
  this->say("Saved " + file);
}

/// Quits; where changes of a session would be lost only when asked once more.
void Window::leave()
{
  if (askedToLeave_ == this->settings() || !asked_.output.session.empty() ||
      !kept_.lacks(this->settings()))
    return this->quit();
  this->say("Changes are not saved in a session: press q again to close without them, or Ctrl+S "
            "to save them");
  askedToLeave_ = this->settings();
  this->render();
}

} // namespace mote::app
