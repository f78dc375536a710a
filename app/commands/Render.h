#pragma once

#include "settings/Settings.h"

namespace mote::app
{

/// Writes one picture, or one for every time step. Throws Failure and Interrupted; then no file is
/// left that is not complete.
void render(const Settings& settings);

} // namespace mote::app
