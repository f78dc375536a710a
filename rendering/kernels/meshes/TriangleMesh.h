#pragma once

#include "../core/ArrayView.h"
#include "../core/Box.h"
#include "../core/RawVector.h"
#include "../core/StoredArray.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace mote
{

/// The points of triangles, three each, of `points` points.
class MeshCorners
{
public:
  using Corners = std::array<std::uint32_t, 3>;

  MeshCorners() = default; ///< of no triangles
  MeshCorners(StoredArray<Corners> corners, std::size_t points)
    : corners_(std::move(corners))
    , last_(static_cast<std::uint32_t>(points > 0 ? points - 1 : 0))
  {
  }

  std::size_t size() const { return corners_.size(); }
  const Corners* data() const { return corners_.data(); }
  /// Points that there are, whatever a damaged file says.
  Corners operator[](std::size_t triangle) const
  {
    const Corners& c = corners_[triangle];
    return {std::min(c[0], last_), std::min(c[1], last_), std::min(c[2], last_)};
  }
  std::size_t bytes() const { return corners_.bytes(); }

private:
  StoredArray<Corners> corners_;
  std::uint32_t last_ = 0;
};

/// Triangles over shared points, copied from the user's arrays: points in float, counted from one
/// origin in double, and in a unit that keeps them within [-1, 1], whatever the model is measured
/// in and wherever it lies.
///
/// Triangles with a corner that is not finite stay, so that indices remain those of the input, and
/// are invalid: nobody hits them. Degenerate triangles are valid, and nobody hits these either.
class TriangleMesh
{
public:
  using Corners = MeshCorners::Corners;

  TriangleMesh() = default; ///< of no triangles
  /// `points`: three coordinates of any type each; `triangles`: three indices of points each, of
  /// any whole type. Throws Error where the arrays have not three components, where an index is not
  /// that of a point, or for more points or triangles than 32 bits count.
  TriangleMesh(const ArrayView& points, const ArrayView& triangles);

  /// Takes other points of the same number for the same triangles. Throws Error where there are
  /// more or fewer.
  void movePoints(const ArrayView& points);

  std::size_t pointCount() const { return points_.size(); }
  std::size_t size() const { return corners_->size(); } ///< triangles, the invalid ones too
  std::size_t validCount() const { return valid_; }
  const Vec3d& origin() const { return origin_; }
  double unit() const { return unit_; } ///< a power of two: scaling by it rounds nothing

  const Vec3f* points() const { return points_.data(); }
  const Corners* triangles() const { return corners_->data(); }
  /// The same, which outlive the mesh and which its copies share.
  const std::shared_ptr<const MeshCorners>& corners() const { return corners_; }
  /// Whether all corners are finite.
  bool isValid(std::size_t triangle) const;
  /// A point in the input's coordinates, as it is stored.
  Vec3d point(std::size_t i) const { return origin_ + unit_ * Vec3d(points_[i]); }
  std::size_t bytes() const { return points_.capacity() * sizeof(Vec3f) + corners_->bytes(); }

private:
  void takeTriangles(const ArrayView& triangles, std::size_t points);
  void takePoints(const ArrayView& points);

  RawVector<Vec3f> points_;
  std::shared_ptr<const MeshCorners> corners_ = std::make_shared<const MeshCorners>();
  std::size_t valid_ = 0;
  Vec3d origin_{0.0};
  double unit_ = 1.0;
};

} // namespace mote
