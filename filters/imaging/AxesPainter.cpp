#include "AxesPainter.h"

#include "LegendLayout.h"
#include "Segment.h"
#include "SvgDrawing.h"
#include "TextLines.h"
#include "TextMask.h"

#include <algorithm>
#include <cmath>

namespace mote::imaging
{
namespace
{

int toPixel(double value)
{
  return static_cast<int>(std::lround(value));
}

/// The text as it is read from the right, from the bottom up.
TextMask turned(const TextMask& text)
{
  TextMask result;
  result.left = -text.top();
  result.bottom = text.left;
  result.width = text.height;
  result.height = text.width;
  result.advance = text.advance;
  result.text = text.text;
  result.size = text.size;
  result.isTurned = true;
  result.coverage.resize(text.coverage.size());
  for (int y = 0; y < text.height; ++y)
    for (int x = 0; x < text.width; ++x)
      result.coverage[static_cast<std::size_t>(x) * text.height + (text.height - 1 - y)] =
        text.coverage[static_cast<std::size_t>(y) * text.width + x];
  return result;
}

/// One picture's axes.
class AxesPainter
{
public:
  AxesPainter(Canvas& canvas, const AxesContent& content)
    : m_content(content)
    , m_canvas(canvas)
    , m_font("")
    , m_unit(labelSize(canvas.width(), canvas.height(), content.fontScale))
    , m_line(std::max(1, toPixel(0.06 * m_unit)))
    , m_frame(content.frame)
  {
    const double paper = luminance(canvas.seen(0, 0));
    const bool isDark = contrast(paper, 0.0) >= contrast(paper, 1.0);
    m_ink = isDark ? Color{0.08, 0.08, 0.09, 1.0} : Color{0.96, 0.96, 0.96, 1.0};
  }

  AxesTicks paint()
  {
    std::string xTitle = m_content.xTitle, yTitle = m_content.yTitle;
    AxesTicks ticks;
    ticks.x = this->ticksOf(m_content.xRange, 4.5 * m_unit / m_frame.width(), xTitle);
    ticks.y = this->ticksOf(m_content.yRange, 1.6 * m_unit / m_frame.height(), yTitle);
    if (m_content.hasGrid)
      this->paintGrid(ticks);
    for (const Curve& curve : m_content.curves)
      this->paintCurve(curve);
    this->paintFrame();
    this->paintAcross(ticks.x, xTitle);
    this->paintUp(ticks.y, yTitle);
    if (!m_content.namesFrame.isEmpty())
      this->paintNames();
    return ticks;
  }

private:
  /// Ticks that leave room for labels, `share` of the axis each; their common power goes to the
  /// title.
  static std::vector<Tick> ticksOf(const double range[2], double share, std::string& title)
  {
    const TickSet ticks = makeTicks(
      {range[0], range[1], false}, std::clamp(static_cast<int>(0.6 / share), 2, 7), share, {});
    if (ticks.exponent != 0)
      title += (title.empty() ? "" : "  ") + ("\u00d7" + powerOfTen(ticks.exponent));
    return ticks.ticks;
  }

  int xOf(const Tick& tick) const
  {
    return m_frame.x0 + toPixel(tick.share * (m_frame.width() - m_line));
  }
  int yOf(const Tick& tick) const
  {
    return m_frame.y0 + toPixel(tick.share * (m_frame.height() - m_line));
  }

  void paintGrid(const AxesTicks& ticks)
  {
    const Color faint{m_ink.red, m_ink.green, m_ink.blue, 0.12};
    for (const Tick& tick : ticks.x)
      m_canvas.fill({xOf(tick), m_frame.y0, xOf(tick) + m_line, m_frame.y1}, faint);
    for (const Tick& tick : ticks.y)
      m_canvas.fill({m_frame.x0, yOf(tick), m_frame.x1, yOf(tick) + m_line}, faint);
  }

  void paintFrame()
  {
    const Rect outer = m_frame.grown(m_line);
    m_canvas.fill({outer.x0, outer.y0, outer.x1, m_frame.y0}, m_ink);
    m_canvas.fill({outer.x0, m_frame.y1, outer.x1, outer.y1}, m_ink);
    m_canvas.fill({outer.x0, m_frame.y0, m_frame.x0, m_frame.y1}, m_ink);
    m_canvas.fill({m_frame.x1, m_frame.y0, outer.x1, m_frame.y1}, m_ink);
  }

