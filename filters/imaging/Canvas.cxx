#include "Canvas.h"

#include "SvgDrawing.h"

#include <vtkDataArray.h>

#include <algorithm>
#include <cmath>

namespace mote::imaging
{
namespace
{

double linear(double value)
{
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

} // namespace

double luminance(const Color& color)
{
  return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
}

double contrast(double luminance, double otherLuminance)
{
  const auto [dark, light] = std::minmax(luminance, otherLuminance);
  return (light + 0.05) / (dark + 0.05);
}

Rect Rect::clipped(int width, int height) const
{
  return {std::max(x0, 0), std::max(y0, 0), std::min(x1, width), std::min(y1, height)};
}

Canvas::Canvas(vtkDataArray* colors, int width, int height, SvgDrawing* svg)
  : m_colors(colors)
  , m_width(width)
  , m_height(height)
  , m_components(colors->GetNumberOfComponents())
  , m_svg(svg)
  , m_scale(colors->GetDataType() == VTK_UNSIGNED_CHAR ? 1.0 / 255.0 : 1.0)
{
}

Color Canvas::seen(int x, int y) const
{
  double v[4] = {0.0, 0.0, 0.0, 1.0 / m_scale};
  m_colors->GetTuple(static_cast<vtkIdType>(y) * m_width + x, v);
  const double alpha = std::clamp(v[3] * m_scale, 0.0, 1.0);
  const double factor = m_scale < 1.0 ? alpha * m_scale : 1.0;
  const auto channel = [&](double value)
  {
    const double over = value * factor + 1.0 - alpha;
    return over > 0.0 ? std::min(over, 1.0) : 0.0; // NaN becomes 0
  };
  return {channel(v[0]), channel(v[1]), channel(v[2]), 1.0};
}

void Canvas::blend(int x, int y, const Color& color, double coverage)
{
  const double share = coverage * color.alpha;
  if (x < 0 || y < 0 || x >= m_width || y >= m_height || share <= 0.0)
    return;
  const vtkIdType pixel = static_cast<vtkIdType>(y) * m_width + x;
  const bool isStraight = m_scale < 1.0;
  double v[4] = {0.0, 0.0, 0.0, 1.0 / m_scale};
  m_colors->GetTuple(pixel, v);
  const double alpha = v[3] * m_scale;
  const double newAlpha = share + alpha * (1.0 - share);
  const double drawn[3] = {color.red, color.green, color.blue};
  for (int c = 0; c < 3; ++c)
  {
    const double behind = share < 1.0 ? v[c] * m_scale * (isStraight ? alpha : 1.0) : 0.0;
    const double mixed = drawn[c] * share + behind * (1.0 - share);
    v[c] = isStraight ? std::round(mixed / newAlpha / m_scale) : mixed;
  }
  v[3] = isStraight ? std::round(newAlpha / m_scale) : newAlpha;
  m_colors->SetTuple(pixel, v);
}

void Canvas::fill(const Rect& rect, const Color& color)
{
  if (m_svg)
    m_svg->addRectangle(rect, 0.0, color);
  fillShape(rect, color, [](double, double) { return 1.0; });
}

void Canvas::fillShape(
  const Rect& rect, const Color& color, const std::function<double(double, double)>& coverage)
{
  const Rect inside = rect.clipped(m_width, m_height);
  for (int y = inside.y0; y < inside.y1; ++y)
    for (int x = inside.x0; x < inside.x1; ++x)
      blend(x, y, color, coverage(x + 0.5, y + 0.5));
}

void Canvas::fillRounded(const Rect& rect, double radius, const Color& color)
{
  if (m_svg)
    m_svg->addRectangle(rect, radius, color);
  fillShape(rect, color,
    [&](double x, double y)
    {
      const double dx = std::max({rect.x0 + radius - x, x - (rect.x1 - radius), 0.0});
      const double dy = std::max({rect.y0 + radius - y, y - (rect.y1 - radius), 0.0});
      return std::clamp(radius - std::hypot(dx, dy) + 0.5, 0.0, 1.0);
    });
}

void Canvas::draw(const TextMask& mask, int x, int y, const Color& color)
{
  if (m_svg)
    m_svg->addText(mask, x, y, color);
  for (int row = 0; row < mask.height; ++row)
  {
    for (int column = 0; column < mask.width; ++column)
    {
      const std::uint8_t value = mask.coverage[static_cast<std::size_t>(row) * mask.width + column];
      blend(x + mask.left + column, y + mask.bottom + row, color, value / 255.0);
    }
  }
}

} // namespace mote::imaging
