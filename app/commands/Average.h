#pragma once

#include "table/CommandLine.h"

#include <array>
#include <optional>

namespace mote::app
{

/// What `mote average` may be told.
struct AverageOptions
{
  GivenSettings given; ///< files, time, threads and colours
  std::string array;
  std::string output; ///< .csv, a picture, or empty for standard output
  int resolution = 200;
  std::optional<std::array<double, 3>> axis, origin;
};

/// Declares the options of `mote average`.
void addAverageOptions(CLI::App& app, AverageOptions& options);

/// Writes the meridional average of an array as a table or a picture. Throws Failure and
/// Interrupted.
void average(const AverageOptions& options);

} // namespace mote::app
