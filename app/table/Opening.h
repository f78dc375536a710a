#pragma once

#include "settings/Settings.h"

#include <string>
#include <vector>

namespace mote::app
{

/// The settings that open files in a window: besides those that are open, or in their place. What
/// speaks of the data (arrays, ranges, radii, the camera) begins anew with other data; light,
/// outlines and the picture stay. A session brings its own. Throws Failure for one that is none,
/// and for a session among other files.
Settings settingsToOpen(const Settings& now, const std::vector<std::string>& files, bool isAdded);

} // namespace mote::app
