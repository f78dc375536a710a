#pragma once

#include "Vec.h"

#include <limits>
#include <optional>
#include <vector>

namespace mote
{

/// A half of space: the points p with dot(normal, p - point) >= 0.
struct ClipPlane
{
  Vec3d point{0.0};
  Vec3d normal{0.0, 0.0, 1.0}; ///< of any length but 0

  bool operator==(const ClipPlane&) const = default;
};

/// A piece of a hollow cylinder: the points whose cylindrical coordinates lie in three ranges, of
/// which each includes its ends.
struct ClipCylinder
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Vec3d center{0.0};              ///< on the axis, where the height is 0
  Vec3d axis{0.0, 0.0, 1.0};      ///< of any length but 0
  Vec3d zeroAngle{1.0, 0.0, 0.0}; ///< where the angle is 0; not along the axis
  double radius[2] = {0.0, infinity};
  double height[2] = {-infinity, infinity};
  /// In radians, by the right-hand rule about the axis, from the first on to the second; all angles
  /// where they are a whole turn apart or more.
  double angle[2] = {0.0, infinity};

  bool operator==(const ClipCylinder&) const = default;
};

/// A part of a ray: tIn <= t <= tOut.
struct RaySpan
{
  double tIn = 0.0, tOut = 0.0;
};

/// What of space an object is shown in: where all planes and the cylinder agree.
struct ClipRegion
{
  std::vector<ClipPlane> planes;
  std::optional<ClipCylinder> cylinder;
  /// What is no farther than this outside of a plane, a half-plane or a range counts as inside: so
  /// surfaces that lie in one are shown whole, however hits on them are rounded.
  double tolerance = 0.0;

  bool isAll() const { return planes.empty() && !cylinder; }
  bool contains(const Vec3d& point) const;

  /// Parts of a ray that lie in the region, in their order and apart from one another, between tMin
  /// and tMax; how many. Their ends are rounded like any number of t.
  static constexpr int mostSpans = 3;
  int spansOf(const Vec3d& origin, const Vec3d& direction, double tMin, double tMax,
    RaySpan spans[mostSpans]) const;

  /// The unit normal, outwards, of the face of the region that a point lies on, where it lies no
  /// farther than `tolerance` from one.
  std::optional<Vec3d> faceAt(const Vec3d& point, double tolerance) const;

  bool operator==(const ClipRegion&) const = default;
};

} // namespace mote
