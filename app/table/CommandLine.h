#pragma once

#include "settings/Settings.h"

#include <string>
#include <utility>
#include <vector>

namespace CLI
{
class App;
} // namespace CLI

namespace mote::app
{

struct Row;

/// What a command line says: settings, and which of them it names.
struct GivenSettings
{
  Settings settings;
  std::vector<std::pair<const Row*, std::vector<std::string>>> named; ///< with their words

  /// The settings; where a session is among the files, those of the session, and with --play those
  /// of the recording, at its end for `mote render`; but for what the command line names. Throws
  /// Failure for a session or recording that is none, and for several.
  Settings resolved() const;

private:
  Settings over(Settings all) const;
};

/// Declares the options of these rows and groups of settingsTable() to the command line, which sets
/// them in `given`. Without the prefix that their names have in the table.
void addSettings(CLI::App& app, GivenSettings& given, const std::vector<std::string>& names,
  const std::string& prefix = "");

/// Declares those of commandTable() that a command has.
void addCommandSettings(CLI::App& app, GivenSettings& given, const std::string& command);

/// Declares all of settingsTable(), and the files.
void addAllSettings(CLI::App& app, GivenSettings& given);

/// Declares the files.
void addFiles(CLI::App& app, Settings& settings);

/// The words of a command line, without the program's name: of options that take a value an empty
/// one behind "=" becomes a word of its own, or the parser would take the next word for it.
std::vector<std::string> wordsOf(const CLI::App& app, int argc, const char* const* argv);

/// These settings as words of a command line: the files, and all that differs from the defaults.
std::vector<std::string> asOptions(const Settings& settings);

/// Words as a line that a shell reads as the same words.
std::string asShellLine(const std::vector<std::string>& words);

} // namespace mote::app
