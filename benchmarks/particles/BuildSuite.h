#pragma once

#include "../Suite.h"

namespace mote::bench
{

/// Time and memory that every method takes to build its structure over particles.
Suite buildSuite();

} // namespace mote::bench
