#pragma once

#include "vtkMoteParticleMapper.h"

#include "MapperOcclusion.h"
#include "ParticleInput.h"
#include "ParticleSelection.h"
#include "RendererImage.h"
#include "StructureBuild.h"

#include "kernels/particles/ParticleStructure.h"

#include "vtkTimeStamp.h"

#include <chrono>
#include <memory>
#include <set>
#include <string>
#include <vector>

/// What vtkMoteParticleMapper keeps between frames. Its methods stand in five files: input,
/// structure and drawing in vtkMoteParticleMapper.cxx, colours in ParticleMapperColors.cxx, ranges
/// in ParticleMapperRanges.cxx, occlusion maps in ParticleMapperOcclusion.cxx, the preview and what
/// is built behind it in ParticleMapperPreview.cxx.
class vtkMoteParticleMapper::Internals
{
public:
  /// What the structure was built from.
  using Key = mote::InputKey;

  /// A range that the user wants of an array.
  struct ArrayRange
  {
    std::string name;
    int component;
    double low, high;
  };

  /// What is known of a preview, and of all that it stands for.
  struct PreviewFacts
  {
    mote::ParticleStatistics whole;
    double enlargement = 1.0;
    std::size_t particles = 0; ///< that are drawn or hidden by range
  };

  mote::RadiusChoice choice;
  std::shared_ptr<mote::ScratchSpace> space; ///< for structures that are built, or null
  std::shared_ptr<mote::ParticleStructure> structure;
  Key structureKey;
  vtkTimeStamp builtAt;
  double commonRadius = 0.0;
  double buildTime = 0.0;
  int builds = 0;
  std::string reported; ///< last error, so that it is told once and not every frame

  std::vector<ArrayRange> ranges;
  mote::PlaceRanges places;
  mote::ParticleSelection selection;
  std::set<std::string> rangeErrors; ///< those that hold now, told when they began to

  mote::MapperOcclusion occlusion;

  mote::DataArrayView colorValues;
  Key colorValuesKey;
  vtkSmartPointer<vtkDataArray> directColors;
  Key directKey;
  std::string reportedColors; ///< the same for colours

  std::string reportedFrame; ///< the same for drawing
  bool reportedClipping = false;
  mote::RendererImages images; ///< for renderers that have no vtkMoteRayCastPass

  std::unique_ptr<PreviewFacts> preview; ///< where `structure` is that of a preview
  std::chrono::steady_clock::time_point buildStart;
  bool exactOnly = false;  ///< somebody waits for the exact structure
  bool continuing = false; ///< in ContinueBuild()
  std::unique_ptr<mote::StructureBuild> build;

  template <typename Get>
  auto fromStructure(const Get& get, decltype(get(mote::CoherentGrid{})) otherwise) const
  {
    return structure ? mote::withStructure(*structure, get) : otherwise;
  }

  /// Of all particles that can be drawn, also while a part of them is.
  mote::ParticleStatistics statistics() const
  {
    return preview ? preview->whole
                   : fromStructure(
                       [](const auto& s) { return s.statistics(); }, mote::ParticleStatistics{});
  }
};
