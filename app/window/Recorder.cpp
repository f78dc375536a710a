#include "Recorder.h"

#include "base/Text.h"

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

using Kind = RecordedEvent::Kind;

double secondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

void Recorder::start(const std::string& file, const Settings& settings, const WindowState& window)
{
  file_ = std::make_unique<RecordingFile>(file, settings, window);
  start_ = std::chrono::steady_clock::now();
  settings_ = settings;
  window_ = window;
}

void Recorder::stop()
{
  this->note({.kind = Kind::End});
  file_ = nullptr;
  seen_ = {};
}

void Recorder::note(Kind how, const Settings& next)
{
  if (!file_)
    return;
  RecordedEvent event;
  const bool isOwn = how != Kind::Change && how != Kind::Camera;
  event.kind = doing_ > 0 && !isOwn ? Kind::Did : how;
  event.changes = changesBetween(settings_, next);
  // What is not recorded, such as the name of a film, is a step of the history, too.
  if (event.changes.empty() && event.kind != Kind::Change)
    return;
  settings_ = next;
  forgetSeen(seen_, event.changes);
  this->note(std::move(event));
}

void Recorder::note(const WindowState& window)
{
  if (!file_ || window == window_)
    return;
  window_ = window;
  RecordedEvent event;
  event.kind = Kind::Window;
  event.window = window;
  this->note(std::move(event));
}

void Recorder::noteSeen(const Settings& settings, const Settings& inForce)
{
  if (!file_)
    return;
  RecordedEvent event;
  event.kind = Kind::Seen;
  event.changes = changesBetween(settings, inForce);
  if (event.changes == seen_)
    return;
  seen_ = event.changes;
  this->note(std::move(event));
}

void Recorder::note(RecordedEvent event)
{
  if (!file_)
    return;
  event.time = secondsSince(start_);
  file_->add(event);
}

std::string Player::progress() const
{
  return withThousands(static_cast<std::int64_t>(next)) + " of " +
         counted(static_cast<std::int64_t>(recording.events.size()), "step");
}

unsigned long Player::wait() const
{
  constexpr double least = 1.0; // ms: what the user does comes in between
  if (this->isDone() || speed <= 0.0)
    return static_cast<unsigned long>(least);
  const double due = 1000.0 * (recording.events[next].time / speed - secondsSince(start));
  constexpr double most = 1e9;
  return static_cast<unsigned long>(std::clamp(std::round(due), least, most));
}

} // namespace mote::app
