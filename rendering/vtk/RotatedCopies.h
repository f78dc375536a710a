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

/// The direction in the data of a component of vectors in the world, of data that are drawn so
/// placed: by it a vector that turns with them has that component. 0 where it is the data's own
/// component, and where there is none.
inline Vec3d componentAlong(const Mat4d& toWorld, int component)
{
  if (component < 0 || component > 2)
    return Vec3d(0.0);
  Vec3d along, own(0.0);
  own[component] = 1.0;
  for (int k = 0; k < 3; ++k)
  {
    const Vec3d way(toWorld[k]); // where the data's axis goes
    const double length = glm::length(way);
    along[k] = length > 0.0 ? way[component] / length : 0.0;
  }
  constexpr double rounding = 1e-12;
  return glm::length(along - own) > rounding ? along : Vec3d(0.0);
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
