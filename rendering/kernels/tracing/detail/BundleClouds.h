#pragma once

#include "../../core/Camera.h"
#include "CloudTracer.h"

#include <deque>

namespace mote
{

/// The clouds of a scene in one sample of a film, a bundle of rays at a time.
class BundleClouds
{
public:
  /// Where a ray of a bundle runs in the world, as its place in the image.
  struct Place
  {
    double x = 0.0, y = 0.0;
  };

  /// The part of a ray from `from` to `to`.
  struct Part
  {
    Place place;
    double from = 0.0, to = 0.0;
  };

  /// All must outlive this; `lights` count from where `rays` has its o0.
  BundleClouds(const Scene& scene, const CameraRays& rays, const std::vector<ShadedLight>& lights,
    int filmSample);

  /// What lies on the parts of up to 64 rays: premultiplied colour and what comes through.
  void gather(const Part* parts, int count, RayColor* colors) const;

private:
  const CameraRays& rays_;
  std::deque<CloudTracer> tracers_;
  std::vector<BundleFrustum::Sides> sides_; ///< a cloud each
};

} // namespace mote
