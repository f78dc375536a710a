#include "Cuts.h"

#include "base/Text.h"
#include "settings/Values.h"

#include <vtkMath.h>
#include <vtkPlane.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mote::app
{

namespace
{

/// Whether it had a length.
bool makeUnit(std::array<double, 3>& direction)
{
  for (const double part : direction)
    if (!std::isfinite(part))
      return false;
  return vtkMath::Normalize(direction.data()) > 0.0;
}

bool readDirection(const std::string& text, std::array<double, 3>& direction)
{
  std::istringstream words(text);
  std::string word;
  std::size_t count = 0;
  for (; std::getline(words, word, ','); ++count)
    if (count == 3 || !parseNumber(word, direction[count]))
      return false;
  return count == 3 && makeUnit(direction);
}

} // namespace

std::optional<CutKind> cutNamed(const std::string& name)
{
  CutKind kind;
  for (const auto& [own, of] :
    {std::pair{"r", CutKind::Radius}, {"h", CutKind::Height}, {"angle", CutKind::Angle}})
    if (name == own)
    {
      kind.of = of;
      return kind;
    }
  const std::string axes = "xyz";
  if (name.size() == 1 && axes.find(name) != std::string::npos)
    kind.direction[axes.find(name)] = 1.0;
  else if (!readDirection(name, kind.direction))
    return {};
  return kind;
}

CutAxis cutAxisOf(const std::vector<double>& numbers)
{
  CutAxis axis;
  if (numbers.empty())
    return axis;
  if (numbers.size() != 3 && numbers.size() != 6)
    throw WrongValue{"an axis is three numbers, its direction, or six, a point and its direction"};
  if (numbers.size() == 6)
    std::copy_n(numbers.begin(), 3, axis.point.begin());
  std::copy_n(numbers.end() - 3, 3, axis.direction.begin());
  if (!makeUnit(axis.direction))
    throw WrongValue{"the direction of an axis must not be 0"};
  return axis;
}

Interval extentOf(const CutKind& kind, const CutAxis& axis, const double bounds[6])
{
  if (kind.of == CutKind::Angle)
    return {0.0, 360.0};
  Interval extent = {HUGE_VAL, -HUGE_VAL};
  for (int corner = 0; corner < 8; ++corner)
  {
    double at[3], from[3];
    for (int k = 0; k < 3; ++k)
    {
      at[k] = bounds[2 * k + (corner >> k & 1)];
      from[k] = at[k] - axis.point[static_cast<std::size_t>(k)];
    }
    const double height = vtkMath::Dot(from, axis.direction.data());
    const double value = kind.of == CutKind::Direction ? vtkMath::Dot(at, kind.direction.data())
                         : kind.of == CutKind::Height
                           ? height
                           : std::sqrt(std::max(0.0, vtkMath::Dot(from, from) - height * height));
    extent.low = std::min(extent.low, value);
    extent.high = std::max(extent.high, value);
  }
  if (kind.of == CutKind::Radius)
    extent.low = 0.0;
  return extent;
}

double shortPlace(double place, double length)
{
  if (!(length > 0.0))
    return place;
  // A division by a power of ten that is whole gives the number that has these digits.
  const double decimals = 3.0 - std::floor(std::log10(length));
  const double power = std::pow(10.0, std::abs(decimals));
  return (decimals > 0.0 ? std::round(place * power) / power : std::round(place / power) * power) +
         0.0; // no -0
}

void Cuts::addPlanes(const std::array<double, 3>& direction, const Interval& shown)
{
  for (const double sign : {1.0, -1.0})
  {
    const double end = sign > 0.0 ? shown.low : shown.high;
    if (!std::isfinite(end))
      continue;
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(end * direction[0], end * direction[1], end * direction[2]);
    plane->SetNormal(sign * direction[0], sign * direction[1], sign * direction[2]);
    planes_->AddItem(plane);
  }
}

void Cuts::follow(const CutSettings& settings)
{
  planes_->RemoveAllItems();
  hasCylinder_ = false;
  const CutAxis axis = cutAxisOf(settings.axis);
  cylinder_->SetCenter(axis.point.data());
  cylinder_->SetAxis(axis.direction.data());
  const auto finite = [](double v) { return std::clamp(v, -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX); };
  Interval radius = {0.0, VTK_DOUBLE_MAX}, height = {-VTK_DOUBLE_MAX, VTK_DOUBLE_MAX};
  Interval angle = {0.0, 360.0};
  for (const ShowRange& range : settings.ranges)
  {
    const std::optional<CutKind> kind = cutNamed(range.name);
    if (!kind || range.intervals.empty())
      continue;
    const Interval shown = {
      finite(range.intervals.front().low), finite(range.intervals.front().high)};
    hasCylinder_ = hasCylinder_ || kind->of != CutKind::Direction;
    if (kind->of == CutKind::Direction)
      this->addPlanes(kind->direction, range.intervals.front());
    else if (kind->of == CutKind::Radius)
      radius = shown;
    else if (kind->of == CutKind::Height)
      height = shown;
    else // of which an open end is that of the turn
      angle = {std::isfinite(range.intervals.front().low) ? shown.low : angle.low,
        std::isfinite(range.intervals.front().high) ? shown.high : angle.high};
  }
  cylinder_->SetRadiusRange(radius.low, radius.high);
  cylinder_->SetHeightRange(height.low, height.high);
  cylinder_->SetAngleRange(angle.low, angle.high);
}

bool Cuts::isInCylinder(const Vec& place) const
{
  Vec center{}, axis{}, zero{};
  cylinder_->GetCenter(center.data());
  cylinder_->GetAxis(axis.data());
  cylinder_->GetZeroAngle(zero.data());
  vtkMath::Normalize(axis.data());
  zero = sum(zero, -dot(zero, axis), axis);
  vtkMath::Normalize(zero.data());
  Vec across{};
  vtkMath::Cross(axis.data(), zero.data(), across.data());
  const Vec from = sum(place, -1.0, center);
  const double x = dot(from, zero), y = dot(from, across), height = dot(from, axis);
  const double radius = std::hypot(x, y);
  const double* radii = cylinder_->GetRadiusRange();
  const double* heights = cylinder_->GetHeightRange();
  const double* angles = cylinder_->GetAngleRange();
  if (radius < radii[0] || radius > radii[1] || height < heights[0] || height > heights[1])
    return false;
  double turn = angles[1] - angles[0];
  if (turn < 0.0)
    turn += 360.0;
  double angle = vtkMath::DegreesFromRadians(std::atan2(y, x)) - angles[0];
  angle -= 360.0 * std::floor(angle / 360.0);
  return turn >= 360.0 || angle <= turn;
}

bool Cuts::contains(const Vec& place) const
{
  for (int i = 0; i < planes_->GetNumberOfItems(); ++i)
    if (planes_->GetItem(i)->EvaluateFunction(place[0], place[1], place[2]) < 0.0)
      return false;
  return !hasCylinder_ || this->isInCylinder(place);
}

} // namespace mote::app
