#include "LegendLayout.h"

#include "TextLines.h"

#include <algorithm>
#include <cmath>

namespace mote::imaging
{
namespace
{

int rounded(double value)
{
  return static_cast<int>(std::lround(value));
}

/// Stacks the parts of a legend from the top, at y = 0, down; x = 0 is the bar's left edge.
class Stack
{
public:
  Stack(TextFont& font, const LegendContent& content, const Placement& placement)
    : m_font(font)
    , m_content(content)
    , m_placement(placement)
    , m_unit(placement.unit)
  {
    m_layout.unit = m_unit;
    m_layout.line = std::max(1, rounded(0.06 * m_unit));
    m_barWidth = rounded(1.15 * m_unit);
    const TextMask zero = m_font.draw("0", m_unit);
    m_halfDigit = (zero.bottom + zero.top()) / 2;
  }

  LegendLayout lay()
  {
    addTitle();
    if (m_content.categories.empty())
      addBar();
    else
      addCategories();
    if (m_content.nan)
    {
      m_top -= rounded(0.8 * m_unit);
      addRow("NaN", *m_content.nan, m_unit, m_barWidth);
    }
    place();
    return std::move(m_layout);
  }

private:
  void addText(const std::string& text, int x, int y, int size)
  {
    PlacedText placed{m_font.draw(text, size), x, y};
    m_right = std::max(m_right, x + rounded(placed.mask.advance));
    m_layout.texts.push_back(std::move(placed));
  }

  int labelX() const { return m_barWidth + rounded(0.75 * m_unit); }

  double labelWidth() const
  {
    double width = 0.0;
    for (const Tick& tick : m_content.ticks.ticks)
      width = std::max(width, m_font.width(tick.label, m_unit));
    for (const Category& category : m_content.categories)
      width = std::max(width, m_font.width(category.label, m_unit));
    return width;
  }

  void addTitle()
  {
    if (m_content.title.empty())
      return;
    const double most = 0.3 * m_placement.imageWidth;
    const double width = std::min(most, std::max(labelX() + labelWidth(), 7.0 * m_unit));
    const TextLines lines = wrapText(m_font, m_content.title, rounded(1.08 * m_unit), width, 4);
    for (const std::string& line : lines.lines)
    {
      m_top -= rounded(1.22 * lines.size);
      addText(line, 0, m_top + rounded(0.22 * lines.size), lines.size);
    }
    m_top -= rounded(0.75 * m_unit);
  }

  void addBar()
  {
    if (m_content.ticks.exponent != 0)
    {
      const std::string text = "\u00d7" + powerOfTen(m_content.ticks.exponent);
      addText(text, 0, m_top - m_unit, m_unit);
      m_top -= rounded(1.75 * m_unit);
    }
    const int tip = rounded(0.9 * m_barWidth);
    if (m_content.above)
    {
      m_layout.swatches.push_back(
        {{0, m_top - tip, m_barWidth, m_top}, *m_content.above, SwatchShape::Up});
      m_top -= tip + m_layout.line;
    }
    m_top -= m_layout.line;
    const int height = barHeight(m_placement.imageHeight);
    m_layout.bar = {0, m_top - height, m_barWidth, m_top};
    addTicks();
    m_top -= height + m_layout.line;
    if (m_content.below)
    {
      m_top -= m_layout.line;
      m_layout.swatches.push_back(
        {{0, m_top - tip, m_barWidth, m_top}, *m_content.below, SwatchShape::Down});
      m_top -= tip;
    }
  }

  void addMark(double share, double length)
  {
    const int height = m_layout.bar.height() - m_layout.line;
    const int y = m_layout.bar.y0 + rounded(share * height);
    const int x = m_layout.bar.x1 + m_layout.line;
    m_layout.marks.push_back({x, y, x + rounded(length * m_unit), y + m_layout.line});
  }

  void addTicks()
  {
    for (const double share : m_content.ticks.minor)
      addMark(share, 0.2);
    for (const Tick& tick : m_content.ticks.ticks)
    {
      addMark(tick.share, 0.38);
      const Rect& mark = m_layout.marks.back();
      addText(tick.label, labelX(), (mark.y0 + mark.y1) / 2 - m_halfDigit, m_unit);
    }
  }

  void addRow(const std::string& label, const Color& color, int size, int side)
  {
    const Rect rect{0, m_top - side, side, m_top};
    m_layout.swatches.push_back({rect, color, SwatchShape::Square});
    const int half = m_halfDigit * size / m_unit;
    addText(
      label, side + m_layout.line + rounded(0.6 * size), (rect.y0 + rect.y1) / 2 - half, size);
    m_top -= side;
  }

