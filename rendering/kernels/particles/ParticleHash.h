#pragma once

#include "../core/ContentHash.h"
#include "ParticleSet.h"

namespace mote
{

/// Of the positions and radii of all particles, in their order, as double numbers: the same
/// whatever type they are kept in, and for any number of threads.
ContentHash hashOf(const ParticleSet& particles);

} // namespace mote
