#include "Chart.h"

#include "ChartFile.h"
#include "base/Failure.h"
#include "stage/ColorMaps.h"

#include <vtkDoubleArray.h>
#include <vtkLookupTable.h>
#include <vtkMoteColorLegend.h>
#include <vtkMoteImageAxes.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mote::app
{

namespace
{

constexpr int chartWidth = 1280, panelHeight = 400;

/// Colours that can be told apart, also in print.
constexpr std::array<std::array<double, 3>, 10> curveColors = {
  {{0.12, 0.35, 0.65}, {0.85, 0.37, 0.01}, {0.11, 0.58, 0.40}, {0.72, 0.08, 0.20},
    {0.46, 0.38, 0.72}, {0.40, 0.26, 0.13}, {0.90, 0.20, 0.58}, {0.35, 0.35, 0.35},
    {0.60, 0.56, 0.00}, {0.10, 0.65, 0.80}}};

bool hasValue(const ChartCurve& curve)
{
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i]))
      return true;
  return false;
}

/// Without panels that show nothing, and without curves that no panel shows.
std::vector<ChartPanel> seenPanels(const Chart& chart)
{
  std::vector<ChartPanel> panels = chart.panels;
  std::erase_if(panels, [](const ChartPanel& panel)
    { return std::none_of(panel.curves.begin(), panel.curves.end(), hasValue); });
  if (panels.empty())
    throw Failure("there is nothing to draw: no curve has a finite value");
  for (std::size_t k = panels.front().curves.size(); k-- > 0;)
    if (std::none_of(panels.begin(), panels.end(),
          [k](const ChartPanel& panel) { return hasValue(panel.curves[k]); }))
      for (ChartPanel& panel : panels)
        panel.curves.erase(panel.curves.begin() + static_cast<std::ptrdiff_t>(k));
  return panels;
}

struct Range
{
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(const std::vector<double>& values)
  {
    for (const double value : values)
      if (std::isfinite(value))
      {
        low = std::min(low, value);
        high = std::max(high, value);
      }
  }
};

/// With some air, and more around values that do not differ but by rounding.
Range withAir(const Range& range, double share)
{
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  const bool isFlat = !(range.high - range.low > 1e-6 * largest);
  const double air = !isFlat         ? share * (range.high - range.low)
                     : largest > 0.0 ? 0.1 * largest
                                     : 1.0;
  return {range.low - air, range.high + air};
}

/// Where the parts of a chart lie, in pixels.
struct ChartLayout
{
  int letter, height, right;
  double fontScale;
  std::vector<std::array<int, 4>> frames; ///< from the top down
};

ChartLayout layOut(const Chart& chart, const std::vector<ChartPanel>& panels, bool hasNames)
{
  ChartLayout layout{};
  const int count = static_cast<int>(panels.size());
  layout.height = count == 1 ? 800 : 180 + count * panelHeight;
  // Letters grow with a picture's height, and are not to.
  layout.fontScale =
    std::clamp(chart.fontScale * vtkMoteImageAxes::LabelSize(chartWidth, 800, 1.0) /
                 vtkMoteImageAxes::LabelSize(chartWidth, layout.height, 1.0),
      0.25, 4.0);
  layout.letter = vtkMoteImageAxes::LabelSize(chartWidth, layout.height, layout.fontScale);
  const int letter = layout.letter;
  std::size_t longest = 0;
  for (const ChartCurve& curve : panels.front().curves)
    longest = std::max(longest, curve.name.size());
  layout.right = !chart.colorTitle.empty() ? 11 * letter
                 : hasNames
                   ? std::min(chartWidth / 3,
                       static_cast<int>((0.64 * static_cast<double>(longest) + 4.5) * letter))
                   : 2 * letter;
  const int bottom = 6 * letter + 10, top = layout.height - 2 * letter, gap = 3 * letter / 2;
  const int room = (top - bottom - (count - 1) * gap) / count;
  for (int i = 0; i < count; ++i)
  {
    const int high = top - i * (room + gap);
    layout.frames.push_back(
      {7 * letter, chartWidth - layout.right, i + 1 == count ? bottom : high - room, high});
  }
  return layout;
}

