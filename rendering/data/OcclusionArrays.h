#ifndef MoteOcclusionArrays_h
#define MoteOcclusionArrays_h

#include "MoteRenderingDataModule.h" // For export macro

#include "kernels/occlusion/OcclusionFile.h"

#include <optional>

class vtkFieldData;

namespace mote
{

/// Occlusion maps as arrays of a data set's field data, as vtkMoteAmbientOcclusionBaker describes
/// them. Adding replaces those that are there.
MOTERENDERINGDATA_EXPORT void addOcclusionArrays(
  vtkFieldData* field, const StoredOcclusion& stored);

/// Reads them again; none where there are none. Throws Error, in one sentence, where they
/// contradict one another.
MOTERENDERINGDATA_EXPORT std::optional<StoredOcclusion> findOcclusionArrays(vtkFieldData* field);

/// When they were last changed; 0 where there are none. Costs nothing.
MOTERENDERINGDATA_EXPORT unsigned long long occlusionArraysTime(vtkFieldData* field);

} // namespace mote

#endif
