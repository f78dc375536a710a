#pragma once

#include "base/ProgressRelay.h"
#include "stage/Input.h"

#include <functional>
#include <string>

namespace mote::app
{

/// "out.png" as "out.0007.png", with as many digits as the steps need, four at least.
std::string numbered(const std::string& file, int step, int steps);

/// Calls `work` with the settings of each time step of particles, or of the one that they ask for,
/// and with what tells the user which of how many it is. Steps have the radius that the last one
/// has, where it comes from the spacing. Throws what `work` throws.
void forSteps(Input& input, const Settings& settings, ProgressRelay& progress,
  const std::function<void(const Settings& ofStep, const std::string& which)>& work);

} // namespace mote::app
