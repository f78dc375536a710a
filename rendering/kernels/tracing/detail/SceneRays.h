#pragma once

#include "../../core/RayPacket.h"
#include "../../scene/Scene.h"

#include <vector>

namespace mote
{

/// What the rays of a packet leave, where that may err: an R-LOD, say.
struct Departures
{
  std::int32_t surface[RayPacket::capacity]; ///< index in the scene, or -1: nothing that errs
  double until[RayPacket::capacity];         ///< hits of this surface at t <= until do not count
};

/// Casts packets of rays that run in the world at all surfaces of a scene. Rays name surfaces by
/// their index in Scene::surfaces.
class SceneRays
{
public:
  /// Origins of rays count from `reference`, a point in the world. The scene must outlive this.
  SceneRays(const Scene& scene, const Vec3d& reference);

  /// Finds for each ray the nearest hit with tMin < t < rays.t, and where there is one writes t,
  /// slot and object. Departures are those that leave() has filled in, for rays that all begin on
  /// surfaces; without them all surfaces count from tMin on.
  void cast(RayPacket& rays, const Departures* from = nullptr) const;

  /// The same of those surfaces alone that keep the sky's light: see SurfaceObject::keepsSky().
  void castAtKeepers(RayPacket& rays, const Departures* from) const;

  /// Looks for anything that keeps the sky's light between tMin and t of each ray; where there is,
  /// t becomes -infinity. See SurfaceKind for what does not count.
  void occlude(RayPacket& rays, const Departures* from = nullptr) const;
  /// The same for those surfaces alone that cast shadows.
  void shadow(RayPacket& rays, const Departures* from = nullptr) const;

  /// Lets ray i begin at a hit on a surface, at that cosine to its normal. Nothing is in its way
  /// that only rounding puts there, and nothing of this surface that only an allowed error does.
  void leave(RayPacket& rays, int i, Departures& from, std::int32_t index, std::uint64_t slot,
    double cosine) const
  {
    rays.tMin[i] = this->rounding(index) / cosine;
    if (!anyErrs_)
      return;
    from.surface[i] = this->errs(index) ? index : -1;
    if (this->errs(index))
      from.until[i] = this->clearance(index, slot, cosine);
  }

  const Scene& scene() const { return scene_; }
  const Vec3d& reference() const { return reference_; }
  const SurfaceObject& surface(std::int32_t index) const
  {
    return scene_.surfaces[static_cast<std::size_t>(index)];
  }
  /// From the world to the coordinates of a surface.
  const Mat4d& toLocal(std::int32_t index) const
  {
    return toLocal_[static_cast<std::size_t>(index)];
  }
  /// How far positions on a surface may be wrong, in world units, because of float numbers relative
  /// to its middle (docs/shadows.md tells the measurement).
  double rounding(std::int32_t index) const { return rounding_[static_cast<std::size_t>(index)]; }
  /// Whether hits on a surface may lie off it by an allowed error.
  bool errs(std::int32_t index) const { return stretch_[static_cast<std::size_t>(index)] > 0.0; }
  /// How far a ray goes in the world from a hit on a surface that errs, at that cosine to its
  /// normal, before nothing of this surface can be in its way because of rounding or the error.
  double clearance(std::int32_t index, std::uint64_t slot, double cosine) const;
  /// A width in the world as one in the coordinates of a surface that may err, or less; 0 for those
  /// that may not.
  double localWidth(std::int32_t index, double width) const
  {
    const double stretch = stretch_[static_cast<std::size_t>(index)];
    return stretch > 0.0 ? width / stretch : 0.0;
  }

private:
  template <bool isNearest, typename Takes, typename Visit>
  void forSurfaces(
    RayPacket& rays, const Departures* from, const Takes& takes, const Visit& visit) const;

  const Scene& scene_;
  Vec3d reference_;
  std::vector<Mat4d> toLocal_;
  std::vector<double> rounding_;
  std::vector<double> stretch_; ///< largest, to the world, of surfaces whose hits may err; else 0
  bool anyErrs_ = false;
  std::vector<Box> bounds_; ///< of each surface, from the reference; none where there is but one
};

} // namespace mote
