#include "PlotFile.h"

#include "ChartFile.h"
#include "base/Text.h"
#include "settings/Values.h"
#include "stage/ColorMaps.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkMoteColorLegend.h>
#include <vtkMoteImageAxes.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

constexpr int paperWidth = 1280, paperHeight = 800;

/// The ends of a part of a range.
std::array<double, 2> endsOf(const Plot& plot, std::size_t axis, int part, int parts)
{
  const double width = plot.most[axis] - plot.least[axis];
  return {plot.least[axis] + width * part / parts, plot.least[axis] + width * (part + 1) / parts};
}

/// The range of an axis: that of a single value is widened, for an axis needs some.
void rangeOf(const Plot& plot, std::size_t axis, double range[2])
{
  range[0] = plot.least[axis], range[1] = plot.most[axis];
  if (!(range[0] < range[1]))
  {
    const double air = std::max(0.1 * std::abs(range[0]), 1e-12);
    range[0] -= air, range[1] += air;
  }
}

/// Colours the pixels of a frame, {x min, x max, y min, y max}, by what is at a share of its width
/// and height; false for none.
template <class ColorAt>
void paint(vtkImageData* paper, const std::array<int, 4>& frame, const ColorAt& colorAt)
{
  auto* pixels = vtkFloatArray::SafeDownCast(paper->GetPointData()->GetScalars());
  for (int y = frame[2]; y <= frame[3]; ++y)
    for (int x = frame[0]; x <= frame[1]; ++x)
      if (double rgb[3]; colorAt((x - frame[0] + 0.5) / (frame[1] - frame[0] + 1),
            (y - frame[2] + 0.5) / (frame[3] - frame[2] + 1), rgb))
        for (int k = 0; k < 3; ++k)
          pixels->SetTypedComponent(vtkIdType(y) * paperWidth + x, k, static_cast<float>(rgb[k]));
}

std::uint32_t countAt(const Plot& plot, double x, double y)
{
  const int column = std::min(static_cast<int>(x * plot.width), plot.width - 1);
  const int row = std::min(static_cast<int>(y * plot.height), plot.height - 1);
  return plot.counts[static_cast<std::size_t>(row) * static_cast<std::size_t>(plot.width) +
                     static_cast<std::size_t>(column)];
}

} // namespace

std::string plotText(const Plot& plot, const PlotChoice& choice)
{
  const std::size_t axes = plot.height > 1 ? 2 : 1;
  std::string text;
  for (std::size_t axis = 0; axis < axes; ++axis)
    text += inQuotes(choice.names[axis] + " from", ',') + ',' +
            inQuotes(choice.names[axis] + " to", ',') + ',';
  text += "count\n";
  for (int row = 0; row < plot.height; ++row)
    for (int column = 0; column < plot.width; ++column)
    {
      const std::uint32_t count =
        plot.counts[static_cast<std::size_t>(row) * static_cast<std::size_t>(plot.width) +
                    static_cast<std::size_t>(column)];
      if (count == 0)
        continue;
      for (std::size_t axis = 0; axis < axes; ++axis)
        for (const double end :
          axis == 0 ? endsOf(plot, 0, column, plot.width) : endsOf(plot, 1, row, plot.height))
          text += exactText(end) + ',';
      text += std::to_string(count) + '\n';
    }
  return text;
}

void writePlotPicture(const Plot& plot, const PlotChoice& choice, bool isLogarithmic,
  const std::string& caption, const std::string& file)
{
  const bool isPair = plot.height > 1;
  const int letter = vtkMoteImageAxes::LabelSize(paperWidth, paperHeight, 1.0);
  const std::array<int, 4> frame = {
    7 * letter, paperWidth - (isPair ? 11 : 2) * letter, 6 * letter + 10, paperHeight - 2 * letter};
  ChartPaper paper(paperWidth, paperHeight);
  const auto height = [isLogarithmic](double count)
  { return isLogarithmic ? std::log10(1.0 + count) : count; };
  double across[2], up[2] = {0.0, 1.05 * std::max(height(plot.highest), 1e-3)};
  rangeOf(plot, 0, across);
  vtkSmartPointer<vtkLookupTable> colors;
  if (isPair)
  {
    rangeOf(plot, 1, up);
    const double counts[2] = {isLogarithmic ? 1.0 : 0.0, std::max(2.0, double(plot.highest))};
    colors = makeColorMap(colorMapNames().front(), counts, isLogarithmic);
  }
  paint(paper.image(), frame,
    [&](double x, double y, double rgb[3])
    {
      const std::uint32_t count = countAt(plot, x, isPair ? y : 0.0);
      if (isPair && count > 0)
        colors->GetColor(count, rgb);
      else
        rgb[0] = 0.3, rgb[1] = 0.5, rgb[2] = 0.75;
      return isPair ? count > 0 : y * up[1] < height(count);
    });
  paper.keepPixels(frame);
  vtkNew<vtkMoteImageAxes> axes;
  axes->SetFrame(frame[0], frame[1], frame[2], frame[3]);
  axes->SetXRange(across);
  axes->SetYRange(up);
  axes->SetXTitle(choice.names[0]);
  axes->SetYTitle(isPair ? choice.names[1] : isLogarithmic ? "log10 (1 + count)" : "count");
  paper.draw(axes.Get());
  vtkNew<vtkMoteColorLegend> legend;
  legend->SetLookupTable(colors);
  legend->SetTitle("count");
  legend->SetCaption(caption);
  paper.draw(legend.Get());
  paper.write(file);
}

} // namespace mote::app
