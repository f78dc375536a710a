#include "Session.h"

#include "Row.h"
#include "base/Failure.h"
#include "base/OutputFile.h"
#include "base/Text.h"

#include <kernels/core/AtomicFile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace mote::app
{

namespace
{

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr const char* versionName = "mote-session";
constexpr int version = 1;

/// A word of a row as JSON.
Json toJson(const Row& row, const std::string& word)
{
  double number = 0.0;
  if (row.numeric && parseNumber(word, number))
    // Whole numbers without a point, as far as doubles hold them exactly.
    return number == std::floor(number) && std::abs(number) < 9007199254740992.0
             ? Json(static_cast<std::int64_t>(number))
             : Json(number);
  return word;
}

Json toJson(const Row& row, const std::vector<std::string>& words)
{
  if (row.shape == Shape::Flag)
    return words.front() == "true";
  if (row.shape != Shape::Many)
    return words.empty() ? Json() : toJson(row, words.front());
  Json list = Json::array();
  for (const std::string& word : words)
    list.push_back(toJson(row, word));
  return list;
}

/// A value of JSON as a word. Throws WrongValue for what is none.
std::string wordOf(const Json& value)
{
  if (value.is_string())
    return value.get<std::string>();
  if (value.is_boolean())
    return value.get<bool>() ? "true" : "false";
  if (value.is_number())
    return value.is_number_float() ? exactText(value.get<double>()) : value.dump();
  throw WrongValue{
    std::string("must be a text, a number or true or false, not ") + value.type_name()};
}

std::vector<std::string> wordsOf(const Row& row, const Json& value)
{
  if (value.is_null() && !row.get(Settings{}).empty() && row.shape != Shape::Many)
    throw WrongValue{"must not be null"};
  if (value.is_null())
    return {};
  if (!value.is_array())
    return {wordOf(value)};
  if (row.shape != Shape::Many)
    throw WrongValue{"takes one value, not a list"};
  std::vector<std::string> words;
  for (const Json& one : value)
    words.push_back(wordOf(one));
  return words;
}

/// A data file as a session at `path` names it.
std::string storedName(const std::string& file, const std::string& path)
{
  std::error_code error;
  if (!fs::exists(file, error))
    return file; // of what is generated: pump:0.02
  const fs::path folder = fs::absolute(path, error).lexically_normal().parent_path();
  const fs::path whole = fs::absolute(file, error).lexically_normal();
  const fs::path relative = whole.lexically_relative(folder);
  return relative.empty() || *relative.begin() == ".." ? whole.string() : relative.string();
}

std::string foundName(const std::string& stored, const std::string& path)
{
  std::error_code error;
  const fs::path folder = fs::path(path).parent_path();
  const fs::path named = folder / stored; // `stored` alone where that is absolute
  if (fs::exists(named, error))
    return named.string();
  if (const fs::path beside = folder / fs::path(stored).filename(); fs::exists(beside, error))
    return beside.string();
  if (stored.find(':') != std::string::npos && stored.find('/') == std::string::npos)
    return stored;
  throw Failure(path + ": the data file " + stored +
                " is not there any more, and not beside the session either; put it there, or "
                "correct \"files\"");
}

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

/// The name of a group in a session: "Colour" is "colour".
std::string groupName(const Row& row)
{
  return lowerCase(row.group);
}

void setGroup(
  Settings& settings, const std::string& group, const Json& values, const std::string& path)
{
  const auto& table = settingsTable();
  if (std::none_of(
        table.begin(), table.end(), [&](const Row& row) { return groupName(row) == group; }))
    throw Failure(path + ": " + group + " is no group of settings that this version of mote knows");
  if (!values.is_object())
    throw Failure(
      path + ": " + group + ": must be an object with a name and value for each choice");
  for (const auto& [name, value] : values.items())
  {
    const Row* row = rowNamed(name);
    if (!row || groupName(*row) != group)
      throw Failure(path + ": " + group + "/" + name +
                    " is no setting that this version of mote "
                    "knows");
    try
    {
      row->set(settings, wordsOf(*row, value));
    }
    catch (const WrongValue& wrong)
    {
      throw Failure(path + ": " + group + "/" + name + ": " + wrong.sentence);
    }
  }
}

Json parsed(const std::string& text, const std::string& path)
{
  try
  {
    return Json::parse(text);
  }
  catch (const Json::exception& error)
  {
    // "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error ..."
    std::string what = error.what();
    if (const std::size_t end = what.find("] "); end != std::string::npos)
      what = what.substr(end + 2);
    throw Failure(path + " is no session: " + what);
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
  for (const Row& row : settingsTable())
    json[groupName(row)][row.name] = toJson(row, row.get(settings));
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
    else if (name != versionName)
      setGroup(settings, name, value, path);
  if (settings.data.files.empty())
    throw Failure(path + " names no data: \"files\" is missing or empty");
  return settings;
}

Settings readSession(const std::string& path)
{
  std::error_code error;
  if (!fs::exists(path, error))
    throw Failure(path + ": there is no such file");
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
  const std::string text = sessionText(settings, path);
  try
  {
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
  }
  catch (const WriteError& error)
  {
    throw Failure(error.what());
  }
}

} // namespace mote::app
