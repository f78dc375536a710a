#pragma once

#include "Keys.h"
#include "Row.h"

#include <array>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

// What a user did in the window, as a file: see docs/guide/sessions.md, "Recordings".

namespace mote::app
{

/// Settings that differ from others.
struct SettingChanges
{
  std::optional<std::vector<std::string>> files;
  NamedValues rows;

  bool empty() const { return !files && rows.empty(); }
  void apply(Settings& settings) const;
  /// Whether the settings have these values.
  bool areIn(const Settings& settings) const;
  bool operator==(const SettingChanges&) const = default;
};

/// Of what sessions keep, and of the window's and its films' own settings but for files that are
/// written.
SettingChanges changesBetween(const Settings& before, const Settings& after);

/// Takes from what was seen with some settings that which need not hold with others: the groups of
/// those that changed.
void forgetSeen(SettingChanges& seen, const SettingChanges& changes);

/// What is no setting, and tells how the window looks.
struct WindowState
{
  std::array<int, 2> size{}; ///< pixels, of the whole window
  std::array<int, 2> view{}; ///< without the panel
  bool panel = true;
  bool isPlaying = false; ///< the time steps
  bool operator==(const WindowState&) const = default;
};

/// A line of a recording.
struct RecordedEvent
{
  enum class Kind
  {
    Change,    ///< settings, as one step of the history
    Drag,      ///< settings while a control is held
    Release,   ///< the control is let go of: what was dragged is one step of the history
    Camera,    ///< was moved by the mouse or the keys; one step of the history
    Pass,      ///< settings that pass without the user, such as steps that play
    Did,       ///< settings that the action before led to
    Refused,   ///< settings after some could not be followed
    Seen,      ///< what the window chose of itself, where it differs from the settings
    Action,    ///< what keys and buttons do besides settings
    Rectangle, ///< picks what is in it
    Open,      ///< files
    Window,    ///< its size and the like
    End
  };
  Kind kind = Kind::End;
  double time = 0.0; ///< s, from the recording's start
  SettingChanges changes = {};
  Action action = Action::None;
  /// Shares of the view's width and height from its lower left: of a pick or from where a rectangle
  /// is drawn, and its other corner.
  std::array<double, 2> at = {}, to = {};
  bool isThrough = false;
  bool adds = false; ///< to what is picked, or to the files that are open
  std::vector<std::string> files = {};
  WindowState window = {};
  bool operator==(const RecordedEvent&) const = default;
};

/// Whether a recording has the action as one; the others are told by what they change.
bool isRecorded(Action action);

struct Recording
{
  Settings start;
  WindowState window;
  std::vector<RecordedEvent> events;
  bool hasEnd = false; ///< else it was cut off, or mote ended early

  /// The settings in force at the end, with the size of the view as the picture's.
  Settings last() const;
};

/// Reads a recording, as far as it goes. Files that are given take the place of those that it
/// starts with. Throws Failure for what is none, for another version, for a line that makes no
/// sense, and for data files that are not there any more.
Recording readRecording(const std::string& path, const std::vector<std::string>& files = {});

/// The settings that `mote --play FILE` starts with, or at the end those of `mote render --play`.
/// Warns where the recording has no end. Throws as readRecording(), and where nothing is open at
/// the end.
Settings settingsToPlay(
  const std::string& path, const std::vector<std::string>& files, bool isAtEnd);

/// A line, and the other way; files are named from where `path` lies. Throws Failure that begins
/// with `place`.
std::string lineOf(const RecordedEvent& event, const std::string& path);
RecordedEvent eventOf(const std::string& line, const std::string& path, const std::string& place);

/// A recording that is being written, a line at a time, so that a crash loses nothing.
class RecordingFile
{
public:
  /// Throws Failure where it cannot be written.
  RecordingFile(const std::string& path, const Settings& start, const WindowState& window);

  /// Warns, once, where it can be written no more.
  void add(const RecordedEvent& event);

private:
  void write(const std::string& line);

  std::string path_;
  std::ofstream file_;
  bool failed_ = false;
};

/// Throws Failure where the recording that the settings ask for cannot be written, or would take
/// the place of what is read.
void checkRecordingOutput(const Settings& settings);

} // namespace mote::app
