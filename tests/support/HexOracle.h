#pragma once

#include <kernels/hexahedra/HexMesh.h>

#include <glm/vec3.hpp>

namespace mote::testing
{

/// A trilinear cell in long double, by nothing but its definition: a point is inside where Newton's
/// method, from many places within the cell, finds coordinates in [0, 1]^3. Slow.
class HexOracle
{
public:
  using Vec = glm::tvec3<long double>;

  explicit HexOracle(const HexCorners& corners);

  /// The coordinates of a point in the cell, if it is in it.
  bool coordinates(const Vec3d& p, Vec& rst) const;
  bool contains(const Vec3d& p) const;
  /// The length of the part of a segment in the cell, in units of the segment: found by `samples`
  /// even samples and bisection between those that differ.
  double share(const Vec3d& from, const Vec3d& to, int samples = 400) const;

private:
  bool newton(const Vec& target, Vec& rst) const;

  Vec corners_[8];
};

} // namespace mote::testing
