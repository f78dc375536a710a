#pragma once

#include "../scene/Scene.h"

#include <limits>
#include <optional>

namespace mote
{

/// The cell of a cloud that keeps back more of a ray's light than any other.
struct CloudPick
{
  std::int32_t object = 0; ///< CloudObject::id
  std::uint64_t cell = 0;  ///< of the input
  double value = 0.0;      ///< of the scalar at `position`; NaN where it has none
  double t = 0.0;          ///< in lengths of the direction given
  Vec3d position{0.0};     ///< the most opaque place of the ray in that cell
  double opacity = 0.0;    ///< of all clouds along the ray, in (0, 1]
};

/// Looks along one ray through the scene's clouds, from tMin to tMax; surfaces are not looked at.
/// `direction` may have any length but 0. None where the clouds let all light through.
std::optional<CloudPick> pickCloud(const Scene& scene, const Vec3d& origin, const Vec3d& direction,
  double tMin = 0.0, double tMax = std::numeric_limits<double>::infinity());

} // namespace mote
