#include "TriangleMesh.h"

#include "../core/Error.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace mote
{

namespace
{

using Range = tbb::blocked_range<std::size_t>;

constexpr std::size_t grain = 1 << 14;

template <typename Point>
bool isFinite(const Point& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

Vec3d pointOf(const ArrayView& points, std::size_t i)
{
  return {points.value(i, 0), points.value(i, 1), points.value(i, 2)};
}

/// The bounds of the points that triangles refer to and that are finite.
Box boundsOf(const ArrayView& points, const MeshCorners& triangles)
{
  std::vector<std::atomic<std::uint8_t>> used(points.count());
  tbb::parallel_for(Range(0, triangles.size(), grain),
    [&](const Range& range)
    {
      for (std::size_t t = range.begin(); t != range.end(); ++t)
        for (const std::uint32_t corner : triangles.data()[t])
          used[corner].store(1, std::memory_order_relaxed);
    });
  return tbb::parallel_reduce(
    Range(0, points.count(), grain), Box(),
    [&](const Range& range, Box box)
    {
      for (std::size_t i = range.begin(); i != range.end(); ++i)
        if (used[i].load(std::memory_order_relaxed) != 0)
          if (const Vec3d p = pointOf(points, i); isFinite(p))
            box.add(p);
      return box;
    },
    [](Box a, const Box& b)
    {
      a.add(b);
      return a;
    });
}

} // namespace

TriangleMesh::TriangleMesh(const ArrayView& points, const ArrayView& triangles)
{
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
  if (points.count() >= most || triangles.count() >= most)
    throw Error("A mesh may have fewer than 4294967295 points and triangles.");
  if (!points.empty() && points.components() != 3)
    throw Error("The points of a mesh need three coordinates each.");
  if (!triangles.empty() && triangles.components() != 3)
    throw Error("The triangles of a mesh need three indices of points each.");
  if (triangles.type() == ArrayView::Type::Float32 || triangles.type() == ArrayView::Type::Float64)
    throw Error("The triangles of a mesh need indices that are whole numbers.");
  takeTriangles(triangles, points.count());
  takePoints(points);
}

void TriangleMesh::movePoints(const ArrayView& points)
{
  if (points.count() != points_.size() || (!points.empty() && points.components() != 3))
    throw Error("The mesh has " + std::to_string(points_.size()) +
                " points: as many are needed to move them, with three coordinates each.");
  takePoints(points);
}

void TriangleMesh::takeTriangles(const ArrayView& triangles, std::size_t points)
{
  RawVector<Corners> corners(triangles.count());
  // The first wrong index is told, however many threads look.
  const auto wrong = tbb::parallel_reduce(
    Range(0, triangles.count(), grain), triangles.count(),
    [&](const Range& range, std::size_t first)
    {
      for (std::size_t t = range.begin(); t != range.end(); ++t)
        for (int k = 0; k < 3; ++k)
        {
          const double index = triangles.value(t, k);
          const bool right = index >= 0.0 && index < static_cast<double>(points);
          corners[t][k] = right ? static_cast<std::uint32_t>(index) : 0;
          if (!right)
            first = std::min(first, t);
        }
      return first;
    },
    [](std::size_t a, std::size_t b) { return std::min(a, b); });
  if (wrong == triangles.count())
  {
    StoredArray<Corners> all;
    all.take(std::move(corners));
    corners_ = std::make_shared<const MeshCorners>(std::move(all), points);
    return;
  }
  std::string text = "Triangle " + std::to_string(wrong) + " has the corners";
  for (int k = 0; k < 3; ++k)
    text +=
      (k > 0 ? ", " : " ") + std::to_string(static_cast<long long>(triangles.value(wrong, k)));
  throw Error(text + ", but the mesh has " + std::to_string(points) + " points.");
}

void TriangleMesh::takePoints(const ArrayView& points)
{
  const Box box = boundsOf(points, *corners_);
  const Vec3d size = box.size();
  const double half = 0.5 * std::max({size.x, size.y, size.z});
  origin_ = box.empty() ? Vec3d(0.0) : box.center();
  unit_ = 1.0;
  // A power of two whose inverse is a number, too; beyond lie denormal sizes.
  if (half > 0x1p-1000 && half < 0x1p1000)
    unit_ = std::exp2(std::ceil(std::log2(half)));
  points_.resize(points.count());
  tbb::parallel_for(Range(0, points.count(), grain),
    [&](const Range& range)
    {
      for (std::size_t i = range.begin(); i != range.end(); ++i)
        points_[i] = Vec3f((pointOf(points, i) - origin_) / unit_);
    });
  valid_ = tbb::parallel_reduce(
    Range(0, this->size(), grain), std::size_t{0},
    [&](const Range& range, std::size_t count)
    {
      for (std::size_t t = range.begin(); t != range.end(); ++t)
        count += isValid(t);
      return count;
    },
    [](std::size_t a, std::size_t b) { return a + b; });
}

bool TriangleMesh::isValid(std::size_t triangle) const
{
  const Corners& c = corners_->data()[triangle];
  return isFinite(points_[c[0]]) && isFinite(points_[c[1]]) && isFinite(points_[c[2]]);
}

} // namespace mote