  void paintAcross(const std::vector<Tick>& ticks, const std::string& title)
  {
    const int tickEnd = m_frame.y0 - m_line - toPixel(0.4 * m_unit);
    const int base = tickEnd - toPixel(1.1 * m_unit);
    for (const Tick& tick : ticks)
    {
      const int x = xOf(tick);
      m_canvas.fill({x, tickEnd, x + m_line, m_frame.y0}, m_ink);
      if (!m_content.hasXLabels)
        continue;
      const TextMask label = m_font.draw(tick.label, m_unit);
      m_canvas.draw(label, x - toPixel(0.5 * label.advance), base, m_ink);
    }
    if (!m_content.hasXLabels)
      return;
    const TextMask text =
      m_font.draw(cutText(m_font, title, m_unit, 1.2 * m_frame.width()), m_unit);
    m_canvas.draw(text, (m_frame.x0 + m_frame.x1) / 2 - toPixel(0.5 * text.advance),
      base - toPixel(1.6 * m_unit), m_ink);
  }

  void paintUp(const std::vector<Tick>& ticks, const std::string& title)
  {
    const TextMask zero = m_font.draw("0", m_unit);
    const int tickEnd = m_frame.x0 - m_line - toPixel(0.4 * m_unit);
    double widest = 0.0;
    for (const Tick& tick : ticks)
    {
      const int y = yOf(tick);
      m_canvas.fill({tickEnd, y, m_frame.x0, y + m_line}, m_ink);
      const TextMask label = m_font.draw(tick.label, m_unit);
      widest = std::max(widest, label.advance);
      m_canvas.draw(label, tickEnd - toPixel(0.35 * m_unit + label.advance),
        y - (zero.bottom + zero.top()) / 2, m_ink);
    }
    const TextMask text =
      turned(m_font.draw(cutText(m_font, title, m_unit, 1.2 * m_frame.height()), m_unit));
    m_canvas.draw(text, tickEnd - toPixel(0.35 * m_unit + widest + 0.8 * m_unit),
      (m_frame.y0 + m_frame.y1) / 2 - toPixel(0.5 * text.advance), m_ink);
  }

  double halfWidth() const { return std::max(0.75, 0.09 * m_unit); }
  double dashOf(const Curve& curve) const { return curve.isDashed ? 0.5 * m_unit : 0.0; }

  void paintCurve(const Curve& curve)
  {
    if (SvgDrawing* svg = m_canvas.svg())
      svg->beginGroup(curve.name, m_frame);
    SvgDrawing::Points line;
    for (std::size_t i = 0; i < curve.x.size(); ++i)
    {
      const double x = place(curve.x[i], m_content.xRange, m_frame.x0, m_frame.width());
      const double y = place(curve.y[i], m_content.yRange, m_frame.y0, m_frame.height());
      const bool isEnd = i + 1 == curve.x.size();
      if (!std::isfinite(x) || !std::isfinite(y))
      {
        this->paintLine(line, curve);
        line.clear();
      }
      // Points closer than this are no other line.
      else if (line.empty() || isEnd ||
               std::hypot(x - line.back().first, y - line.back().second) >= 0.5)
        line.emplace_back(x, y);
    }
    this->paintLine(line, curve);
    if (SvgDrawing* svg = m_canvas.svg())
      svg->endGroup();
  }

  void paintLine(const SvgDrawing::Points& points, const Curve& curve)
  {
    if (points.empty())
      return;
    const double half = halfWidth();
    // A point alone is seen, too.
    if (m_content.hasDots || points.size() == 1)
      for (const auto& [x, y] : points)
        this->paintDot(x, y, m_content.hasDots ? 2.2 * half : half, curve.color);
    if (SvgDrawing* svg = m_canvas.svg(); svg && points.size() > 1)
      svg->addLine(points, 2.0 * half, dashOf(curve), curve.color);
    double along = 0.0; // of the line, for its dashes
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      const double a[2] = {points[i - 1].first, points[i - 1].second};
      const double b[2] = {points[i].first, points[i].second};
      this->paintDashes(a, b, along, curve, m_frame);
      along += std::hypot(b[0] - a[0], b[1] - a[1]);
    }
  }

