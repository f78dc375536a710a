/**
 * Puts a laid-out legend on an image, legibly.
 */

#ifndef MoteLegendPainter_h
#define MoteLegendPainter_h

#include "Canvas.h"
#include "LegendLayout.h"

#include <functional>
#include <optional>

namespace mote::imaging
{

enum class PanelUse
{
  WhereNeeded,
  Always,
  Never
};

struct LegendStyle
{
  std::optional<Color> text; // none for dark or light, whichever stands out
  PanelUse panel = PanelUse::WhereNeeded;
};

/**
 * `barColor` maps the place along the bar, in (0, 1) from the bottom, to its colour.
 */
void paintLegend(Canvas& canvas, const LegendLayout& layout, const LegendStyle& style,
  const std::function<Color(double)>& barColor);

} // namespace mote::imaging

#endif
