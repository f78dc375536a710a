#include "SurfaceFaces.h"

#include "SurfaceTriangles.h"

#include "kernels/hexahedra/HangingFaces.h"

#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"

#include <glm/common.hpp>

#include <limits>
#include <numeric>

namespace mote
{

SurfaceFaces::SurfaceFaces(const SurfaceTriangles& surface, vtkPoints* points)
{
  const ArrayView triangles = surface.view();
  std::vector<vtkIdType> ids; // ascending
  ids.reserve(3 * triangles.count());
  for (std::size_t t = 0; t < triangles.count(); ++t)
    for (int k = 0; k < 3; ++k)
      ids.push_back(static_cast<vtkIdType>(triangles.value(t, k)));
  triangles_.resize(triangles.count());
  const std::vector<vtkIdType> all = ids;
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  for (std::size_t i = 0; i < all.size(); ++i)
    triangles_[i / 3][i % 3] =
      static_cast<std::size_t>(std::lower_bound(ids.begin(), ids.end(), all[i]) - ids.begin());
  corners_.resize(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    points->GetPoint(ids[i], &corners_[i].x);
    lower_ = i == 0 ? corners_[i] : glm::min(lower_, corners_[i]);
    upper_ = i == 0 ? corners_[i] : glm::max(upper_, corners_[i]);
  }
  if (points->GetDataType() == VTK_FLOAT)
    rounding_ =
      std::numeric_limits<float>::epsilon() * std::max(glm::length(lower_), glm::length(upper_));
  this->findFaces(surface.edges);
  this->makeIndex();
}

SurfaceFaces::~SurfaceFaces() = default;

bool SurfaceFaces::isNear(const Vec3d& place, double radius) const
{
  for (int axis = 0; axis < 3; ++axis)
    if (!(place[axis] >= lower_[axis] - radius && place[axis] <= upper_[axis] + radius))
      return false;
  return true;
}

void SurfaceFaces::cornersOf(
  const Face& face, const std::vector<vtkIdType>& numbers, std::vector<vtkIdType>& found) const
{
  found.clear();
  for (std::size_t t = face.first; t < face.end; ++t)
    for (const std::size_t corner : triangles_[t])
      found.push_back(numbers[corner]);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  if (found.front() < 0)
    found.clear();
}

vtkIdType SurfaceFaces::cornerAt(const Vec3d& place, double radius) const
{
  double distance = 0.0;
  // Which is not const, but changes nothing once it is built.
  auto* locator = const_cast<vtkStaticPointLocator*>(locator_.Get());
  return locator->FindClosestPointWithinRadius(radius, &place.x, distance);
}

std::uint64_t SurfaceFaces::hashOf(const std::vector<vtkIdType>& corners)
{
  std::uint64_t hash = corners.size();
  for (const vtkIdType corner : corners)
    hash = (hash ^ static_cast<std::uint64_t>(corner)) * 0x9E3779B97F4A7C15ULL;
  return hash;
}

void SurfaceFaces::makeIndex()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(corners_.size()));
  for (std::size_t i = 0; i < corners_.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), &corners_[i].x);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  locator_->SetDataSet(cloud);
  locator_->BuildLocator();
  numbers_.resize(corners_.size());
  std::iota(numbers_.begin(), numbers_.end(), vtkIdType(0));
  std::vector<vtkIdType> corners;
  for (std::size_t f = 0; f < all_.size(); ++f)
  {
    this->cornersOf(all_[f], numbers_, corners);
    byHash_.emplace_back(hashOf(corners), f);
  }
  std::sort(byHash_.begin(), byHash_.end());
}

void SurfaceFaces::findFaces(const std::vector<std::uint8_t>& edges)
{
  for (const FaceRange& range : facesOf(triangles_.size(), edges))
  {
    Face face = {range.first, range.end};
    for (std::size_t t = range.first; t < range.end; ++t)
    {
      const Triangle& at = triangles_[t];
      const Vec3d from = corners_[at[0]];
      face.normal += glm::cross(corners_[at[1]] - from, corners_[at[2]] - from);
    }
    all_.push_back(face);
  }
}

} // namespace mote
