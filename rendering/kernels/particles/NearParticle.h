#pragma once

#include "../core/Vec.h"

#include <cstdint>

namespace mote
{

/// A particle that findNear() of a structure has found: centre and radius as they are stored, in
/// the input's coordinates.
struct NearParticle
{
  Vec3d center;
  double radius;
  std::uint64_t slot;

  /// Whether the sphere comes closer to the point than `distance`.
  static bool isNear(const Vec3d& center, double radius, const Vec3d& point, double distance)
  {
    const Vec3d way = center - point;
    const double most = distance + radius;
    return glm::dot(way, way) < most * most;
  }
};

} // namespace mote
