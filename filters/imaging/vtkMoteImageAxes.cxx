#include "vtkMoteImageAxes.h"

#include "Canvas.h"
#include "LegendLayout.h"
#include "Segment.h"
#include "TextLines.h"
#include "TextMask.h"
#include "TickValues.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using mote::imaging::Canvas;
using mote::imaging::Color;
using mote::imaging::Rect;
using mote::imaging::TextMask;

int rounded(double value)
{
  return static_cast<int>(std::lround(value));
}

bool isAscending(const double range[2])
{
  return std::isfinite(range[0]) && std::isfinite(range[1]) && range[0] < range[1];
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
  result.coverage.resize(text.coverage.size());
  for (int y = 0; y < text.height; ++y)
    for (int x = 0; x < text.width; ++x)
      result.coverage[static_cast<std::size_t>(x) * text.height + (text.height - 1 - y)] =
        text.coverage[static_cast<std::size_t>(y) * text.width + x];
  return result;
}

} // namespace

/// One picture's axes.
class vtkMoteImageAxes::Painter
{
public:
  Painter(vtkMoteImageAxes* axes, Canvas& canvas)
    : m_axes(axes)
    , m_canvas(canvas)
    , m_font("")
    , m_unit(mote::imaging::labelSize(canvas.width(), canvas.height(), axes->FontScale))
    , m_line(std::max(1, rounded(0.06 * m_unit)))
    , m_frame{axes->Frame[0], axes->Frame[2], axes->Frame[1] + 1, axes->Frame[3] + 1}
  {
    using namespace mote::imaging;
    const double paper = luminance(canvas.seen(0, 0));
    const bool isDark = contrast(paper, 0.0) >= contrast(paper, 1.0);
    m_ink = isDark ? Color{0.08, 0.08, 0.09, 1.0} : Color{0.96, 0.96, 0.96, 1.0};
  }

  void paint()
  {
    for (const Curve& curve : m_axes->Curves)
      this->paintCurve(curve);
    this->paintFrame();
    this->paintAcross();
    this->paintUp();
  }

private:
  /// Ticks that leave room for labels, `share` of the axis each; their common power goes to the
  /// title.
  std::vector<mote::imaging::Tick> makeTicks(
    int axis, const double range[2], double share, std::string& title)
  {
    const auto ticks = mote::imaging::makeTicks(
      {range[0], range[1], false}, std::clamp(static_cast<int>(0.6 / share), 2, 7), share, {});
    for (const auto& tick : ticks.ticks)
      m_axes->Ticks[axis].emplace_back(tick.value, tick.label);
    if (ticks.exponent != 0)
      title += (title.empty() ? "" : "  ") + ("\u00d7" + mote::imaging::powerOfTen(ticks.exponent));
    return ticks.ticks;
  }

  void paintFrame()
  {
    const Rect outer = m_frame.grown(m_line);
    m_canvas.fill({outer.x0, outer.y0, outer.x1, m_frame.y0}, m_ink);
    m_canvas.fill({outer.x0, m_frame.y1, outer.x1, outer.y1}, m_ink);
    m_canvas.fill({outer.x0, m_frame.y0, m_frame.x0, m_frame.y1}, m_ink);
    m_canvas.fill({m_frame.x1, m_frame.y0, outer.x1, m_frame.y1}, m_ink);
  }

  void paintAcross()
  {
    std::string title = m_axes->XTitle;
    const double share = 4.5 * m_unit / m_frame.width();
    const int tickEnd = m_frame.y0 - m_line - rounded(0.4 * m_unit);
    const int base = tickEnd - rounded(1.1 * m_unit);
    for (const auto& tick : this->makeTicks(0, m_axes->XRange, share, title))
    {
      const int x = m_frame.x0 + rounded(tick.share * (m_frame.width() - m_line));
      m_canvas.fill({x, tickEnd, x + m_line, m_frame.y0}, m_ink);
      const TextMask label = m_font.draw(tick.label, m_unit);
      m_canvas.draw(label, x - rounded(0.5 * label.advance), base, m_ink);
    }
    const TextMask text =
      m_font.draw(mote::imaging::cutText(m_font, title, m_unit, 1.2 * m_frame.width()), m_unit);
    m_canvas.draw(text, (m_frame.x0 + m_frame.x1) / 2 - rounded(0.5 * text.advance),
      base - rounded(1.6 * m_unit), m_ink);
  }

  void paintUp()
  {
    std::string title = m_axes->YTitle;
    const double share = 1.6 * m_unit / m_frame.height();
    const TextMask zero = m_font.draw("0", m_unit);
    const int tickEnd = m_frame.x0 - m_line - rounded(0.4 * m_unit);
    double widest = 0.0;
    for (const auto& tick : this->makeTicks(1, m_axes->YRange, share, title))
    {
      const int y = m_frame.y0 + rounded(tick.share * (m_frame.height() - m_line));
      m_canvas.fill({tickEnd, y, m_frame.x0, y + m_line}, m_ink);
      const TextMask label = m_font.draw(tick.label, m_unit);
      widest = std::max(widest, label.advance);
      m_canvas.draw(label, tickEnd - rounded(0.35 * m_unit + label.advance),
        y - (zero.bottom + zero.top()) / 2, m_ink);
    }
    const TextMask text = turned(
      m_font.draw(mote::imaging::cutText(m_font, title, m_unit, 1.2 * m_frame.height()), m_unit));
    m_canvas.draw(text, tickEnd - rounded(0.35 * m_unit + widest + 0.8 * m_unit),
      (m_frame.y0 + m_frame.y1) / 2 - rounded(0.5 * text.advance), m_ink);
  }

