#include "LegendPainter.h"

#include "SvgDrawing.h"

#include <algorithm>
#include <cmath>

namespace mote::imaging
{
namespace
{

constexpr Color Dark{0.08, 0.08, 0.09, 1.0};
constexpr Color Light{0.96, 0.96, 0.96, 1.0};
constexpr double ReadableContrast = 4.5;
/// Spread of luminance below which a background counts as plain: it has no edges to read across.
constexpr double PlainSpread = 0.05;

struct Ink
{
  Color text;
  Color panel; // alpha 0 for none
};

/// What lies behind a rectangle.
struct Background
{
  double meanLuminance = 1.0;
  double spread = 0.0;       // standard deviation of the luminance
  double darkUnreadable = 0; // shares of pixels on which dark or light text cannot be read
  double lightUnreadable = 0;
};

Background look(const Canvas& canvas, const Rect& rect)
{
  const Rect inside = rect.clipped(canvas.width(), canvas.height());
  Background result;
  if (inside.isEmpty())
    return result;
  const double dark = luminance(Dark);
  const double light = luminance(Light);
  double sum = 0.0;
  double squares = 0.0;
  for (int y = inside.y0; y < inside.y1; ++y)
  {
    for (int x = inside.x0; x < inside.x1; ++x)
    {
      const double value = luminance(canvas.seen(x, y));
      sum += value;
      squares += value * value;
      result.darkUnreadable += contrast(value, dark) < ReadableContrast;
      result.lightUnreadable += contrast(value, light) < ReadableContrast;
    }
  }
  const double count = static_cast<double>(inside.width()) * inside.height();
  result.meanLuminance = sum / count;
  result.spread = std::sqrt(std::max(0.0, squares / count - std::pow(sum / count, 2)));
  result.darkUnreadable /= count;
  result.lightUnreadable /= count;
  return result;
}

Ink chooseInk(const Background& background, const LegendStyle& style)
{
  const double mean = background.meanLuminance;
  const bool isDark = contrast(mean, luminance(Dark)) >= contrast(mean, luminance(Light));
  Ink ink;
  ink.text = style.text.value_or(isDark ? Dark : Light);
  const bool isDarkText = luminance(ink.text) < 0.18;
  const double unreadable = isDarkText ? background.darkUnreadable : background.lightUnreadable;
  const bool isPlain = background.spread < PlainSpread && unreadable < 0.01;
  ink.panel = isDarkText ? Color{1.0, 1.0, 1.0, 0.78} : Color{0.05, 0.05, 0.06, 0.72};
  if (style.panel == PanelUse::Never || (style.panel == PanelUse::WhereNeeded && isPlain))
    ink.panel.alpha = 0.0;
  return ink;
}

/// A triangle that fills `rect`, its tip up or down, antialiased.
void fillTriangle(Canvas& canvas, const Rect& rect, bool isUp, double inset, const Color& color)
{
  const double half = rect.width() / 2.0;
  const double height = rect.height();
  const double middle = rect.x0 + half;
  const auto isInside = [&](double x, double y)
  {
    const double fromBase = isUp ? y - rect.y0 : rect.y1 - y;
    const double slack = half * (1.0 - fromBase / height) - std::abs(x - middle);
    // The distance from a slanted side is the horizontal one times the cosine of its slope.
    return fromBase >= inset && slack * height / std::hypot(half, height) >= inset;
  };
  if (SvgDrawing* svg = canvas.svg())
  {
    // The sides move inwards by `inset`; the tip by more, as it is narrower.
    const double shift = inset * std::hypot(half, height) / half, side = shift + inset;
    const double base = isUp ? rect.y0 + inset : rect.y1 - inset;
    const double tip = isUp ? rect.y1 - shift : rect.y0 + shift;
    const double beside = half * (1.0 - side / height);
    svg->addPolygon({{middle - beside, base}, {middle + beside, base}, {middle, tip}}, color);
  }
  canvas.fillShape(rect, color,
    [&](double x, double y)
    {
      constexpr int n = 8;
      int hits = 0;
      for (int i = 0; i < n * n; ++i)
      {
        hits += isInside(x - 0.5 + (i % n + 0.5) / n, y - 0.5 + (i / n + 0.5) / n);
      }
      return static_cast<double>(hits) / (n * n);
    });
}

void paintSwatch(Canvas& canvas, const Swatch& swatch, int line, const Color& frame)
{
  if (swatch.shape == SwatchShape::Square)
  {
    canvas.fill(swatch.rect.grown(line), frame);
    canvas.fill(swatch.rect, swatch.color);
    return;
  }
  const bool isUp = swatch.shape == SwatchShape::Up;
  const Rect outer{swatch.rect.x0 - line, swatch.rect.y0, swatch.rect.x1 + line, swatch.rect.y1};
  fillTriangle(canvas, outer, isUp, 0.0, frame);
  fillTriangle(canvas, outer, isUp, line, swatch.color);
}

void paintBar(Canvas& canvas, const LegendLayout& layout, const Color& frame,
  const std::function<Color(double)>& barColor)
{
  canvas.fill(layout.bar.grown(layout.line), frame);
  for (int y = layout.bar.y0; y < layout.bar.y1; ++y)
  {
    const Color color = barColor((y - layout.bar.y0 + 0.5) / layout.bar.height());
    canvas.fill({layout.bar.x0, y, layout.bar.x1, y + 1}, color);
  }
}

} // namespace

void paintLegend(Canvas& canvas, const LegendLayout& layout, const LegendStyle& style,
  const std::function<Color(double)>& barColor)
{
  // Where all is said nothing depends on what lies behind.
  const bool isSaid = style.text && style.panel != PanelUse::WhereNeeded;
  const Ink ink = chooseInk(isSaid ? Background() : look(canvas, layout.panel), style);
  if (ink.panel.alpha > 0.0)
  {
    // A faint edge, since the panel may be as light or dark as what is beside it.
    const double radius = 0.35 * layout.unit;
    Color edge = ink.text;
    edge.alpha = 0.25;
    canvas.fillRounded(layout.panel, radius, edge);
    canvas.fillRounded(layout.panel.grown(-layout.line), radius - layout.line, ink.panel);
  }
  if (barColor && !layout.bar.isEmpty())
    paintBar(canvas, layout, ink.text, barColor);
  for (const Swatch& swatch : layout.swatches)
    paintSwatch(canvas, swatch, layout.line, ink.text);
  for (const Rect& mark : layout.marks)
    canvas.fill(mark, ink.text);
  for (const PlacedText& text : layout.texts)
    canvas.draw(text.mask, text.x, text.y, ink.text);
}

} // namespace mote::imaging
