#include "SurfaceCover.h"

#include "SurfaceFaces.h"

#include "kernels/core/ArrayView.h"
#include "kernels/core/RayPacket.h"
#include "kernels/meshes/TriangleMesh.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mote
{

namespace
{

constexpr double flatShare = 1e-3;  // of the shortest side
constexpr double curvedShare = 0.2; // of the longest side times the angle; an eighth is needed
constexpr double sharpest = 0.7;    // cosine: faces that meet at a sharper edge are of two surfaces
constexpr double facing = -0.8;     // cosine between normals of faces that look at one another
constexpr double inset = 0.25;      // from the corners to the middle: places that are tried

Vec3d unitOf(const Vec3d& v)
{
  const double length = glm::length(v);
  return length > 0.0 ? v / length : Vec3d(0.0);
}

/// The greatest angle between each face and those that share a corner with it, but across edges.
std::vector<double> turnsOf(const SurfaceFaces& faces)
{
  const auto& all = faces.all();
  std::vector<std::vector<std::size_t>> at(faces.corners().size());
  std::vector<Vec3d> normals(all.size());
  for (std::size_t f = 0; f < all.size(); ++f)
  {
    normals[f] = unitOf(all[f].normal);
    for (std::size_t t = all[f].first; t < all[f].end; ++t)
      for (const std::size_t corner : faces.triangles()[t])
        if (at[corner].empty() || at[corner].back() != f)
          at[corner].push_back(f);
  }
  std::vector<double> least(all.size(), 1.0); // cosines
  constexpr std::size_t most = 32;            // of those at a corner, which may be the tip of many
  for (const std::vector<std::size_t>& meeting : at)
    for (const std::size_t one : meeting)
      for (std::size_t k = 0; k < meeting.size(); k += 1 + meeting.size() / most)
        if (const double cosine = glm::dot(normals[one], normals[meeting[k]]); cosine > sharpest)
          least[one] = std::min(least[one], cosine);
  std::transform(least.begin(), least.end(), least.begin(), [](double c) { return std::acos(c); });
  return least;
}

} // namespace

std::vector<double> SurfaceCover::distancesOf(const SurfaceFaces& faces)
{
  std::vector<double> distances = turnsOf(faces);
  for (std::size_t f = 0; f < distances.size(); ++f)
  {
    double longest = 0.0, shortest = std::numeric_limits<double>::infinity();
    for (std::size_t t = faces.all()[f].first; t < faces.all()[f].end; ++t)
      for (std::size_t k = 0; k < 3; ++k)
      {
        const SurfaceFaces::Triangle& at = faces.triangles()[t];
        const double side = glm::distance(faces.corners()[at[k]], faces.corners()[at[(k + 1) % 3]]);
        longest = std::max(longest, side);
        shortest = std::min(shortest, side);
      }
    distances[f] = flatShare * shortest + curvedShare * longest * distances[f] +
                   2.0 * (surfaceError * faces.extent() + faces.rounding());
  }
  return distances;
}

SurfaceCover::SurfaceCover(const SurfaceFaces& faces)
  : faces_(&faces)
  , distances_(distancesOf(faces))
{
  if (faces.all().empty())
    return;
  static_assert(sizeof(std::size_t) == 8);
  const auto& triangles = faces.triangles();
  tree_.build(TriangleMesh(ArrayView(&faces.corners().data()->x, faces.corners().size(), 3),
    ArrayView(triangles.data(), ArrayView::Type::UInt64, triangles.size(), 3)));
  for (const double distance : distances_)
    farthest_ = std::max(farthest_, distance);
  faceOf_.resize(triangles.size());
  for (std::size_t f = 0; f < faces.all().size(); ++f)
    for (std::size_t t = faces.all()[f].first; t < faces.all()[f].end; ++t)
      faceOf_[t] = f;
}

bool SurfaceCover::isCovered(
  const Vec3d& place, const Vec3d& normal, double distance, const MayCover& mayCover) const
{
  const double reach = std::max(distance, farthest_);
  RayPacket ray;
  ray.count = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    ray.origin[axis][0] = place[axis] + reach * normal[axis];
    ray.direction[axis][0] = -normal[axis];
  }
  ray.t[0] = 0.0;
  constexpr int most = 16; // of the surface's own faces that may stand before it
  for (int k = 0; k < most; ++k)
  {
    ray.tMin[0] = ray.t[0];
    ray.t[0] = 2.0 * reach;
    ray.slot[0] = RayPacket::noHit;
    ray.object[0] = -1;
    tree_.castInner(ray, 0);
    if (ray.slot[0] == RayPacket::noHit)
      return false;
    const std::size_t triangle = tree_.inputIndex(ray.slot[0]);
    const std::size_t face = faceOf_[triangle];
    if (std::abs(ray.t[0] - reach) <= std::max(distance, distances_[face]) &&
        glm::dot(normal, unitOf(faces_->all()[face].normal)) < facing &&
        (!mayCover || mayCover(triangle)))
      return true;
  }
  return false;
}

bool SurfaceCover::coversFace(
  const SurfaceCover& others, std::size_t face, const Mat4d& turn, const MayCover& mayCover) const
{
  const SurfaceFaces::Face& one = others.faces_->all()[face];
  const Vec3d normal = unitOf(Mat3d(turn) * one.normal);
  const double distance = others.distances_[face];
  // The middles first, which tell most.
  for (const double share : {1.0, inset})
    for (std::size_t t = one.first; t < one.end; ++t)
    {
      std::array<Vec3d, 3> at;
      for (std::size_t k = 0; k < 3; ++k)
        at[k] = transformPoint(turn, others.faces_->corners()[others.faces_->triangles()[t][k]]);
      const Vec3d middle = (at[0] + at[1] + at[2]) / 3.0;
      for (std::size_t k = 0; k < (share < 1.0 ? 3 : 1); ++k)
        if (const Vec3d place = glm::mix(at[k], middle, share);
            !faces_->isNear(place, std::max(distance, farthest_)) ||
            !this->isCovered(place, normal, distance, mayCover))
          return false;
    }
  return normal != Vec3d(0.0);
}

void SurfaceCover::mark(const SurfaceCover& others, const Mat4d& turn,
  std::vector<std::uint8_t>& marks, const PairFilter& mayCover) const
{
  const auto& all = others.faces_->all();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, all.size(), 256),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t f = range.begin(); f < range.end(); ++f)
      {
        MayCover ofFace;
        if (mayCover)
          ofFace = [&, other = all[f].first](std::size_t own) { return mayCover(other, own); };
        if (marks[all[f].first] == 0 && this->coversFace(others, f, turn, ofFace))
          std::fill(marks.begin() + static_cast<std::ptrdiff_t>(all[f].first),
            marks.begin() + static_cast<std::ptrdiff_t>(all[f].end), std::uint8_t(1));
      }
    });
}

} // namespace mote
