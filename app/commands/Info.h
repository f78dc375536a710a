#pragma once

#include "table/CommandLine.h"

namespace mote::app
{

struct InfoOptions
{
  GivenSettings given; ///< files, time and threads
  bool json = false;
};

/// Declares the options of `mote info`.
void addInfoOptions(CLI::App& app, InfoOptions& options);

/// Prints what the files hold. Throws Failure and Interrupted.
void printInfo(const InfoOptions& options);

} // namespace mote::app
