#pragma once

#include "../Suite.h"

namespace mote::bench
{

/// Primary rays through particles: cast by every method, checked against the reference.
Suite particlesSuite();

} // namespace mote::bench
