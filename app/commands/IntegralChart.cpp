#include "IntegralChart.h"

#include "DataUnits.h"
#include "TableFile.h"
#include "base/Failure.h"
#include "base/Text.h"
#include "base/Unit.h"
#include "stage/Arrays.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace mote::app
{

namespace
{

/// Metres and seconds, in which gravity is 9.80665.
const Unit metre = *Unit::parse("m"), second = *Unit::parse("s");
const Unit kinematicUnit = *Unit::parse("m^2/s^2");

/// What the section of a row is: "r" and 0.06 of "r=0.06".
struct SectionPlace
{
  std::string kind;
  double place = 0.0;
};

std::optional<SectionPlace> placeOf(const std::string& section)
{
  const std::size_t at = section.rfind('=');
  SectionPlace found;
  if (at == std::string::npos || !parseNumber(section.substr(at + 1), found.place))
    return {};
  found.kind = section.substr(0, at);
  return found;
}

std::string kindTitle(const std::string& kind, const std::string& length)
{
  if (kind == "angle")
    return "angle (degrees)";
  const std::string name = kind == "r"       ? "radius"
                           : kind == "h"     ? "height"
                           : kind.size() > 1 ? "distance along " + kind
                                             : kind;
  return withUnit(name, length);
}

/// A table of integrals, row by row.
class IntegralRows
{
public:
  explicit IntegralRows(vtkTable* table)
    : table_(table)
    , times_(numbersOf(table, "time"))
  {
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      parts_.push_back(table->GetValueByName(row, "part").ToString());
      sections_.push_back(table->GetValueByName(row, "section").ToString());
    }
  }

  std::size_t size() const { return parts_.size(); }
  double time(std::size_t row) const { return times_[row]; }
  const std::string& section(std::size_t row) const { return sections_[row]; }

  /// "rotor, r=0.06": what of it tells curves apart.
  std::string name(std::size_t row, bool withSection) const
  {
    const bool manyParts = differ(parts_), manySections = withSection && differ(sections_);
    return (manyParts ? parts_[row] : "") + (manyParts && manySections ? ", " : "") +
           (manySections ? sections_[row] : "");
  }
  bool hasParts() const { return differ(parts_); }

private:
  static bool differ(const std::vector<std::string>& words)
  {
    return std::any_of(
      words.begin(), words.end(), [&](const std::string& word) { return word != words.front(); });
  }

  vtkTable* table_;
  std::vector<double> times_;
  std::vector<std::string> parts_, sections_;
};

/// The columns that curves show.
std::vector<std::string> chosenColumns(vtkTable* table, const Settings& settings)
{
  const auto isNumeric = [&](const std::string& name)
  { return vtkDataArray::SafeDownCast(table->GetColumnByName(name.c_str())) != nullptr; };
  for (const std::string& name : settings.chart.curves)
    if (!isNumeric(name))
    {
      std::vector<std::string> known;
      for (vtkIdType c = 0; c < table->GetNumberOfColumns(); ++c)
        if (const std::string column = table->GetColumnName(c);
            isNumeric(column) && !column.ends_with("_error"))
          known.push_back(column);
      throw Failure(
        "the table has no column " + name + " for curves; it has " + joined(known, ", "));
    }
  if (!settings.chart.curves.empty())
    return settings.chart.curves;
  std::vector<std::string> names;
  const auto add = [&](const std::string& name)
  {
    const std::vector<double> numbers = numbersOf(table, name);
    if (std::any_of(
          numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); }))
      names.push_back(name);
  };
  for (vtkIdType c = 0; c < table->GetNumberOfColumns(); ++c)
    if (const std::string column = table->GetColumnName(c);
        table->GetColumnByName((column + "_integral").c_str()))
      add(column);
  for (const char* column : {"flow", "torque", "power", "head"})
    add(column);
  if (names.empty())
    names.emplace_back("area");
  names.resize(std::min<std::size_t>(names.size(), 6));
  return names;
}

/// Points of curves: rows by the curve's name, in their order.
struct RowsOfCurves
{
  std::vector<std::string> names;
  std::vector<std::vector<std::pair<double, std::size_t>>> points; ///< place along x, and row
  std::vector<double> values;                                      ///< ChartCurve::value

  void add(const std::string& name, double value, double x, std::size_t row)
  {
    const auto at =
      static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    if (at == names.size())
    {
      names.push_back(name);
      points.emplace_back();
      values.push_back(value);
    }
    points[at].emplace_back(x, row);
  }
};

