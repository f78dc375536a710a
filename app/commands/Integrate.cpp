#include "Integrate.h"

#include "ChartFile.h"
#include "IntegralChart.h"
#include "OpenedInput.h"
#include "TableFile.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/OutputFile.h"
#include "stage/Arrays.h"
#include "stage/Cuts.h"
#include "stage/ShownCells.h"
#include "stage/Slices.h"

#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkMath.h>
#include <vtkMoteSurfaceIntegrals.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTable.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <utility>

namespace mote::app
{

namespace
{

/// The first of the names that an array with so many components has in any of the data sets.
std::string usualName(
  const std::vector<NamedData>& data, const std::vector<const char*>& names, int components)
{
  for (const char* name : names)
    for (const NamedData& one : data)
      for (vtkDataSetAttributes* of : {static_cast<vtkDataSetAttributes*>(one.data->GetPointData()),
             static_cast<vtkDataSetAttributes*>(one.data->GetCellData())})
        if (vtkDataArray* array = of->GetArray(name);
            array && array->GetNumberOfComponents() == components)
          return name;
  return {};
}

std::string chosen(const std::string& asked, const std::string& usual)
{
  return asked == "none" ? "" : asked.empty() ? usual : asked;
}

/// Sections named as the user wrote them.
void addSections(vtkMoteSurfaceIntegrals* filter, const Settings& settings)
{
  const auto slices = slicesOf(settings, 0.0);
  std::size_t next = 0;
  for (const ShowRange& asked : settings.volume.slices.value_or(std::vector<ShowRange>()))
    for (const Interval& place : asked.intervals)
    {
      vtkMoteSlice* slice = slices[next++];
      const std::string name = asked.name + "=" + asNumber(place.low, 10);
      if (slice->GetShape() == vtkMoteSlice::PLANE)
        filter->AddPlane(name, slice->GetCenter(), slice->GetAxis());
      else if (slice->GetShape() == vtkMoteSlice::HALF_PLANE)
        filter->AddHalfPlane(name, slice->GetCenter(), slice->GetAxis(), slice->GetOutwards());
      else
        filter->AddCylinder(name, slice->GetCenter(), slice->GetAxis(), slice->GetRadius());
    }
  if (settings.integrate.boundary || slices.empty())
    filter->AddBoundary("boundary");
}

/// Adds what torques do at so many turns a minute.
void addPowers(vtkTable* table, double rpm)
{
  if (!table->GetColumnByName("torque"))
    throw Failure("--rpm makes powers of torques, which need a pressure; --pressure names it");
  const double speed = 2.0 * vtkMath::Pi() * rpm / 60.0;
  for (const auto& [from, to] : {std::pair{"torque", "power"}, {"torque_error", "power_error"}})
  {
    vtkNew<vtkDoubleArray> power;
    power->SetName(to);
    for (const double torque : numbersOf(table, from))
      power->InsertNextValue(
        from == std::string("torque") ? speed * torque : std::abs(speed) * torque);
    table->AddColumn(power);
  }
}

/// The data with marks on cells that --show, --where and the like leave out, as ghosts.
vtkSmartPointer<vtkDataSet> withHiddenCells(vtkDataSet* data, const SelectionSettings& selection)
{
  ShownCells shown;
  shown.update(data, cellLimitsOf(data, selection, {}), {});
  if (!shown.mask())
    return data;
  auto copy = vtk::TakeSmartPointer(data->NewInstance());
  copy->ShallowCopy(data);
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(data->GetNumberOfCells());
  vtkUnsignedCharArray* before = data->GetCellGhostArray();
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
    marks->SetValue(
      cell, static_cast<unsigned char>(
              (before ? before->GetValue(cell) : 0) |
              (shown.mask()->GetValue(cell) != 0 ? 0 : vtkDataSetAttributes::HIDDENCELL)));
  copy->GetCellData()->AddArray(marks);
  return copy;
}

/// The table of one time step.
vtkSmartPointer<vtkTable> tableOf(
  vtkMoteSurfaceIntegrals* filter, const std::vector<NamedData>& data, OpenedInput& opened)
{
  const IntegrateSettings& wanted = opened.settings.integrate;
  vtkNew<vtkMultiBlockDataSet> blocks;
  std::string known;
  for (const NamedData& one : data)
  {
    const unsigned number = blocks->GetNumberOfBlocks();
    blocks->SetBlock(number, withHiddenCells(one.data, opened.settings.selection));
    blocks->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), one.name.c_str());
    if (known.empty())
      known = listArrays(one.data);
  }
  filter->SetVelocityArrayName(
    chosen(wanted.velocity, usualName(data, {"U", "velocity", "Velocity", "u"}, 3)));
  filter->SetPressureArrayName(
    chosen(wanted.pressure, usualName(data, {"p", "pressure", "Pressure"}, 1)));
  filter->SetKinematicPressure(
    wanted.kinematic || isKinematic(data, filter->GetPressureArrayName()));
  filter->SetInputData(blocks);
  ProgressRelay::Work work(opened.progress, "Integrating", filter);
  filter->Update();
  work.finish();
  Messages::takeError(); // the filter keeps it
  if (const std::string& error = filter->GetErrorMessage(); !error.empty())
    throw Failure(opened.input.name() + ": " + error +
                  (error.starts_with("there is no array") ? "; it has " + known : ""));
  auto table = vtkSmartPointer<vtkTable>::New();
  table->DeepCopy(filter->GetOutput());
  if (wanted.rpm)
    addPowers(table, *wanted.rpm);
  return table;
}

