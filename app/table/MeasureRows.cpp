// What the commands may be told that make tables and charts of cells: average, integrate, probe.

#include "Table.h"

namespace mote::app
{

namespace
{

using Rows = std::vector<Row>;

/// What pictures of a command's table show: help of --curves, and the words and help of --over.
void addChart(Rows& table, const std::string& command, const std::string& curves,
  const std::string& usual, const std::vector<std::string>& words, const std::string& over,
  const std::string& usualOver)
{
  table.push_back(
    row<ChartSettings, std::vector<std::string>>(&Settings::chart, &ChartSettings::curves,
      {.group = "Chart",
        .name = "curves",
        .value = "NAME,...",
        .help = curves,
        .usual = usual,
        .command = command}));
  table.push_back(row(&Settings::chart, &ChartSettings::over,
    {.group = "Chart",
      .name = "over",
      .value = "WHAT",
      .help = over,
      .words = words,
      .usual = usualOver,
      .command = command}));
}

void requireAscending(const std::vector<double>& range)
{
  if (range.size() == 2 && !(range[0] < range[1]))
    throw WrongValue{"LO must be less than HI"};
}

void addAverage(Rows& table)
{
  const std::string group = "Averaging", command = "average";
  const auto average = &Settings::average;
  table.push_back(row(average, &AverageSettings::array,
    {.group = group,
      .name = "array",
      .value = "NAME",
      .help = "Array to average, named as in --color-by: cell:p, U:2, U:magnitude. Of vectors the "
              "parts along axis, radius and circumference are averaged",
      .alias = "-a",
      .command = command,
      .required = true}));
  table.push_back(outputRow(command,
    "Table to write, .csv, or picture, .png, .jpg, .tif, .exr or .svg, in which the axis goes to "
    "the right and the radius upwards, or with --over curves. By default the table goes to "
    "standard output",
    false));
  addChart(table, command, "Columns of the table that curves show, one above the other",
    "the average, of a vector its three parts", {"axial", "radial"},
    "Average along the other direction, too: a profile along the axis, or along the radius, as "
    "table or curves, in steps of four bins",
    "a map of both");
  table.push_back(allStepsRow(
    command, "With --over: all time steps, with a column of their times, and a curve for each"));
  table.push_back(row(average, &AverageSettings::resolution,
    {.group = group,
      .name = "resolution",
      .value = "N",
      .help = "Bins along the longer edge",
      .limits = {.least = 1, .most = 4096},
      .command = command}));
  table.push_back(row(average, &AverageSettings::axis,
    {.group = group,
      .name = "axis",
      .value = "X,Y,Z",
      .help = "Direction of the axis",
      .count = 3,
      .usual = "what the data say, else z",
      .command = command}));
  table.push_back(row(average, &AverageSettings::origin,
    {.group = group,
      .name = "origin",
      .value = "X,Y,Z",
      .help = "A point of the axis",
      .count = 3,
      .usual = "what the data say, else 0,0,0",
      .command = command}));
  const auto add =
    [&](std::vector<double> AverageSettings::*range, const char* name, const char* help)
  {
    table.push_back(row<AverageSettings, std::vector<double>>(average, range,
      {.group = group,
        .name = name,
        .value = "LO HI",
        .help = help,
        .count = 2,
        .usual = "all",
        .command = command},
      requireAscending));
  };
  add(&AverageSettings::radial, "radial-range", "Distances from the axis that are averaged");
  add(&AverageSettings::axial, "axial-range", "Places along the axis that are averaged");
}

void addIntegralOutput(Rows& table, const std::string& command)
{
  addChart(table, command,
    "Columns of the table that a picture shows, one above the other. Units stand where the data "
    "name theirs",
    "the means of --array, flow, torque, power and head, as far as there are any",
    {"time", "place"},
    "What the curves of a picture run over: time, with a curve for each part and section, or the "
    "place of slices of one kind, with a curve for each part and time step",
    "time with --all-steps, else place");
  table.push_back(allStepsRow(command, "All time steps, with a column of their times"));
  table.push_back(row(&Settings::output, &OutputSettings::json,
    {.group = "Output",
      .name = "json",
      .help = "Write JSON in place of a table",
      .command = command}));
  table.push_back(outputRow(command,
    "Table to write, .csv, or .json; or picture of curves, .png, .jpg, .tif, .exr or .svg. By "
    "default the table goes to standard output",
    false));
}

void addIntegrate(Rows& table)
{
  const std::string group = "Integrals", command = "integrate";
  const auto integrate = &Settings::integrate;
  table.push_back(row(integrate, &IntegrateSettings::boundary,
    {.group = group,
      .name = "boundary",
      .help = "Integrate over the boundary of each part, too; without --slice over that alone",
      .command = command}));
  table.push_back(
    row<IntegrateSettings, std::vector<std::string>>(integrate, &IntegrateSettings::arrays,
      {.group = group,
        .name = "array",
        .value = "NAME,...",
        .help = "Arrays to integrate, on points or cells: their means, and integrals",
        .alias = "-a",
        .usual = "none",
        .command = command}));
  const auto add = [&](std::string IntegrateSettings::*name, const char* option, const char* help,
                     const char* usual)
  {
    table.push_back(row(integrate, name,
      {.group = group,
        .name = option,
        .value = "NAME",
        .help = help,
        .usual = usual,
        .command = command}));
  };
  add(&IntegrateSettings::velocity, "velocity",
    "Array of the velocity, for flow rates and means weighted with the flow; or none",
    "U or velocity, if it is there");
  add(&IntegrateSettings::pressure, "pressure",
    "Array of the pressure, for torques on boundaries and, with a velocity, total pressure and "
    "head; or none",
    "p or pressure, if it is there");
  table.push_back(row(integrate, &IntegrateSettings::density,
    {.group = group,
      .name = "density",
      .value = "RHO",
      .help = "Density of the fluid",
      .limits = {.aboveZero = true},
      .command = command}));
  table.push_back(row(integrate, &IntegrateSettings::kinematic,
    {.group = group,
      .name = "kinematic",
      .help = "The pressure is given over the density, as incompressible solvers do",
      .command = command}));
  table.push_back(row(integrate, &IntegrateSettings::rpm,
    {.group = group,
      .name = "rpm",
      .value = "N",
      .help = "Turns a minute: boundaries get their power, torque times angular velocity",
      .usual = "no powers",
      .command = command}));
  addIntegralOutput(table, command);
}

void addProbe(Rows& table)
{
  const std::string group = "Line", command = "probe";
  const auto probe = &Settings::probe;
  table.push_back(row(probe, &ProbeSettings::from,
    {.group = group,
      .name = "from",
      .value = "X,Y,Z",
      .help = "Where the line begins",
      .count = 3,
      .needs = "to",
      .command = command}));
  table.push_back(row(probe, &ProbeSettings::to,
    {.group = group,
      .name = "to",
      .value = "X,Y,Z",
      .help = "Where it ends",
      .count = 3,
      .needs = "from",
      .command = command}));
  table.push_back(row<ProbeSettings, std::vector<double>>(probe, &ProbeSettings::at,
    {.group = group,
      .name = "at",
      .value = "X,Y,Z,...",
      .help = "A point to look at in place of a line, or several: three numbers for each",
      .usual = "the line",
      .excludes = {"from", "to", "points"},
      .command = command},
    [](const std::vector<double>& numbers)
    {
      if (numbers.size() % 3 != 0)
        throw WrongValue{
          "takes three numbers for each point, not " + std::to_string(numbers.size()) + " in all"};
    }));
  table.push_back(row(probe, &ProbeSettings::points,
    {.group = group,
      .name = "points",
      .value = "N",
      .help = "Points along the line, its ends included",
      .limits = {.least = 2, .most = 1000000},
      .command = command}));
  addChart(table, command,
    "Arrays that a picture shows, one above the other, named as in --color-by: p, U, U:2",
    "that of --color-by", {"distance", "time"},
    "What the curves of a picture run over: the distance along the line, with a curve for each "
    "time step, or time, with a curve for each point",
    "distance, with --at time");
  table.push_back(allStepsRow(command, "All time steps, with a column of their times"));
  table.push_back(outputRow(command,
    "Table to write, as comma-separated values; or picture of curves, .png, .jpg, .tif, .exr or "
    ".svg. By default the table goes to standard output",
    false));
}

} // namespace

void addMeasureRows(Rows& table)
{
  addAverage(table);
  addIntegrate(table);
  addProbe(table);
}

} // namespace mote::app
