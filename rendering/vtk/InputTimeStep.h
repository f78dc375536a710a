#pragma once

class vtkAlgorithm;

namespace mote
{

/// vtkAlgorithm::UpdateTimeStep() for an algorithm without outputs, of which that cannot ask for a
/// time: brings the input of port 0 up to date for it. False where there is none, or it fails.
bool updateInputTimeStep(vtkAlgorithm* algorithm, double time, int piece, int pieces,
  int ghostLevels, const int extents[6]);

} // namespace mote
