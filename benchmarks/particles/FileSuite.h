#pragma once

#include "../Suite.h"

namespace mote::bench
{

/// What a .mote file of any size costs: to open, to a first picture, a frame; and what of it is in
/// memory then.
Suite fileSuite();

} // namespace mote::bench
