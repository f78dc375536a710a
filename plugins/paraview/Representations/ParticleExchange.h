#pragma once

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkMultiProcessController;

namespace mote
{

/// What each rank is to have of the particles of this one, by their numbers.
struct ParticleShares
{
  explicit ParticleShares(int ranks)
    : own(ranks)
    , ghosts(ranks)
  {
  }

  std::vector<std::vector<vtkIdType>> own, ghosts;
};

/// Sends all ranks their shares, and joins what this rank receives: its own particles first, then
/// the ghosts, which vtkGhostType marks where `isMarked`. `whenSent` is called when all has left,
/// so that what is not needed any more can be freed before the rest is joined. All ranks must call
/// it together.
vtkSmartPointer<vtkPolyData> exchangeParticles(vtkMultiProcessController* controller,
  vtkSmartPointer<vtkPolyData> from, ParticleShares shares, bool isMarked,
  const std::function<void()>& whenSent);

} // namespace mote
