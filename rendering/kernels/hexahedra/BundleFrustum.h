#pragma once

#include "HexRay.h"
#include "SpaceBounds.h"

namespace mote
{

/// What holds a bundle of rays with a common origin or a common direction: four planes along the
/// rays, and two across. Bounds of which it tells that no ray meets them meet none; of others it
/// may be wrong.
class BundleFrustum
{
public:
  /// How neighbouring rays of the bundle differ, in their directions or, where these are the same,
  /// in their origins; any lengths. Planes are tight where the rays fill a parallelogram of these
  /// sides.
  struct Sides
  {
    Vec3d x, y;
  };

  /// Everything counts from `origin`. At least one ray; their directions must be as long across
  /// the sides, as a camera's are.
  BundleFrustum(const HexRay* rays, int count, const Sides& sides, const Vec3d& origin);

  /// Whether it could be made: not of other rays, of rays in one plane with the sides, or where t
  /// begins below 0.
  bool exists() const { return exists_; }

  /// Whether a ray may meet the bounds. If so, `t` is the least t at which one could.
  bool meets(const SpaceBounds& bounds, double& t) const
  {
    const Vec3d lower = bounds.from(), upper = bounds.to();
    const Vec3d middle = 0.5 * (lower + upper), half = 0.5 * (upper - lower);
    for (const Plane& plane : planes_)
      if (glm::dot(plane.normal, middle) - glm::dot(glm::abs(plane.normal), half) > plane.at)
        return false;
    const double at = glm::dot(along_.normal, middle) - along_.at;
    const double reach = glm::dot(glm::abs(along_.normal), half);
    t = at - reach > tMin_ ? at - reach : tMin_;
    return at - reach <= tMax_ && at + reach >= tMin_;
  }

private:
  struct Plane
  {
    Vec3d normal{0.0};
    double at = 0.0;
  };

  Plane planes_[4]; ///< rays are where normal . p <= at
  Plane along_;     ///< t is normal . p - at
  double tMin_, tMax_;
  bool exists_;
};

} // namespace mote
