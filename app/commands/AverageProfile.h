#pragma once

#include "Chart.h"
#include "settings/Settings.h"

#include <vtkSmartPointer.h>
#include <vtkTable.h>

namespace mote::app
{

/// The table of a meridional average, averaged along the other direction, too, by volume. `over` is
/// the column that is left, "axial" or "radial", in ascending order: a quarter as many places as
/// there are bins.
vtkSmartPointer<vtkTable> profileOf(vtkTable* bins, const std::string& over);

/// The curves of profiles, of one time step or of several, which a column of times then tells.
/// `array` is what was averaged, with its unit. Throws Failure.
Chart profileChart(
  vtkTable* profiles, const std::string& array, const std::string& unit, const Settings& settings);

} // namespace mote::app
