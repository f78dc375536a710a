#include "Table.h"

#include "stage/Cuts.h"

#include <algorithm>

namespace mote::app
{

namespace
{

void checkCuts(const std::vector<ShowRange>& cuts)
{
  for (const ShowRange& cut : cuts)
  {
    if (!cutNamed(cut.name))
      throw WrongValue{"there is no cut by '" + cut.name +
                       "', but by x, y, z, r, h, angle, or a direction of three numbers"};
    if (cut.intervals.size() != 1)
      throw WrongValue{"'" + cut.name + "' takes one range, from LO to HI"};
    if (std::count_if(cuts.begin(), cuts.end(),
          [&](const ShowRange& other) { return other.name == cut.name; }) > 1)
      throw WrongValue{"'" + cut.name + "' is given twice"};
  }
  if (cuts.size() > 8)
    throw WrongValue{"at most eight cuts are possible, not " + std::to_string(cuts.size())};
}

} // namespace

void addCutRows(std::vector<Row>& table)
{
  const std::string group = "Cuts";
  const auto cuts = &Settings::cuts;
  table.push_back(row<CutSettings, std::vector<ShowRange>>(cuts, &CutSettings::ranges,
    {.group = group,
      .name = "cut",
      .value = "NAME=LO:HI",
      .help =
        "Cut everything open: show only what lies from LO to HI along x, y or z, or along a "
        "direction of three numbers, as in 1,1,0=0:5, or by a coordinate about the axis of "
        "--cut-axis: r, its distance, h, the height, or angle, in degrees. LO or HI may be left "
        "out, of an angle for 0 and 360. May be given up to eight times. Spheres are cut through "
        "and closed, surfaces are "
        "open, volumes end there. Bounds, counts and statistics stay those of the whole",
      .commas = false,
      .usual = "nothing is cut"},
    checkCuts));
  table.push_back(row<CutSettings, std::vector<double>>(cuts, &CutSettings::axis,
    {.group = group,
      .name = "cut-axis",
      .value = "X,Y,Z,...",
      .help =
        "The axis of cuts and slices by r, h and angle: its direction, or a point on it and its "
        "direction. Angles count from the x axis, or from y where the axis is x, by the "
        "right-hand rule",
      .usual = "z through the origin"},
    [](const std::vector<double>& numbers) { cutAxisOf(numbers); }));
}

} // namespace mote::app
