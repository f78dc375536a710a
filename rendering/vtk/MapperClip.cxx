#include "MapperClip.h"

#include "vtkAbstractMapper.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// How far off the hits on its cells may be, and what its coordinates lose where they are floats.
double roundingOf(vtkPointSet& input)
{
  constexpr double hits = 1e-6;
  double rounding = hits * input.GetLength();
  double bounds[6];
  input.GetBounds(bounds);
  if (input.GetPoints() && input.GetPoints()->GetDataType() == VTK_FLOAT)
    for (const double bound : bounds)
      rounding = std::max(rounding, std::numeric_limits<float>::epsilon() * std::abs(bound));
  return rounding;
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

ClipRegion MapperClip::region(
  vtkAbstractMapper* mapper, vtkPointSet& input, const Mat4d& toWorld) const
{
  ClipRegion region = this->region(mapper);
  if (!region.isAll())
    region.tolerance = scaleOf(toWorld) * roundingOf(input);
  return region;
}

vtkMTimeType MapperClip::time(vtkAbstractMapper* mapper) const
{
  vtkMTimeType time = cylinder_ ? cylinder_->GetMTime() : 0;
  forPlanes(mapper, [&](vtkPlane* plane) { time = std::max(time, plane->GetMTime()); });
  return time;
}

} // namespace mote
