#pragma once

#include "../../core/Camera.h"
#include "../../hexahedra/CellWalk.h"
#include "../../hexahedra/LineBundle.h"
#include "../../hexahedra/RayColor.h"
#include "../../scene/Cloud.h"
#include "SceneLighting.h"

#include <optional>

namespace mote
{

/// A ray on its way through a cloud: in the mesh's coordinates, and how long its direction is in
/// the world.
struct CloudRay
{
  HexRay local;
  double speed = 1.0;
};

/// Traces rays through one cloud of a scene, for one sample of a film.
class CloudTracer
{
public:
  /// The cloud must outlive this and stay where it is. `lights` light it where it wants that, seen
  /// from `reference`, and must outlive this too. Throws Error where there is no structure or
  /// field, and for bad settings.
  CloudTracer(const CloudObject& cloud, const std::vector<ShadedLight>& lights,
    const Vec3d& reference, int filmSample);

  CloudTracer(const CloudTracer&) = delete;
  CloudTracer& operator=(const CloudTracer&) = delete;

  /// The ray with this origin and direction in the world, between tMin and tMax.
  CloudRay ray(const Vec3d& origin, const Vec3d& direction, double tMin, double tMax) const;

  /// Gathers the cloud's colour along the ray.
  template <typename Counts = NoCounts>
  void gather(const CloudRay& ray, RayGatherer& gatherer, Counts&& counts = {}) const;

  /// The same for a bundle of 1 to 64 rays, a gatherer each.
  void gather(const CloudRay* rays, int count, const BundleFrustum::Sides& sides,
    RayGatherer* const* gatherers) const;

  /// Makes a walk(), once for a view: for rays of this camera in an image of so many pixels. False
  /// where rays must go through the structure.
  bool lookFrom(const CameraRays& rays, int width, int height);
  /// Gathers rays of that camera from cell to cell; null where there is none.
  const CellWalk* walk() const { return walk_ ? &*walk_ : nullptr; }

  const ClipRegion& clip() const { return cloud_.clip; }

  /// How the rays of a camera differ from pixel to pixel, in the coordinates of the mesh.
  BundleFrustum::Sides sidesOf(const CameraRays& rays) const;

private:
  template <typename With>
  void withIntegrator(const HexMesh& mesh, const With& with) const;
  template <typename Integrator, typename Make>
  bool gatherTogether(const CartesianBvh& bvh, const CloudRay* rays, int count,
    const BundleFrustum::Sides& sides, RayGatherer* const* gatherers, const Make& make) const;
  /// What queries of the structure keep.
  auto keep() const
  {
    return [this](const ScalarRange& range)
    { return settings_.transfer.isVisible(range.lower, range.upper); };
  }
  /// Whether rays go through a cell as if it were not there.
  bool isHidden(std::uint32_t cell) const { return cloud_.hidden && (*cloud_.hidden)[cell]; }
  const CloudLighting* lighting() const { return lighting_ ? &lighting_ : nullptr; }

  const CloudObject& cloud_;
  Mat4d toLocal_;
  Mat3d normalToWorld_;
  CloudSettings settings_;
  CloudLighting lighting_;
  std::optional<CellWalk> walk_;
};

} // namespace mote
