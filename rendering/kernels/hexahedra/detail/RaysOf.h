#pragma once

#include "../../core/RayBundle.h"
#include "../../core/RayPacket.h"
#include "../HexRay.h"

namespace mote
{

/// Ray i of a bundle or a packet.
inline HexRay rayOf(const RayBundle& rays, int i)
{
  return {rays.originOf(i), rays.directionOf(i), rays.tMin, rays.t[i]};
}

inline HexRay rayOf(const RayPacket& rays, int i)
{
  return {{rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]},
    {rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]}, rays.tMin[i], rays.t[i]};
}

} // namespace mote
