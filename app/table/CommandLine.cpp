#include "CommandLine.h"

#include "Row.h"
#include "Session.h"
#include "base/Checks.h"
#include "base/Failure.h"
#include "base/Text.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace mote::app
{

namespace
{

/// The sentence of help, with the words and numbers that are possible and the default.
std::string helpOf(const Row& row, const Settings& settings)
{
  std::string text = row.help;
  const auto add = [&text](const std::string& more) { text += ". " + more; };
  if (!row.words.empty())
  {
    std::vector<std::string> shown;
    std::copy_if(row.words.begin(), row.words.end(), std::back_inserter(shown),
      [](const std::string& word) { return !word.empty(); });
    add("One of " + joined(shown, ", "));
  }
  if (const std::string limits = row.limits.text(); !limits.empty())
    add(std::string(1, static_cast<char>(std::toupper(limits.front()))) + limits.substr(1));
  if (row.shape == Shape::Flag)
    return text;
  const std::string usual =
    !row.usual.empty() ? row.usual : joined(row.get(settings), row.commas ? "," : " ");
  if (!usual.empty())
    add("Default: " + usual);
  return text;
}

/// Sets a row from the words of the command line.
void setFromWords(const Row& row, GivenSettings& given, const std::vector<std::string>& words)
{
  try
  {
    row.set(given.settings, words);
    given.named.emplace_back(row.name, words);
  }
  catch (const WrongValue& wrong)
  {
    throw CLI::ValidationError("--" + row.name, wrong.sentence);
  }
}

CLI::Option* addRow(CLI::App& app, GivenSettings& given, const Row& row, const std::string& prefix)
{
  std::string names = row.option() + (row.alias.empty() ? "" : "," + row.alias);
  if (const std::size_t at = names.find(prefix); at != std::string::npos)
    names.erase(at, prefix.size());
  if (row.shape == Shape::Flag)
  {
    const std::string value = row.get(Settings{}).front() == "true" ? "false" : "true";
    return app.add_flag_function(
      names, [&row, &given, value](std::int64_t) { setFromWords(row, given, {value}); },
      helpOf(row, given.settings));
  }
  if (row.shape == Shape::OptionalOne)
    return app
      .add_flag_function(
        names, [](std::int64_t) {}, helpOf(row, given.settings))
      ->type_name(row.value)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
      ->check(CLI::Validator(
        [&row, &given](std::string& word) -> std::string
        {
          try
          {
            const std::vector<std::string> words = {word == "true" ? "on" : word};
            row.set(given.settings, words);
            given.named.emplace_back(row.name, words);
          }
          catch (const WrongValue& wrong)
          {
            return wrong.sentence;
          }
          word = "true"; // of which the library makes a count
          return {};
        },
        "", "words"));
  auto* option = app.add_option_function<std::vector<std::string>>(
    names,
    [&row, &given](const std::vector<std::string>& words) { setFromWords(row, given, words); },
    helpOf(row, given.settings));
  option->type_name(row.value)->type_size(1)->allow_extra_args(false);
  if (row.shape != Shape::Many)
    return option->expected(1);
  if (!row.commas)
    return option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  option->delimiter(',');
  if (row.value.find(' ') != std::string::npos)
    option->expected(row.count);
  return option;
}

/// Whether a row or its group is among the names; none stand for all.
bool isIn(const Row& row, const std::vector<std::string>& names)
{
  return names.empty() ||
         std::any_of(names.begin(), names.end(),
           [&](const auto& name) { return name == row.group || name == row.name; });
}

void addRows(CLI::App& app, GivenSettings& given, const std::vector<std::string>& groups,
  const std::string& prefix)
{
  for (const Row& row : settingsTable())
    if (isIn(row, groups))
      addRow(app, given, row, prefix)->group(row.group);
  for (const Row& row : settingsTable())
    if (isIn(row, groups) && !(row.needs.empty() && row.excludes.empty()))
    {
      CLI::Option* option = app.get_option(row.option());
      if (!row.needs.empty())
        option->needs(app.get_option(rowNamed(row.needs)->option()));
      if (!row.excludes.empty())
        option->excludes(app.get_option(rowNamed(row.excludes)->option()));
    }
}

} // namespace

void addFiles(CLI::App& app, Settings& settings)
{
  app
    .add_option("FILE", settings.data.files,
      "Files to read. LAMMPS dumps, VTK and .mote files that differ only in the digits of a number "
      "are steps of one series")
    ->type_name("");
}

void addSettings(CLI::App& app, GivenSettings& given, const std::vector<std::string>& groups,
  const std::string& prefix)
{
  addRows(app, given, groups, prefix);
}

CLI::Option* addVectorOption(CLI::App& app, const std::string& name,
  std::optional<std::array<double, 3>>& value, const std::string& help)
{
  return app
    .add_option_function<std::vector<double>>(
      name,
      [&value](const std::vector<double>& v) {
        value = {v[0], v[1], v[2]};
      },
      help)
    ->delimiter(',')
    ->check(isNumber())
    ->expected(3)
    ->type_name("X,Y,Z");
}

void addAllSettings(CLI::App& app, GivenSettings& given)
{
  addFiles(app, given.settings);
  addRows(app, given, {}, "");
}

void addSessionOption(CLI::App& app, std::string& file)
{
  app
    .add_option("--save-session", file,
      "Write all of this as a session, .json, which mote and mote render open as they do data")
    ->type_name("FILE")
    ->group("Session");
}

Settings GivenSettings::resolved() const
{
  const std::vector<std::string>& files = settings.data.files;
  const auto session = std::find_if(files.begin(), files.end(), isSessionFile);
  if (session == files.end())
    return settings;
  if (files.size() > 1)
    throw Failure(*session + " is a session, which names its data files itself; give it alone");
  Settings all = readSession(*session);
  for (const auto& [name, words] : named)
  {
    if (name == "time" || name == "step")
      all.data.time = {}; // one stands for the other
    if (name == "view" || name == "azimuth" || name == "elevation" || name == "zoom")
      all.camera.camera.clear();
    rowNamed(name)->set(all, words);
  }
  return all;
}

std::vector<std::string> asOptions(const Settings& settings)
{
  std::vector<std::string> all = settings.data.files;
  for (const Row& row : settingsTable())
  {
    if (row.isDefault(settings))
      continue;
    const std::vector<std::string> words = row.get(settings);
    if (row.shape == Shape::Flag)
      all.push_back(row.option());
    else if (row.shape == Shape::Many && row.commas)
      all.push_back(row.option() + "=" + joined(words, ","));
    else
      for (const std::string& word : words)
        if (word.empty()) // the parser takes no value behind "="
          all.insert(all.end(), {row.option(), word});
        else
          all.push_back(row.option() + "=" + word);
  }
  return all;
}

std::string asShellLine(const std::vector<std::string>& words)
{
  const std::string plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                            "-_=+:,./%@";
  std::string line;
  for (const std::string& word : words)
  {
    line += line.empty() ? "" : " ";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
    {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word)
      line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

} // namespace mote::app