  void addCategories()
  {
    const int count = static_cast<int>(m_content.categories.size());
    const int margin = m_unit;
    const int room = m_placement.imageHeight - m_placement.reserved + m_top - 3 * margin;
    const double pitch =
      std::clamp(static_cast<double>(room) / count, std::min(9.0, 1.0 * m_unit), 1.6 * m_unit);
    const int shown = std::clamp(static_cast<int>(room / pitch), 1, count);
    const int size = std::min(m_unit, rounded(0.9 * pitch));
    const int side = std::min(m_barWidth, rounded(0.8 * pitch));
    const double most = 0.4 * m_placement.imageWidth;
    const int begin = m_top;
    for (int i = 0; i < shown; ++i)
    {
      m_top = begin - rounded(i * pitch);
      if (i + 1 == shown && shown < count)
      {
        const std::string more = "and " + std::to_string(count - i) + " more";
        addText(more, 0, m_top - size, size);
        m_top -= rounded(1.3 * size);
        return;
      }
      const Category& category = m_content.categories[i];
      addRow(cutText(m_font, category.label, size, most), category.color, size, side);
      m_layout.bar = {0, m_top, side, begin};
    }
  }

  /// Moves all to its place in the image.
  void place()
  {
    const int padding = rounded(0.8 * m_unit);
    const int margin = rounded(0.8 * m_unit);
    m_right = std::max(m_right, m_barWidth);
    const int width = m_right + 2 * padding;
    const int height = -m_top + 2 * padding;
    const int x = m_placement.isLeft ? margin : m_placement.imageWidth - margin - width;
    const int lowest = m_placement.reserved > 0 ? m_placement.reserved + margin / 2 : margin;
    const int highest = m_placement.imageHeight - margin - height;
    int y = (m_placement.imageHeight - height) / 2;
    y = std::min(std::max(y, lowest), std::max(highest, 0));
    m_layout.panel = {x, y, x + width, y + height};
    const int dx = x + padding;
    const int dy = y + padding - m_top;
    m_layout.bar = m_layout.bar.moved(dx, dy);
    for (Rect& mark : m_layout.marks)
      mark = mark.moved(dx, dy);
    for (Swatch& swatch : m_layout.swatches)
      swatch.rect = swatch.rect.moved(dx, dy);
    for (PlacedText& text : m_layout.texts)
    {
      text.x += dx;
      text.y += dy;
    }
  }

  TextFont& m_font;
  const LegendContent& m_content;
  const Placement& m_placement;
  int m_unit;
  int m_barWidth = 0;
  int m_halfDigit = 0;
  int m_top = 0;   // where the next part begins
  int m_right = 0; // the farthest so far
  LegendLayout m_layout;
};

} // namespace

int barHeight(int imageHeight)
{
  return std::max(1, imageHeight / 2);
}

int labelSize(int imageWidth, int imageHeight, double scale)
{
  const double height = std::min<double>(imageHeight, 1.25 * imageWidth);
  return std::max(4, rounded(std::max(9.0, 0.022 * height) * scale));
}

LegendLayout layOutLegend(TextFont& font, const LegendContent& content, const Placement& placement)
{
  return Stack(font, content, placement).lay();
}

LegendLayout layOutCaption(TextFont& font, const std::string& text, const Placement& placement)
{
  LegendLayout layout;
  layout.unit = placement.unit;
  const int margin = rounded(0.8 * placement.unit);
  const int paddingX = rounded(0.5 * placement.unit);
  const int paddingY = rounded(0.35 * placement.unit);
  const double most = placement.imageWidth - 2.0 * (margin + paddingX);
  const TextLines lines = wrapText(font, text, rounded(0.95 * placement.unit), most, 3);
  const int pitch = rounded(1.3 * lines.size);
  const int count = static_cast<int>(lines.lines.size());
  int right = 0;
  const int height = 2 * paddingY + count * pitch;
  const int bottom = placement.isCaptionOnTop ? placement.imageHeight - margin - height : margin;
  for (int i = 0; i < count; ++i)
  {
    const int y = bottom + paddingY + (count - 1 - i) * pitch + rounded(0.26 * lines.size);
    PlacedText placed{font.draw(lines.lines[i], lines.size), margin + paddingX, y};
    right = std::max(right, placed.x + rounded(placed.mask.advance));
    layout.texts.push_back(std::move(placed));
  }
  layout.panel = {margin, bottom, right + paddingX, bottom + height};
  return layout;
}

} // namespace mote::imaging
