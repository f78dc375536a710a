#pragma once

#include "../core/RayPacket.h"
#include "Scene.h"

#include <vector>

namespace mote
{

/// Casts packets of rays that run in the world through the structures of all objects of a scene.
class SceneRays
{
public:
  /// Origins of rays count from `reference`, a point in the world. The scene must outlive this.
  SceneRays(const Scene& scene, const Vec3d& reference);

  /// Finds for each ray the nearest hit with tMin < t < rays.t, and where there is one writes t,
  /// slot and object.
  void cast(RayPacket& rays) const;

  /// Looks for anything between tMin and t of each ray; where there is, t becomes -infinity. The
  /// particle that a ray's slot and object name does not count.
  void occlude(RayPacket& rays) const;

  const Scene& scene() const { return scene_; }
  const Vec3d& reference() const { return reference_; }
  /// From the world to the coordinates of an object of particles.
  const Mat4d& toLocal(std::size_t object) const { return toLocal_[object]; }
  /// How far positions on an object's surfaces (volumes are numbered after particles) may be wrong,
  /// in world units, because of float numbers relative to its middle (docs/shadows.md tells the
  /// measurement).
  double rounding(std::size_t object) const { return rounding_[object]; }

private:
  template <typename Visit>
  void forObjects(RayPacket& rays, const Visit& visit) const;

  const Scene& scene_;
  Vec3d reference_;
  std::vector<Mat4d> toLocal_;   ///< of the particles' objects
  std::vector<double> rounding_; ///< of the particles' objects and of the volumes
};

} // namespace mote
