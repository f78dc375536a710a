#include "Probe.h"

#include "Chart.h"
#include "ChartFile.h"
#include "DataUnits.h"
#include "OpenedInput.h"
#include "ProbeTable.h"
#include "TableFile.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/OutputFile.h"
#include "base/Text.h"
#include "stage/Arrays.h"
#include "stage/Part.h"

#include <kernels/hexahedra/HexMesh.h>

#include <vtkLineSource.h>
#include <vtkMoteCylindricalLocator.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProbeFilter.h>

#include <cmath>

namespace mote::app
{

namespace
{

/// The heading of a component's column, or the array's name for one without components and for a
/// magnitude.
std::string headingOf(vtkDataArray* array, const std::string& name, int component)
{
  if (array->GetNumberOfComponents() == 1 || component == ArrayChoice::magnitude)
    return name;
  const char* known = array->GetComponentName(component);
  return name + ":" + (known ? known : std::to_string(component));
}

/// An array that a picture shows.
struct Shown
{
  ArrayChoice choice;
  std::string heading, title;
  std::vector<std::vector<double>> values; ///< of each step, at each point
};

/// What the user names; else the array of --color-by, or the most telling.
Shown shownOf(const std::vector<NamedData>& data, const std::string& asked)
{
  for (const NamedData& one : data)
  {
    const auto ranked = rankedArrays(one.data);
    const ArrayChoice choice = !asked.empty()   ? findArray(one.data, asked)
                               : ranked.empty() ? ArrayChoice()
                                                : ranked.front();
    if (vtkDataArray* array = arrayOf(one.data, choice))
      return {choice, headingOf(array, choice.name, choice.component),
        withUnit(describe(one.data, choice), unitText(unitOf(one.data, choice.name))), {}};
  }
  throw Failure(asked.empty()
                  ? "there are no values to draw"
                  : "there is no array " + asked + "; there are " + listArrays(data.front().data));
}

/// Whether Mote's locator finds all cells, and sooner than VTK's own search: to build it takes as
/// long as that does for about a point for 50 cells.
bool isWorthALocator(vtkDataSet* data, vtkIdType points)
{
  const vtkIdType cells = data->GetNumberOfCells();
  if (points <= cells / 50)
    return false;
  for (vtkIdType i = 0; i < cells; ++i)
    if (collapsedCorners(data->GetCellType(i)).points == 0)
      return false;
  return true;
}

ProbedPoints pointsOf(const ProbeSettings& asked)
{
  if (asked.at.empty() && asked.from.empty())
    throw Failure("--from and --to name a line to look along, or --at points to look at");
  ProbedPoints points;
  points.isLine = asked.at.empty();
  points.data = vtkSmartPointer<vtkPolyData>::New();
  if (points.isLine)
  {
    vtkNew<vtkLineSource> line;
    line->SetPoint1(asked.from.data());
    line->SetPoint2(asked.to.data());
    line->SetResolution(asked.points - 1);
    line->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    line->Update();
    points.data->ShallowCopy(line->GetOutput());
    return points;
  }
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (std::size_t i = 0; i < asked.at.size(); i += 3)
    places->InsertNextPoint(&asked.at[i]);
  points.data->SetPoints(places);
  return points;
}

/// Looks the points up in the data of one step.
void lookUp(const ProbedPoints& points, const std::vector<NamedData>& data, OpenedInput& opened,
  ProbeTable& table)
{
  vtkNew<vtkMoteCylindricalLocator> locator;
  vtkIdType cells = 0;
  for (const NamedData& one : data)
  {
    cells += Part::isMesh(one.data) ? one.data->GetNumberOfCells() : 0;
    vtkNew<vtkProbeFilter> filter;
    filter->SetInputData(points.data);
    filter->SetSourceData(one.data);
    if (isWorthALocator(one.data, points.data->GetNumberOfPoints()))
      filter->SetCellLocatorPrototype(locator);
    ProgressRelay::Work work(opened.progress, "Probing " + one.name, filter);
    filter->Update();
    work.finish();
    table.add(one.name, filter->GetOutput()->GetPointData());
  }
  Messages::throwError();
  const std::string name = opened.input.name();
  if (cells == 0)
    throw Failure(name + " holds no cells, in which values could be looked up");
  if (!table.anyInside())
    throw Failure(
      "no point " + std::string(points.isLine ? "of the line " : "") + "lies in a cell of " + name);
}

/// Whether the picture is to have a curve for each point, over time; else it has one for each time
/// step, over the distance.
bool isOverTime(const ProbedPoints& points, const Settings& settings)
{
  const bool overTime =
    settings.chart.over.empty() ? !points.isLine : settings.chart.over == "time";
  if (overTime && !settings.output.allSteps)
    throw Failure("curves over time need --all-steps");
  if (!overTime && !points.isLine)
    throw Failure("--at names points: curves over the distance need a line, --from and --to");
  if (!overTime && !(points.distance(points.data->GetNumberOfPoints() - 1) > 0.0))
    throw Failure("--from and --to are one point: there is no line to draw values along");
  return overTime;
}

/// Curves of what is shown, in panels; `times` has one for each step.
Chart chartOf(const ProbedPoints& points, const std::vector<Shown>& shown,
  const std::vector<double>& times, const std::string& lengthUnit, const std::string& timeUnit,
  const Settings& settings)
{
  const bool overTime = isOverTime(points, settings);
  const auto count = static_cast<std::size_t>(points.data->GetNumberOfPoints());
  const std::size_t curves = overTime ? count : times.size();
  Chart chart;
  const std::string distance = withUnit("distance", lengthUnit) + " from " + points.place(0);
  chart.xTitle = overTime ? withUnit("time", timeUnit) : distance;
  if (curves > mostNamedCurves)
    chart.colorTitle = !overTime       ? withUnit("time", timeUnit)
                       : points.isLine ? withUnit("distance", lengthUnit)
                                       : "point";
  for (const Shown& one : shown)
  {
    ChartPanel panel;
    panel.title = one.title;
    for (std::size_t k = 0; k < curves; ++k)
    {
      ChartCurve& curve = panel.curves.emplace_back();
      const auto point = static_cast<vtkIdType>(k);
      if (overTime)
      {
        curve.name = points.place(point);
        curve.value = points.isLine ? points.distance(point) : static_cast<double>(k + 1);
        curve.x = times;
        for (const auto& values : one.values)
          curve.y.push_back(values[k]);
        continue;
      }
      curve.name = times.size() > 1 ? "t = " + asNumber(times[k]) : "";
      curve.value = times[k];
      for (std::size_t i = 0; i < count; ++i)
        curve.x.push_back(points.distance(static_cast<vtkIdType>(i)));
      curve.y = one.values[k];
    }
    chart.panels.push_back(std::move(panel));
  }
  if (chart.panels.size() == 1 && settings.picture.title)
    chart.panels.front().title = *settings.picture.title;
  chart.range = settings.color.range;
  chart.fontScale = settings.picture.fontScale;
  return chart;
}

} // namespace

void probe(const Settings& settings)
{
  const std::string& output = settings.output.file;
  const bool isPicture = isChartFile(output);
  checkOutput(output, settings.data.files);
  const ProbedPoints points = pointsOf(settings.probe);
  if (isPicture)
    isOverTime(points, settings); // says what is wrong before anything is read
  OpenedInput opened(settings);
  std::vector<std::string> asked = settings.chart.curves;
  if (asked.empty())
    asked.push_back(settings.color.array);
  vtkSmartPointer<vtkTable> all;
  std::vector<Shown> shown;
  std::vector<double> times;
  std::string lengthUnit, timeUnit;
  opened.forSteps(
    [&](int step)
    {
      const std::vector<NamedData> data = opened.read();
      ProbeTable table(points);
      lookUp(points, data, opened, table);
      times.push_back(opened.timeOf(step));
      if (isPicture && shown.empty())
      {
        for (const std::string& name : asked)
          shown.push_back(shownOf(data, name));
        lengthUnit = unitText(lengthUnitOf(data.front().data));
        timeUnit = timeUnitOf(data);
      }
      for (Shown& one : shown)
        one.values.push_back(table.values(one.choice, one.heading));
      vtkSmartPointer<vtkTable> rows = table.table();
      if (settings.output.allSteps)
        rows = withTime(rows, times.back());
      if (!isPicture && !appendRows(all, rows))
        throw Failure(opened.input.name() + ": time step " + std::to_string(step + 1) +
                      " has other arrays than those before");
    });
  if (!isPicture)
  {
    writeTable(all, output);
    return;
  }
  Chart chart = chartOf(points, shown, times, lengthUnit, timeUnit, settings);
  chart.caption = opened.chartCaption();
  writeChart(chart, output);
}

} // namespace mote::app
