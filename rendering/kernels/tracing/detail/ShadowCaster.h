#pragma once

#include "SceneRays.h"
#include "SurfaceBlock.h"

namespace mote
{

/// Finds which hits a light sample does not reach, by bundles of rays with the sample as their
/// common origin (or common direction) at all surfaces that cast shadows.
///
/// What is shown casts a full shadow, whatever its opacity. A particle that is lit is left out,
/// being convex: it shadows only the side of it that faces away, which Lambert's law leaves dark.
/// All else counts up to where rounding could confuse it with the surface that is lit, so that
/// spheres which coincide do not shadow one another in speckles. A surface seen from within its
/// sphere is lit by what lies within and by nothing else. Source: Gribble et al.,
/// UUSCI-2006-024, section on soft shadows; docs/shadows.md.
class ShadowCaster
{
public:
  /// Positions and light samples count from the rays' reference point.
  explicit ShadowCaster(const SceneRays& rays);

  /// Sets cosine and shine to 0 where something stands between the hit and the sample. Casts rays
  /// to the hits with a cosine above 0 and to no others. `footprint` is the width in the world that
  /// the block's camera bundle has at its hits: bundles of shadow rays become not much wider.
  void remove(SurfaceBlock& block, const LightSample& sample, double footprint) const;

private:
  struct Work;

  bool reachesWithin(const SurfaceBlock& block, int i, const LightSample& sample) const;
  void cast(Work& work, std::uint16_t* hits, int count) const;
  void castTogether(Work& work, const std::uint16_t* hits, int count) const;

  const SceneRays& rays_;
  Box bounds_; ///< of the scene, from the reference point
};

} // namespace mote
