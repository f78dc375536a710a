#pragma once

#include "settings/Settings.h"

#include <array>
#include <cstddef>
#include <vector>

class vtkRenderer;

namespace mote::app
{

class Stage;

/// Where views lie beside one another in a picture of some size, and the legend beside them:
/// pixels, from the lower left corner. Rows are filled from the upper left on; views are as near to
/// squares as the picture's shape lets them be.
struct SideBySide
{
  /// `isLabelled`: whether there is room for a legend, where the stage has one.
  SideBySide(
    const Stage& stage, std::size_t views, const std::array<int, 2>& size, bool isLabelled);

  int left(std::size_t view) const { return first + static_cast<int>(view) % columns * width; }
  int bottom(std::size_t view) const
  {
    return top - (static_cast<int>(view) / columns + 1) * height;
  }
  int right() const { return first + columns * width; } ///< of all views

  /// Lines between columns and rows of views, as {left, right, bottom, top}, without the pixels at
  /// right and top.
  std::vector<std::array<int, 4>> dividers() const;

  int columns = 1, rows = 1;
  int width = 1, height = 1; ///< of each view
  int first = 0;             ///< where the first column begins
  int top = 1;               ///< of the picture
  int legend = 0;            ///< width of what is left beside them
};

/// In how many rows so many views of a room come nearest to squares.
int rowsOf(int views, int width, int height);

/// Of lines between views.
Color dividerInk(vtkRenderer* renderer);

} // namespace mote::app
