#pragma once

#include "PlaceMath.h"
#include "settings/Settings.h"

#include <vtkMoteClipCylinder.h>
#include <vtkNew.h>
#include <vtkPlaneCollection.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace mote::app
{

/// What the name of a cut means: a coordinate along a direction, or one about the axis of the cuts.
struct CutKind
{
  enum Of
  {
    Direction,
    Radius,
    Height,
    Angle
  } of = Direction;
  std::array<double, 3> direction = {0.0, 0.0, 0.0}; ///< of unit length
};

/// "x", "y", "z", three numbers "1,1,0", "r", "h" or "angle"; none for other names.
std::optional<CutKind> cutNamed(const std::string& name);

/// The axis of --cut-axis: a point on it, and its direction, of unit length; z through the origin
/// where none is given. Throws WrongValue where the numbers are no axis.
struct CutAxis
{
  std::array<double, 3> point = {0.0, 0.0, 0.0}, direction = {0.0, 0.0, 1.0};
  bool operator==(const CutAxis&) const = default;
};
CutAxis cutAxisOf(const std::vector<double>& numbers);

/// Where a coordinate of cuts may lie in a box: from and to; of angles a whole turn.
Interval extentOf(const CutKind& kind, const CutAxis& axis, const double bounds[6]);

/// The place in digits that are enough to tell a thousandth of a length or a little less.
double shortPlace(double place, double length);

/// What --cut asks for, as mappers take it.
class Cuts
{
public:
  void follow(const CutSettings& settings);

  vtkPlaneCollection* planes() const { return planes_; }
  /// Null where no cut is about the axis.
  vtkMoteClipCylinder* cylinder() const { return hasCylinder_ ? cylinder_.Get() : nullptr; }

  /// Whether a place lies in all of them.
  bool contains(const Vec& place) const;

private:
  bool isInCylinder(const Vec& place) const;
  void addPlanes(const std::array<double, 3>& direction, const Interval& shown);

  vtkNew<vtkPlaneCollection> planes_;
  vtkNew<vtkMoteClipCylinder> cylinder_;
  bool hasCylinder_ = false;
};

} // namespace mote::app
