#pragma once

#include "../Suite.h"

namespace mote::bench
{

/// Silhouettes in depth images: time of the filter alone, and of whole frames with and without.
Suite silhouetteSuite();

} // namespace mote::bench
