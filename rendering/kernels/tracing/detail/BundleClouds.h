#pragma once

#include "../../core/Camera.h"
#include "../../core/Film.h"
#include "CloudTracer.h"

#include <deque>

namespace mote
{

/// The clouds of a scene in one sample of a film, a bundle of rays at a time.
class BundleClouds
{
public:
  using Place = CellWalk::Place;
  using Part = CellWalk::Part;
  static constexpr int mostParts = CellWalk::mostRays; ///< that gather() takes

  /// All must outlive this; `lights` count from where `rays` has its o0.
  BundleClouds(const Scene& scene, const CameraRays& rays, const std::vector<ShadedLight>& lights,
    const Film& film);

  /// What lies on the parts of up to mostParts rays: premultiplied colour and what comes through.
  void gather(const Part* parts, int count, RayColor* colors) const;

private:
  using Runs = std::vector<RayRun>;
  void gather(std::size_t cloud, const Part* parts, int count, RayColor* colors, Runs* runs) const;
  void gatherClipped(
    std::size_t cloud, const Part* parts, int count, RayColor* colors, Runs* runs) const;
  void gatherWhole(
    std::size_t cloud, const Part* parts, int count, RayColor* colors, Runs* runs) const;

  const CameraRays& rays_;
  std::deque<CloudTracer> tracers_;
  std::vector<BundleFrustum::Sides> sides_; ///< a cloud each
};

} // namespace mote
