#ifndef MoteOcclusionArrays_h
#define MoteOcclusionArrays_h

#include "MoteFiltersParticlesModule.h" // For export macro

#include "kernels/occlusion/OcclusionFile.h"

#include <optional>

class vtkFieldData;

namespace mote
{

/// Occlusion maps as arrays of a data set's field data, as vtkMoteAmbientOcclusionBaker describes
/// them. Adding replaces those that are there.
MOTEFILTERSPARTICLES_EXPORT void addOcclusionArrays(
  vtkFieldData* field, const StoredOcclusion& stored);

/// Reads them again; none where there are none. Throws Error, in one sentence, where they
/// contradict one another.
MOTEFILTERSPARTICLES_EXPORT std::optional<StoredOcclusion> findOcclusionArrays(vtkFieldData* field);

/// When they were last changed; 0 where there are none. Costs nothing.
MOTEFILTERSPARTICLES_EXPORT unsigned long long occlusionArraysTime(vtkFieldData* field);

} // namespace mote

#endif
