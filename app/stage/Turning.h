#pragma once

#include "Cuts.h"
#include "Input.h"
#include "settings/Settings.h"

#include <vtkSmartPointer.h>
#include <vtkTransform.h>

namespace mote::app
{

/// How far a part has turned about an axis.
struct Turn
{
  CutAxis axis;
  double degrees = 0.0; ///< in [0, 360)
  bool operator==(const Turn&) const = default;
};

/// What --turn makes of a data set at its time, about the axis of --cut-axis, or else about the one
/// that the data name in the field arrays AxisOrigin and AxisDirection. Throws Failure for data
/// that turn by themselves.
Turn turnOf(const NamedData& one, const Settings& settings);

/// A sentence where parts are named that are not there, or that nothing turns as there is no time;
/// else nothing.
std::string idleTurns(const std::vector<NamedData>& data, const Settings& settings);

/// Turns about an axis, from the data's place to where they stand.
vtkSmartPointer<vtkTransform> transformOf(const Turn& turn);

/// Bounds of a box that has been moved; what is not initialized stays so.
void moveBounds(vtkTransform* moved, double bounds[6]);

} // namespace mote::app
