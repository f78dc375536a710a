#pragma once

#include "Settings.h"

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace CLI
{
class App;
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

/// Declares the options of these rows and groups of settingsTable() to the command line, which sets them in
/// `given`.
void addSettings(
  CLI::App& app, GivenSettings& given, std::initializer_list<std::string> groups);

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
