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
  /// What opacitiesFor() found of an array.
  struct Found
  {
    ArrayChoice choice;
    std::vector<OpacityPoint> points;
  };

  const std::vector<OpacityPoint>& of(
    const std::vector<vtkDataSet*>& data, const ArrayChoice& choice);
  /// Takes what was found of these data before.
  void offer(const std::vector<vtkDataSet*>& data, const Found& found);
  /// What was found of these data; no array where nothing was.
  Found foundOf(const std::vector<vtkDataSet*>& data) const;

private:
  std::vector<std::pair<vtkDataSet*, unsigned long>> key_; ///< with their times of change
  Found found_;
};

} // namespace mote::app
