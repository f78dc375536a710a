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
/// the histogram's range. `isOutside`: what is shown lies outside the range. `option` is what the
/// command line has for it.
bool rangeControl(const char* id, const Histogram& histogram, Interval& range, bool isOutside,
  const std::string& option = "--show NAME=LO:HI");

/// A range of which one end was entered beyond the other one: that follows, so that the range is as
/// wide as before, or as many times its lower end where all is above zero, as for logarithms.
Interval inOrder(const Interval& before, Interval entered);

/// A field for a number, or for a text with a hint where that is empty: true once it is left with
/// another one, by Enter, Tab or a click elsewhere.
bool numberField(const char* label, double& value, const char* format = "%.6g");
bool textField(const char* label, const char* hint, std::string& text);

/// Two fields for the numbers of a range, with this tooltip. Returns whether one was entered.
bool rangeFields(const char* id, Interval& range, const char* help);

/// Draws a histogram in the colours of its values, and over it the curve of the opacities, whose
/// points can be dragged, added by a double click and taken away by a right one. Points are in
/// values. Returns whether the points are others now. With the keys, space takes hold of a point,
/// arrows move it, Page Up and Page Down go to others, Insert adds one, Delete takes one away.
bool opacityControl(const char* id, const Histogram& histogram, vtkLookupTable* table,
  std::vector<OpacityPoint>& points);

/// The same points as numbers, in lines that are unfolded, with buttons that add and take away.
bool opacityFields(std::vector<OpacityPoint>& points, const Histogram& histogram);

/// Draws a histogram in the colours of its values with a line for each of some values, in any
/// order, which can be dragged, added by a double click and taken away by a right one. Returns
/// whether the values are others now.
bool isoControl(
  const char* id, const Histogram& histogram, vtkLookupTable* table, std::vector<double>& values);

/// One more value, in the middle of the widest gap between those that there are.
double newIsoValue(const Histogram& histogram, std::vector<double> values);

/// Draws a colour map as a strip of this width and height, at the cursor: from colour to colour, or
/// a block for each entry of the table.
void colorStrip(vtkLookupTable* table, float width, float height, bool isOfBlocks);

} // namespace mote::app
