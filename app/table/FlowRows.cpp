#include "Table.h"

namespace mote::app
{

void addFlowRows(std::vector<Row>& table)
{
  const std::string group = "Flow";
  const auto flow = &Settings::flow;
  table.push_back(row(flow, &FlowSettings::lines,
    {.group = group,
      .name = "streamlines",
      .value = "N",
      .help = "Show the streamlines through N places of the volumes, both ways, as tubes",
      .invalidates = Invalidates::Structure,
      .limits = {.least = 0, .most = 1'000'000},
      .usual = "0, none"}));
  table.push_back(row(flow, &FlowSettings::arrows,
    {.group = group,
      .name = "arrows",
      .value = "N",
      .help = "Show arrows at N places of the volumes, as long as the vectors there",
      .invalidates = Invalidates::Structure,
      .limits = {.least = 0, .most = 1'000'000},
      .usual = "0, none"}));
  table.push_back(row(flow, &FlowSettings::arrowsOn,
    {.group = group,
      .name = "arrows-on",
      .value = "WHERE",
      .help =
        "Where --arrows are: throughout the volume, or evenly over the slices that are shown, "
        "about as many in all",
      .invalidates = Invalidates::Structure,
      .words = {"volume", "slices"},
      .needs = "arrows"}));
  table.push_back(row(flow, &FlowSettings::arrowVectors,
    {.group = group,
      .name = "arrow-vectors",
      .value = "WHICH",
      .help = "What --arrows-on slices shows: full vectors, or tangential, their part that lies in "
              "the slice",
      .invalidates = Invalidates::Structure,
      .words = {"full", "tangential"},
      .needs = "arrows"}));
  table.push_back(row(flow, &FlowSettings::array,
    {.group = group,
      .name = "flow-array",
      .value = "NAME",
      .help = "The vectors of --streamlines and --arrows, of points or cells",
      .invalidates = Invalidates::Structure,
      .usual = "the first array with three components"}));
  table.push_back(row(flow, &FlowSettings::from,
    {.group = group,
      .name = "flow-from",
      .value = "X,Y,Z,X,Y,Z",
      .help =
        "Places of --streamlines and --arrows lie evenly on the line between these two points",
      .invalidates = Invalidates::Structure,
      .usual = "evenly through the volume"},
    std::function<void(const std::vector<double>&)>(
      [](const std::vector<double>& numbers)
      {
        if (!numbers.empty() && numbers.size() != 6)
          throw WrongValue{"a line is six numbers, its two ends"};
      })));
  table.push_back(row(flow, &FlowSettings::length,
    {.group = group,
      .name = "streamline-length",
      .value = "LENGTH",
      .help = "How far streamlines go from their places, each way, in the data's units",
      .invalidates = Invalidates::Structure,
      .limits = {.aboveZero = true},
      .usual = "the diagonal of the data"}));
  table.push_back(row(flow, &FlowSettings::width,
    {.group = group,
      .name = "streamline-width",
      .value = "LENGTH",
      .help = "How wide the tubes of streamlines are, in the data's units",
      .invalidates = Invalidates::Structure,
      .limits = {.aboveZero = true},
      .usual = "three thousandths of the diagonal of the data"}));
  table.push_back(row(flow, &FlowSettings::arrowScale,
    {.group = group,
      .name = "arrow-scale",
      .value = "FACTOR",
      .help = "Length of an arrow of the mean length, as a share of how far arrows lie apart",
      .invalidates = Invalidates::Structure,
      .limits = {.most = 100.0, .aboveZero = true}}));
}

} // namespace mote::app
