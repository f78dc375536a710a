#pragma once

#include "../Suite.h"

namespace mote::bench
{

/// Primary and occlusion rays through triangles, by every method.
Suite trianglesSuite();

} // namespace mote::bench
