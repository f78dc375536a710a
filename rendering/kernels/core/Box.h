#pragma once

#include "Vec.h"

#include <glm/common.hpp>

#include <limits>

namespace mote
{

/// An axis-aligned box in double; empty while lower > upper.
struct Box
{
  Vec3d lower{std::numeric_limits<double>::infinity()};
  Vec3d upper{-std::numeric_limits<double>::infinity()};

  bool empty() const { return lower.x > upper.x || lower.y > upper.y || lower.z > upper.z; }
  Vec3d size() const { return empty() ? Vec3d(0.0) : upper - lower; }
  Vec3d center() const { return empty() ? Vec3d(0.0) : lower + 0.5 * (upper - lower); }

  void add(const Vec3d& p)
  {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  void add(const Box& b)
  {
    lower = glm::min(lower, b.lower);
    upper = glm::max(upper, b.upper);
  }
  /// The box grown by `margin` on every side.
  Box expanded(double margin) const
  {
    return empty() ? *this : Box{lower - Vec3d(margin), upper + Vec3d(margin)};
  }
};

} // namespace mote
