#pragma once

#include "settings/Settings.h"

namespace mote::app
{

/// Writes integrals over sections and boundaries as a table. Throws Failure and Interrupted.
void integrate(const Settings& settings);

} // namespace mote::app
