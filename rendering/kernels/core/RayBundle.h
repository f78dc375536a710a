#pragma once

#include "Vec.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace mote
{

/// Up to 256 rays that share an origin (a camera's, or those towards a point light) or a direction
/// (an orthographic camera's, or those towards a light far away), and what they have hit so far.
///
/// With a common origin ray i is origin + t * (direction + x[i] * dx + y[i] * dy), with a common
/// direction it is origin + x[i] * dx + y[i] * dy + t * direction. x and y should be small numbers:
/// they count from a ray in the bundle's middle, so that float tells neighbours apart.
/// `direction`, `dx` and `dy` must not lie in one plane.
struct RayBundle
{
  static constexpr int capacity = 256;
  static constexpr std::uint64_t noHit = std::numeric_limits<std::uint64_t>::max();

  enum class Kind : std::uint8_t
  {
    CommonOrigin,
    CommonDirection
  };

  Kind kind = Kind::CommonOrigin;
  int count = 0; ///< rays in use, from the front
  int side = 0;  ///< of the square that the rays fill in the order of bundleOffset(); 0: any rays
  Vec3d origin{0.0};
  Vec3d direction{0.0};
  Vec3d dx{0.0}, dy{0.0};
  double tMin = 0.0; ///< hits at t <= tMin do not count
  /// How far apart neighbouring rays are at t, or what else an error may be compared with:
  /// footprint + t * footprintPerT. Read only where a caster is allowed an error.
  double footprint = 0.0, footprintPerT = 0.0;
  alignas(64) float x[capacity];
  alignas(64) float y[capacity];
  alignas(64) double t[capacity]; ///< in: farthest t that counts; out: t of the nearest hit
  alignas(64) std::uint64_t slot[capacity];  ///< particle's place in its structure, or noHit
  alignas(64) std::int32_t object[capacity]; ///< index of the object in the scene, or -1

  Vec3d originOf(int i) const
  {
    return kind == Kind::CommonOrigin ? origin : origin + double(x[i]) * dx + double(y[i]) * dy;
  }
  Vec3d directionOf(int i) const
  {
    return kind == Kind::CommonOrigin ? direction + double(x[i]) * dx + double(y[i]) * dy
                                      : direction;
  }
};

/// Column and row of ray i in a square block of rays, its side 2, 4, 8 or 16: blocks of 4x4 rays in
/// Z order, row by row within each, so that a quarter of the bundle is a quarter of the square, and
/// SIMD vectors of 4, 8 and 16 rays are compact.
inline void bundleOffset(int side, int i, int& x, int& y)
{
  if (side < 4)
  {
    x = i % side;
    y = i / side;
    return;
  }
  const int block = i / 16;
  x = (i & 3) | ((block & 1) << 2) | ((block & 4) << 1);
  y = ((i >> 2) & 3) | ((block & 2) << 1) | (block & 8);
}

/// Makes `to` of `count` rays of `from`: the same rays with the same answers so far.
void copyRays(const RayBundle& from, int first, int count, RayBundle& to);

/// Two unit vectors perpendicular to `v` and to one another. `v` may have any length but 0.
void acrossAxes(const Vec3d& v, Vec3d& a, Vec3d& b);

/// Calls cast(bundle), and where that answers false the same for each quarter of the bundle, down
/// to single rays; answers come back into the bundle. cast() must take single rays.
template <typename Cast>
void bySplitting(RayBundle& bundle, const Cast& cast)
{
  if (cast(bundle) || bundle.count <= 1)
    return;
  const int quarter = (bundle.count + 3) / 4;
  for (int first = 0; first < bundle.count; first += quarter)
  {
    RayBundle part;
    copyRays(bundle, first, std::min(quarter, bundle.count - first), part);
    bySplitting(part, cast);
    std::copy_n(part.t, part.count, bundle.t + first);
    std::copy_n(part.slot, part.count, bundle.slot + first);
    std::copy_n(part.object, part.count, bundle.object + first);
  }
}

} // namespace mote
