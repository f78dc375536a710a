#pragma once

#include "CommandLine.h"

namespace mote::app
{

/// Declare the options of the window and of each command. In one file, since CLI11 takes long to
/// compile.
//@{
void addWindowOptions(CLI::App& app, GivenSettings& given);
void addRenderOptions(CLI::App& app, GivenSettings& given);
void addAnimateOptions(CLI::App& app, GivenSettings& given);
void addConvertOptions(CLI::App& app, GivenSettings& given);
void addInfoOptions(CLI::App& app, GivenSettings& given);
void addAverageOptions(CLI::App& app, GivenSettings& given);
void addImageSilhouetteOptions(CLI::App& app, GivenSettings& given);
void addBakeOptions(CLI::App& app, GivenSettings& given);
void addIntegrateOptions(CLI::App& app, GivenSettings& given);
void addProbeOptions(CLI::App& app, GivenSettings& given);
//@}

} // namespace mote::app