/// Curves over the places of sections, which must be of one kind. Returns the kind.
std::string addPlaces(const IntegralRows& rows, bool hasTimes, RowsOfCurves& curves)
{
  std::string kind;
  std::set<double> places;
  for (std::size_t row = 0; row < rows.size(); ++row)
    if (const auto at = placeOf(rows.section(row)))
    {
      kind = kind.empty() ? at->kind : kind == at->kind ? kind : "different";
      places.insert(at->place);
      const std::string time = hasTimes ? "t = " + asNumber(rows.time(row)) : "";
      const std::string part = rows.name(row, false);
      curves.add(part + (part.empty() || time.empty() ? "" : ", ") + time,
        hasTimes ? rows.time(row) : 0.0, at->place, row);
    }
  if (kind == "different" || places.size() < 2)
    throw Failure("curves over places need slices of one kind, at two places or more, such as "
                  "--slice r=0.1,0.2; curves over time need --all-steps");
  for (auto& points : curves.points)
    std::sort(points.begin(), points.end());
  return kind;
}

} // namespace

bool isKinematic(const std::vector<NamedData>& data, const std::string& pressure)
{
  const auto unit = pressure.empty() ? std::nullopt : knownUnit(data, pressure);
  return unit && unit->inBaseUnits() == kinematicUnit;
}

IntegralUnits::IntegralUnits(const std::vector<NamedData>& data, const std::string& velocity,
  const std::string& pressure, const Settings& settings)
{
  const auto length = knownUnit(data);
  time_ = timeUnitOf(data);
  const auto set = [&](const std::string& column, const std::optional<Unit>& unit)
  {
    if (unit)
      columns_[column] = columns_[column + "_error"] = unit->text();
  };
  for (const NamedData& one : data)
    for (vtkFieldData* arrays : {static_cast<vtkFieldData*>(one.data->GetPointData()),
           static_cast<vtkFieldData*>(one.data->GetCellData())})
      for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
        if (const char* name = arrays->GetArrayName(i))
          if (const auto unit = knownUnit(data, name))
          {
            set(name, unit);
            set(std::string(name) + "_flow_mean", unit);
            if (length)
              set(std::string(name) + "_integral", *unit * length->toThe(2));
          }
  if (!length)
    return;
  length_ = length->text();
  set("area", length->toThe(2));
  const auto speed = velocity.empty() ? std::nullopt : knownUnit(data, velocity);
  if (speed)
    set("flow", *speed * length->toThe(2));
  auto press = pressure.empty() ? std::nullopt : knownUnit(data, pressure);
  if (!press)
    return;
  press = press->inBaseUnits();
  // The density is then in the same units: kg/m³ where these are metres.
  if (*press == kinematicUnit && settings.integrate.density != 1.0)
    press = *Unit::parse("Pa");
  set("total_pressure", press);
  set("torque", *press * length->toThe(3));
  set("power", (*press * length->toThe(3)) / second);
  if (*length == metre && (*press == kinematicUnit || press->text() == "Pa"))
    set("head", metre);
}

std::string IntegralUnits::of(const std::string& column) const
{
  if (const auto found = columns_.find(column); found != columns_.end())
    return found->second;
  // A component, "U:0", has the unit of all.
  const std::size_t colon = column.rfind(':');
  if (colon == std::string::npos)
    return {};
  const std::size_t end = column.find('_', colon);
  const auto found =
    columns_.find(column.substr(0, colon) + (end == column.npos ? "" : column.substr(end)));
  return found == columns_.end() ? "" : found->second;
}

Chart integralChart(vtkTable* table, const IntegralUnits& units, const Settings& settings)
{
  const IntegralRows rows(table);
  const bool hasTimes = table->GetColumnByName("time") != nullptr;
  const bool overTime = settings.chart.over.empty() ? hasTimes : settings.chart.over == "time";
  if (overTime && !hasTimes)
    throw Failure("curves over time need --all-steps");
  Chart chart;
  RowsOfCurves curves;
  if (overTime)
  {
    chart.xTitle = withUnit("time", units.ofTime());
    for (std::size_t row = 0; row < rows.size(); ++row)
      curves.add(rows.name(row, true), 0.0, rows.time(row), row);
  }
  else
  {
    chart.xTitle = kindTitle(addPlaces(rows, hasTimes, curves), units.ofLength());
    if (hasTimes && !rows.hasParts() && curves.names.size() > mostNamedCurves)
      chart.colorTitle = withUnit("time", units.ofTime());
  }
  for (const std::string& column : chosenColumns(table, settings))
  {
    const std::vector<double> numbers = numbersOf(table, column);
    ChartPanel panel;
    panel.title = withUnit(column, units.of(column));
    for (std::size_t k = 0; k < curves.names.size(); ++k)
    {
      ChartCurve& curve = panel.curves.emplace_back();
      curve.name = curves.names[k];
      curve.value = curves.values[k];
      for (const auto& [x, row] : curves.points[k])
      {
        curve.x.push_back(x);
        curve.y.push_back(numbers[row]);
      }
      // That of the first section is 0 by itself, and says nothing.
      if (column == "head" && overTime && curves.names.size() > 1 &&
          std::all_of(curve.y.begin(), curve.y.end(), [](double head) { return head == 0.0; }))
        curve.y.assign(curve.y.size(), std::nan(""));
    }
    chart.panels.push_back(std::move(panel));
  }
  chart.range = settings.color.range;
  chart.fontScale = settings.picture.fontScale;
  return chart;
}

} // namespace mote::app
