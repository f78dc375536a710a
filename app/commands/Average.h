#pragma once

#include "settings/Settings.h"

namespace mote::app
{

/// Writes the meridional average of an array as a table or a picture. Throws Failure and
/// Interrupted.
void average(const Settings& settings);

} // namespace mote::app
