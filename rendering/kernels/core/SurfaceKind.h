#pragma once

#include "Box.h"
#include "Camera.h"
#include "ColorMix.h"
#include "HitBlock.h"
#include "RayPacket.h"

#include <concepts>
#include <limits>
#include <memory>
#include <vector>

namespace mote
{

/// A radius, or half the width, of one of the things that a surface is made of, and the area of
/// cross-section that it stands for.
struct FeatureSize
{
  double size = 0.0;
  double section = 0.0;
};

/// The nearest edge of the cell that a hit lies on, as the hit's ray sees it: how far it is from
/// the hit across the ray, and how far the cell goes on that way, from edge to edge. Infinite where
/// there is none.
struct EdgeSeen
{
  double distance = std::numeric_limits<double>::infinity();
  double extent = std::numeric_limits<double>::infinity();

  /// Takes an edge that goes along `edge` at `offset` from the hit, seen along `way`, neither of
  /// them 0, in place of a farther one.
  void take(const Vec3d& offset, const Vec3d& edge, const Vec3d& way, double share)
  {
    const Vec3d v = glm::normalize(way);
    const Vec3d across = offset - glm::dot(offset, v) * v;
    const Vec3d along = edge - glm::dot(edge, v) * v;
    const double length = glm::length(along);
    const double seen =
      length > 0.0 ? glm::length(glm::cross(across, along)) / length : glm::length(across);
    if (seen < distance)
      *this = {seen, share > 0.0 ? seen / share : extent};
  }
};

/// A pointer that equals `owner` and keeps nothing alive.
template <typename T>
std::shared_ptr<T> unowned(const std::shared_ptr<T>& owner)
{
  return {std::shared_ptr<void>(), owner.get()};
}

/// What every kind of surface does. All is in the surface's own coordinates, const, and safe to
/// call from several threads. Rays may have directions of any length but 0; `index` is the
/// surface's place in the scene, which rays carry as `object` to tell what they hit.
///
/// - `bounds()`: of all that can be hit. `rounding()`: how far hits may lie off the surface.
/// - `cast(bundle, index)`, `cast(packet, index)`: finds for each ray the nearest hit with
///   tMin < t < ray.t, and where there is one writes t, slot and object. A slot is the kind's own
///   number for what was hit. A packet of one is a single ray.
/// - `occlude(bundle, index)`, `occlude(packet, index)`: t of each ray that meets anything between
///   tMin and t becomes -infinity; slot and object stay. A convex thing that the ray's slot and
///   object name does not count; kinds that are not convex rely on the rounding() by which rays
///   are kept off.
/// - `bundleSide(rays, x0, y0, size)`: side in pixels (2, 4, 8, 16) of the bundles that are cast
///   fastest in this square of the camera's image.
/// - `fetch(block)`, then `place(block, placing)`: brings what memory holds of the block's hits;
///   fills normals, toEye, sides and, where asked for, positions.
/// - `normalAt(slot, point)`: the outward normal of one hit, of any length, or 0 where there is
///   none. `encloses(slot, point)`: whether what was hit is a solid with the point inside.
/// - `colorIndices(slots, count, indices)`: which values or colours of the surface's colouring the
///   hits have. `inputIds(slots, count, ids)`: what the user knows them by (particle, cell, ...).
/// - `mayMixColors`: whether hits may have colours between those of several indices. Such kinds
/// have
///   `mixesColors()`, whether this surface's do, and `mixColors(slots, points, count, mix)`, which
///   tells it of hits at these points; colorIndices() is not asked then.
/// - `hasValues`: whether the surface itself knows the values of its colouring. Such kinds have
///   `values(slots, points, count, values)`, which are looked up in the map; colorIndices() is not
///   asked then.
/// - `hasEdges`: whether hits lie on cells that have edges. Such kinds have
///   `edges(slots, points, ways, count, found)`, see EdgeSeen; the ways are the rays' directions.
/// - `mayErr`: whether hits may lie farther off the surface than rounding() tells, because an error
///   is allowed. Such kinds have `pixelsOfError()`, how far hits of the camera's rays may lie off
///   in pixels, 0 if not; and
///   `clearance(slot, cosine)`: how far a ray goes from such a hit, at that cosine to its normal,
///   before it has left behind all of the surface that the error might put in its way; and
///   `meanPlace(slot)`: where the colour of a hit that stands for many stands among the means of
///   SurfaceColoring, or `RayBundle::noHit` for a hit that stands for itself; and
///   `seenNormalAt(slot, point, way)`: in place of normalAt() for a hit that stands for many, what
///   is seen of their normals by a ray that goes this way.
/// - `isConvex`: whether what a slot names is convex, so that a line meets it twice at most.
/// - `slots()`: how many slots occlusion maps count, or 0 where the kind can have none.
/// - `featureSizes()`: of a sample of what the surface is made of; empty where nothing has a size.
/// - `==`: whether it is the same surface of the same data. What changes in place does not show.
///   `unowned()`: equal to the surface, but it keeps no data alive: to be compared, not used.
template <typename S>
concept SurfaceKind = std::equality_comparable<S> &&
  requires(const S& s, RayBundle& bundle, RayPacket& packet, const CameraRays& rays,
    HitBlock& block, const HitPlacing& placing, std::int32_t index, std::uint64_t slot,
    const std::uint64_t* slots, std::uint64_t* ids, const Vec3d& point, int n)
{
  {
    S::isConvex
    } -> std::convertible_to<bool>;
  {
    S::mayMixColors
    } -> std::convertible_to<bool>;
  requires !S::mayMixColors || requires(ColorMix & mix)
  {
    {
      s.mixesColors()
      } -> std::same_as<bool>;
    s.mixColors(slots, &point, n, mix);
  };
  {
    S::hasValues
    } -> std::convertible_to<bool>;
  requires !S::hasValues || requires(double* values)
  {
    s.values(slots, &point, n, values);
  };
  {
    S::hasEdges
    } -> std::convertible_to<bool>;
  requires !S::hasEdges || requires(EdgeSeen * found)
  {
    s.edges(slots, &point, &point, n, found);
  };
  {
    S::mayErr
    } -> std::convertible_to<bool>;
  requires !S::mayErr || requires(double cosine)
  {
    {
      s.pixelsOfError()
      } -> std::same_as<double>;
    {
      s.clearance(slot, cosine)
      } -> std::same_as<double>;
    {
      s.meanPlace(slot)
      } -> std::same_as<std::uint64_t>;
    {
      s.seenNormalAt(slot, point, point)
      } -> std::same_as<Vec3d>;
  };
  {
    s.bounds()
    } -> std::same_as<Box>;
  {
    s.rounding()
    } -> std::same_as<double>;
  s.cast(bundle, index);
  s.cast(packet, index);
  s.occlude(bundle, index);
  s.occlude(packet, index);
  {
    s.bundleSide(rays, n, n, n)
    } -> std::same_as<int>;
  s.fetch(block);
  s.place(block, placing);
  {
    s.normalAt(slot, point)
    } -> std::same_as<Vec3d>;
  {
    s.encloses(slot, point)
    } -> std::same_as<bool>;
  s.colorIndices(slots, n, ids);
  s.inputIds(slots, n, ids);
  {
    s.slots()
    } -> std::same_as<std::size_t>;
  {
    s.featureSizes()
    } -> std::same_as<std::vector<FeatureSize>>;
  {
    s.unowned()
    } -> std::same_as<S>;
};

} // namespace mote
