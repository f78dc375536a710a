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

} // namespace mote::app
