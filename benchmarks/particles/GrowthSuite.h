#pragma once

#include "../Suite.h"

namespace mote::bench
{

/// How time and memory grow with the number of particles.
Suite growthSuite();

} // namespace mote::bench
