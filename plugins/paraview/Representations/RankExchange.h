#pragma once

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkMultiProcessController;

namespace mote
{

/// What each rank is to have of the particles or polygons of this one, by their numbers.
struct RankShares
{
  RankShares(int ranks, bool areCells)
    : own(ranks)
    , ghosts(ranks)
    , ofCells(areCells)
  {
  }

  std::vector<std::vector<vtkIdType>> own, ghosts;
  bool ofCells; ///< polygons, else particles
};

/// Sends all ranks their shares, and joins what this rank receives. vtkGhostType, of points or
/// cells, marks ghosts where `isMarked`. `whenSent` is called when all has left,
/// so that what is not needed any more can be freed before the rest is joined. All ranks must call
/// it together.
vtkSmartPointer<vtkPolyData> exchange(vtkMultiProcessController* controller,
  vtkSmartPointer<vtkPolyData> from, RankShares shares, bool isMarked,
  const std::function<void()>& whenSent);

/// Parts one after another, with the arrays that all have. Several lose their arrays.
vtkSmartPointer<vtkPolyData> joined(const std::vector<vtkSmartPointer<vtkPolyData>>& parts);

} // namespace mote
