#pragma once

#include "../Suite.h"

#include <kernels/particles/ParticleSet.h>

#include <memory>
#include <string>
#include <vector>

namespace mote::bench
{

/// Particles to measure on, and whoever owns their numbers.
struct ParticleInput
{
  std::string name; ///< as it was specified
  ParticleSet set;
  ParticleStatistics statistics;
  std::shared_ptr<const void> owner;
};

/// What coordinates in float are relative to.
inline Vec3d middleOf(const ParticleInput& input)
{
  return input.statistics.centers.center();
}

/// Makes or reads what the specification says: `lattice:N`, `random:N:R`, `varied:N` or a file; a
/// name that is also a file is a file. Made particles are kept in memory, or with `onTheFly` made
/// again whenever they are looked at. Throws Error.
ParticleInput makeParticleInput(const std::string& specification, bool onTheFly = false);

/// The forms of specifications, for --help.
std::vector<Named> particleInputs();

/// Reads a file, its last step where it has several, with Mote's or VTK's readers. Radii are the
/// array `radius`, or half the array `diameter`, or half the spacing where there is neither.
ParticleInput readParticles(const std::string& fileName);

} // namespace mote::bench
