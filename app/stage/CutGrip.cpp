#include "CutGrip.h"

#include "PlaceMath.h"

#include <vtkMath.h>
#include <vtkMoteClipCylinder.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

/// The coordinate of a cut at a place, where it grows, and by how much for each unit of length.
struct Coordinate
{
  double value, perLength;
  Vec way;
};

Coordinate coordinateAt(const CutKind& kind, const CutAxis& axis, const Vec& place)
{
  if (kind.of == CutKind::Direction)
    return {dot(place, kind.direction), 1.0, kind.direction};
  const Vec from = sum(place, -1.0, axis.point);
  const double height = dot(from, axis.direction);
  if (kind.of == CutKind::Height)
    return {height, 1.0, axis.direction};
  const Vec outwards = sum(from, -height, axis.direction);
  const double radius = std::sqrt(dot(outwards, outwards));
  const Vec unit = radius > 0.0 ? sum({}, 1.0 / radius, outwards) : Vec{};
  if (kind.of == CutKind::Radius)
    return {radius, 1.0, unit};
  vtkNew<vtkMoteClipCylinder> cylinder;
  cylinder->SetAxis(axis.direction.data());
  Vec zero{}, side{}, around{};
  cylinder->GetZeroAngle(zero.data());
  zero = sum(zero, -dot(zero, axis.direction), axis.direction);
  vtkMath::Normalize(zero.data());
  vtkMath::Cross(axis.direction.data(), zero.data(), side.data());
  vtkMath::Cross(axis.direction.data(), unit.data(), around.data());
  const double angle = vtkMath::DegreesFromRadians(std::atan2(dot(unit, side), dot(unit, zero)));
  return {angle < 0.0 ? angle + 360.0 : angle,
    radius > 0.0 ? vtkMath::DegreesFromRadians(1.0 / radius) : 0.0, around};
}

bool isThere(const CutKind& kind, double value, double place, double tolerance)
{
  const double away = kind.of == CutKind::Angle ? std::abs(std::remainder(value - place, 360.0))
                                                : std::abs(value - place);
  return std::isfinite(place) && away <= tolerance;
}

} // namespace

/// The first of which isMeant(name, kind, its value, coordinate of the place) is true.
template <typename IsMeant>
std::optional<CutGrip> CutGrip::find(
  const Settings& shown, const Vec& place, const IsMeant& isMeant)
{
  CutGrip grip;
  grip.axis_ = cutAxisOf(shown.cuts.axis);
  grip.place_ = place;
  const auto take = [&](const ShowRange& cut, double at)
  {
    const std::optional<CutKind> kind = cutNamed(cut.name);
    if (!kind)
      return false;
    const Coordinate found = coordinateAt(*kind, grip.axis_, place);
    if (!isMeant(cut.name, *kind, at, found))
      return false;
    grip.cut_ = cut.name;
    grip.kind_ = *kind;
    grip.value_ = at;
    grip.way_ = found.way;
    grip.perLength_ = found.perLength;
    return true;
  };
  for (const ShowRange& cut : shown.cuts.ranges)
    for (const bool isHigh : {false, true})
      if (take(cut, isHigh ? cut.intervals.front().high : cut.intervals.front().low))
      {
        grip.isHigh_ = isHigh;
        return grip;
      }
  grip.isSlice_ = true;
  for (const ShowRange& slice : shown.volume.slices.value_or(std::vector<ShowRange>()))
    for (std::size_t k = 0; k < slice.intervals.size(); ++k)
      if (!(shown.volume.unroll && slice.name == "r") && take(slice, slice.intervals[k].low))
      {
        grip.number_ = k;
        return grip;
      }
  return {};
}

std::optional<CutGrip> CutGrip::at(const Settings& shown, const Vec& place, double size)
{
  constexpr double near = 1e-5; // of the size: slices on faces of cuts lie a little within
  return find(shown, place,
    [&](const std::string&, const CutKind& kind, double at, const Coordinate& found)
    { return isThere(kind, found.value, at, near * size * std::max(found.perLength, 1e-300)); });
}

std::optional<CutGrip> CutGrip::of(
  const Settings& shown, const std::string& name, double value, const Vec& place)
{
  return find(shown, place,
    [&](const std::string& own, const CutKind&, double at, const Coordinate&)
    { return own == name && at == value; });
}

std::optional<double> CutGrip::valueAt(const GripRay& ray, const double bounds[6])
{
  constexpr double steep = 0.06; // the square of a sine: 14 degrees. A pixel would go four times as
                                 // far as aside, and much farther soon.
  // Lines place + s way and origin + t direction are nearest to one another at this s.
  const double length2 = dot(ray.direction, ray.direction);
  const double along = dot(way_, ray.direction), across2 = length2 - along * along;
  const Vec from = sum(place_, -1.0, ray.origin);
  double s = (along * dot(ray.direction, from) - length2 * dot(way_, from)) / across2;
  if (!isAlong_)
    isAlong_ = !(across2 > steep * length2);
  if (*isAlong_ && dot(ray.up, ray.up) > 0.0)
  {
    const Vec nearest = sum(ray.origin, dot(ray.direction, from) / length2, ray.direction);
    s = (along < 0.0 ? -1.0 : 1.0) * dot(sum(nearest, -1.0, place_), ray.up);
  }
  else if (!(across2 > 1e-3 * length2))
    return {};
  const double value = value_ + perLength_ * s;
  if (kind_.of == CutKind::Angle)
    return value - 360.0 * std::floor(value / 360.0);
  const Interval extent = extentOf(kind_, axis_, bounds);
  const double least = kind_.of == CutKind::Radius ? 1e-6 * extent.high : extent.low;
  return std::clamp(value, least, extent.high);
}

Settings CutGrip::moved(Settings settings, const Settings& shown, double value) const
{
  if (isSlice_)
  {
    std::vector<ShowRange> slices = shown.volume.slices.value_or(std::vector<ShowRange>());
    for (ShowRange& slice : slices)
      if (slice.name == cut_ && number_ < slice.intervals.size())
        slice.intervals[number_] = {value, value};
    settings.volume.slices = slices;
    return settings;
  }
  for (ShowRange& cut : settings.cuts.ranges)
    if (cut.name == cut_)
    {
      Interval& ends = cut.intervals.front();
      (isHigh_ ? ends.high : ends.low) = value;
      // An end does not pass the other; of angles it goes round.
      if (kind_.of != CutKind::Angle && ends.low > ends.high)
        (isHigh_ ? ends.high : ends.low) = isHigh_ ? ends.low : ends.high;
    }
  return settings;
}

} // namespace mote::app
