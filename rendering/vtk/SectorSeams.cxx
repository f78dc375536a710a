#include "SectorSeams.h"

#include "RotatedCopies.h"
#include "SurfaceTriangles.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <array>

namespace mote
{

namespace
{

constexpr double agreement = 1e-6; // of the surface's extent

/// The corners of a surface, each once, and which of them the turn leads to which.
class Corners
{
public:
  Corners(const ArrayView& triangles, vtkPoints* points, const Mat4d& turn)
  {
    ids_.reserve(3 * triangles.count());
    for (std::size_t t = 0; t < triangles.count(); ++t)
      for (int k = 0; k < 3; ++k)
        ids_.push_back(static_cast<vtkIdType>(triangles.value(t, k)));
    std::sort(ids_.begin(), ids_.end());
    ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
    vtkNew<vtkPoints> own;
    own->SetDataTypeToDouble();
    own->SetNumberOfPoints(static_cast<vtkIdType>(ids_.size()));
    for (std::size_t i = 0; i < ids_.size(); ++i)
      own->SetPoint(static_cast<vtkIdType>(i), points->GetPoint(ids_[i]));
    this->pair(own, turn);
  }

  std::size_t size() const { return ids_.size(); }
  std::size_t place(vtkIdType id) const
  {
    return static_cast<std::size_t>(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
  }
  /// Where a corner is turned to, and from where one is turned to it; -1: nowhere.
  vtkIdType after(std::size_t place) const { return after_[place]; }
  vtkIdType before(std::size_t place) const { return before_[place]; }

private:
  void pair(vtkPoints* own, const Mat4d& turn)
  {
    after_.assign(ids_.size(), -1);
    before_.assign(ids_.size(), -1);
    vtkNew<vtkPolyData> cloud;
    cloud->SetPoints(own);
    vtkNew<vtkStaticPointLocator> locator;
    locator->SetDataSet(cloud);
    locator->BuildLocator();
    const double radius = agreement * cloud->GetLength();
    for (std::size_t i = 0; i < ids_.size(); ++i)
    {
      const double* p = own->GetPoint(static_cast<vtkIdType>(i));
      const Vec4d q = turn * Vec4d(p[0], p[1], p[2], 1.0);
      double distance = 0.0;
      const double place[3] = {q.x, q.y, q.z};
      const vtkIdType met = locator->FindClosestPointWithinRadius(radius, place, distance);
      if (met < 0)
        continue;
      after_[i] = met;
      before_[static_cast<std::size_t>(met)] = static_cast<vtkIdType>(i);
    }
  }

  std::vector<vtkIdType> ids_; ///< ascending
  std::vector<vtkIdType> after_, before_;
};

Vec3d normalOf(vtkPoints* points, const std::array<vtkIdType, 3>& corners)
{
  Vec3d p[3];
  for (int k = 0; k < 3; ++k)
    points->GetPoint(corners[static_cast<std::size_t>(k)], &p[k].x);
  return glm::cross(p[1] - p[0], p[2] - p[0]);
}

/// A triangle, and whether all of its corners are turned to others.
struct Side
{
  std::array<std::size_t, 3> places{}; ///< of its corners
  Vec3d normal{0.0};
  bool after = false, before = false;
};

std::vector<Side> sidesOf(const ArrayView& triangles, vtkPoints* points, const Corners& corners)
{
  std::vector<Side> sides(triangles.count());
  for (std::size_t t = 0; t < sides.size(); ++t)
  {
    Side& side = sides[t];
    std::array<vtkIdType, 3> ids{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      ids[k] = static_cast<vtkIdType>(triangles.value(t, static_cast<int>(k)));
      side.places[k] = corners.place(ids[k]);
    }
    const auto all = [&](auto isTurned)
    { return std::all_of(side.places.begin(), side.places.end(), isTurned); };
    side.after = all([&](std::size_t place) { return corners.after(place) >= 0; });
    side.before = all([&](std::size_t place) { return corners.before(place) >= 0; });
    side.normal = normalOf(points, ids);
  }
  return sides;
}

} // namespace

std::vector<std::uint8_t> coveredByCopies(
  const SurfaceTriangles& surface, vtkPoints* points, const SectorCopies& copies)
{
  const std::vector<Mat4d> turns = rotatedCopies(copies.count, &copies.center.x, &copies.axis.x);
  const ArrayView triangles = surface.view();
  if (turns.size() < 2 || triangles.empty())
    return {};
  const Mat3d turn(turns[1]);
  const Corners corners(triangles, points, turns[1]);
  const std::vector<Side> sides = sidesOf(triangles, points, corners);
  // Where the sides of the sector look: what of a whole wheel covers itself looks the same way.
  std::vector<Vec3d> after(corners.size(), Vec3d(0.0)), before = after;
  for (const Side& side : sides)
    for (const std::size_t place : side.places)
    {
      after[place] += side.after ? side.normal : Vec3d(0.0);
      before[place] += side.before ? side.normal : Vec3d(0.0);
    }
  std::vector<std::uint8_t> isCovered;
  isCovered.reserve(sides.size());
  for (const Side& side : sides)
  {
    double facing[2] = {};
    for (const std::size_t place : side.places)
    {
      if (side.after)
        facing[0] +=
          glm::dot(turn * side.normal, before[static_cast<std::size_t>(corners.after(place))]);
      if (side.before)
        facing[1] +=
          glm::dot(side.normal, turn * after[static_cast<std::size_t>(corners.before(place))]);
    }
    isCovered.push_back(facing[0] < 0.0 || facing[1] < 0.0);
  }
  return isCovered;
}

} // namespace mote
