#include "SideBySide.h"

#include "Stage.h"
#include "settings/Colors.h"

#include <algorithm>

namespace mote::app
{

SideBySide::SideBySide(
  const Stage& stage, std::size_t views, const std::array<int, 2>& size, bool isLabelled)
{
  const PictureSettings& picture = stage.settings().picture;
  const bool hasLegend = isLabelled && picture.legend && stage.coloring().legendTable();
  const int count = static_cast<int>(std::max<std::size_t>(1, views));
  legend = hasLegend ? std::min(static_cast<int>(0.17 * size[1]), size[0] / 3) : 0;
  width = std::max(1, (size[0] - legend) / count);
  legend = std::max(0, size[0] - count * width); // and what is left over
  first = picture.legendSide == "left" ? legend : 0;
}

Color dividerInk(vtkRenderer* renderer)
{
  const Color ink = inkOn(renderer);
  const double* ground = renderer->GetBackground();
  Color quiet;
  for (std::size_t i = 0; i < 3; ++i)
    quiet[i] = 0.45 * ink[i] + 0.55 * ground[i];
  return quiet;
}

} // namespace mote::app
