#pragma once

#include "../../core/Camera.h"
#include "../../scene/Scene.h"

#include <vector>

namespace mote
{

/// The camera's bundles against all surfaces of a scene.
class CameraCasts
{
public:
  /// The scene must outlive this.
  CameraCasts(const Scene& scene, const CameraRays& rays);

  /// The camera's rays in the coordinates of a surface.
  const CameraRays& local(std::size_t surface) const { return local_[surface]; }

  /// Finds the nearest hits of the bundle of that side at (x0, y0), filled by fillBundle(). It is
  /// in the coordinates of the last surface afterwards.
  void cast(RayBundle& rays, int side, int x0, int y0, double jitterX, double jitterY) const;

private:
  const Scene& scene_;
  CameraRays rays_;
  std::vector<CameraRays> local_;
};

} // namespace mote
