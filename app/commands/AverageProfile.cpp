#include "AverageProfile.h"

#include "DataUnits.h"
#include "TableFile.h"
#include "base/Failure.h"
#include "base/Text.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace mote::app
{

namespace
{

constexpr const char* deviation = "_deviation";

/// Rows of bins by their place.
using BinsOfPlace = std::map<double, std::vector<std::size_t>>;

/// So many places of bins are one of a profile: where cells and bins are in step, what falls into
/// each of them would show.
constexpr int joinedBins = 4;

BinsOfPlace placesOf(const std::vector<double>& at)
{
  std::vector<double> all = at;
  std::sort(all.begin(), all.end());
  double size = 0.0;
  for (std::size_t i = 1; i < all.size(); ++i)
    if (const double step = all[i] - all[i - 1]; step > 0.0 && (size == 0.0 || step < size))
      size = step;
  BinsOfPlace places;
  for (std::size_t bin = 0; bin < at.size(); ++bin)
  {
    const double number = size > 0.0 ? std::round((at[bin] - all.front()) / size) : 0.0;
    const double group = std::floor(number / joinedBins);
    places[all.front() + (joinedBins * group + 0.5 * (joinedBins - 1)) * size].push_back(bin);
  }
  return places;
}

void addColumn(vtkTable* table, const std::string& name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> column;
  column->SetName(name.c_str());
  for (const double value : values)
    column->InsertNextValue(value);
  table->AddColumn(column);
}

/// Means of values by volume.
std::vector<double> means(
  const BinsOfPlace& places, const std::vector<double>& volumes, const std::vector<double>& values)
{
  std::vector<double> result;
  for (const auto& [place, bins] : places)
  {
    double sum = 0.0, volume = 0.0;
    for (const std::size_t bin : bins)
    {
      sum += volumes[bin] * values[bin];
      volume += volumes[bin];
    }
    result.push_back(sum / volume);
  }
  return result;
}

} // namespace

vtkSmartPointer<vtkTable> profileOf(vtkTable* bins, const std::string& over)
{
  const std::vector<double> volumes = numbersOf(bins, "volume");
  const BinsOfPlace places = placesOf(numbersOf(bins, over));
  auto profile = vtkSmartPointer<vtkTable>::New();
  std::vector<double> ends, sums;
  for (const auto& [place, rows] : places)
  {
    ends.push_back(place);
    double sum = 0.0;
    for (const std::size_t row : rows)
      sum += volumes[row];
    sums.push_back(sum);
  }
  addColumn(profile, over, ends);
  addColumn(profile, "volume", sums);
  for (vtkIdType c = 0; c < bins->GetNumberOfColumns(); ++c)
  {
    const std::string name = bins->GetColumnName(c);
    if (name == "axial" || name == "radial" || name == "volume")
      continue;
    std::vector<double> values = numbersOf(bins, name);
    if (!name.ends_with(deviation))
    {
      addColumn(profile, name, means(places, volumes, values));
      continue;
    }
    // Within the bins, and from bin to bin.
    std::vector<double> own = numbersOf(bins, name.substr(0, name.rfind(deviation)));
    const std::vector<double> middle = means(places, volumes, own);
    for (std::size_t bin = 0; bin < values.size(); ++bin)
      values[bin] = values[bin] * values[bin] + own[bin] * own[bin];
    std::vector<double> spread = means(places, volumes, values);
    for (std::size_t i = 0; i < spread.size(); ++i)
      spread[i] = std::sqrt(std::max(0.0, spread[i] - middle[i] * middle[i]));
    addColumn(profile, name, spread);
  }
  return profile;
}

Chart profileChart(
  vtkTable* profiles, const std::string& array, const std::string& unit, const Settings& settings)
{
  std::vector<std::string> columns = settings.chart.curves;
  std::vector<std::string> known;
  for (vtkIdType c = 0; c < profiles->GetNumberOfColumns(); ++c)
    known.emplace_back(profiles->GetColumnName(c));
  for (const std::string& column : columns)
    if (std::find(known.begin(), known.end(), column) == known.end())
      throw Failure(
        "the average has no column " + column + " for curves; it has " + joined(known, ", "));
  for (const std::string& column : known)
    if (settings.chart.curves.empty() && column.starts_with(array) &&
        !column.ends_with(deviation) && !column.ends_with("_magnitude"))
      columns.push_back(column);
  Chart chart;
  const std::vector<double> x = numbersOf(profiles, settings.chart.over);
  const std::vector<double> times = numbersOf(profiles, "time");
  for (const std::string& column : columns)
  {
    const std::vector<double> values = numbersOf(profiles, column);
    ChartPanel panel;
    panel.title = withUnit(column, column.starts_with(array) ? unit : "");
    for (std::size_t row = 0; row < x.size(); ++row)
    {
      if (row == 0 || (std::isfinite(times[row]) && times[row] != times[row - 1]))
      {
        ChartCurve& curve = panel.curves.emplace_back();
        curve.name = std::isfinite(times[row]) ? "t = " + asNumber(times[row]) : "";
        curve.value = times[row];
      }
      panel.curves.back().x.push_back(x[row]);
      panel.curves.back().y.push_back(values[row]);
    }
    chart.panels.push_back(std::move(panel));
  }
  if (!chart.panels.empty() && chart.panels.front().curves.size() > mostNamedCurves)
    chart.colorTitle = "time";
  chart.range = settings.color.range;
  chart.fontScale = settings.picture.fontScale;
  return chart;
}

} // namespace mote::app
