#pragma once

#include "stage/Plot.h"

#include <string>

namespace mote::app
{

/// The counts of a plot as comma-separated values: a line for each part of the range that holds
/// something, with its ends.
std::string plotText(const Plot& plot, const PlotChoice& choice);

/// The plot as a picture, with axes: bars of a histogram, or colours with a legend. The file's
/// ending says which picture. Throws Failure.
void writePlotPicture(const Plot& plot, const PlotChoice& choice, bool isLogarithmic,
  const std::string& caption, const std::string& file);

} // namespace mote::app
