#pragma once

#include "HexMesh.h"

#include <array>

namespace mote
{

/// One value for each corner of a cell.
using CornerValues = std::array<double, 8>;

/// A trilinear cell in its own coordinates: counted from its middle, so that cells far from the
/// origin lose nothing. (r, s, t) in [0, 1]^3 with the corners in VTK's order; a wedge's, pyramid's
/// or tetrahedron's corners coincide.
///
/// Everything is in double: a cell at a time, float is no faster, and Newton in double needs
/// no second try.
class TrilinearCell
{
public:
  explicit TrilinearCell(const HexCorners& corners);
  TrilinearCell(const HexMesh& mesh, std::size_t cell)
    : TrilinearCell(mesh.corners(cell))
  {
  }

  /// The point with the cell's coordinates `rst`.
  Vec3d point(const Vec3d& rst) const { return origin_ + local(rst); }

  /// Which (r, s, t) gives the point `p`, found by Newton's method from `start`. True where the
  /// method converged; inside or not is not asked here (see CellCrossings.h), so `rst` may lie
  /// outside of [0, 1]^3. Where it does not converge, damped steps from several places within the
  /// cell follow, and `rst` is the best that was found, within [0, 1]^3.
  bool coordinates(const Vec3d& p, Vec3d& rst, const Vec3d& start = Vec3d(0.5)) const;

  /// The same by Newton's method alone, where that converges; else false.
  bool converges(const Vec3d& p, Vec3d& rst) const;

  /// The same, but no farther than it takes to tell on which side of the
  /// cell's faces the point lies.
  bool settles(const Vec3d& p, Vec3d& rst) const;

  /// The trilinear weights of the eight corners at `rst`; their sum is 1.
  static CornerValues weights(const Vec3d& rst);

  /// The weights 1/d of the eight corners at the point `p`, d being the corner's distance, divided
  /// by their sum: the interpolation of Wang, Elshehaly and Cao. At a corner the corner's weight is
  /// 1, shared among corners that coincide.
  CornerValues inverseDistanceWeights(const Vec3d& p) const;

  /// The gradient in space of the trilinear interpolant of `values` at `rst`. Where corners
  /// coincide and the coordinates are singular, it is taken a little nearer to the middle.
  Vec3d gradient(const CornerValues& values, const Vec3d& rst) const;

  const HexCorners& corners() const { return corners_; }

private:
  Vec3d local(const Vec3d& rst) const;
  /// The columns are the derivatives along r, s and t.
  Mat3d jacobian(const Vec3d& rst) const;
  template <typename IsEnough>
  bool newton(const Vec3d& target, Vec3d& rst, const IsEnough& isEnough) const;
  void search(const Vec3d& target, Vec3d& rst) const;

  HexCorners corners_;
  Vec3d origin_;
  std::array<Vec3d, 8> c_; ///< of 1, r, s, t, rs, st, tr, rst
};

/// The value at `weights` of what the corners have.
inline double weighted(const CornerValues& values, const CornerValues& weights)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < 8; ++i)
    sum += values[i] * weights[i];
  return sum;
}

/// How far a trilinear value may be from a line between its values at the ends of a straight way
/// within the cell, at most: by what is not linear in the cell's own coordinates, and by what makes
/// a straight way bend in these, with the Jacobian's change over the cell bounded by the same
/// numbers. What is linear in space has no bend and is taken off before. Never more than the range
/// of the values.
double bendOf(const HexCorners& corners, const CornerValues& values);

/// A cell's signed volume, and the range of its Jacobian determinant over the corners and the
/// points of the 2 x 2 x 2 Gauss rule, which is exact for the volume.
struct JacobianRange
{
  double volume = 0.0;
  double smallest = 0.0;
  double largest = 0.0;
};
JacobianRange jacobianRange(const HexCorners& corners);

} // namespace mote
