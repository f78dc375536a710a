#pragma once

#include "OcclusionBake.h"
#include "OcclusionFile.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace mote
{

/// A bit a particle: bit k % 64 of word k / 64. No words at all stand for all bits set.
using ParticleBits = std::vector<std::uint64_t>;

inline bool hasBit(const ParticleBits& bits, std::size_t k)
{
  return bits.empty() || (bits[k / 64] >> (k % 64) & 1) != 0;
}

/// Whether the maps were baked with these settings, `reach` being a number.
bool wereBakedWith(const StoredOcclusion& stored, const OcclusionBakeOptions& options);

/// The occlusion maps of the particles of one structure: what is known of them, and what a change
/// of what is shown leaves of that. All members take that same structure.
class ParticleOcclusion
{
public:
  /// Forgets all. The options hold from now on, but for `selected`; their `reach` becomes a number.
  void begin(const ParticleStructure& structure, const OcclusionBakeOptions& options);

  /// The same with maps that there are already, and their settings in place of the options'. What
  /// the structure shows may differ from what it did then. Throws Error where the maps are of fewer
  /// particles than the structure's input.
  void begin(const ParticleStructure& structure, const OcclusionBakeOptions& options,
    const StoredOcclusion& stored);

  /// Takes up what the structure shows now; see stillValid().
  void update(const ParticleStructure& structure);

  /// Bakes those of the `wanted` particles that are shown and have no map. False where `progress`
  /// stopped it; what was baked until then stays. Throws Error as bakeOcclusion() does.
  bool bake(
    const ParticleStructure& structure, const ParticleBits& wanted, const Progress& progress = {});
  /// How many bake() would bake.
  std::size_t countMissing(const ParticleBits& wanted = {}) const;

  /// By slot; null before begin(). What it points to never changes.
  const std::shared_ptr<const OcclusionMaps>& maps() const { return maps_; }
  const OcclusionBakeOptions& options() const { return options_; }
  /// Of all that was baked since begin().
  const OcclusionBakeStatistics& statistics() const { return statistics_; }

  /// The maps by index of the input, of `inputs` particles with that content.
  StoredOcclusion stored(
    const ParticleStructure& structure, std::size_t inputs, const ContentHash& content) const;

private:
  bool isMissing(const ParticleBits& wanted, std::size_t slot) const
  {
    return !maps_->isBaked(slot) && hasBit(shown_, slot) && hasBit(wanted, slot);
  }

  std::shared_ptr<const OcclusionMaps> maps_;
  ParticleBits shown_; ///< shownBits(), as the maps know it
  OcclusionBakeOptions options_;
  OcclusionBakeStatistics statistics_;
};

} // namespace mote
