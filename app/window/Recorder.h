#pragma once

#include "table/Recording.h"

#include <chrono>
#include <memory>
#include <string>

namespace mote::app
{

/// Writes what is done in a window into a recording; does nothing until it is started.
class Recorder
{
public:
  /// Throws Failure where the file cannot be written.
  void start(const std::string& file, const Settings& settings, const WindowState& window);
  bool isOn() const { return file_ != nullptr; }
  /// Writes the end. What follows is not recorded.
  void stop();

  /// That these settings are to be followed, before they are: where that crashes the recording
  /// tells of it.
  void note(RecordedEvent::Kind how, const Settings& next);
  /// What the window looks like, where that has changed.
  void note(const WindowState& window);
  /// What the window has chosen of itself for these settings, where that has changed.
  void noteSeen(const Settings& settings, const Settings& inForce);
  void note(RecordedEvent event);

  /// While it lives, settings that change are what an action led to.
  class Doing
  {
  public:
    explicit Doing(Recorder& recorder)
      : recorder_(recorder)
    {
      ++recorder_.doing_;
    }
    ~Doing() { --recorder_.doing_; }
    Doing(const Doing&) = delete;
    Doing& operator=(const Doing&) = delete;

  private:
    Recorder& recorder_;
  };

private:
  std::unique_ptr<RecordingFile> file_;
  std::chrono::steady_clock::time_point start_;
  Settings settings_; ///< as the file has them by now
  WindowState window_;
  SettingChanges seen_; ///< as far as the file says
  int doing_ = 0;
};

/// Does again what a recording has, event after event, at its times or faster.
struct Player
{
  Recording recording;
  std::string file;
  std::size_t next = 0;    ///< of the events
  std::size_t strayed = 0; ///< that led elsewhere than when they were recorded
  double speed = 1.0;      ///< factor; 0: as fast as it goes
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

  bool isDone() const { return next >= recording.events.size(); }
  /// "3 of 80 steps".
  std::string progress() const;
  /// Until the next event is due: ms.
  unsigned long wait() const;
};

} // namespace mote::app
