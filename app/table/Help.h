#pragma once

#include <string>
#include <vector>

namespace CLI
{
class App;
} // namespace CLI

namespace mote::app
{

/// What `mote help` may be told.
struct HelpOptions
{
  std::string topic; ///< a group or a name of settingsTable(), "keys" or "formats"; or none
  std::string format = "text"; ///< "text", "markdown", "man" or "bash"
};

/// Declares the options of `mote help`.
void addHelpOptions(CLI::App& app, HelpOptions& options);

/// Prints help about a topic, or all of it as a page of the reference, a manual page or a
/// completion for bash. `app` is the whole command line. Throws Failure for an unknown topic.
void printHelp(const CLI::App& app, const HelpOptions& options);

} // namespace mote::app
