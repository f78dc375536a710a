#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cmath>

namespace mote
{

using Vec3f = glm::vec3;
using Vec4f = glm::vec4;
using Vec3d = glm::dvec3;
using Vec4d = glm::dvec4;
using Vec3i = glm::ivec3;
using Mat3d = glm::dmat3;
using Mat4d = glm::dmat4;

/// Applies an affine 4x4 matrix to a point.
inline Vec3d transformPoint(const Mat4d& m, const Vec3d& p)
{
  return Vec3d(m * Vec4d(p, 1.0));
}

/// How much longer lengths become by an affine matrix, on average over directions.
inline double scaleOf(const Mat4d& m)
{
  return std::cbrt(std::abs(glm::determinant(Mat3d(m))));
}

/// Applies the linear part of an affine 4x4 matrix to a vector.
inline Vec3d transformVector(const Mat4d& m, const Vec3d& v)
{
  return Vec3d(m * Vec4d(v, 0.0));
}

} // namespace mote
