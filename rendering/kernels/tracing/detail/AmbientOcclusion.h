#pragma once

#include "SceneRays.h"
#include "SurfaceBlock.h"

namespace mote
{

/// Finds how much of an even sky the surfaces see: the share of cosine-weighted directions about
/// the normal along which nothing stands within reach.
///
/// The share is an estimate by a few rays a hit, stratified, different from pixel to pixel, and
/// moving on with the film sample: the mean over film samples tends to the exact share. A
/// particle that is lit is left out, being convex: a lone sphere is open everywhere. All else
/// counts from where rounding could no longer confuse it with the surface, so that spheres which
/// coincide do not darken one another in speckles. A surface that is seen from within its sphere
/// has that sphere's far side before it. Source: Zhukov, Iones, Kronin, "An Ambient Light
/// Illumination Model", Rendering Techniques 1998; docs/ambient-occlusion.md.
class AmbientOcclusion
{
public:
  /// For the options that the scene of `rays` has, and one sample of a film.
  AmbientOcclusion(const SceneRays& rays, int filmSample);

  /// Finds the open share of the sky of the block's hits, or where `shares` knows some already of
  /// those alone that are NaN there. Takes positions, normals, sides and seeds.
  void findShares(const SurfaceBlock& block, float* shares, bool known) const;

private:
  struct Work;

  void cast(Work& work) const;

  const SceneRays& rays_;
  int count_; ///< rays a hit
  double reach_;
  std::uint32_t first_; ///< of the sample points of this film sample
};

} // namespace mote
