#pragma once

#include "MoteRenderingDataModule.h" // For export macro
#include "ParticleInput.h"

#include "kernels/occlusion/ParticleOcclusion.h"

#include "vtkTimeStamp.h"

#include <functional>
#include <optional>
#include <string>

namespace mote
{

/// The occlusion maps that a picture wants of a mapper.
struct OcclusionRequest
{
  OcclusionBakeOptions options; ///< in the units of the mapper's particles
  bool reachChosen = false;     ///< whether the user has said how far rays go
  /// For frames that move: takes what comes with a structure that is new, such as another time
  /// step's, and leaves all else as it is.
  bool isMoving = false;
};

/// Gives maps that are there already, or none. Throws Error where there are some that cannot be
/// used.
using FindMaps = std::function<std::optional<StoredOcclusion>()>;

/// The occlusion maps that a ParticleModel keeps between frames and runs: those that somebody else
/// has made, where they belong to its particles, and those that were baked here.
class MOTERENDERINGDATA_EXPORT MapperOcclusion
{
public:
  /// Brings what is known up to date with a structure, known by what it was built from and by when
  /// it, or what it shows, last changed, and with options. `find` is asked where another structure,
  /// other options, or another `key`, which stands for all else that it depends on, ask for other
  /// maps. Returns a sentence where what it found cannot be used, once for each; or nothing.
  std::string update(const ParticleStructure& structure, const InputKey& structureKey,
    vtkMTimeType changed, const OcclusionBakeOptions& options, const InputKey& key,
    const FindMaps& find);

  /// Bakes those of the particles that have no map; see ParticleOcclusion::bake(). After update().
  bool bake(
    const ParticleStructure& structure, const ParticleBits& wanted, const Progress& progress);

  /// Whether there are maps, and of the structure that was built from `key`.
  bool isOf(const InputKey& key) const { return known_.maps() && key == structureKey_; }
  /// By slot of that structure.
  const std::shared_ptr<const OcclusionMaps>& maps() const { return known_.maps(); }
  const ParticleOcclusion& known() const { return known_; }
  /// Whether they know every particle that is shown.
  bool complete() const { return complete_; }
  /// Changes with the maps.
  vtkMTimeType time() const { return at_.GetMTime(); }

private:
  void noteChange(const std::shared_ptr<const OcclusionMaps>& before);

  ParticleOcclusion known_;
  InputKey structureKey_;       ///< of the structure that the maps belong to
  InputKey requestKey_;         ///< of what was asked
  vtkMTimeType seenChange_ = 0; ///< of the particles
  bool complete_ = false;
  vtkTimeStamp at_;
};

} // namespace mote
