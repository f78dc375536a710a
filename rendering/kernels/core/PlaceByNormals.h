#pragma once

#include "HitBlock.h"

namespace mote
{

/// What SurfaceKind's place() does for a surface both sides of which look alike: fills normals,
/// toEye, sides and, where asked for, positions from the normals in `own[0]` to `own[2]`, of any
/// length and either side, in the surface's coordinates. Where a normal is 0 the surface looks
/// straight at the eye.
void placeByNormals(HitBlock& block, const HitPlacing& placing);

} // namespace mote
