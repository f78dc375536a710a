#pragma once

#include "../scene/Scene.h"

#include <array>
#include <limits>
#include <optional>
#include <utility>

namespace mote
{

/// What one ray meets first.
struct ScenePick
{
  std::int32_t object = 0; ///< SurfaceObject::id
  std::uint64_t id = 0;    ///< of the input: of a particle, of a cell
  /// Of the surface's colouring: of a particle, of an iso-value. Where several indices are mixed,
  /// that with the largest share.
  std::uint64_t colorIndex = 0;
  /// The indices that are mixed, and their shares; where one tells the colour, it has all.
  std::array<std::pair<std::uint64_t, double>, ColorMix::corners> colorShares{};
  Vec3d along{0.0};            ///< SurfaceColoring::along
  std::optional<double> value; ///< that a surface itself knows; see SurfaceKind::hasValues
  double t = 0.0;              ///< in lengths of the direction given
  Vec3d position{0.0};
  Vec3d normal{0.0}; ///< unit length, outwards; 0 where there is none
};

/// Casts one ray at the scene's surfaces. What is wholly transparent is not met. `direction` may
/// have any length but 0.
std::optional<ScenePick> pick(const Scene& scene, const Vec3d& origin, const Vec3d& direction,
  double tMin = 0.0, double tMax = std::numeric_limits<double>::infinity());

} // namespace mote
