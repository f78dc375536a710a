#include "Session.h"

#include "RowJson.h"
#include "base/Failure.h"
#include "base/OutputFile.h"
#include "base/Text.h"
#include "kernels/core/JsonDepth.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace mote::app
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* versionName = "mote-session";
constexpr int version = 1;

std::vector<std::string> filesOf(const Json& value, const std::string& path)
{
  if (!value.is_array())
    throw Failure(path + ": files: must be a list of file names");
  std::vector<std::string> files;
  for (const Json& one : value)
  {
    if (!one.is_string() || one.get<std::string>().empty())
      throw Failure(path + ": files: must be a list of file names, and " + one.dump() + " is none");
    files.push_back(foundName(one.get<std::string>(), path));
  }
  return files;
}

Json parsed(const std::string& text, const std::string& path)
{
  if (isDeepJson(text))
    throw Failure(path + " is no session: its lists lie in one another too deeply");
  try
  {
    return Json::parse(text);
  }
  catch (const Json::exception& error)
  {
    throw Failure(path + " is no session: " + sentenceOf(error));
  }
}

void requireVersion(const Json& json, const std::string& path)
{
  const auto found = json.is_object() ? json.find(versionName) : json.end();
  if (!json.is_object() || found == json.end() || !found->is_number_integer())
    throw Failure(path + " is no session: it has no number \"" + versionName + "\"");
  if (const auto number = found->get<std::int64_t>(); number != version)
    throw Failure(path + " is a session of version " + std::to_string(number) +
                  ", and this mote reads version " + std::to_string(version));
}

/// What a session keeps: the settings, and how large the window saves pictures.
const std::vector<Row>& sessionTable()
{
  static const std::vector<Row> table = []
  {
    std::vector<Row> rows = settingsTable();
    rows.push_back(*commandRow("mote", "picture-size"));
    return rows;
  }();
  return table;
}

constexpr const char* keyFramesName = "key-frames";

/// The views of a film, each as what it has otherwise than the session.
Json jsonOfKeyFrames(const Settings& settings, const std::string& path)
{
  Json list = Json::array();
  for (const Settings& key : settings.keyFrames)
  {
    Json json = Json::object();
    for (const Row& row : settingsTable())
      if (const auto words = row.get(key); words != row.get(settings))
        json[groupName(row)][row.name] = jsonOf(row, words, path);
    list.push_back(json);
  }
  return list;
}

std::vector<Settings> keyFramesOf(
  const Json& list, const Settings& settings, const std::string& path)
{
  if (!list.is_array())
    throw Failure(path + ": " + keyFramesName + ": must be a list of views");
  std::vector<Settings> all;
  for (const Json& json : list)
  {
    all.push_back(settings);
    if (!json.is_object())
      throw Failure(path + ": " + keyFramesName + ": " + json.dump() + " is no view");
    for (const auto& [name, value] : json.items())
      for (const auto& [row, words] : groupOf(name, value, settingsTable(), path, path))
        row->set(all.back(), words);
  }
  return all;
}

} // namespace

bool isSessionFile(const std::string& path)
{
  return lowerCase(fs::path(path).extension().string()) == ".json";
}

std::string sessionText(const Settings& settings, const std::string& path)
{
  Json json;
  json[versionName] = version;
  json["files"] = Json::array();
  for (const std::string& file : settings.data.files)
    json["files"].push_back(storedName(file, path));
  for (const Row& row : sessionTable())
    if (row.command.empty() || settings.output.size[0] > 0)
      json[groupName(row)][row.name] = jsonOf(row, row.get(settings), path);
  if (!settings.keyFrames.empty())
    json[keyFramesName] = jsonOfKeyFrames(settings, path);
  // File names need not be UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Settings parseSession(const std::string& text, const std::string& path)
{
  const Json json = parsed(text, path);
  requireVersion(json, path);
  Settings settings;
  for (const auto& [name, value] : json.items())
    if (name == "files")
      settings.data.files = filesOf(value, path);
    else if (name != versionName && name != keyFramesName)
      for (const auto& [row, words] : groupOf(name, value, sessionTable(), path, path))
        row->set(settings, words);
  if (settings.data.files.empty())
    throw Failure(path + " names no data: \"files\" is missing or empty");
  if (const auto found = json.find(keyFramesName); found != json.end())
    settings.keyFrames = keyFramesOf(*found, settings, path);
  return settings;
}

Settings readSession(const std::string& path)
{
  std::error_code error;
  if (!fs::exists(path, error))
    throw Failure(path + ": there is no such file");
  if (!fs::is_regular_file(path, error))
    throw Failure(path + ": this is not a regular file");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file && file.peek() == std::ifstream::traits_type::eof())
    throw Failure(path + ": the file is empty");
  if (!file || !(text << file.rdbuf()))
    throw Failure(path + " cannot be read");
  return parseSession(text.str(), path);
}

void checkSessionOutput(const Settings& settings)
{
  const std::string& file = settings.output.session;
  if (file.empty())
    return;
  if (!isSessionFile(file))
    throw Failure("--save-session: a session's name must end in .json, unlike " + file);
  checkOutput(file, settings.data.files);
}

void writeSession(const Settings& settings, const std::string& path)
{
  writeText(path, sessionText(settings, path));
}

} // namespace mote::app
