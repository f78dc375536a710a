#include "Recording.h"

#include "RowJson.h"
#include "Session.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/OutputFile.h"
#include "kernels/core/JsonDepth.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

namespace mote::app
{

namespace
{

using Kind = RecordedEvent::Kind;

constexpr const char* versionName = "mote-recording";
constexpr int version = 1;

struct NamedKind
{
  Kind kind;
  const char* name;
};
constexpr NamedKind kinds[] = {{Kind::Change, "change"}, {Kind::Drag, "drag"},
  {Kind::Release, "release"}, {Kind::Camera, "camera"}, {Kind::Pass, "pass"}, {Kind::Did, "did"},
  {Kind::Refused, "refused"}, {Kind::Seen, "seen"}, {Kind::Action, "action"},
  {Kind::Rectangle, "rectangle"}, {Kind::Open, "open"}, {Kind::Window, "window"},
  {Kind::End, "end"}};

struct NamedAction
{
  Action action;
  const char* name;
};
constexpr NamedAction actions[] = {{Action::Help, "help"}, {Action::Play, "play"},
  {Action::Pick, "pick"}, {Action::PickMore, "pick-more"}, {Action::HidePicked, "hide-picked"},
  {Action::OnlyPicked, "only-picked"}, {Action::ShowHidden, "show-hidden"},
  {Action::CopyPicked, "copy-picked"}, {Action::SavePicked, "save-picked"},
  {Action::SavePickedJson, "save-picked-json"}, {Action::SavePickedData, "save-picked-data"},
  {Action::PathsOfPicked, "paths-of-picked"}, {Action::PlotOverTime, "plot-over-time"},
  {Action::SaveOverTime, "save-over-time"}, {Action::SavePlot, "save-plot"},
  {Action::SavePlotSvg, "save-plot-svg"}, {Action::SaveCounts, "save-counts"},
  {Action::SavePicture, "save-picture"}, {Action::SaveFilm, "save-film"},
  {Action::SaveShown, "save-shown"}, {Action::AddKeyFrame, "add-key-frame"},
  {Action::ForgetKeyFrame, "forget-key-frame"}, {Action::ForgetKeyFrames, "forget-key-frames"},
  {Action::SaveSession, "save-session"}, {Action::PrintCommand, "print-command"},
  {Action::PrintScript, "print-script"}, {Action::Undo, "undo"}, {Action::Redo, "redo"},
  {Action::Escape, "escape"}};

bool isPick(Action action)
{
  return action == Action::Pick || action == Action::PickMore;
}

/// What recordings have: not the files that this run writes.
const std::vector<Row>& recordedRows()
{
  static const std::vector<Row> table = []
  {
    std::vector<Row> rows = settingsTable();
    for (const Row& row : commandTable())
      if ((row.command == "mote" || row.command == "animate") && row.name != "output" &&
          row.name != "save-session" && row.name != "key-frames" && row.group != "Recording")
        rows.push_back(row);
    return rows;
  }();
  return table;
}

Json jsonOf(const std::vector<std::string>& files, const std::string& path)
{
  Json list = Json::array();
  for (const std::string& file : files)
    list.push_back(storedName(file, path));
  return list;
}

Json jsonOf(const SettingChanges& changes, const std::string& path)
{
  Json json = Json::object();
  if (changes.files)
    json["files"] = jsonOf(*changes.files, path);
  for (const auto& [row, words] : changes.rows)
    json[groupName(*row)][row->name] = jsonOf(*row, words, path);
  return json;
}

Json jsonOf(const WindowState& window)
{
  return {{"size", window.size}, {"view", window.view}, {"panel", window.panel},
    {"playing", window.isPlaying}};
}

/// One line; names of files need not be UTF-8.
std::string textOf(const Json& json)
{
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

//------------------------------------------------------------------------------------------------
// Reading

/// The names, where they lie now if that can be told.
std::vector<std::string> filesOf(const Json& list, const std::string& path)
{
  std::vector<std::string> files;
  for (const Json& one : list)
    try
    {
      files.push_back(foundName(one.get<std::string>(), path));
    }
    catch (const Failure&)
    {
      files.push_back(one.get<std::string>()); // whoever opens it says so
    }
  return files;
}

SettingChanges changesOf(const Json& json, const std::string& path, const std::string& place)
{
  SettingChanges changes;
  for (const auto& [name, value] : json.items())
    if (name == "files")
      changes.files = filesOf(value, path);
    else
      for (auto& one : groupOf(name, value, recordedRows(), path, place))
        changes.rows.push_back(std::move(one));
  return changes;
}

WindowState windowOf(const Json& json)
{
  WindowState window;
  window.size = json.at("size").get<std::array<int, 2>>();
  window.view = json.at("view").get<std::array<int, 2>>();
  window.panel = json.at("panel").get<bool>();
  window.isPlaying = json.at("playing").get<bool>();
  constexpr int most = 32768;
  for (const auto& size : {window.size, window.view})
    if (size[0] < 0 || size[1] < 0 || size[0] > most || size[1] > most)
      throw Failure("a recording's window cannot be so large: " + json.dump());
  return window;
}

/// The text as JSON; none where it is cut off.
Json parsedLine(const std::string& line)
{
  return isDeepJson(line) ? Json(Json::value_t::discarded) : Json::parse(line, nullptr, false);
}

/// The first line. Its data files are only looked for where none are given.
void readHeader(Recording& recording, const std::string& line, const std::string& path,
  const std::vector<std::string>& files)
{
  const Json json = parsedLine(line);
  const auto found = json.is_object() ? json.find(versionName) : json.end();
  if (!json.is_object() || found == json.end() || !found->is_number_integer())
    throw Failure(path + " is no recording of mote's window: its first line has no number \"" +
                  versionName + "\"");
  if (const auto number = found->get<std::int64_t>(); number != version)
    throw Failure(path + " is a recording of version " + std::to_string(number) +
                  ", and this mote reads version " + std::to_string(version));
  try
  {
    Json settings = json.at("settings");
    std::vector<std::string> named = files;
    if (named.empty())
      for (const Json& one : settings.at("files"))
        named.push_back(foundName(one.get<std::string>(), path));
    settings.erase("files");
    changesOf(settings, path, path + ", line 1").apply(recording.start);
    recording.start.data.files = named;
    if (const auto keys = json.find("key-frames"); keys != json.end())
      for (const Json& key : *keys)
      {
        Settings view = recording.start;
        view.keyFrames.clear();
        changesOf(key, path, path + ", line 1").apply(view);
        recording.start.keyFrames.push_back(view);
      }
    recording.window = windowOf(json.at("window"));
  }
  catch (const Json::exception& error)
  {
    throw Failure(path + ", line 1 makes no sense: " + sentenceOf(error));
  }
}

} // namespace

//------------------------------------------------------------------------------------------------
// Settings that differ

void SettingChanges::apply(Settings& settings) const
{
  if (files)
    settings.data.files = *files;
  for (const auto& [row, words] : rows)
    row->set(settings, words);
}

bool SettingChanges::areIn(const Settings& settings) const
{
  Settings wanted = settings;
  this->apply(wanted);
  return wanted == settings;
}

SettingChanges changesBetween(const Settings& before, const Settings& after)
{
  SettingChanges changes;
  if (before.data.files != after.data.files)
    changes.files = after.data.files;
  for (const Row& row : recordedRows())
    if (std::vector<std::string> words = row.get(after); words != row.get(before))
      changes.rows.emplace_back(&row, std::move(words));
  return changes;
}

void forgetSeen(SettingChanges& seen, const SettingChanges& changes)
{
  if (changes.files)
    seen = {};
  std::erase_if(seen.rows,
    [&](const auto& one)
    {
      return std::any_of(changes.rows.begin(), changes.rows.end(),
        [&](const auto& other) { return other.first->group == one.first->group; });
    });
}

bool isRecorded(Action action)
{
  return !isPick(action) && std::any_of(std::begin(actions), std::end(actions),
                              [&](const NamedAction& one) { return one.action == action; });
}

//------------------------------------------------------------------------------------------------
// Lines

std::string lineOf(const RecordedEvent& event, const std::string& path)
{
  Json json;
  json["time"] = std::round(1000.0 * event.time) / 1000.0;
  for (const NamedKind& one : kinds)
    if (one.kind == event.kind)
      json["what"] = one.name;
  switch (event.kind)
  {
  case Kind::Action:
    for (const NamedAction& one : actions)
      if (one.action == event.action)
        json["action"] = one.name;
    if (isPick(event.action))
      json["at"] = event.at;
    break;
  case Kind::Rectangle:
    json["from"] = event.at;
    json["to"] = event.to;
    json["through"] = event.isThrough;
    json["adds"] = event.adds;
    break;
  case Kind::Open:
    json["files"] = jsonOf(event.files, path);
    json["adds"] = event.adds;
    break;
  case Kind::Window:
    json["window"] = jsonOf(event.window);
    break;
  case Kind::Release:
  case Kind::End:
    break;
  default:
    json["settings"] = jsonOf(event.changes, path);
  }
  return textOf(json);
}

namespace
{

/// What the kind of line has besides.
void readContents(
  RecordedEvent& event, const Json& json, const std::string& path, const std::string& place)
{
  switch (event.kind)
  {
  case Kind::Action:
  {
    const std::string name = json.at("action").get<std::string>();
    const auto found = std::find_if(std::begin(actions), std::end(actions),
      [&](const NamedAction& one) { return one.name == name; });
    if (found == std::end(actions))
      throw Failure(place + ": " + name + " is no action that this version of mote knows");
    event.action = found->action;
    if (isPick(event.action))
      event.at = json.at("at").get<std::array<double, 2>>();
    break;
  }
  case Kind::Rectangle:
    event.at = json.at("from").get<std::array<double, 2>>();
    event.to = json.at("to").get<std::array<double, 2>>();
    event.isThrough = json.at("through").get<bool>();
    event.adds = json.at("adds").get<bool>();
    break;
  case Kind::Open:
    event.files = filesOf(json.at("files"), path);
    event.adds = json.at("adds").get<bool>();
    break;
  case Kind::Window:
    event.window = windowOf(json.at("window"));
    break;
  case Kind::Release:
  case Kind::End:
    break;
  default:
    event.changes = changesOf(json.at("settings"), path, place);
  }
}

} // namespace

RecordedEvent eventOf(const std::string& line, const std::string& path, const std::string& place)
{
  RecordedEvent event;
  try
  {
    if (isDeepJson(line))
      throw Failure(place + ": its lists lie in one another too deeply");
    const Json json = Json::parse(line);
    event.time = json.at("time").get<double>();
    const std::string what = json.at("what").get<std::string>();
    const auto found = std::find_if(
      std::begin(kinds), std::end(kinds), [&](const NamedKind& one) { return one.name == what; });
    if (found == std::end(kinds))
      throw Failure(place + ": " + what + " is nothing that this version of mote can do");
    event.kind = found->kind;
    readContents(event, json, path, place);
  }
  catch (const Json::exception& error)
  {
    throw Failure(place + " makes no sense: " + sentenceOf(error));
  }
  return event;
}

//------------------------------------------------------------------------------------------------
// Files

Settings Recording::last() const
{
  Settings settings = start;
  SettingChanges seen;
  settings.picture.size = window.view;
  for (const RecordedEvent& event : events)
    switch (event.kind)
    {
    case Kind::Seen:
      seen = event.changes;
      break;
    case Kind::Window:
      settings.picture.size = event.window.view;
      break;
    default:
      forgetSeen(seen, event.changes);
      event.changes.apply(settings);
    }
  const std::array<int, 2> view = settings.picture.size;
  seen.apply(settings);
  settings.picture.size = view;
  return settings;
}

Recording readRecording(const std::string& path, const std::vector<std::string>& files)
{
  if (std::error_code error; !std::filesystem::exists(path, error))
    throw Failure(path + ": there is no such file");
  else if (!std::filesystem::is_regular_file(path, error))
    throw Failure(path + ": this is not a regular file");
  std::ifstream file(path, std::ios::binary);
  std::string line;
  if (!std::getline(file, line))
    throw Failure(path + (file.eof() ? ": the file is empty" : " cannot be read"));
  Recording recording;
  readHeader(recording, line, path, files);
  for (int number = 2; std::getline(file, line); ++number)
  {
    // The last line of a file that was cut off may end anywhere.
    if (file.eof() && parsedLine(line).is_discarded())
      break;
    recording.events.push_back(eventOf(line, path, path + ", line " + std::to_string(number)));
  }
  recording.hasEnd = !recording.events.empty() && recording.events.back().kind == Kind::End;
  return recording;
}

Settings settingsToPlay(
  const std::string& path, const std::vector<std::string>& files, bool isAtEnd)
{
  const Recording recording = readRecording(path, files);
  if (!recording.hasEnd)
    Messages::warn(path + " was cut off, or mote did not end by itself: played is what is there");
  if (isAtEnd)
  {
    Settings last = recording.last();
    if (!files.empty())
      last.data.files = files;
    if (last.data.files.empty())
      throw Failure(path + ": nothing is open at the end of this recording");
    return last;
  }
  Settings start = recording.start;
  start.picture.size = recording.window.size;
  start.output.panel = recording.window.panel;
  return start;
}

RecordingFile::RecordingFile(
  const std::string& path, const Settings& start, const WindowState& window)
  : path_(path)
  , file_(path, std::ios::binary | std::ios::trunc)
{
  if (!file_)
    throw Failure(path + " cannot be written");
  Json json;
  json[versionName] = version;
  json["mote"] = MOTE_VERSION;
  json["window"] = jsonOf(window);
  SettingChanges all;
  all.files = start.data.files;
  // All that sessions keep; of the rest what was chosen.
  for (const Row& row : recordedRows())
    if (row.command.empty() || !row.isDefault(start))
      all.rows.emplace_back(&row, row.get(start));
  json["settings"] = jsonOf(all, path);
  for (const Settings& key : start.keyFrames)
    json["key-frames"].push_back(jsonOf(changesBetween(start, key), path));
  this->write(textOf(json));
}

void RecordingFile::add(const RecordedEvent& event)
{
  this->write(lineOf(event, path_));
}

void RecordingFile::write(const std::string& line)
{
  if (failed_)
    return;
  file_ << line << '\n' << std::flush;
  if (!file_)
  {
    failed_ = true;
    Messages::warn(path_ + " can be written no more: what follows is not recorded");
  }
}

void checkRecordingOutput(const Settings& settings)
{
  const std::string& file = settings.output.record;
  if (file.empty())
    return;
  std::vector<std::string> read = settings.data.files;
  if (!settings.output.play.empty())
    read.push_back(settings.output.play);
  checkOutput(file, read);
  if (isSessionFile(file))
    throw Failure(
      "--record: a recording is no session: its name must not end in .json, unlike " + file);
}

} // namespace mote::app
