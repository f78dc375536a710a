#ifndef MoteLAMMPSVelocities_h
#define MoteLAMMPSVelocities_h

#include "LAMMPSPolyData.h"

#include <string>
#include <vector>

namespace mote
{

/// The arrays that a frame's own section of velocities makes; none where it has no such section.
std::vector<std::string> velocityArrays(const LAMMPSFrame& frame, bool combine);

/// Adds these arrays to the atoms in `output`, which have an array "id": to each the velocity of
/// the same id, or 0. Every piece passes over all velocities. Throws FileError.
void addLAMMPSVelocities(const std::string& path, const LAMMPSFrame& frame,
  const LAMMPSReadOptions& options, const Progress& progress, vtkPolyData* output);

} // namespace mote

#endif
