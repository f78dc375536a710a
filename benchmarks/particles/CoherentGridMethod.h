#pragma once

#include "HitImage.h"

#include <kernels/core/Camera.h>
#include <kernels/particles/CoherentGrid.h>

namespace mote::bench
{

/// Casts the rays of a camera through a coherent grid in bundles of `side` x `side` pixels: 2, 4, 8
/// or 16, or 0 for the grid's own choice tile by tile.
void castBundles(const CoherentGrid& grid, int side, const CameraRays& rays, HitImage& image);

} // namespace mote::bench
