#pragma once

#include <cstdint>
#include <limits>

namespace mote
{

/// Surfaces lie where they should to within this share of their object's longest side: float
/// numbers relative to its middle, and a ray's formulas (docs/shadows.md tells the measurement).
constexpr double surfaceError = 5e-7;

/// Which end of rays lies on a surface. Where a caster is allowed an error, what stands for many
/// and holds that end in its thickness is not in the way of the ray: it stands for the surface
/// itself.
enum class OnSurface : std::uint8_t
{
  Neither,
  Start, ///< the origin, t = 0
  End    ///< the farthest t that counts
};

/// Up to 64 rays that need have nothing in common, and what they have hit so far. Rays of one
/// origin or one direction are cast much faster as a RayBundle.
///
/// Ray i is origin + t * direction in double; the direction need not have unit length, and t counts
/// in its lengths.
struct RayPacket
{
  static constexpr int capacity = 64;
  static constexpr std::uint64_t noHit = std::numeric_limits<std::uint64_t>::max();

  alignas(64) double origin[3][capacity];
  alignas(64) double direction[3][capacity];
  alignas(64) double tMin[capacity]; ///< hits at t <= tMin do not count
  alignas(64) double t[capacity];    ///< in: farthest t that counts; out: t of the nearest hit
  alignas(64) std::uint64_t slot[capacity];    ///< particle's place in its structure, or noHit
  alignas(64) std::int32_t object[capacity];   ///< index of the object in the scene, or -1
  int count = 0;                               ///< rays in use, from the front
  double footprint = 0.0, footprintPerT = 0.0; ///< of all rays, as RayBundle has them
  OnSurface onSurface = OnSurface::Neither;    ///< of all rays
};

} // namespace mote
