#pragma once

#include "settings/Settings.h"
#include "stage/Input.h"

#include <string>

namespace mote::app
{

/// The one set of particles of the input at the settings' step. Throws Failure, with `why` one is
/// needed, where there are more or none.
NamedData particlesOf(
  Input& input, const Settings& settings, ProgressRelay& progress, const std::string& why);

/// Writes a .mote file, which the last of the files names. Throws Failure and Interrupted; then no
/// file is left that is not complete.
void convert(const Settings& settings);

} // namespace mote::app
