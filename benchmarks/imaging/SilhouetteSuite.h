#pragma once

#include "../Suite.h"

namespace mote::bench
{

/// Edges in depth images: time of the filter alone, and of whole frames with and without edges.
Suite silhouetteSuite();

} // namespace mote::bench
