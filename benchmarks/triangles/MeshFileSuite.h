#pragma once

#include "../Suite.h"

namespace mote::bench
{

/// What a .mote file of triangles costs, by pixels of error: to open, to a first picture, and which
/// of its pages that takes.
Suite meshFileSuite();

} // namespace mote::bench
