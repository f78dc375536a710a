#pragma once

#include "CellOutline.h"
#include "HexMesh.h"
#include "HexRay.h"
#include "SpaceBounds.h"

#include <algorithm>

namespace mote
{

/// The space (x, y, z), counted from the middle of the mesh.
///
/// TwoLevelGrid and HexBvh are written once, over a space. A space says where points and cells are
/// in its coordinates, how large bounds are, and how a ray goes from step to step of a lattice and
/// through bounds.
class CartesianSpace
{
public:
  /// The steps around that a lattice needs at least to be walked through; 1 always does.
  static constexpr int leastAround = 1;
  static constexpr bool wraps = false;
  static constexpr const char* prefix = "cart"; ///< of structures' names
  static constexpr const char* axes = "(x, y, z)";

  struct Ray
  {
    Vec3d origin, direction, inverse;
  };

  CartesianSpace() = default;
  CartesianSpace(const Vec3d& origin, double margin)
    : origin_(origin)
    , margin_(margin)
  {
  }

  using Steps = CartesianSteps;
  CellOutline outlineOf(HexCorners corners) const
  {
    for (Vec3d& p : corners)
      p -= origin_;
    return {corners, margin_};
  }

  /// Where coordinates count from.
  const Vec3d& origin() const { return origin_; }
  Vec3d coordinates(const Vec3d& p) const { return p - origin_; }
  Ray ray(const HexRay& r) const { return {r.origin - origin_, r.direction, 1.0 / r.direction}; }
  SpaceBounds boundsOf(const HexCorners& corners) const
  {
    Box box;
    for (const Vec3d& p : corners)
      box.add(p - origin_);
    return {box.lower - Vec3d(margin_), box.upper + Vec3d(margin_)};
  }

  /// The lengths of bounds along the three coordinates; their product is the volume.
  static Vec3d sides(const Vec3d& lower, const Vec3d& upper) { return upper - lower; }
  static double area(const SpaceBounds& b)
  {
    const Vec3d d = b.to() - b.from();
    return 2.0 * (d.x * d.y + d.y * d.z + d.z * d.x);
  }
  /// The lattice over `extent` with `n` steps.
  static Lattice lattice(const SpaceBounds& extent, const std::array<int, 3>& n)
  {
    return {extent.from(), (extent.to() - extent.from()) / Vec3d(n[0], n[1], n[2]), n};
  }
  /// The lattice within step (i, j, k) of another.
  static Lattice within(const Lattice& l, int i, int j, int k, const std::array<int, 3>& n)
  {
    return {l.lower + Vec3d(i, j, k) * l.step, l.step / Vec3d(n[0], n[1], n[2]), n};
  }
  static LatticeRange overlap(const Lattice& l, const SpaceBounds& b)
  {
    LatticeRange range;
    for (int k = 0; k < 3; ++k)
    {
      const auto i = static_cast<std::size_t>(k);
      range.first[i] = l.clampedAt(k, b.lower[i]);
      range.last[i] = l.clampedAt(k, b.upper[i]);
    }
    return range;
  }
  /// The same for a lattice within a step of another.
  static LatticeRange overlapWithin(const Lattice& l, const SpaceBounds& b)
  {
    return overlap(l, b);
  }

  /// Bounds that rays meet. `tIn` and `tOut` are narrowed to the part within; false for none.
  class Region
  {
  public:
    Region() = default;
    explicit Region(const SpaceBounds& b)
      : bounds_(b)
    {
    }
    const SpaceBounds& bounds() const { return bounds_; }
    double area() const { return CartesianSpace::area(bounds_); }
    bool clip(const Ray& ray, double& tIn, double& tOut) const
    {
      for (int k = 0; k < 3; ++k)
      {
        const auto i = static_cast<std::size_t>(k);
        if (ray.direction[k] == 0.0)
        {
          if (ray.origin[k] < bounds_.lower[i] || ray.origin[k] > bounds_.upper[i])
            return false;
          continue;
        }
        const double a = (bounds_.lower[i] - ray.origin[k]) * ray.inverse[k];
        const double b = (bounds_.upper[i] - ray.origin[k]) * ray.inverse[k];
        tIn = std::max(tIn, std::min(a, b));
        tOut = std::min(tOut, std::max(a, b));
      }
      return tIn <= tOut;
    }
    /// Whether the point with these coordinates is within.
    bool contains(const Vec3d& c) const
    {
      for (int k = 0; k < 3; ++k)
        if (c[k] < bounds_.lower[static_cast<std::size_t>(k)] ||
            c[k] > bounds_.upper[static_cast<std::size_t>(k)])
          return false;
      return true;
    }

    bool overlaps(const Region& other) const
    {
      for (std::size_t k = 0; k < 3; ++k)
        if (bounds_.lower[k] > other.bounds_.upper[k] || other.bounds_.lower[k] > bounds_.upper[k])
          return false;
      return true;
    }

  private:
    SpaceBounds bounds_;
  };
  static Vec3d regionCoordinates(const Vec3d& coordinates) { return coordinates; }

  /// The steps of a lattice that a ray passes between t and tEnd, one after another.
  class Walk
  {
  public:
    Walk(const CartesianSpace&, const Ray& ray, const Lattice& lattice, double t, double tEnd)
      : ray_(ray)
      , lattice_(lattice)
      , tEnd_(tEnd)
      , t_(t)
    {
      const Vec3d at = ray.origin + t * ray.direction;
      for (int k = 0; k < 3; ++k)
      {
        at_[static_cast<std::size_t>(k)] = lattice.clampedAt(k, at[k]);
        plan(k);
      }
      choose();
    }
    double tIn() const { return t_; }
    double tOut() const { return tOut_; }
    bool isOutside() const { return false; }
    const std::array<int, 3>& at() const { return at_; }
    /// To the next step; false behind the last.
    bool next()
    {
      t_ = tOut_;
      if (t_ >= tEnd_)
        return false;
      const auto i = static_cast<std::size_t>(axis_);
      at_[i] += ray_.direction[axis_] > 0.0 ? 1 : -1;
      plan(axis_);
      choose();
      return true;
    }

  private:
    /// When coordinate k leaves its step; never out of the lattice.
    void plan(int k)
    {
      const auto i = static_cast<std::size_t>(k);
      const bool up = ray_.direction[k] > 0.0;
      const bool stays =
        ray_.direction[k] == 0.0 || (up ? at_[i] == lattice_.n[i] - 1 : at_[i] == 0);
      leaves_[i] = stays ? std::numeric_limits<double>::infinity()
                         : (lattice_.lower[k] + (at_[i] + up) * lattice_.step[k] - ray_.origin[k]) *
                             ray_.inverse[k];
    }
    void choose()
    {
      axis_ = leaves_[0] < leaves_[1] ? (leaves_[0] < leaves_[2] ? 0 : 2)
                                      : (leaves_[1] < leaves_[2] ? 1 : 2);
      tOut_ = std::min(std::max(leaves_[static_cast<std::size_t>(axis_)], t_), tEnd_);
    }

    const Ray& ray_;
    const Lattice& lattice_;
    std::array<int, 3> at_;
    std::array<double, 3> leaves_;
    double tEnd_, t_, tOut_ = 0.0;
    int axis_ = 0;
  };

private:
  Vec3d origin_{0.0};
  double margin_ = 0.0;
};

} // namespace mote
