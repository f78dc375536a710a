#pragma once

#include "table/CommandLine.h"

namespace mote::app
{

/// Declares the options of `mote silhouettes`.
void addImageSilhouetteOptions(CLI::App& app, GivenSettings& given);

/// Draws the silhouettes of a depth image over its colours, or on white. Throws Failure.
void drawImageSilhouettes(const Settings& settings);

} // namespace mote::app
