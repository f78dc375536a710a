#pragma once

#include "settings/Settings.h"

#include <string>
#include <utility>
#include <vector>

namespace CLI
{
class App;
class Option;
} // namespace CLI

namespace mote::app
{

/// What a command line says: settings, and which of them it names.
struct GivenSettings
{
  Settings settings;
  std::vector<std::pair<std::string, std::vector<std::string>>> named; ///< rows and their words

  /// The settings; where a session is among the files, those of the session, but for what the
  /// command line names. Throws Failure for a session that is none, and for several.
  Settings resolved() const;
};

/// Declares the options of these rows and groups of settingsTable() to the command line, which sets
/// them in `given`. Without the prefix that their names have in the table.
void addSettings(CLI::App& app, GivenSettings& given, const std::vector<std::string>& groups,
  const std::string& prefix = "");

/// Declares an option of three numbers with commas.
CLI::Option* addVectorOption(CLI::App& app, const std::string& name,
  std::optional<std::array<double, 3>>& value, const std::string& help);

/// Declares all of them, and the files.
void addAllSettings(CLI::App& app, GivenSettings& given);

/// Declares the files.
void addFiles(CLI::App& app, Settings& settings);

/// Declares --save-session.
void addSessionOption(CLI::App& app, std::string& file);

/// These settings as words of a command line: the files, and all that differs from the defaults.
std::vector<std::string> asOptions(const Settings& settings);

/// Words as a line that a shell reads as the same words.
std::string asShellLine(const std::vector<std::string>& words);

} // namespace mote::app