std::string asJson(vtkTable* table)
{
  auto rows = nlohmann::ordered_json::array();
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    nlohmann::ordered_json one;
    for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
    {
      const vtkVariant value = table->GetValue(row, column);
      auto& entry = one[table->GetColumnName(column)];
      if (!value.IsNumeric())
        entry = value.ToString();
      else if (value.GetType() == VTK_ID_TYPE)
        entry = value.ToLongLong();
      else if (std::isfinite(value.ToDouble())) // null is what is not known
        entry = value.ToDouble();
    }
    rows.push_back(one);
  }
  return rows.dump(2) + "\n";
}

} // namespace

void integrate(const Settings& settings)
{
  const std::string& output = settings.output.file;
  const bool isJson = lowerCase(std::filesystem::path(output).extension().string()) == ".json" ||
                      settings.output.json;
  if (!isTableFile(output) && !isJson && !isChartFile(output))
    throw Failure("cannot write " + output +
                  ": the name must end in .csv or .json for a table, or "
                  ".png, .jpg, .tif, .exr or .svg for curves");
  checkOutput(output, settings.data.files);
  OpenedInput opened(settings);
  vtkNew<vtkMoteSurfaceIntegrals> filter;
  addSections(filter, settings);
  // What is left is smaller by far, as it is extrapolated; less would take longer.
  filter->SetTolerance(1e-5);
  for (const std::string& name : settings.integrate.arrays)
    filter->AddArray(name);
  filter->SetDensity(settings.integrate.density);
  if (!settings.cuts.axis.empty())
  {
    const CutAxis axis = cutAxisOf(settings.cuts.axis);
    filter->AxisFromInputOff();
    filter->SetOrigin(axis.point.data());
    filter->SetAxis(axis.direction.data());
  }
  vtkSmartPointer<vtkTable> all;
  std::vector<NamedData> data;
  std::string told;
  opened.forSteps(
    [&](int step)
    {
      data = opened.read();
      auto table = tableOf(filter, data, opened);
      if (const std::string& report = filter->GetReport();
          std::exchange(told, report) != report && !report.empty())
        Messages::warn(report);
      if (settings.output.allSteps)
        table = withTime(table, opened.timeOf(step));
      if (!appendRows(all, table))
        throw Failure(opened.input.name() + ": time step " + std::to_string(step + 1) +
                      " has other arrays; --array, --velocity and --pressure name those of all");
    });
  if (isJson && output.empty())
    std::fputs(asJson(all).c_str(), stdout);
  else if (isJson)
    writeText(output, asJson(all));
  else if (isTableFile(output))
    writeTable(all, output);
  else
  {
    const IntegralUnits units(
      data, filter->GetVelocityArrayName(), filter->GetPressureArrayName(), settings);
    Chart chart = integralChart(all, units, settings);
    chart.caption = opened.chartCaption();
    writeChart(chart, output);
  }
}

} // namespace mote::app
