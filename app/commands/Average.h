#pragma once

#include "table/CommandLine.h"

namespace mote::app
{

/// Declares the options of `mote average`.
void addAverageOptions(CLI::App& app, GivenSettings& given);

/// Writes the meridional average of an array as a table or a picture. Throws Failure and
/// Interrupted.
void average(const Settings& settings);

} // namespace mote::app
