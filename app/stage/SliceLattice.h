#pragma once

#include <vtkMoteSlice.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>

#include <array>

namespace mote::app
{

/// Places that lie evenly on a slice, at the corners of a lattice of triangles.
class SliceLattice
{
public:
  /// Where the slice lies near a box; the slice must outlive this.
  SliceLattice(vtkMoteSlice* slice, const double bounds[6]);

  /// Of the piece of the slice that places lie on.
  double area() const;
  /// Places, each for about this area.
  vtkSmartPointer<vtkPoints> places(double areaOfEach) const;

  /// The slice's normal, of unit length, at a place on it.
  std::array<double, 3> normalAt(const std::array<double, 3>& place) const;

private:
  using Vec = std::array<double, 3>;
  bool isRound() const { return slice_->GetShape() == vtkMoteSlice::CYLINDER; }

  vtkMoteSlice* slice_;
  Vec center_{}, axis_{}, across_{}, along_{}; ///< the last two lie in a plane, or about an axis
  double low_[2], high_[2];                    ///< lengths along both; round: of the arc
};

} // namespace mote::app
