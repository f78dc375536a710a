#pragma once

#include "kernels/core/Vec.h"
#include "kernels/meshes/RlodTree.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace mote
{

class SurfaceFaces;

/// Finds which faces of other surfaces lie on those of a surface and look at them, whatever corners
/// the two have: a rotor's at its stator's, with other numbers of cells around.
///
/// A face is covered where all places in it that are tried, four for each of its triangles, are.
/// Two meshes of one curved surface lie apart by what their flat faces cut off, an eighth of the
/// side's length times the angle by which the surface turns along it. So much is allowed, with a
/// margin, by the angles between neighbouring faces; where both are flat a thousandth of the
/// shortest side, and what coordinates are rounded by. Sides that come together at a sharp trailing
/// edge are farther apart.
class SurfaceCover
{
public:
  /// Keeps `faces`, which must outlive it.
  explicit SurfaceCover(const SurfaceFaces& faces);

  /// Whether a triangle of the surface may cover one of the others.
  using PairFilter = std::function<bool(std::size_t other, std::size_t own)>;
  /// Sets the marks of the triangles of `others`, turned, which this surface covers to 1; those of
  /// faces that are marked are not looked at.
  void mark(const SurfaceCover& others, const Mat4d& turn, std::vector<std::uint8_t>& marks,
    const PairFilter& mayCover = {}) const;

private:
  using MayCover = std::function<bool(std::size_t own)>; ///< triangle
  bool isCovered(
    const Vec3d& place, const Vec3d& normal, double distance, const MayCover& mayCover) const;
  bool coversFace(const SurfaceCover& others, std::size_t face, const Mat4d& turn,
    const MayCover& mayCover) const;
  /// How far from each face others may lie.
  static std::vector<double> distancesOf(const SurfaceFaces& faces);

  const SurfaceFaces* faces_;
  RlodTree tree_;
  std::vector<double> distances_;   ///< of the faces
  double farthest_ = 0.0;           ///< of these
  std::vector<std::size_t> faceOf_; ///< of the triangles
};

} // namespace mote
