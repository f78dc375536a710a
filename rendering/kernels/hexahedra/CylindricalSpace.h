#pragma once

#include "CellOutline.h"
#include "CylinderAxis.h"
#include "HexRay.h"
#include "SpaceBounds.h"

#include <algorithm>
#include <vector>

namespace mote
{

/// The space (r, theta, h) about an axis; theta in [0, 2 pi), bounds may reach over the seam, up to
/// 4 pi. Offers what CartesianSpace does.
class CylindricalSpace
{
public:
  static constexpr int leastAround = 4;
  static constexpr bool wraps = true;
  static constexpr const char* prefix = "cyl";
  static constexpr const char* axes = "(r, theta, h)";

  /// A ray in the axis' frame, and how it goes about the axis.
  struct Ray
  {
    Vec3d origin, direction; ///< (x, y, h)
    double planar;           ///< the direction's squared length across the axis
    double nearest;          ///< t of the point nearest to the axis
    double nearest2;         ///< the squared distance there
    double turn;             ///< above 0 where theta rises, below where it falls
    double inversePlanar, inverseHeight;
    Vec3d foot; ///< the point nearest to the axis, h left out

    /// (x, y, h), with exact proportions of x and y also next to the axis.
    Vec3d at(double t) const
    {
      const double s = t - nearest;
      return {foot.x + s * direction.x, foot.y + s * direction.y, origin.z + t * direction.z};
    }
  };

  CylindricalSpace() = default;
  /// `extent` is the mesh's size; the seam lies at the angle `seam` from an arbitrary direction.
  CylindricalSpace(const CylinderAxis& axis, double extent, double seam = 0.0);

  using Steps = CylindricalSteps;
  CellOutline outlineOf(HexCorners corners) const;

  /// (r, theta, h) of a point.
  Vec3d coordinates(const Vec3d& p) const;
  Ray ray(const HexRay& r) const;
  /// Tight bounds that hold the whole cell, its bulging faces as well.
  ///
  /// A bilinear face lies in the hull of its corners, and the greatest r and the range of h of
  /// a hull are at corners. The least r is at a corner or on a segment between two of them: the
  /// twelve edges and the faces' diagonals, across the axis. Where the hull of a face's corners
  /// holds the axis, r begins at 0 and theta is the full circle; where not, the range of theta
  /// is at the corners.
  SpaceBounds boundsOf(const HexCorners& corners) const;

  static Vec3d sides(const Vec3d& lower, const Vec3d& upper)
  {
    const Vec3d d = upper - lower;
    return {d.x, d.y * 0.5 * (lower.x + upper.x), d.z};
  }
  /// (2 r + d_r)(d_r + d_h) d_theta + 2 d_r d_h, after Wang, Elshehaly and Cao.
  static double area(const SpaceBounds& b);
  /// The full circle, whatever part of it `extent` covers.
  static Lattice lattice(const SpaceBounds& extent, const std::array<int, 3>& n);
  static Lattice within(const Lattice& l, int i, int j, int k, const std::array<int, 3>& n);
  static LatticeRange overlap(const Lattice& l, const SpaceBounds& b);
  static LatticeRange overlapWithin(const Lattice& l, const SpaceBounds& b);

  /// A sector of a ring, with the directions of its two sides. Sectors wider than pi count as the
  /// full circle.
  class Region
  {
  public:
    Region() = default;
    explicit Region(const SpaceBounds& b);
    bool clip(const Ray& ray, double& tIn, double& tOut) const;
    bool contains(const Vec3d& xyh) const;
    bool overlaps(const Region& other) const;
    double area() const;

  private:
    bool clipHole(const Ray& ray, double inner2, double& tIn, double& tOut) const;
    bool isSector() const { return from_[0] != 0.0F || from_[1] != 0.0F; }
    /// Whether a direction, or a point across the axis, lies in the sector, which has two sides.
    bool isBetween(double x, double y) const
    {
      return from_[0] * y - from_[1] * x >= 0.0 && to_[1] * x - to_[0] * y >= 0.0;
    }

    float inner_ = 0.0F, outer_ = 0.0F, bottom_ = 0.0F, top_ = 0.0F;
    std::array<float, 2> from_{}, to_{}; ///< both (0, 0) for the full circle
  };
  /// What Region::contains() takes.
  static Vec3d regionCoordinates(const Vec3d& rth)
  {
    return {rth.x * std::cos(rth.y), rth.x * std::sin(rth.y), rth.z};
  }

  class Walk;

  double seam() const { return seam_; }

private:
  Vec3d toFrame(const Vec3d& p) const
  {
    const Vec3d v = p - origin_;
    return {glm::dot(v, x_), glm::dot(v, y_), glm::dot(v, h_)};
  }

  Vec3d origin_{0.0}, x_{1.0, 0.0, 0.0}, y_{0.0, 1.0, 0.0}, h_{0.0, 0.0, 1.0};
  double extent_ = 1.0, seam_ = 0.0;
};

/// Steps of a lattice that a ray passes, see CartesianSpace::Walk. Shells are met on the way in and
/// on the way out, half-planes in the order of theta, which rises or falls along the whole ray.
class CylindricalSpace::Walk
{
public:
  Walk(
    const CylindricalSpace& space, const Ray& ray, const Lattice& lattice, double t, double tEnd);

  double tIn() const { return t_; }
  double tOut() const { return tOut_; }
  /// Whether the ray is in the hole within the lattice.
  bool isOutside() const { return at_[0] < 0; }
  const std::array<int, 3>& at() const { return at_; }
  bool next();

private:
  void planRadius();
  void planAngle();
  void planHeight();
  void choose();
  void passAxis();

  const Ray& ray_;
  const Lattice& lattice_;
  std::array<int, 3> at_;
  std::array<double, 3> leaves_;
  double cosine_ = 1.0, sine_ = 0.0; ///< of the next half-plane
  double stepCosine_ = 1.0, stepSine_ = 0.0;
  double tEnd_, t_, tOut_ = 0.0;
  int axis_ = 0;
  bool inwards_;
  bool full_; ///< the lattice covers the full circle, and the hole within it
};

} // namespace mote