  void paintCurve(const Curve& curve)
  {
    const vtkIdType count = std::min(curve.X->GetNumberOfTuples(), curve.Y->GetNumberOfTuples());
    const Color color{curve.Color[0], curve.Color[1], curve.Color[2], 1.0};
    const double half = std::max(0.75, 0.09 * m_unit);
    double last[2];
    bool isOn = false;
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double at[2] = {
        this->place(curve.X->GetComponent(i, 0), m_axes->XRange, m_frame.x0, m_frame.width()),
        this->place(curve.Y->GetComponent(i, 0), m_axes->YRange, m_frame.y0, m_frame.height())};
      const bool isThere = std::isfinite(at[0]) && std::isfinite(at[1]);
      const bool isEnd = i + 1 == count;
      // Points closer than this are no other line.
      if (isThere && isOn && !isEnd && std::hypot(at[0] - last[0], at[1] - last[1]) < 0.5)
        continue;
      if (isThere)
        this->paintSegment(isOn ? last : at, at, half, color);
      isOn = isThere;
      std::copy(at, at + 2, last);
    }
  }

  void paintSegment(const double from[2], const double to[2], double half, const Color& color)
  {
    double a[2], b[2];
    if (!mote::imaging::clipped(from, to, m_frame.grown(rounded(half) + 2), a, b))
      return;
    Rect rect = mote::imaging::rectAround(a, b, half + 1.0);
    rect = {std::max(rect.x0, m_frame.x0), std::max(rect.y0, m_frame.y0),
      std::min(rect.x1, m_frame.x1), std::min(rect.y1, m_frame.y1)};
    m_canvas.fillShape(rect, color,
      [&](double x, double y)
      { return std::clamp(half + 0.5 - mote::imaging::distanceTo(a, b, x, y), 0.0, 1.0); });
  }

  /// In pixels.
  static double place(double value, const double range[2], int from, int size)
  {
    return from + (value - range[0]) / (range[1] - range[0]) * size;
  }

  vtkMoteImageAxes* m_axes;
  Canvas& m_canvas;
  mote::imaging::TextFont m_font;
  int m_unit;
  int m_line;
  Rect m_frame;
  Color m_ink;
};

vtkStandardNewMacro(vtkMoteImageAxes);

vtkMoteImageAxes::vtkMoteImageAxes() = default;

vtkMoteImageAxes::~vtkMoteImageAxes() = default;

int vtkMoteImageAxes::LabelSize(int width, int height, double fontScale)
{
  return mote::imaging::labelSize(width, height, fontScale);
}

void vtkMoteImageAxes::AddCurve(
  vtkDataArray* x, vtkDataArray* y, double red, double green, double blue)
{
  this->Curves.push_back({x, y, {red, green, blue}});
  this->Modified();
}

void vtkMoteImageAxes::RemoveAllCurves()
{
  this->Curves.clear();
  this->Modified();
}

double vtkMoteImageAxes::TickValue(int axis, int i) const
{
  return i >= 0 && i < static_cast<int>(this->Ticks[axis].size())
           ? this->Ticks[axis][i].first
           : std::numeric_limits<double>::quiet_NaN();
}

std::string vtkMoteImageAxes::TickLabel(int axis, int i) const
{
  return i >= 0 && i < static_cast<int>(this->Ticks[axis].size()) ? this->Ticks[axis][i].second
                                                                  : std::string();
}

int vtkMoteImageAxes::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->ShallowCopy(input);
  this->Ticks[0].clear();
  this->Ticks[1].clear();
  vtkDataArray* colors = input->GetPointData()->GetArray("color");
  colors = colors ? colors : input->GetPointData()->GetScalars();
  int size[3];
  input->GetDimensions(size);
  if (size[2] != 1 || !colors || colors->GetNumberOfComponents() < 3)
  {
    vtkErrorMacro(<< "Axes need an image of one slice with an array of colours.");
    return 0;
  }
  if (this->Frame[1] <= this->Frame[0] || this->Frame[3] <= this->Frame[2] ||
      !isAscending(this->XRange) || !isAscending(this->YRange))
  {
    vtkErrorMacro(<< "Axes need a rectangle of pixels, and ranges from less to more.");
    return 0;
  }
  const auto drawn = vtk::TakeSmartPointer(colors->NewInstance());
  drawn->DeepCopy(colors);
  Canvas canvas(drawn, size[0], size[1]);
  Painter(this, canvas).paint();
  const bool isActive = output->GetPointData()->GetScalars() == colors;
  if (colors->GetName())
    output->GetPointData()->AddArray(drawn); // replaces that of the same name
  if (isActive || !colors->GetName())
    output->GetPointData()->SetScalars(drawn);
  return 1;
}

void vtkMoteImageAxes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Frame: " << this->Frame[0] << " " << this->Frame[1] << " " << this->Frame[2]
     << " " << this->Frame[3] << "\n";
  os << indent << "XRange: " << this->XRange[0] << " " << this->XRange[1] << "\n";
  os << indent << "YRange: " << this->YRange[0] << " " << this->YRange[1] << "\n";
  os << indent << "XTitle: " << this->XTitle << "\n";
  os << indent << "YTitle: " << this->YTitle << "\n";
  os << indent << "FontScale: " << this->FontScale << "\n";
  os << indent << "Curves: " << this->Curves.size() << "\n";
}
