#pragma once

#include "table/CommandLine.h"

namespace mote::app
{

/// Declares the options of `mote render`.
void addRenderOptions(CLI::App& app, GivenSettings& given);

/// Writes one picture, or one for every time step. Throws Failure and Interrupted; then no file is
/// left that is not complete.
void render(const Settings& settings);

} // namespace mote::app
