#pragma once

#include "../Options.h"
#include "AmbientMethods.h"
#include "EmbreeBake.h"

#include <algorithm>
#include <memory>

namespace mote::bench
{

/// Bit slot % 64 of word slot / 64: particles that are baked; empty: all.
using SlotBits = std::vector<std::uint64_t>;

/// Maps and what they took.
struct BakedMaps
{
  std::string mode; ///< of Embree, or of the structure
  std::shared_ptr<const OcclusionMaps> maps;
  OcclusionBakeStatistics statistics;

  double bytesPerParticle() const
  {
    return static_cast<double>(maps->bytes()) / static_cast<double>(maps->size());
  }
  /// Texels, and the byte that every particle takes.
  double bytesPerBaked() const
  {
    return 1.0 + static_cast<double>(maps->texels().size()) /
                   static_cast<double>(std::max<std::size_t>(1, statistics.particles));
  }
};

/// Bakes the particles of one structure by any method.
class AmbientBaker
{
public:
  /// All must outlive the baker. `reach` is in world units.
  AmbientBaker(const Options& options, const ParticleInput& input,
    const ParticleStructure& structure, double reach);

  /// Bakes those particles on so many threads.
  BakedMaps bake(const AmbientMethod& method, const SlotBits& slots, int threads);

  /// The same with one ray a texel, unless `method` is adaptive and its texels depend on them: maps
  /// that are looked up as fast as well-baked ones.
  BakedMaps bakeQuickly(const AmbientMethod& method, const SlotBits& slots, int threads);

  /// The way in which Embree is fastest, found by a bake of some of those particles in each.
  std::size_t bestEmbreeMode(const SlotBits& slots, int threads);

  /// At most `count` or so of those particles, in runs of neighbours.
  SlotBits thinned(const SlotBits& slots, std::size_t count) const;
  std::size_t count(const SlotBits& slots) const;

private:
  OcclusionBakeOptions baking(
    const AmbientMethod& method, const SlotBits& slots, int threads, std::size_t mode);

  int samples_; ///< rays a texel
  const ParticleInput& input_;
  const ParticleStructure& structure_;
  std::size_t size_; ///< slots
  double reach_;
  std::unique_ptr<EmbreeBake> embree_; ///< made when first asked for
  std::size_t embreeMode_ = 0;
  bool embreeModeKnown_ = false;
};

} // namespace mote::bench
