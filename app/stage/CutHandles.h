#pragma once

#include "CutGrip.h"
#include "settings/Settings.h"

#include <array>
#include <vector>

namespace mote::app
{

/// What a slice, or a face of a cut, is held by: its outline within the data's bounds, and a mark
/// in its middle.
struct CutHandle
{
  using Place = std::array<double, 3>;
  std::string name; ///< of the slice or cut
  double value = 0.0;
  Place middle{};
  std::vector<std::vector<Place>> outlines; ///< lines from place to place

  /// It, held at one of its places.
  std::optional<CutGrip> heldAt(const Settings& shown, const Place& place) const;
};

/// Those of all faces of cuts and of all slices that are shown, but for what is rolled out.
std::vector<CutHandle> cutHandles(const Settings& shown, const double bounds[6]);

} // namespace mote::app
