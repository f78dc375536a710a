#pragma once

#include <string>
#include <vector>

namespace mote::app
{

struct ChartCurve
{
  std::string name;
  std::vector<double> x, y; ///< of one length; what is not finite is a gap
  double value = 0.0;       ///< that colours it, where Chart::colorTitle is not empty
};

/// One quantity.
struct ChartPanel
{
  std::string title; ///< with its unit
  std::vector<ChartCurve> curves;
};

/// Curves over one axis, in panels one above the other, all with the same curves in one order.
struct Chart
{
  std::string xTitle, caption;
  std::vector<ChartPanel> panels;
  std::string colorTitle;    ///< what curves are coloured by; empty: each has a colour of its own
  std::vector<double> range; ///< of the values in all panels; none: theirs
  double fontScale = 1.0;
};

/// How many curves a list of names tells apart well; more are to be coloured by a value.
constexpr std::size_t mostNamedCurves = 8;

/// Writes it as a picture, or as .svg. Throws Failure, also where nothing can be seen.
void writeChart(const Chart& chart, const std::string& file);

} // namespace mote::app
