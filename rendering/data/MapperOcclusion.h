#pragma once

#include "MoteRenderingDataModule.h" // For export macro
#include "ParticleInput.h"

#include "kernels/shading/ParticleOcclusion.h"

#include "vtkTimeStamp.h"

#include <functional>
#include <string>

class vtkFieldData;

namespace mote
{

/// The occlusion maps that a picture wants of a mapper.
struct OcclusionRequest
{
  OcclusionBakeOptions options; ///< in the units of the mapper's particles
  bool reachChosen = false;     ///< whether the user has said how far rays go
};

/// The particles of a mapper as of its last Update().
struct MappedParticles
{
  const ParticleStructure& structure;
  const InputKey& key;                  ///< what the structure was built from
  vtkMTimeType changed;                 ///< when it, or what it shows, last did
  vtkFieldData* field;                  ///< of the input, where maps may lie; or null
  std::function<ParticleInput()> input; ///< asked only where maps lie there
};

/// The occlusion maps that a vtkMoteParticleMapper keeps between frames: those of its input, where
/// they belong to its particles, and those that were baked for a picture.
class MOTERENDERINGDATA_EXPORT MapperOcclusion
{
public:
  /// Brings what is known up to date with particles and request. Returns a sentence where maps of
  /// the input cannot be used, once for each; or nothing.
  std::string update(const MappedParticles& particles, const OcclusionRequest& request);

  /// Bakes those of the particles that have no map; see ParticleOcclusion::bake(). After update().
  bool bake(
    const ParticleStructure& structure, const ParticleBits& wanted, const Progress& progress);

  /// Whether there are maps, and of the structure that was built from `key`.
  bool isOf(const InputKey& key) const { return known_.maps() && key == structureKey_; }
  /// By slot of that structure.
  const std::shared_ptr<const OcclusionMaps>& maps() const { return known_.maps(); }
  /// Whether they know every particle that is shown.
  bool complete() const { return complete_; }
  /// Changes with the maps.
  vtkMTimeType time() const { return at_.GetMTime(); }

private:
  std::string begin(const MappedParticles& particles, const OcclusionRequest& request);
  void noteChange(const std::shared_ptr<const OcclusionMaps>& before);

  ParticleOcclusion known_;
  InputKey structureKey_;       ///< of the structure that the maps belong to
  InputKey requestKey_;         ///< of what was asked, and of the input's maps
  vtkMTimeType seenChange_ = 0; ///< of the particles
  bool complete_ = false;
  vtkTimeStamp at_;
};

} // namespace mote
