#include "vtkMoteImageMarks.h"

#include "Canvas.h"
#include "LegendLayout.h"
#include "Segment.h"
#include "TextMask.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace
{

using mote::imaging::Canvas;
using mote::imaging::Color;
using mote::imaging::Rect;

Color colorOf(const std::array<double, 3>& rgb, double alpha = 1.0)
{
  return {rgb[0], rgb[1], rgb[2], alpha};
}

int rounded(double value)
{
  return static_cast<int>(std::lround(value));
}

} // namespace

/// One picture's marks.
class vtkMoteImageMarks::Painter
{
public:
  Painter(Canvas& canvas, vtkDataArray* depth, bool isParallel)
    : m_canvas(canvas)
    , m_depth(depth)
    , m_isParallel(isParallel)
    , m_font("")
    , m_unit(mote::imaging::labelSize(canvas.width(), canvas.height(), 1.0))
  {
  }

  void paint(const Line& line)
  {
    using namespace mote::imaging;
    const double half = 0.5 * line.Width;
    const Rect all{0, 0, m_canvas.width(), m_canvas.height()};
    double a[2], b[2];
    if (!clipped(line.From.data(), line.To.data(), all.grown(rounded(half) + 2), a, b))
      return;
    const double* from = line.From.data();
    const double* to = line.To.data();
    const Color color = colorOf(line.Color);
    m_canvas.fillShape(rectAround(a, b, half + 1.0), color,
      [&](double x, double y)
      {
        const double coverage = std::clamp(half + 0.5 - distanceTo(a, b, x, y), 0.0, 1.0);
        if (coverage <= 0.0 || line.OnTop)
          return coverage;
        const double t = nearestShare(from, to, x, y);
        return this->isHidden(x, y, this->between(from[2], to[2], t)) ? 0.0 : coverage;
      });
  }

  void paint(const Ball& ball)
  {
    const double* middle = ball.Middle.data();
    const double radius = ball.Radius;
    const Rect rect = mote::imaging::rectAround(middle, middle, radius + 1.0)
                        .clipped(m_canvas.width(), m_canvas.height());
    for (int y = rect.y0; y < rect.y1; ++y)
      for (int x = rect.x0; x < rect.x1; ++x)
      {
        const double away = std::hypot(x + 0.5 - middle[0], y + 0.5 - middle[1]);
        const double coverage = std::clamp(radius + 0.5 - away, 0.0, 1.0);
        const double slope = std::sqrt(std::max(0.0, 1.0 - away * away / (radius * radius)));
        if (coverage <= 0.0 || this->isHidden(x + 0.5, y + 0.5, middle[2] - slope * ball.Reach))
          continue;
        const double light = 0.5 + 0.5 * slope;
        m_canvas.blend(x, y,
          colorOf(
            {ball.Color[0] * light, ball.Color[1] * light, ball.Color[2] * light}, ball.Opacity),
          coverage);
      }
  }

  void paint(const Label& label)
  {
    const auto text = m_font.draw(label.Text, m_unit);
    const int padding = rounded(0.35 * m_unit);
    const int x = rounded(label.Place[0] - 0.5 * text.advance);
    const int height = rounded(1.25 * m_unit);
    const int y = rounded(label.Place[1]) + (label.Below ? -height - padding : padding);
    m_canvas.fill({x - padding, y, x + rounded(text.advance) + padding, y + height},
      Color{0.09, 0.10, 0.12, 0.82});
    m_canvas.draw(text, x, y + rounded(0.3 * m_unit), colorOf(label.Color));
  }

private:
  /// The distance along the view axis at a place of a line.
  double between(double a, double b, double t) const
  {
    return m_isParallel || a <= 0.0 || b <= 0.0 ? a + t * (b - a)
                                                : 1.0 / (1.0 / a + t * (1.0 / b - 1.0 / a));
  }

  /// Whether what was traced is nearer.
  bool isHidden(double x, double y, double distance) const
  {
    if (!m_depth)
      return false;
    const int column = std::clamp(static_cast<int>(x), 0, m_canvas.width() - 1);
    const int row = std::clamp(static_cast<int>(y), 0, m_canvas.height() - 1);
    return m_depth->GetComponent(static_cast<vtkIdType>(row) * m_canvas.width() + column, 0) <
           distance;
  }

  Canvas& m_canvas;
  vtkDataArray* m_depth;
  bool m_isParallel;
  mote::imaging::TextFont m_font;
  int m_unit;
};

vtkStandardNewMacro(vtkMoteImageMarks);

vtkMoteImageMarks::vtkMoteImageMarks() = default;

vtkMoteImageMarks::~vtkMoteImageMarks() = default;

void vtkMoteImageMarks::AddLine(
  const double from[3], const double to[3], const double color[3], double width, bool onTop)
{
  this->Lines.push_back({{from[0], from[1], from[2]}, {to[0], to[1], to[2]},
    {color[0], color[1], color[2]}, width, onTop});
  this->Modified();
}

void vtkMoteImageMarks::AddBall(
  const double middle[3], double radius, double reach, const double color[3], double opacity)
{
  this->Balls.push_back(
    {{middle[0], middle[1], middle[2]}, {color[0], color[1], color[2]}, radius, reach, opacity});
  this->Modified();
}

void vtkMoteImageMarks::AddLabel(
  const double place[2], const std::string& text, const double color[3], bool below)
{
  this->Labels.push_back({{place[0], place[1]}, text, {color[0], color[1], color[2]}, below});
  this->Modified();
}

void vtkMoteImageMarks::RemoveAll()
{
  this->Lines.clear();
  this->Balls.clear();
  this->Labels.clear();
  this->Modified();
}

int vtkMoteImageMarks::GetNumberOfMarks() const
{
  return static_cast<int>(this->Lines.size() + this->Balls.size() + this->Labels.size());
}

int vtkMoteImageMarks::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->ShallowCopy(input);
  if (this->GetNumberOfMarks() == 0)
    return 1;
  vtkDataArray* colors = input->GetPointData()->GetArray("color");
  int size[3];
  input->GetDimensions(size);
  if (size[2] != 1 || !colors || colors->GetNumberOfComponents() < 3)
  {
    vtkErrorMacro(<< "Marks need an image of one slice with an array of colours.");
    return 0;
  }
  const auto drawn = vtk::TakeSmartPointer(colors->NewInstance());
  drawn->DeepCopy(colors);
  Canvas canvas(drawn, size[0], size[1]);
  Painter painter(canvas, input->GetPointData()->GetArray("depth"), this->ParallelProjection != 0);
  for (const Line& line : this->Lines)
    painter.paint(line);
  for (const Ball& ball : this->Balls)
    painter.paint(ball);
  for (const Label& label : this->Labels)
    painter.paint(label);
  const bool isActive = output->GetPointData()->GetScalars() == colors;
  output->GetPointData()->AddArray(drawn); // replaces that of the same name
  if (isActive)
    output->GetPointData()->SetScalars(drawn);
  return 1;
}

void vtkMoteImageMarks::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ParallelProjection: " << this->ParallelProjection << "\n";
  os << indent << "Lines: " << this->Lines.size() << "\n";
  os << indent << "Balls: " << this->Balls.size() << "\n";
  os << indent << "Labels: " << this->Labels.size() << "\n";
}
