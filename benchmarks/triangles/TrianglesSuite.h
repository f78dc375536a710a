#pragma once

#include "../Suite.h"
#include "../particles/Views.h"

#include <vector>

namespace mote::bench
{

/// Primary and occlusion rays through triangles, by every method.
Suite trianglesSuite();

/// Where models are seen from.
const std::vector<View>& triangleViews();

} // namespace mote::bench
