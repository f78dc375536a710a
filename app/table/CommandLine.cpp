#include "CommandLine.h"

#include "Recording.h"
#include "Row.h"
#include "Session.h"
#include "base/Failure.h"
#include "base/Text.h"
#include "stage/Framing.h"

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
  if (std::string values = row.values(); !row.words.empty())
    text += ". One of " + values;
  else if (!values.empty())
    text += std::string(". ") + static_cast<char>(std::toupper(values.front())) + values.substr(1);
  if (const std::string usual = row.usualText(settings); !usual.empty())
    text += ". Default: " + usual;
  return text;
}

/// Sets a row from the words of the command line, where it has a name of that command's.
void setFromWords(const Row& row, GivenSettings& given, const std::string& name,
  const std::vector<std::string>& words)
{
  try
  {
    row.set(given.settings, words);
    given.named.emplace_back(&row, words);
  }
  catch (const WrongValue& wrong)
  {
    throw CLI::ValidationError(name, wrong.sentence);
  }
}

CLI::Option* addRow(CLI::App& app, GivenSettings& given, const Row& row, const std::string& prefix)
{
  std::string name = row.option();
  if (const std::size_t at = name.find(prefix); at != std::string::npos)
    name.erase(at, prefix.size());
  const std::string names = name + (row.alias.empty() ? "" : "," + row.alias);
  if (row.shape == Shape::Flag)
  {
    const std::string value = row.get(Settings{}).front() == "true" ? "false" : "true";
    return app.add_flag_function(
      names, [&row, &given, name, value](std::int64_t) { setFromWords(row, given, name, {value}); },
      helpOf(row, given.settings));
  }
  if (row.shape == Shape::OptionalOne)
    return app
      .add_flag_function(
        names, [](std::int64_t) {}, helpOf(row, given.settings))
      ->type_name("[=" + row.value + "]")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
      ->check(CLI::Validator(
        [&row, &given](std::string& word) -> std::string
        {
          try
          {
            const std::vector<std::string> words = {word == "true" ? "on" : word};
            row.set(given.settings, words);
            given.named.emplace_back(&row, words);
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
    [&row, &given, name](const std::vector<std::string>& words)
    { setFromWords(row, given, name, words); },
    helpOf(row, given.settings));
  option->type_name(row.value)->type_size(1)->allow_extra_args(false);
  if (row.shape != Shape::Many)
    return option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  if (!row.commas)
    return option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  option->delimiter(',');
  if (row.count > 0)
    option->expected(row.count);
  return option;
}

/// Declares rows, and then what some ask of others.
void addRows(CLI::App& app, GivenSettings& given, const std::vector<const Row*>& rows,
  const std::string& prefix = "")
{
  for (const Row* row : rows)
    addRow(app, given, *row, prefix)->group(row->group)->required(row->required);
  for (const Row* row : rows)
  {
    CLI::Option* option = app.get_option_no_throw(row->option());
    if (option && !row->needs.empty())
      option->needs(app.get_option("--" + row->needs));
    for (const std::string& other : row->excludes)
      option->excludes(app.get_option("--" + other));
  }
}

/// The rows that `isIn` takes.
template <typename IsIn>
std::vector<const Row*> rowsOf(const std::vector<Row>& table, const IsIn& isIn)
{
  std::vector<const Row*> rows;
  for (const Row& row : table)
    if (isIn(row))
      rows.push_back(&row);
  return rows;
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

void addSettings(CLI::App& app, GivenSettings& given, const std::vector<std::string>& names,
  const std::string& prefix)
{
  const auto isNamed = [&](const Row& row)
  {
    return std::any_of(names.begin(), names.end(),
      [&](const auto& name) { return name == row.group || name == row.name; });
  };
  addRows(app, given, rowsOf(settingsTable(), isNamed), prefix);
}

void addCommandSettings(CLI::App& app, GivenSettings& given, const std::string& command)
{
  addRows(
    app, given, rowsOf(commandTable(), [&](const Row& row) { return row.command == command; }));
}

void addAllSettings(CLI::App& app, GivenSettings& given)
{
  addFiles(app, given.settings);
  addRows(app, given, rowsOf(settingsTable(), [](const Row&) { return true; }));
}

Settings GivenSettings::resolved() const
{
  const std::vector<std::string>& files = settings.data.files;
  const auto session = std::find_if(files.begin(), files.end(), isSessionFile);
  const std::string& recording = settings.output.play;
  if (session == files.end() && recording.empty())
    return settings;
  if (session == files.end())
  {
    const bool isAtEnd = std::any_of(named.begin(), named.end(),
      [](const auto& one) { return one.first->name == "play" && one.first->command == "render"; });
    return this->over(settingsToPlay(recording, files, isAtEnd));
  }
  if (!recording.empty())
    throw Failure(*session + " is a session, and --play brings its own settings; give one of them");
  if (files.size() > 1)
    throw Failure(*session + " is a session, which names its data files itself; give it alone");
  const Settings kept = readSession(*session);
  Settings all = this->over(kept);
  if (std::none_of(named.begin(), named.end(),
        [](const auto& one) { return one.first->name == "silhouette-thickness"; }))
    all.output.seenHeight = kept.picture.size[1];
  all.output.isSession = true;
  all.output.fitsView = std::none_of(named.begin(), named.end(),
    [](const auto& one) { return one.first->name == "size" && one.first->command.empty(); });
  return all;
}

/// Other settings, but for what is named here.
Settings GivenSettings::over(Settings all) const
{
  const bool wasParallel = all.camera.orthographic;
  const std::vector<double> camera = all.camera.camera;
  for (const auto& [row, words] : named)
  {
    const std::string& name = row->command.empty() ? row->name : "";
    if (name == "time" || name == "step")
      all.data.time = {}; // one stands for the other
    if (name == "view" || name == "azimuth" || name == "elevation" || name == "zoom")
      all.camera.camera.clear();
    row->set(all, words);
  }
  if (all.camera.orthographic && !wasParallel && !camera.empty() && all.camera.camera == camera)
    all.camera.camera = withParallelProjection(camera);
  return all;
}

std::vector<std::string> wordsOf(const CLI::App& app, int argc, const char* const* argv)
{
  std::vector<std::string> words;
  const CLI::App* command = &app;
  for (int i = 1; i < argc; ++i)
  {
    std::string word = argv[i];
    const auto named = app.get_subcommands(
      [&](const CLI::App* one) { return command == &app && one->get_name() == word; });
    if (!named.empty())
      command = named.front();
    const bool isEmpty = word.starts_with("--") && word.ends_with("=") && word.size() > 3;
    const std::string name = isEmpty ? word.substr(0, word.size() - 1) : "";
    const CLI::Option* option = isEmpty ? command->get_option_no_throw(name) : nullptr;
    if (option && option->get_items_expected_max() > 0)
      words.insert(words.end(), {name, ""});
    else
      words.push_back(std::move(word));
  }
  return words;
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
