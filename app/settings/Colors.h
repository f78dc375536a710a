#pragma once

#include "Settings.h"

#include <string>

class vtkRenderer;

namespace mote::app
{

/// A colour by its HTML name or as #rgb or #rrggbb; false if the text is neither.
bool parseColor(const std::string& text, Color& color);

/// Gives the renderer one colour, or two from bottom to top, or the default for none.
void setBackground(vtkRenderer* renderer, const std::vector<Color>& colors);

/// A colour for text and lines that stands out against the renderer's background.
Color inkOn(vtkRenderer* renderer);

/// The renderer's background at a share of its height, from the bottom.
Color groundAt(vtkRenderer* renderer, double share);

/// How much of the data a veil in the background's colour hides, on which texts are read.
constexpr double veilOpacity = 0.7;

} // namespace mote::app
