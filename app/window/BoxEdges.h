#pragma once

#include "settings/Colors.h"
#include "stage/Stage.h"

#include <vtkActor.h>
#include <vtkNew.h>

#include <vector>

namespace mote::app
{

/// The edges of the simulation box, or of the bounds, of some parts.
class BoxEdges
{
public:
  explicit BoxEdges(vtkRenderer* renderer);

  /// Follows the data of these parts; none of them: no box.
  void update(const Stage& stage, const std::vector<std::size_t>& parts);
  void setInk(const Color& ink, const double ground[3]);

private:
  vtkNew<vtkActor> actor_;
};

} // namespace mote::app
