#pragma once

#include "../Suite.h"

namespace mote::bench
{

/// Volumes on hexahedra, drawn through Mote's structures and by VTK's mappers.
Suite hexahedraSuite();

} // namespace mote::bench
