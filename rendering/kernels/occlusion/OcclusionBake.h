#pragma once

#include "../core/Progress.h"
#include "../core/RayPacket.h"
#include "OcclusionMaps.h"

#include <array>
#include <functional>

namespace mote
{

/// How occlusion maps are baked.
struct OcclusionBakeOptions
{
  int side = 16; ///< texels along a side of the largest maps: 1, 2, 4, 8, 16 or 32
  /// Rays a texel, about: those whose neighbourhood is mixed ask 1.7 times as many, others a
  /// quarter. [4, 65536], values outside are clamped.
  int samples = 49;
  /// How far away particles occlude, in the particles' unit of length; 0: a tenth of the longest
  /// side of their bounds, whether or not they are shown. May be infinite.
  double reach = 0.0;
  OcclusionSky sky;
  /// Whether each particle has as few texels and rays as `tolerance` allows, or all have `side` x
  /// `side` texels.
  bool adaptive = true;
  /// Error that a coarser map of a particle may have, as a share of the brightest sky: root mean
  /// square over the surface, in which each place counts by its chance to be seen, its open share.
  /// It is what maps of half as many texels a side as the largest may have; coarser ones may have
  /// less, in proportion to their side.
  double tolerance = 0.005;
  /// Whether texels that lie inside of other particles are filled from their neighbours; if not,
  /// they are dark.
  bool dilate = true;
  /// Which slots to bake, of those that are shown; called from several threads. Empty: all that
  /// the maps known before do not know.
  std::function<bool(std::size_t slot)> selected;
  int threads = 0; ///< 0: as many as there are cores
  /// Answers what RayPacket's rays meet, as occlude() of the structures does, in their place: all
  /// rays of the bake go there, one direction after the other. Called from several threads.
  std::function<void(RayPacket&)> occlude;
};

/// What a bake has done.
struct OcclusionBakeStatistics
{
  std::size_t particles = 0; ///< baked
  std::size_t rays = 0;      ///< answered, by whatever means
  double seconds = 0.0;      ///< on the wall
  bool finished = true;      ///< false: interrupted; particles that were not reached are not baked
  std::array<std::size_t, OcclusionMaps::Open + 1> levels{}; ///< particles baked to each

  double raysPerSecond() const { return seconds > 0.0 ? double(rays) / seconds : 0.0; }
};

/// Finds how much of the sky each particle's surface sees past the other particles of the
/// structure, those that are shown.
///
/// Each texel asks rays from its middle, or, where that lies inside of another particle, from a
/// place of it that does not (jittered over the texel, rays would be blurred with it): in
/// directions spread evenly over the half of space above, turned at random for each particle and
/// weighted by their cosine to the normal. Texels that lie inside as a whole, of 9 jittered places,
/// ask none. Other particles count from a rounding distance off the surface, as in
/// AmbientOcclusion. The answer depends neither on the number of threads nor, but for rounding, on
/// the kind of structure where that knows input indices.
///
/// Particles that `known` knows and that are not selected keep their maps; `known` must be of as
/// many particles and of the same sky, and should be of the same reach. Others that are not baked
/// are NotBaked. Where `progress` answers false, what is baked by then is returned. Throws Error
/// for options without meaning. Source: Bigler, "Use of Silhouette Edges and Ambient Occlusion in
/// Particle Visualization", University of Utah, 2004; docs/ambient-occlusion.md.
OcclusionMaps bakeOcclusion(const ParticleStructure& structure,
  const OcclusionBakeOptions& options = {}, const Progress& progress = {},
  OcclusionBakeStatistics* statistics = nullptr, const OcclusionMaps* known = nullptr);

/// The reach that the options mean, in the particles' unit of length.
double occlusionReach(const ParticleStructure& structure, const OcclusionBakeOptions& options);

/// Which particles are shown, a bit a slot, the first lowest.
std::vector<std::uint64_t> shownBits(const ParticleStructure& structure);

/// What of the maps still holds after a change of what is shown, baked with `reach`: particles are
/// NotBaked that have one within reach whose bit in `shownBefore`, the shownBits() then, differs
/// from now, and a few beside them. Baked anew with the answer as what is known, they are as if all
/// had been baked. Hidden particles keep their maps. Throws Error where sizes do not fit.
OcclusionMaps stillValid(const OcclusionMaps& maps, const ParticleStructure& structure,
  const std::vector<std::uint64_t>& shownBefore, double reach);

} // namespace mote
