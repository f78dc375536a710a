#pragma once

#include "../Suite.h"

namespace mote::bench
{

/// Incoherent rays from what a view shows that ask for anything in their way, as ambient occlusion
/// does: answered by the methods that can, checked against the reference.
Suite occlusionSuite();

} // namespace mote::bench
