#pragma once

#include "settings/Settings.h"

namespace mote::app
{

/// Draws the silhouettes of a depth image over its colours, or on white. Throws Failure.
void drawImageSilhouettes(const Settings& settings);

} // namespace mote::app
