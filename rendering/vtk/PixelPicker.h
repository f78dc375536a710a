#pragma once

#include "kernels/core/Camera.h"
#include "kernels/tracing/CloudPicking.h"
#include "kernels/tracing/Picking.h"

#include <optional>

namespace mote
{

/// What a ray meets: a surface, or else a cell of a cloud.
struct RayPick
{
  std::optional<ScenePick> surface;
  std::optional<CloudPick> cell;
};

/// Looks along rays of a camera. A cloud that keeps back more than half of the light before a
/// surface is what is seen, and the surface is not.
class PixelPicker
{
public:
  /// The scene must outlive this. Without `clouds` these are not looked at.
  PixelPicker(const Scene& scene, const CameraRays& rays, bool clouds)
    : scene_(scene)
    , rays_(rays)
    , clouds_(scene)
    , looksAtClouds_(clouds && !scene.clouds.empty())
  {
  }

  /// At a place in the image, in pixels. Any number of threads may ask.
  RayPick at(double x, double y, CloudPicker::Wanted wanted) const
  {
    const Vec3d origin = rays_.originAt(x, y), direction = rays_.directionAt(x, y);
    RayPick found{pick(scene_, origin, direction, rays_.tMin, rays_.tMax), {}};
    if (!looksAtClouds_)
      return found;
    const double end = found.surface ? found.surface->t : rays_.tMax;
    found.cell = clouds_.pick(origin, direction, rays_.tMin, end, wanted);
    if (found.surface && found.cell && !(found.cell->opacity > 0.5))
      found.cell.reset();
    if (found.cell)
      found.surface.reset();
    return found;
  }

private:
  const Scene& scene_;
  const CameraRays& rays_;
  CloudPicker clouds_;
  bool looksAtClouds_;
};

} // namespace mote
