#pragma once

#include "../core/ArrayView.h"
#include "../core/Box.h"
#include "../core/RawVector.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace mote
{

/// Triangles over shared points, copied from the user's arrays: points in float, counted from one
/// origin in double, and in a unit that keeps them within [-1, 1], whatever the model is measured
/// in and wherever it lies.
///
/// Triangles with a corner that is not finite stay, so that indices remain those of the input, and
/// are invalid: nobody hits them. Degenerate triangles are valid, and nobody hits these either.
class TriangleMesh
{
public:
  using Corners = std::array<std::uint32_t, 3>;

  TriangleMesh() = default;
  /// `points`: three coordinates of any type each; `triangles`: three indices of points each, of
  /// any whole type. Throws Error where the arrays have not three components, where an index is not
  /// that of a point, or for more points or triangles than 32 bits count.
  TriangleMesh(const ArrayView& points, const ArrayView& triangles);

  /// Takes other points of the same number for the same triangles. Throws Error where there are
  /// more or fewer.
  void movePoints(const ArrayView& points);

  std::size_t pointCount() const { return points_.size(); }
  std::size_t size() const { return triangles_.size(); } ///< triangles, the invalid ones too
  std::size_t validCount() const { return valid_; }
  const Vec3d& origin() const { return origin_; }
  double unit() const { return unit_; } ///< a power of two: scaling by it rounds nothing

  const Vec3f* points() const { return points_.data(); }
  const Corners* triangles() const { return triangles_.data(); }
  /// Whether all corners are finite.
  bool isValid(std::size_t triangle) const;
  /// A point in the input's coordinates, as it is stored.
  Vec3d point(std::size_t i) const { return origin_ + unit_ * Vec3d(points_[i]); }
  std::size_t bytes() const
  {
    return points_.capacity() * sizeof(Vec3f) + triangles_.capacity() * sizeof(Corners);
  }

private:
  void takeTriangles(const ArrayView& triangles, std::size_t points);
  void takePoints(const ArrayView& points);

  RawVector<Vec3f> points_;
  RawVector<Corners> triangles_;
  std::size_t valid_ = 0;
  Vec3d origin_{0.0};
  double unit_ = 1.0;
};

} // namespace mote
