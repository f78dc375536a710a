#pragma once

#include "Arrays.h"
#include "settings/Settings.h"

#include <vector>

namespace mote::app
{

/// Opacities that show what is rare and let through what is common: the least and the greatest
/// values by volume are the most opaque. Of one value everywhere, the same opacity. Of no value,
/// none. The data sets count together.
std::vector<OpacityPoint> opacitiesFor(
  const std::vector<vtkDataSet*>& data, const ArrayChoice& choice);

/// Keeps opacities until data or array change.
class UsualOpacity
{
public:
  const std::vector<OpacityPoint>& of(
    const std::vector<vtkDataSet*>& data, const ArrayChoice& choice);

private:
  std::vector<std::pair<vtkDataSet*, unsigned long>> key_; ///< with their times of change
  ArrayChoice choice_;
  std::vector<OpacityPoint> points_;
};

} // namespace mote::app
