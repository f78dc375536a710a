#include "Slices.h"

#include "Cuts.h"

#include <vtkLinearTransform.h>
#include <vtkMath.h>
#include <vtkMoteClipCylinder.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

/// The direction away from the axis at an angle in degrees, which count as those of cuts do.
std::array<double, 3> outwardsAt(const CutAxis& axis, double angle)
{
  vtkNew<vtkMoteClipCylinder> cylinder;
  cylinder->SetAxis(axis.direction.data());
  std::array<double, 3> zero{}, side{}, outwards{};
  cylinder->GetZeroAngle(zero.data());
  const double along = vtkMath::Dot(zero.data(), axis.direction.data());
  for (std::size_t k = 0; k < 3; ++k)
    zero[k] -= along * axis.direction[k];
  vtkMath::Normalize(zero.data());
  vtkMath::Cross(axis.direction.data(), zero.data(), side.data());
  const double radians = vtkMath::RadiansFromDegrees(angle);
  for (std::size_t k = 0; k < 3; ++k)
    outwards[k] = std::cos(radians) * zero[k] + std::sin(radians) * side[k];
  return outwards;
}

vtkSmartPointer<vtkMoteSlice> sliceAt(
  const CutKind& kind, const CutAxis& axis, double value, bool isUnrolled)
{
  auto slice = vtkSmartPointer<vtkMoteSlice>::New();
  std::array<double, 3> center = axis.point;
  const bool isAlong = kind.of == CutKind::Direction;
  const std::array<double, 3>& direction = isAlong ? kind.direction : axis.direction;
  if (isAlong)
    center = {0.0, 0.0, 0.0};
  if (isAlong || kind.of == CutKind::Height)
    for (std::size_t k = 0; k < 3; ++k)
      center[k] += value * direction[k];
  if (kind.of == CutKind::Radius)
  {
    slice->SetShape(isUnrolled ? vtkMoteSlice::UNROLLED_CYLINDER : vtkMoteSlice::CYLINDER);
    slice->SetRadius(value);
  }
  if (kind.of == CutKind::Angle)
    slice->SetShapeToHalfPlane();
  slice->SetCenter(center.data());
  slice->SetAxis(direction.data());
  slice->SetOutwards(outwardsAt(axis, kind.of == CutKind::Angle ? value : 0.0).data());
  return slice;
}

} // namespace

namespace
{

/// A slice that lies on the face of a cut by the same name lies within, by less than can be seen:
/// else rounding would cut part of it away.
double withinCuts(const CutSettings& cuts, const std::string& name, double place, double step)
{
  for (const ShowRange& cut : cuts.ranges)
    if (cut.name == name)
    {
      const auto [low, high] = cut.intervals.front();
      return place == low ? place + step : place == high ? place - step : place;
    }
  return place;
}

} // namespace

std::vector<vtkSmartPointer<vtkMoteSlice>> slicesOf(const Settings& settings, double length)
{
  std::vector<vtkSmartPointer<vtkMoteSlice>> slices;
  const CutAxis axis = cutAxisOf(settings.cuts.axis);
  if (!settings.volume.slices)
    return slices;
  for (const ShowRange& asked : *settings.volume.slices)
    if (const std::optional<CutKind> kind = cutNamed(asked.name))
      for (const Interval& place : asked.intervals)
      {
        const double step = 1e-6 * (kind->of == CutKind::Angle ? 360.0 : length);
        slices.push_back(sliceAt(*kind, axis,
          withinCuts(settings.cuts, asked.name, place.low, step), settings.volume.unroll));
      }
  return slices;
}

void moveSlices(const std::vector<vtkSmartPointer<vtkMoteSlice>>& slices, vtkLinearTransform* moved)
{
  for (const auto& slice : slices)
  {
    double to[3];
    moved->TransformPoint(slice->GetCenter(), to);
    slice->SetCenter(to);
    moved->TransformVector(slice->GetAxis(), to);
    slice->SetAxis(to);
    moved->TransformVector(slice->GetOutwards(), to);
    slice->SetOutwards(to);
  }
}

} // namespace mote::app
