#ifndef MoteMeridionalBins_h
#define MoteMeridionalBins_h

#include "CollapsedCell.h"

#include <vector>

class vtkDataArray;
class vtkDataSet;

namespace mote
{

/// A line in space.
struct Axis
{
  Vec3d origin{0.0}, direction{0.0, 0.0, 1.0}; ///< of length 1

  double along(const Vec3d& p) const { return glm::dot(p - origin, direction); }
  double from(const Vec3d& p) const { return glm::length(this->outwards(p)); }
  /// From the axis to the point, square to it.
  Vec3d outwards(const Vec3d& p) const
  {
    const Vec3d d = p - origin;
    return d - glm::dot(d, direction) * direction;
  }
};

/// What is averaged: places along an axis and distances from it, both ends included.
struct Limits
{
  double axial[2], radial[2];
};

/// Square bins in the plane of the place along an axis and the distance from it.
struct BinGrid
{
  int axial = 0, radial = 0;       ///< how many
  double size = 1.0;               ///< a bin's edge
  Limits limits;                   ///< what lies outside belongs to no bin
  double first = 0.0, inner = 0.0; ///< where bins begin along the axis, and away from it

  std::size_t count() const { return static_cast<std::size_t>(axial) * radial; }
  /// The bin of a point; those at the rim count to the last one inside. count(): none.
  std::size_t at(double along, double from) const;
};

/// Bins of which the longer edge of what the points of the data sets reach has `resolution`, as far
/// as they lie within limits.
BinGrid binsFor(
  const std::vector<vtkDataSet*>& data, const Axis& axis, const Limits& limits, int resolution);

/// The integrals over the part of the volume that falls into a bin.
struct Bin
{
  double volume = 0.0;
  /// Of the value and the square of its difference from a middle; of vectors of the parts along
  /// axis, radius and circumference, and of the magnitude.
  double sums[4] = {0.0, 0.0, 0.0, 0.0};
};

/// Adds a data set's cells. The array lies on its points or cells, and has one or three components.
/// `middle` is a value within the range of a scalar. Returns how many cells were left out for a
/// value that is not finite.
vtkIdType addToBins(std::vector<Bin>& bins, const BinGrid& grid, const Axis& axis, vtkDataSet* data,
  vtkDataArray* array, bool ofCells, double middle);

} // namespace mote

#endif
