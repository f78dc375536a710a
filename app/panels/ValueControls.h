#pragma once

#include "settings/Settings.h"
#include "stage/Histogram.h"

#include <string>
#include <vector>

class vtkLookupTable;

namespace mote::app
{

/// Draws a histogram with two handles at the ends of a range, which can be dragged, as can what
/// lies between them. Returns whether the range is another one now. Keeps `low` <= `high`, within
/// the histogram's range.
bool rangeControl(const char* id, const Histogram& histogram, Interval& range);

/// A range of which one end was entered beyond the other one: that follows, so that the range is as
/// wide as before, or as many times its lower end where all is above zero, as for logarithms.
Interval inOrder(const Interval& before, Interval entered);

/// Two fields for the numbers of a range. Returns whether one was entered.
bool rangeFields(const char* id, Interval& range);

/// Draws a histogram in the colours of its values, and over it the curve of the opacities, whose
/// points can be dragged, added by a double click and taken away by a right one. Points are in
/// values. Returns whether the points are others now.
bool opacityControl(const char* id, const Histogram& histogram, vtkLookupTable* table,
  std::vector<OpacityPoint>& points);

/// Draws a histogram in the colours of its values with a line for each of some values, in any
/// order, which can be dragged, added by a double click and taken away by a right one. Returns
/// whether the values are others now.
bool isoControl(
  const char* id, const Histogram& histogram, vtkLookupTable* table, std::vector<double>& values);

/// One more value, in the middle of the widest gap between those that there are.
double newIsoValue(const Histogram& histogram, std::vector<double> values);

/// Draws a colour map as a strip of this width and height, at the cursor.
void colorStrip(vtkLookupTable* table, float width, float height);

} // namespace mote::app
