#pragma once

#include "settings/Settings.h"
#include "stage/Input.h"

#include <optional>

namespace mote::app
{

/// The one set of particles of the input at the settings' step; none where there are more or none.
std::optional<NamedData> onlyParticlesOf(
  Input& input, const Settings& settings, ProgressRelay& progress);

/// Writes the last of the files: a .mote file, or what is shown for other programs. Throws Failure
/// and Interrupted; then no file is left that is not complete.
void convert(const Settings& settings);

} // namespace mote::app
