/**
 * Axes around a rectangle of an image, curves in it, and their names beside it.
 */

#ifndef MoteAxesPainter_h
#define MoteAxesPainter_h

#include "Canvas.h"
#include "TickValues.h"

#include <string>
#include <vector>

namespace mote::imaging
{

struct Curve
{
  std::string name;
  std::vector<double> x, y; // of one length; what is not finite is a gap
  Color color;
  bool isDashed = false;
};

struct AxesContent
{
  Rect frame;       // that the axes go around
  Rect namesFrame;  // where names of curves stand; empty for none
  double xRange[2]; // values at the frame's edges
  double yRange[2];
  std::string xTitle;
  std::string yTitle;
  double fontScale = 1.0;
  bool hasXLabels = true; // numbers and title below
  bool hasGrid = false;   // faint lines at the ticks
  bool hasDots = false;   // at the points of the curves
  std::vector<Curve> curves;
};

/// The ticks of both axes.
struct AxesTicks
{
  std::vector<Tick> x, y;
};

AxesTicks paintAxes(Canvas& canvas, const AxesContent& content);

} // namespace mote::imaging

#endif
