#pragma once

#include "table/CommandLine.h"

#include <array>
#include <optional>

namespace mote::app
{

/// What `mote probe` may be told.
struct ProbeOptions
{
  GivenSettings given; ///< files, time and threads
  std::optional<std::array<double, 3>> from, to;
  int points = 101;
  std::string output; ///< .csv, or empty for standard output
};

/// Declares the options of `mote probe`.
void addProbeOptions(CLI::App& app, ProbeOptions& options);

/// Writes the values along a line as a table. Throws Failure and Interrupted.
void probe(const ProbeOptions& options);

} // namespace mote::app
