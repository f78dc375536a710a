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
  rows = rowsOf(count, size[0] - legend, size[1]);
  columns = (count + rows - 1) / rows;
  width = std::max(1, (size[0] - legend) / columns);
  height = std::max(1, size[1] / rows);
  top = size[1];
  legend = std::max(0, size[0] - columns * width); // and what is left over
  first = picture.legendSide == "left" ? legend : 0;
}

std::vector<std::array<int, 4>> SideBySide::dividers() const
{
  const int thick = std::max(1, top / 700);
  std::vector<std::array<int, 4>> lines;
  for (int column = 1; column < columns; ++column)
  {
    const int x = this->left(static_cast<std::size_t>(column)) - thick / 2;
    lines.push_back({std::max(0, x), x + thick, 0, top});
  }
  for (int row = 1; row < rows; ++row)
  {
    const int y = top - row * height - thick / 2;
    lines.push_back({first, this->right(), std::max(0, y), y + thick});
  }
  return lines;
}

int rowsOf(int views, int width, int height)
{
  constexpr double worth = 1.1; // more rows are to be better by this, as steps down are harder to
                                // compare than steps aside
  int best = 1;
  const auto least = [&](int rows)
  { return std::min(double(width) / ((views + rows - 1) / rows), double(height) / rows); };
  for (int rows = 2; rows <= views; ++rows)
    if (least(rows) > worth * least(best))
      best = rows;
  return best;
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
