#pragma once

#include "stage/ParticlePaths.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

class vtkRenderer;

namespace mote::app
{

/// The paths of the particles of some data sets, as lines in a view.
class PathLines
{
public:
  explicit PathLines(vtkRenderer* renderer);

  /// Shows the paths as far as they are read; null: none.
  void update(const ParticlePaths* paths, const std::vector<std::size_t>& parts);

private:
  vtkNew<vtkPolyData> lines_;
  vtkNew<vtkActor> actor_;
};

} // namespace mote::app
