#include "detail/PatchSums.h"

#include "../core/RayBundle.h"

#include <algorithm>
#include <cmath>

namespace mote
{

PatchSums PatchSums::joined(const PatchSums* parts, int count)
{
  PatchSums all;
  Vec3d plain(0.0);
  for (int k = 0; k < count; ++k)
  {
    all.weight += parts[k].weight;
    all.middle += parts[k].weight * parts[k].middle;
    all.normal += parts[k].normal;
    plain += parts[k].middle;
  }
  if (!(all.weight > 0.0))
  {
    all.middle = count > 0 ? plain / double(count) : plain;
    return all;
  }
  all.middle /= all.weight;
  for (int k = 0; k < count; ++k)
  {
    const Vec3d d = parts[k].middle - all.middle;
    const double products[6] = {d.x * d.x, d.y * d.y, d.z * d.z, d.x * d.y, d.x * d.z, d.y * d.z};
    for (int i = 0; i < 6; ++i)
      all.moments[i] += parts[k].moments[i] + parts[k].weight * products[i];
  }
  return all;
}

namespace
{

/// A symmetric matrix: xx, yy, zz, xy, xz, yz.
struct Symmetric
{
  double m[6];

  double trace() const { return m[0] + m[1] + m[2]; }
  Symmetric scaled(double s) const
  {
    return {{m[0] * s, m[1] * s, m[2] * s, m[3] * s, m[4] * s, m[5] * s}};
  }
  /// The matrix of cofactors: it has the same eigenvectors, each with the product of the two other
  /// eigenvalues.
  Symmetric adjugate() const
  {
    return {{m[1] * m[2] - m[5] * m[5], m[0] * m[2] - m[4] * m[4], m[0] * m[1] - m[3] * m[3],
      m[4] * m[5] - m[3] * m[2], m[3] * m[5] - m[4] * m[1], m[3] * m[4] - m[0] * m[5]}};
  }
  Symmetric squared() const
  {
    const double xy = m[3] * m[3], xz = m[4] * m[4], yz = m[5] * m[5];
    return {{m[0] * m[0] + xy + xz, m[1] * m[1] + xy + yz, m[2] * m[2] + xz + yz,
      m[3] * (m[0] + m[1]) + m[4] * m[5], m[4] * (m[0] + m[2]) + m[3] * m[5],
      m[5] * (m[1] + m[2]) + m[3] * m[4]}};
  }
  /// The longest column, which in powers of a matrix is along the largest eigenvalue's vector.
  Vec3d longestColumn() const
  {
    const Vec3d columns[3] = {{m[0], m[3], m[4]}, {m[3], m[1], m[5]}, {m[4], m[5], m[2]}};
    const int k = m[0] >= m[1] ? (m[0] >= m[2] ? 0 : 2) : (m[1] >= m[2] ? 1 : 2);
    return columns[k];
  }
};

/// The unit eigenvector of the largest eigenvalue of a matrix without negative ones and with a
/// trace of 1, by squaring it until nothing else is left. Where the largest two are nearly equal
/// any vector between theirs is as good.
Vec3d greatestAxis(Symmetric power)
{
  for (int step = 0; step < 12; ++step)
  {
    power = power.squared();
    const double share = power.trace(); // 1 where there is one eigenvalue alone
    power = power.scaled(1.0 / share);
    if (share > 1.0 - 1e-14)
      break;
  }
  return glm::normalize(power.longestColumn());
}

Vec3d unitOr(const Vec3d& v, const Vec3d& other)
{
  const double length = glm::length(v);
  return length > 0.0 ? v / length : other;
}

} // namespace

Vec3d leastAxis(const double moments[6], const Vec3d& towards)
{
  constexpr double least = 1e-280;
  Symmetric m;
  std::copy_n(moments, 6, m.m);
  const double size = m.trace();
  if (!(size > least)) // a point
    return unitOr(towards, {0.0, 0.0, 1.0});
  m = m.scaled(1.0 / size);
  const Symmetric cofactors = m.adjugate();
  // About the share of the second eigenvalue: below, rounding decides, and the patch is a needle.
  const double width = cofactors.trace();
  if (!(width > 1e-11))
  {
    const Vec3d along = greatestAxis(m);
    Vec3d a, b;
    acrossAxes(along, a, b);
    const Vec3d across = towards - glm::dot(towards, along) * along;
    return glm::dot(across, across) > 1e-12 * glm::dot(towards, towards) ? glm::normalize(across)
                                                                         : a;
  }
  const Vec3d axis = greatestAxis(cofactors.scaled(1.0 / width));
  return glm::dot(axis, towards) < 0.0 ? -axis : axis;
}

} // namespace mote
