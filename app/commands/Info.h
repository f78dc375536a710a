#pragma once

#include "settings/Settings.h"

namespace mote::app
{

/// Prints what the files hold. Throws Failure and Interrupted.
void printInfo(const Settings& settings);

} // namespace mote::app
