#pragma once

#include "PickedSet.h"
#include "SimulationBox.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace mote::app
{

using Place = std::array<double, 3>;

/// The way from one place to another, in a periodic box to the nearest of its images.
struct Distance
{
  Place from{}, to{}; ///< as they are
  Place step{};       ///< from `from` to `to`, or to the image of `to` that is nearest
  double length = 0.0;
  double direct = 0.0;   ///< without the box
  bool isAcross = false; ///< by an image
};

/// What is between two places, or three.
struct Measured
{
  std::vector<Distance> distances; ///< from each place to the next
  std::optional<double> angle;     ///< at the second of three: degrees
};

/// Which of a box's vectors are periods: those that the data's "boundary" calls so ("pp").
std::array<bool, 3> periodsOf(vtkDataSet* data);

Distance distanceBetween(const Place& from, const Place& to,
  const std::optional<SimulationBox>& box, const std::array<bool, 3>& isPeriodic);

/// What is between two or three picked, in the order of picking; none of fewer or more.
std::optional<Measured> measure(const PickedSet::Parts& parts, const PickedSet& picked);

/// "12.3", and "12.3 to the nearest image" where it is by one.
std::string asText(const Distance& distance);

} // namespace mote::app
