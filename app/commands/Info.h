#pragma once

#include "table/CommandLine.h"

namespace mote::app
{

/// Declares the options of `mote info`.
void addInfoOptions(CLI::App& app, GivenSettings& given);

/// Prints what the files hold. Throws Failure and Interrupted.
void printInfo(const Settings& settings);

} // namespace mote::app
