// What the window alone may be told, about time and plots.

#include "Table.h"

#include "base/Text.h"

#include <kernels/core/MemoryLimit.h>

#include <algorithm>

namespace mote::app
{

void addTimeRows(std::vector<Row>& table)
{
  const std::string group = "Time", command = "mote";
  const auto output = &Settings::output;
  table.push_back(row<OutputSettings, std::string>(output, &OutputSettings::cache,
    {.group = group,
      .name = "cache",
      .value = "SIZE",
      .help = "Memory for time steps that are read and built ahead, such as 4G, or a share of the "
              "machine's such as 25%; 0: none are",
      .invalidates = Invalidates::Nothing,
      .usual = "25%",
      .command = command},
    [](const std::string& text)
    {
      if (!memoryOf(text))
        throw WrongValue{"'" + text + "' is neither a size such as 4G nor a share such as 25%"};
    }));
  table.push_back(row(output, &OutputSettings::follow,
    {.group = group,
      .name = "follow",
      .help = "Read new time steps as a simulation writes them: at the end of a dump, or as new "
              "files of a series. Where the last step is shown the new one is",
      .invalidates = Invalidates::Nothing,
      .command = command}));
  table.push_back(row(output, &OutputSettings::speed,
    {.group = group,
      .name = "speed",
      .value = "N",
      .help = "Time steps a second while they are played, at most",
      .invalidates = Invalidates::Nothing,
      .limits = {.least = 0.1, .most = 100.0},
      .command = command}));
  table.push_back(row(output, &OutputSettings::loop,
    {.group = group,
      .name = "loop",
      .help = "Stop at the last time step; else playing begins again at the first",
      .invalidates = Invalidates::Nothing,
      .command = command}));
}

void addPlotRows(std::vector<Row>& table)
{
  const std::string group = "Plot", command = "mote";
  const auto plot = &Settings::plot;
  const auto nothing = Invalidates::Nothing;
  table.push_back(row(plot, &PlotSettings::x,
    {.group = group,
      .name = "plot-x",
      .value = "NAME",
      .help = "What the panel plots to the right: an array as --color-by names it, or x, y, z",
      .invalidates = nothing,
      .usual = "what colours",
      .command = command}));
  table.push_back(row(plot, &PlotSettings::y,
    {.group = group,
      .name = "plot-y",
      .value = "NAME",
      .help = "What the panel plots upwards, for a scatter plot of two values",
      .invalidates = nothing,
      .usual = "how many there are",
      .command = command}));
  table.push_back(row(plot, &PlotSettings::of,
    {.group = group,
      .name = "plot-of",
      .value = "WHICH",
      .help = "Whose values the panel plots: of all, of those that are visible, or of the picked",
      .invalidates = nothing,
      .words = {"all", "visible", "picked"},
      .command = command}));
  table.push_back(row(plot, &PlotSettings::logarithmic,
    {.group = group,
      .name = "plot-log",
      .help = "Plot the logarithm of the counts",
      .invalidates = nothing,
      .command = command}));
  table.push_back(row(plot, &PlotSettings::overTime,
    {.group = group,
      .name = "plot-over-time",
      .value = "NAME",
      .help = "Which values of the picked particles the panel plots over time",
      .invalidates = nothing,
      .usual = "what colours",
      .command = command}));
}

std::optional<std::uint64_t> memoryOf(const std::string& text)
{
  double share = 0.0;
  if (text == "0")
    return 0;
  if (text.ends_with("%") && parseNumber(text.substr(0, text.size() - 1), share))
  {
    if (share < 0.0 || share > 100.0)
      return std::nullopt;
    return static_cast<std::uint64_t>(0.01 * share * static_cast<double>(physicalMemory()));
  }
  const std::uint64_t bytes = bytesOf(text);
  return bytes > 0 ? std::optional(bytes) : std::nullopt;
}

const Row* commandRow(const std::string& command, const std::string& name)
{
  const auto& table = commandTable();
  const auto found = std::find_if(table.begin(), table.end(),
    [&](const Row& row) { return row.command == command && row.name == name; });
  return found == table.end() ? nullptr : &*found;
}

} // namespace mote::app
