#pragma once

#include "../Suite.h"

namespace mote::bench
{

/// Ambient occlusion by rays in every picture and by maps that are baked once: error against time.
Suite ambientSuite();

} // namespace mote::bench
