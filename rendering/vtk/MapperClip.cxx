#include "MapperClip.h"

#include "vtkAbstractMapper.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mote
{

namespace
{

Vec3d vecOf(const double* v)
{
  return {v[0], v[1], v[2]};
}

/// Calls visit(plane) for the planes of a mapper.
template <typename Visit>
void forPlanes(vtkAbstractMapper* mapper, const Visit& visit)
{
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  vtkCollectionSimpleIterator next;
  if (planes)
    for (planes->InitTraversal(next); vtkPlane* plane = planes->GetNextPlane(next);)
      visit(plane);
}

ClipCylinder cylinderOf(vtkMoteClipCylinder* from)
{
  ClipCylinder cylinder;
  cylinder.center = vecOf(from->GetCenter());
  cylinder.axis = vecOf(from->GetAxis());
  double zero[3];
  from->GetZeroAngle(zero);
  cylinder.zeroAngle = vecOf(zero);
  const auto limit = [](double v)
  {
    return v >= VTK_DOUBLE_MAX    ? ClipCylinder::infinity
           : v <= -VTK_DOUBLE_MAX ? -ClipCylinder::infinity
                                  : v;
  };
  for (int end = 0; end < 2; ++end)
  {
    cylinder.radius[end] = limit(from->GetRadiusRange()[end]);
    cylinder.height[end] = limit(from->GetHeightRange()[end]);
    cylinder.angle[end] = vtkMath::RadiansFromDegrees(from->GetAngleRange()[end]);
  }
  constexpr double turn = 2.0 * std::numbers::pi;
  if (const double width = cylinder.angle[1] - cylinder.angle[0]; width < 0.0)
    cylinder.angle[1] -= turn * std::floor(width / turn);
  return cylinder;
}

} // namespace

bool MapperClip::set(vtkMoteClipCylinder* cylinder)
{
  const bool isOther = cylinder_ != cylinder;
  cylinder_ = cylinder;
  return isOther;
}

ClipRegion MapperClip::region(vtkAbstractMapper* mapper) const
{
  ClipRegion region;
  forPlanes(mapper,
    [&](vtkPlane* plane)
    {
      if (vtkMath::Norm(plane->GetNormal()) > 0.0) // else it leaves all
        region.planes.push_back({vecOf(plane->GetOrigin()), vecOf(plane->GetNormal())});
    });
  if (cylinder_ && vtkMath::Norm(cylinder_->GetAxis()) > 0.0)
    region.cylinder = cylinderOf(cylinder_);
  return region;
}

vtkMTimeType MapperClip::time(vtkAbstractMapper* mapper) const
{
  vtkMTimeType time = cylinder_ ? cylinder_->GetMTime() : 0;
  forPlanes(mapper, [&](vtkPlane* plane) { time = std::max(time, plane->GetMTime()); });
  return time;
}

} // namespace mote
