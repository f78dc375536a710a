#pragma once

#include "settings/Settings.h"

#include <array>
#include <cstddef>

class vtkRenderer;

namespace mote::app
{

class Stage;

/// Where views lie beside one another in a picture of some size, and the legend beside them:
/// pixels.
struct SideBySide
{
  /// `isLabelled`: whether there is room for a legend, where the stage has one.
  SideBySide(
    const Stage& stage, std::size_t views, const std::array<int, 2>& size, bool isLabelled);

  /// Where a view begins, from the left.
  int begin(std::size_t view) const { return first + static_cast<int>(view) * width; }

  int width = 1;  ///< of each view
  int first = 0;  ///< where the first one begins
  int legend = 0; ///< width of what is left beside them
};

/// Of lines between views.
Color dividerInk(vtkRenderer* renderer);

} // namespace mote::app