vtkSmartPointer<vtkDoubleArray> arrayOf(const std::vector<double>& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  for (const double value : values)
    array->InsertNextValue(value);
  return array;
}

void addCurves(vtkMoteImageAxes* axes, const ChartPanel& panel, vtkLookupTable* colors)
{
  for (std::size_t k = 0; k < panel.curves.size(); ++k)
  {
    const ChartCurve& curve = panel.curves[k];
    std::array<double, 3> color = curveColors[k % curveColors.size()];
    if (colors)
      colors->GetColor(curve.value, color.data());
    axes->AddNamedCurve(curve.name, arrayOf(curve.x), arrayOf(curve.y), color[0], color[1],
      color[2], !colors && k / curveColors.size() % 2 == 1);
  }
}

/// The colours of curves that have no colours of their own; null where they have.
vtkSmartPointer<vtkLookupTable> colorsOf(const Chart& chart, const ChartPanel& panel)
{
  if (chart.colorTitle.empty())
    return nullptr;
  Range range;
  for (const ChartCurve& curve : panel.curves)
    range.add({curve.value});
  if (!(range.low < range.high))
    range = withAir(range, 0.0);
  const double ends[2] = {range.low, range.high};
  auto colors = makeColorMap("plasma", ends, false);
  vtkNew<vtkLookupTable> all;
  all->DeepCopy(colors);
  const vtkIdType count = colors->GetNumberOfTableValues();
  for (vtkIdType i = 0; i < count; ++i) // its light end cannot be seen on white
    colors->SetTableValue(i, all->GetTableValue(i * 85 / 100));
  return colors;
}

} // namespace

void writeChart(const Chart& chart, const std::string& file)
{
  const std::vector<ChartPanel> panels = seenPanels(chart);
  const std::vector<ChartCurve>& first = panels.front().curves;
  const auto colors = colorsOf(chart, panels.front());
  const bool hasNames = !colors && (first.size() > 1 || !first.front().name.empty());
  const ChartLayout layout = layOut(chart, panels, hasNames);
  Range across;
  std::size_t points = 0;
  for (const ChartPanel& panel : panels)
    for (const ChartCurve& curve : panel.curves)
    {
      across.add(curve.x);
      points = std::max(points, curve.x.size());
    }
  across = withAir(across, points <= 60 ? 0.02 : 0.0);
  ChartPaper paper(chartWidth, layout.height);
  for (std::size_t i = 0; i < panels.size(); ++i)
  {
    Range up;
    for (const ChartCurve& curve : panels[i].curves)
      up.add(curve.y);
    up = withAir(up, 0.04);
    if (chart.range.size() == 2)
      up = {chart.range[0], chart.range[1]};
    const auto& frame = layout.frames[i];
    vtkNew<vtkMoteImageAxes> axes;
    axes->SetFrame(frame[0], frame[1], frame[2], frame[3]);
    axes->SetFontScale(layout.fontScale);
    axes->SetXRange(across.low, across.high);
    axes->SetYRange(up.low, up.high);
    axes->SetXTitle(chart.xTitle);
    axes->SetYTitle(panels[i].title);
    axes->SetXLabels(i + 1 == panels.size());
    axes->GridOn();
    axes->SetDots(points <= 60);
    addCurves(axes, panels[i], colors);
    if (hasNames && i == 0)
      axes->SetNamesFrame(
        frame[1] + layout.letter, chartWidth - layout.letter, layout.frames.back()[2], frame[3]);
    paper.draw(axes.Get());
  }
  vtkNew<vtkMoteColorLegend> legend; // and the caption
  legend->SetLookupTable(colors);
  legend->SetTitle(chart.colorTitle);
  legend->SetFontScale(layout.fontScale);
  legend->SetCaption(chart.caption);
  paper.draw(legend.Get());
  paper.write(file);
}

} // namespace mote::app
