#pragma once

#include "ViewOptions.h"

namespace mote::app
{

struct InfoOptions
{
  ViewOptions read; ///< files, time and threads
  bool json = false;
};

/// Declares the options of `mote info`.
void addInfoOptions(CLI::App& app, InfoOptions& options);

/// Prints what the files hold. Throws Failure and Interrupted.
void printInfo(const InfoOptions& options);

} // namespace mote::app
