#include "UserFiles.h"

#include <cstdlib>
#include <system_error>

namespace mote::app
{

namespace fs = std::filesystem;

namespace
{

/// A folder that the environment names; empty for none, and for a relative one, which the rules of
/// XDG have ignored.
fs::path folderNamed(const char* variable)
{
  const char* value = std::getenv(variable);
  const fs::path folder = value ? value : "";
  return folder.is_absolute() ? folder : fs::path();
}

} // namespace

fs::path demoFolder()
{
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error)
    return {};
  // bin/mote of an installation, and build/release/bin/mote of the source tree.
  for (const char* place : {"../" MOTE_DEMO_FOLDER, "../../../data"})
  {
    const fs::path folder = (program.parent_path() / place).lexically_normal();
    if (fs::exists(folder / "hopper.dump.gz", error))
      return folder;
  }
  return {};
}

fs::path stateFile()
{
  if (const fs::path state = folderNamed("XDG_STATE_HOME"); !state.empty())
    return state / "mote" / "state.json";
  if (const fs::path home = folderNamed("HOME"); !home.empty())
    return home / ".local" / "state" / "mote" / "state.json";
  return {};
}

fs::path homeFolder()
{
  const fs::path home = folderNamed("HOME");
  return home.empty() ? "/" : home;
}

} // namespace mote::app
