#pragma once

#include <kernels/core/Vec.h>

namespace mote::bench
{

/// The part of a triangle that lies in a box: a convex polygon, in double.
class ClippedTriangle
{
public:
  static constexpr int capacity = 9; ///< each side of the box may cut one more corner off

  ClippedTriangle(const Vec3d& a, const Vec3d& b, const Vec3d& c)
    : points_{a, b, c}
  {
  }

  /// Cuts away what lies outside of a box. What lies in its sides stays.
  void clip(const float low[3], const float high[3]);

  int count() const { return count_; } ///< of points, 0 where nothing is left
  const Vec3d& point(int k) const { return points_[k]; }

private:
  void cut(int axis, double bound, double sign);

  Vec3d points_[capacity];
  int count_ = 3;
};

} // namespace mote::bench
