#pragma once

#include "Contest.h"

namespace mote::bench
{

/// What it takes one method to build its structure on so many threads.
struct BuildCost
{
  std::string method;
  int threads = 1;
  double first = unknown; ///< seconds of the first build of a new object, median
  double least = unknown, most = unknown;
  double again = unknown; ///< seconds of a second build into the same object, median
  double bytesPerParticle = unknown;
  double peakBytesPerParticle =
    unknown; ///< the most held during a first build, the result included
};

/// One, and as many as may be used.
std::vector<int> threadCounts(int threads);

/// Builds all methods with each of these numbers of threads in one race. The costs of a number of
/// threads stand side by side, in the order of `methods`.
std::vector<BuildCost> measureBuilds(const std::vector<const ParticleMethodEntry*>& methods,
  const MethodOptions& options, const ParticleInput& input, const std::vector<int>& threads,
  int repeat);

/// The costs as a table.
Section buildSection(const std::vector<BuildCost>& costs);

/// The cost as a measurement of the input.
Measurement toMeasurement(const BuildCost& cost, const ParticleInput& input, int repeat);

} // namespace mote::bench
