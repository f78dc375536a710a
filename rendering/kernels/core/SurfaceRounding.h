#pragma once

#include "RayPacket.h"
#include "Vec.h"

#include <algorithm>

namespace mote
{

/// How far the hits of an object of this size may lie from where they should, in the scene's
/// lengths: the longest side decides, also of a flat object.
inline double surfaceRounding(const Vec3d& size)
{
  return surfaceError * std::max({size.x, size.y, size.z});
}

} // namespace mote
