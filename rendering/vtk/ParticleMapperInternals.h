#pragma once

#include "vtkMoteParticleMapper.h"

#include "ParticleInput.h"
#include "RendererImage.h"

#include "kernels/particles/ParticleStructure.h"

#include "vtkTimeStamp.h"

#include <string>

/// What vtkMoteParticleMapper keeps between frames. Its methods stand in two files: input,
/// structure and drawing in vtkMoteParticleMapper.cxx, colours and visibility in
/// ParticleMapperColors.cxx.
class vtkMoteParticleMapper::Internals
{
public:
  /// What the structure was built from, and which particles it was told to show.
  using Key = mote::InputKey;

  mote::RadiusChoice choice;
  std::shared_ptr<mote::ParticleStructure> structure;
  Key structureKey;
  Key visibilityKey;
  vtkTimeStamp builtAt;
  double commonRadius = 0.0;
  double buildTime = 0.0;
  int builds = 0;
  std::string reported; ///< last error, so that it is told once and not every frame

  mote::DataArrayView colorValues;
  Key colorValuesKey;
  vtkSmartPointer<vtkDataArray> directColors;
  Key directKey;
  std::string arrayError;
  std::string reportedColors; ///< the same for colours

  std::string reportedFrame; ///< the same for drawing
  bool reportedClipping = false;
  mote::RendererImages images; ///< for renderers that have no vtkMoteRayCastPass

  template <typename Get>
  auto fromStructure(const Get& get, decltype(get(mote::CoherentGrid{})) otherwise) const
  {
    return structure ? mote::withStructure(*structure, get) : otherwise;
  }
};
