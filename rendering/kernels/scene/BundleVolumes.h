#pragma once

#include "../core/Camera.h"
#include "VolumeTracer.h"

#include <deque>

namespace mote
{

/// The volumes of a scene in one sample of a film: what BundleTracer asks of them, a bundle of rays
/// at a time.
class BundleVolumes
{
public:
  /// Where ray i of a bundle runs in the world, as its place in the image.
  struct Place
  {
    double x = 0.0, y = 0.0;
  };
  /// The iso-surfaces that a bundle's rays meet first.
  struct Surfaces
  {
    int count = 0;
    std::uint16_t ray[RayBundle::capacity];
    std::int32_t volume[RayBundle::capacity];
    IsoHit hit[RayBundle::capacity];
  };

  /// All must outlive this; `lighting` counts from where `rays` has its o0.
  BundleVolumes(
    const Scene& scene, const CameraRays& rays, const SceneLighting& lighting, int filmSample);

  bool hasSurfaces() const { return hasSurfaces_; }

  /// Looks for iso-surfaces nearer than rays.t; where there are, t, slot and object become theirs.
  /// `placeOf(i)` tells where ray i runs.
  template <typename PlaceOf>
  void cast(RayBundle& rays, const PlaceOf& placeOf, Surfaces& surfaces) const
  {
    surfaces.count = 0;
    for (int i = 0; hasSurfaces_ && i < rays.count; ++i)
      castRay(rays, i, placeOf(i), surfaces);
  }

  /// Shades the surfaces of one volume into the block, those that no nearer one hides. Seeds must
  /// be filled where the lighting has occlusion; `seed` does that.
  template <typename Seed>
  void shade(std::int32_t volume, const RayBundle& rays, const Surfaces& surfaces,
    SurfaceBlock& block, double footprint, const Place* places, const Seed& seed) const
  {
    gather(volume, rays, surfaces, block, places);
    if (block.count == 0)
      return;
    seed(block);
    lightSurfaces(
      block, tracers_[static_cast<std::size_t>(volume)].volume().material, lighting_, footprint);
  }

  /// What lies in front of t on up to 64 rays: premultiplied colour and what comes through.
  void clouds(const Place* places, const double* t, int count, RayColor* colors) const;

private:
  void castRay(RayBundle& rays, int i, const Place& place, Surfaces& surfaces) const;
  void gather(std::int32_t volume, const RayBundle& rays, const Surfaces& surfaces,
    SurfaceBlock& block, const Place* places) const;

  const CameraRays& rays_;
  const SceneLighting& lighting_;
  std::size_t particles_; ///< objects of the scene before the volumes
  std::deque<VolumeTracer> tracers_;
  std::vector<BundleFrustum::Sides> sides_; ///< a volume each
  int clouds_ = 0;
  bool hasSurfaces_ = false;
};

} // namespace mote
