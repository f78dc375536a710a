#include "BundleFrustum.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

/// A range that grows a little more than roundings do.
struct WideRange
{
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;

  void add(double x)
  {
    lower = std::min(lower, x);
    upper = std::max(upper, x);
  }
  void widen()
  {
    const double by = 1e-6 * (upper - lower) + 1e-12 * std::max(std::abs(lower), std::abs(upper));
    lower -= by;
    upper += by;
  }
};

} // namespace

BundleFrustum::BundleFrustum(const HexRay* rays, int count, const Sides& sides, const Vec3d& origin)
  : tMin_(std::numeric_limits<double>::infinity())
  , tMax_(-tMin_)
{
  // Coordinates in which every ray goes by 1 along the third axis per t, and by its slopes along
  // the others.
  const Vec3d from = rays[0].origin;
  const Mat3d inverse = glm::inverse(Mat3d(sides.x, sides.y, rays[0].direction));
  const Mat3d rows = glm::transpose(inverse);
  const double size = glm::length(rows[0]) + glm::length(rows[1]) + glm::length(rows[2]);
  exists_ = std::isfinite(size);
  WideRange slopes[2], starts[2];
  for (int i = 0; i < count; ++i)
  {
    const Vec3d slope = inverse * rays[i].direction, start = inverse * (rays[i].origin - from);
    for (int k = 0; k < 2; ++k)
    {
      slopes[k].add(slope[k]);
      starts[k].add(start[k]);
    }
    exists_ = exists_ && std::abs(slope.z - 1.0) <= 1e-9 &&
              (rays[i].origin == from || rays[i].direction == rays[0].direction);
    tMin_ = std::min(tMin_, rays[i].tMin);
    tMax_ = std::max(tMax_, rays[i].tMax);
  }
  for (int k = 0; k < 2; ++k)
  {
    slopes[k].widen();
    starts[k].widen();
    planes_[2 * k].normal = rows[k] - slopes[k].upper * rows[2];
    planes_[2 * k].at = starts[k].upper;
    planes_[2 * k + 1].normal = slopes[k].lower * rows[2] - rows[k];
    planes_[2 * k + 1].at = -starts[k].lower;
  }
  for (Plane& plane : planes_)
    plane.at += glm::dot(plane.normal, from - origin);
  along_ = {rows[2], glm::dot(rows[2], from - origin)};
  // Behind the origin the planes would be crossed.
  exists_ = exists_ && tMin_ >= 0.0;
}

} // namespace mote
