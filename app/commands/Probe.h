#pragma once

#include "table/CommandLine.h"

namespace mote::app
{

/// Declares the options of `mote probe`.
void addProbeOptions(CLI::App& app, GivenSettings& given);

/// Writes the values along a line as a table. Throws Failure and Interrupted.
void probe(const Settings& settings);

} // namespace mote::app
