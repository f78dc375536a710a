#pragma once

#include "settings/Settings.h"

namespace mote::app
{

/// Writes the values along a line as a table. Throws Failure and Interrupted.
void probe(const Settings& settings);

} // namespace mote::app
