#pragma once

#include "kernels/core/Box.h"
#include "kernels/core/Vec.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <vector>

namespace mote
{

/// Copies of what is drawn, evenly around an axis: of a sector they are the whole wheel. The first
/// turns nothing; one alone where the axis has no direction.
inline std::vector<Mat4d> rotatedCopies(int count, const double center[3], const double axis[3])
{
  std::vector<Mat4d> turns = {Mat4d(1.0)};
  const Vec3d middle(center[0], center[1], center[2]), direction(axis[0], axis[1], axis[2]);
  const double length = glm::length(direction);
  for (int k = 1; k < count && length > 0.0 && std::isfinite(length); ++k)
    turns.push_back(glm::translate(Mat4d(1.0), middle) *
                    glm::rotate(Mat4d(1.0), 2.0 * M_PI * k / count, direction / length) *
                    glm::translate(Mat4d(1.0), -middle));
  return turns;
}

/// Bounds of a box and its copies.
inline Box withRotatedCopies(
  const Box& box, int count, const double center[3], const double axis[3])
{
  Box all;
  for (const Mat4d& turn : rotatedCopies(box.empty() ? 0 : count, center, axis))
    for (int corner = 0; corner < 8 && !box.empty(); ++corner)
      all.add(Vec3d(
        turn * Vec4d(corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
                 corner & 4 ? box.upper.z : box.lower.z, 1.0)));
  return all;
}

} // namespace mote