  void paintDot(double x, double y, double radius, const Color& color)
  {
    if (SvgDrawing* svg = m_canvas.svg())
      svg->addDot(x, y, radius, color);
    const double at[2] = {x, y};
    double a[2], b[2]; // far outside there are no pixels
    if (clipped(at, at, m_frame.grown(toPixel(radius) + 1), a, b))
      this->paintSegment(at, at, radius, color, m_frame);
  }

  void paintDashes(
    const double from[2], const double to[2], double along, const Curve& curve, const Rect& inside)
  {
    const double half = halfWidth(), dash = dashOf(curve);
    double a[2], b[2];
    if (!clipped(from, to, inside.grown(toPixel(half) + 2), a, b))
      return;
    if (dash <= 0.0)
    {
      this->paintSegment(a, b, half, curve.color, inside);
      return;
    }
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    const double begin = along + std::hypot(a[0] - from[0], a[1] - from[1]);
    const double end = along + std::hypot(b[0] - from[0], b[1] - from[1]);
    for (double k = std::floor(begin / (2.0 * dash)); 2.0 * dash * k < end; ++k)
    {
      const double on = std::max(begin, 2.0 * dash * k);
      const double off = std::min(end, 2.0 * dash * k + dash);
      if (!(on < off))
        continue;
      const auto at = [&](double place, double p[2])
      {
        for (int axis = 0; axis < 2; ++axis)
          p[axis] = from[axis] + (place - along) / length * (to[axis] - from[axis]);
      };
      double p[2], q[2];
      at(on, p);
      at(off, q);
      this->paintSegment(p, q, half, curve.color, inside);
    }
  }

  void paintSegment(
    const double a[2], const double b[2], double half, const Color& color, const Rect& inside)
  {
    Rect rect = rectAround(a, b, half + 1.0);
    rect = {std::max(rect.x0, inside.x0), std::max(rect.y0, inside.y0),
      std::min(rect.x1, inside.x1), std::min(rect.y1, inside.y1)};
    m_canvas.fillShape(rect, color,
      [&](double x, double y)
      { return std::clamp(half + 0.5 - distanceTo(a, b, x, y), 0.0, 1.0); });
  }

  /// The names that fit, from the top down, each behind a piece of its curve.
  void paintNames()
  {
    const Rect& room = m_content.namesFrame;
    const double height = 1.6 * m_unit, piece = 1.8 * m_unit;
    const std::size_t most =
      std::max<std::size_t>(1, static_cast<std::size_t>(room.height() / height));
    const std::size_t count = m_content.curves.size();
    const std::size_t shown = count > most ? most - 1 : count;
    const int left = room.x0 + toPixel(piece + 0.5 * m_unit);
    const auto write = [&](std::size_t row, const std::string& text, int x)
    {
      const int base = room.y1 - toPixel((row + 0.5) * height + 0.35 * m_unit);
      m_canvas.draw(
        m_font.draw(cutText(m_font, text, m_unit, room.x1 - x), m_unit), x, base, m_ink);
    };
    for (std::size_t row = 0; row < shown; ++row)
    {
      const Curve& curve = m_content.curves[row];
      const double y = room.y1 - (row + 0.5) * height;
      const double a[2] = {room.x0 + 2.0, y}, b[2] = {room.x0 + piece, y};
      if (SvgDrawing* svg = m_canvas.svg())
        svg->addLine({{a[0], y}, {b[0], y}}, 2.0 * halfWidth(), dashOf(curve), curve.color);
      this->paintDashes(a, b, 0.0, curve, room);
      write(row, curve.name, left);
    }
    if (shown < count)
      write(shown, "and " + std::to_string(count - shown) + " more", room.x0);
  }

  /// In pixels.
  static double place(double value, const double range[2], int from, int size)
  {
    return from + (value - range[0]) / (range[1] - range[0]) * size;
  }

  const AxesContent& m_content;
  Canvas& m_canvas;
  TextFont m_font;
  int m_unit;
  int m_line;
  Rect m_frame;
  Color m_ink;
};

} // namespace

AxesTicks paintAxes(Canvas& canvas, const AxesContent& content)
{
  return AxesPainter(canvas, content).paint();
}

} // namespace mote::imaging
