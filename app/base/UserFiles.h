#pragma once

#include <filesystem>

namespace mote::app
{

/// The folder of the simulations that come with Mote, in the installation or the source tree that
/// the program lies in; empty where there is none.
std::filesystem::path demoFolder();

/// The file that keeps what the program remembers of its user, in XDG_STATE_HOME or
/// ~/.local/state; empty where the environment names no folder. It need not exist.
std::filesystem::path stateFile();

/// The user's own folder, or "/" where the environment names none.
std::filesystem::path homeFolder();

} // namespace mote::app
