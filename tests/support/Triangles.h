#pragma once

#include "CastOracle.h"

#include <kernels/meshes/TriangleMesh.h>

#include <array>
#include <functional>
#include <vector>

namespace mote::testing
{

/// Triangles in double that own their numbers.
struct Triangles
{
  std::vector<double> points;
  std::vector<std::int32_t> corners;

  std::int32_t addPoint(const Vec3d& p);
  void add(std::int32_t a, std::int32_t b, std::int32_t c)
  {
    corners.insert(corners.end(), {a, b, c});
  }
  /// A triangle with points of its own.
  void add(const Vec3d& a, const Vec3d& b, const Vec3d& c)
  {
    const std::int32_t first = addPoint(a);
    addPoint(b);
    addPoint(c);
    add(first, first + 1, first + 2);
  }
  std::size_t size() const { return corners.size() / 3; }
  std::size_t pointCount() const { return points.size() / 3; }
  Vec3d point(std::size_t i) const { return {points[3 * i], points[3 * i + 1], points[3 * i + 2]}; }
  std::array<Vec3d, 3> of(std::size_t triangle) const
  {
    return {point(corners[3 * triangle]), point(corners[3 * triangle + 1]),
      point(corners[3 * triangle + 2])};
  }
  /// Views: valid until something is added.
  ArrayView pointView() const { return {points.data(), points.size() / 3, 3}; }
  ArrayView cornerView() const
  {
    return {corners.data(), ArrayView::Type::Int32, corners.size() / 3, 3};
  }
  TriangleMesh mesh() const { return {pointView(), cornerView()}; }
  /// Moves every point.
  void move(const std::function<Vec3d(const Vec3d&)>& to);
};

/// A closed sphere of 4 * rings^2 - 4 * rings triangles, displaced along its radii: bumps of a
/// tenth of it.
Triangles bumpySphere(int rings, const Vec3d& center = Vec3d(0.0), double radius = 1.0);

/// Triangles with points of their own, anywhere in [-1, 1]^3, their sides about `size` long.
Triangles randomTriangles(std::size_t count, std::uint64_t seed, double size);

/// Judges answers about triangles by brute force in long double, allowing for one length of
/// rounding, `slack`: an answer is right if the point that it names lies within the slack of the
/// triangle that it names, and no triangle is surely hit before it. A hit is sure that lies more
/// than the slack within the triangle's border.
class TriangleOracle
{
public:
  /// `share` of the longest side of the bounds becomes the slack.
  explicit TriangleOracle(const Triangles& triangles, double share = 1e-6);

  double slack() const { return slack_; }
  /// t of the nearest hit, exact, or infinity.
  double nearest(const reference::Ray& ray) const;
  /// t of the nearest sure hit, and what rounding may add to it; or infinity.
  double nearestSure(const reference::Ray& ray) const;
  /// Whether the ray comes within the slack of any triangle.
  bool mayHit(const reference::Ray& ray) const;
  void judge(const reference::Ray& ray, double t, std::size_t triangle, CastReport& report) const;

private:
  std::vector<std::array<Vec3d, 3>> triangles_;
  std::vector<bool> finite_;
  double slack_;
};

/// Distance of a point from a triangle.
double distanceFrom(const std::array<Vec3d, 3>& triangle, const Vec3d& point);

} // namespace mote::testing
