#pragma once

#include "../core/Camera.h"
#include "../hexahedra/IsoCrossing.h"
#include "../hexahedra/LineBundle.h"
#include "../hexahedra/RayColor.h"
#include "../shading/Shader.h"
#include "Volume.h"

#include <optional>

namespace mote
{

/// A ray on its way through a volume: in the mesh's coordinates, and how long its direction is in
/// the world.
struct VolumeRay
{
  HexRay local;
  double speed = 1.0;
};

/// Traces rays through one volume of a scene, for one sample of a film.
class VolumeTracer
{
public:
  /// The volume must outlive this and stay where it is. `lights` light clouds that want it, seen
  /// from `reference`, and must outlive this too. Throws Error where there is no structure or
  /// field, and for bad settings.
  VolumeTracer(const VolumeObject& volume, const std::vector<ShadedLight>& lights,
    const Vec3d& reference, int filmSample);

  VolumeTracer(const VolumeTracer&) = delete;
  VolumeTracer& operator=(const VolumeTracer&) = delete;

  const VolumeObject& volume() const { return volume_; }
  bool hasSurfaces() const { return !values_.empty(); }
  bool hasCloud() const { return volume_.isCloud; }

  /// The ray with this origin and direction in the world, between tMin and tMax.
  VolumeRay ray(const Vec3d& origin, const Vec3d& direction, double tMin, double tMax) const;

  /// The first iso-surface on the ray.
  template <typename Counts = NoCounts>
  std::optional<IsoHit> surface(const VolumeRay& ray, Counts&& counts = {}) const;
  /// Gathers the cloud's colour along the ray.
  template <typename Counts = NoCounts>
  void gather(const VolumeRay& ray, RayGatherer& gatherer, Counts&& counts = {}) const;

  /// The same for a bundle of 1 to 64 rays, a gatherer each.
  void gather(const VolumeRay* rays, int count, const BundleFrustum::Sides& sides,
    RayGatherer* const* gatherers) const;

  /// How the rays of a camera differ from pixel to pixel, in the coordinates of the mesh.
  BundleFrustum::Sides sidesOf(const CameraRays& rays) const;

  /// Of an iso-surface, with an opacity of 1.
  Vec4f colorOf(const IsoHit& hit) const { return colors_[hit.surface]; }
  std::uint64_t inputCell(const IsoHit& hit) const;
  /// Across an iso-surface, of unit length or 0, in the world.
  Vec3d normalOf(const IsoHit& hit) const;

private:
  template <typename With>
  void withIntegrator(const HexMesh& mesh, const With& with) const;
  template <typename Integrator, typename Make>
  bool gatherTogether(const CartesianBvh& bvh, const VolumeRay* rays, int count,
    const BundleFrustum::Sides& sides, RayGatherer* const* gatherers, const Make& make) const;
  /// What queries of the structure keep for the cloud.
  auto keep() const
  {
    return [this](const ScalarRange& range)
    { return settings_.transfer.isVisible(range.lower, range.upper); };
  }
  const CloudLighting* lighting() const { return lighting_ ? &lighting_ : nullptr; }

  const VolumeObject& volume_;
  Mat4d toLocal_;
  Mat3d normalToWorld_;
  CloudSettings settings_;
  CloudLighting lighting_;
  std::vector<double> values_; ///< of iso-surfaces, from the field's offset
  std::vector<Vec4f> colors_;
};

} // namespace mote
