#include "detail/SceneRays.h"

#include "detail/ClippedRays.h"

#include <algorithm>
#include <type_traits>

namespace mote
{

SceneRays::SceneRays(const Scene& scene, const Vec3d& reference)
  : scene_(scene)
  , reference_(reference)
{
  for (const SurfaceObject& object : scene.surfaces)
  {
    const Mat3d linear(object.toWorld);
    const double stretch =
      std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
    toLocal_.push_back(glm::inverse(object.toWorld));
    rounding_.push_back(
      withSurface(object.surface, [](const auto& s) { return s.rounding(); }) * stretch);
    stretch_.push_back(pixelsOfError(object) > 0.0 ? stretch : 0.0);
    anyErrs_ = anyErrs_ || stretch_.back() > 0.0;
    if (scene.surfaces.size() < 2)
      continue;
    Box box = worldBounds(object);
    box = box.expanded(rounding_.back() + 1e-9 * glm::length(box.size()));
    bounds_.push_back(box.empty() ? box : Box{box.lower - reference, box.upper - reference});
  }
}

double SceneRays::clearance(std::int32_t index, std::uint64_t slot, double cosine) const
{
  const double local = withSurface(this->surface(index).surface,
    [&](const auto& s)
    {
      if constexpr (std::decay_t<decltype(s)>::mayErr)
        return s.clearance(slot, cosine);
      else
        return s.rounding() / cosine;
    });
  return stretch_[static_cast<std::size_t>(index)] * local;
}

namespace
{

/// Whether a ray of the packet may meet the box: false only where none does.
bool mayMeet(const RayPacket& rays, const Box& box)
{
  bool any = false;
  for (int i = 0; i < rays.count; ++i)
  {
    double from = rays.tMin[i], to = rays.t[i];
    for (int axis = 0; axis < 3; ++axis)
    {
      // A direction of 0 makes infinities, or NaN in the box's face, which both comparisons pass
      // over.
      const double reciprocal = 1.0 / rays.direction[axis][i];
      const double a = (box.lower[axis] - rays.origin[axis][i]) * reciprocal;
      const double b = (box.upper[axis] - rays.origin[axis][i]) * reciprocal;
      const double first = a < b ? a : b, last = a < b ? b : a;
      from = first > from ? first : from;
      to = last < to ? last : to;
    }
    any = any || from <= to;
  }
  return any;
}

} // namespace

/// Calls visit(surface, packet, index) for each surface that `takes` accepts, the packet holding
/// the rays in the surface's coordinates, and of those that leave it no more than what lies behind
/// their departure; their answers come back into `rays`.
template <bool isNearest, typename Takes, typename Visit>
void SceneRays::forSurfaces(
  RayPacket& rays, const Departures* from, const Takes& takes, const Visit& visit) const
{
  RayPacket local;
  local.count = rays.count;
  local.onSurface = rays.onSurface;
  std::copy_n(rays.tMin, rays.count, local.tMin);
  std::copy_n(rays.t, rays.count, local.t);
  std::copy_n(rays.slot, rays.count, local.slot);
  std::copy_n(rays.object, rays.count, local.object);
  for (std::size_t k = 0; k < toLocal_.size(); ++k)
  {
    if (!takes(scene_.surfaces[k]))
      continue;
    if (!bounds_.empty())
    {
      std::copy_n(local.t, rays.count, rays.t); // rays that found something end there
      if (!mayMeet(rays, bounds_[k]))
        continue;
    }
    const Mat3d linear(toLocal_[k]);
    const Vec3d origin = transformPoint(toLocal_[k], reference_);
    for (int i = 0; i < rays.count; ++i)
    {
      const Vec3d at =
        origin + linear * Vec3d(rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]);
      const Vec3d way =
        linear * Vec3d(rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]);
      for (int axis = 0; axis < 3; ++axis)
      {
        local.origin[axis][i] = at[axis];
        local.direction[axis][i] = way[axis];
      }
    }
    if (anyErrs_ && from != nullptr)
      for (int i = 0; i < rays.count; ++i)
        local.tMin[i] =
          from->surface[i] == static_cast<std::int32_t>(k) ? from->until[i] : rays.tMin[i];
    local.footprint = localWidth(static_cast<std::int32_t>(k), rays.footprint);
    local.footprintPerT = localWidth(static_cast<std::int32_t>(k), rays.footprintPerT);
    const SurfaceObject& object = scene_.surfaces[k];
    withSurface(object.surface,
      [&](const auto& s)
      {
        const auto look = [&](RayPacket& some) { visit(s, some, static_cast<std::int32_t>(k)); };
        if (object.clip.isAll())
          return look(local);
        ClippedPacket clipped(object.clip, local,
          [&](int i, const auto& with)
          {
            with(reference_ + Vec3d(rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]),
              Vec3d(rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]));
          });
        if constexpr (isNearest)
          clipped.castNearest(local, s, static_cast<std::int32_t>(k));
        else
          clipped.cast(local, look);
      });
  }
  std::copy_n(local.t, rays.count, rays.t);
  std::copy_n(local.slot, rays.count, rays.slot);
  std::copy_n(local.object, rays.count, rays.object);
}

namespace
{

constexpr auto all = [](const SurfaceObject&) { return true; };
constexpr auto keepSky = [](const SurfaceObject& object) { return object.keepsSky(); };
constexpr auto casters = [](const SurfaceObject& object) { return object.castsShadows; };
constexpr auto castAt = [](const auto& s, RayPacket& rays, std::int32_t k) { s.cast(rays, k); };
constexpr auto occludeAt = [](const auto& s, RayPacket& rays, std::int32_t k)
{ s.occlude(rays, k); };

} // namespace

void SceneRays::cast(RayPacket& rays, const Departures* from) const
{
  this->forSurfaces<true>(rays, from, all, castAt);
}

void SceneRays::castAtKeepers(RayPacket& rays, const Departures* from) const
{
  this->forSurfaces<true>(rays, from, keepSky, castAt);
}

void SceneRays::occlude(RayPacket& rays, const Departures* from) const
{
  this->forSurfaces<false>(rays, from, keepSky, occludeAt);
}

void SceneRays::shadow(RayPacket& rays, const Departures* from) const
{
  this->forSurfaces<false>(rays, from, casters, occludeAt);
}

} // namespace mote
