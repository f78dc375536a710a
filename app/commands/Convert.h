#pragma once

#include "stage/Input.h"
#include "table/CommandLine.h"

#include <cstdint>
#include <string>

namespace mote::app
{

/// What `mote convert` may be told: the files, the last of which is written, the time step, radii.
struct ConvertOptions
{
  GivenSettings given;
  std::uint64_t memory = 0; ///< bytes to keep to; 0: half of the machine's
};

/// The one set of particles of the input at a step. Throws Failure, with `why` one is needed, where
/// there are more or none.
NamedData particlesOf(Input& input, int step, ProgressRelay& progress, const std::string& why);

/// Declares the options of `mote convert`.
void addConvertOptions(CLI::App& app, ConvertOptions& options);

/// Writes a .mote file. Throws Failure and Interrupted; then no file is left that is not complete.
void convert(const ConvertOptions& options);

} // namespace mote::app
