#include "Table.h"

#include "stage/Cuts.h"
#include "stage/Slices.h"

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

void checkSlices(const std::optional<std::vector<ShowRange>>& asked)
{
  const std::vector<ShowRange> slices = asked.value_or(std::vector<ShowRange>());
  std::size_t count = 0;
  for (const ShowRange& slice : slices)
  {
    const std::optional<CutKind> kind = cutNamed(slice.name);
    if (!kind)
      throw WrongValue{"there is no slice by '" + slice.name +
                       "', but by x, y, z, r, h, angle, or a direction of three numbers"};
    for (const Interval& place : slice.intervals)
    {
      if (place.low != place.high)
        throw WrongValue{"'" + slice.name + "' takes places, such as 0.1 or 0.1,0.2, not a range"};
      if (kind->of == CutKind::Radius && !(place.low > 0.0))
        throw WrongValue{"a slice by r lies at a radius above 0"};
      ++count;
    }
    if (std::count_if(slices.begin(), slices.end(),
          [&](const ShowRange& other) { return other.name == slice.name; }) > 1)
      throw WrongValue{"'" + slice.name + "' is given twice; places are joined by commas"};
  }
  if (count > mostSlices)
    throw WrongValue{"at most " + std::to_string(mostSlices) + " slices are possible, not " +
                     std::to_string(count)};
}

void checkTurns(const std::vector<ShowRange>& turns)
{
  for (const ShowRange& turn : turns)
    if (turn.intervals.size() != 1 || turn.intervals.front().low != turn.intervals.front().high ||
        !std::isfinite(turn.intervals.front().low))
      throw WrongValue{"'" + turn.name + "' takes one number, turns a minute"};
}

} // namespace

void addSliceRows(std::vector<Row>& table)
{
  const std::string group = "Slices";
  const auto volume = &Settings::volume;
  table.push_back(
    row<VolumeSettings, std::optional<std::vector<ShowRange>>>(volume, &VolumeSettings::slices,
      {.group = group,
        .name = "slice",
        .value = "NAME=PLACE,...",
        .help =
          "Show volumes sliced: by planes across x, y, z or a direction of three numbers, as in "
          "1,1,0=5, by cylinders about the axis of --cut-axis at radii r, by planes across it at "
          "heights h, or by half planes at angles in degrees, which end at the axis. Colours are "
          "those of the cells' values, to the pixel. May be given for several names; none is no "
          "slice",
        .commas = false,
        .usual = "without --cloud, --iso and --streamlines the faces of --cut, else one across the "
                 "shortest side, where no selection hides cells"},
      checkSlices));
  table.push_back(row(volume, &VolumeSettings::unroll,
    {.group = group,
      .name = "unroll",
      .help = "Roll slices by r out flat, blade to blade: onto the plane that touches the cylinder "
              "at angle 0, half a turn to either side",
      .needs = "slice"}));
  table.push_back(row(volume, &VolumeSettings::walls,
    {.group = group,
      .name = "walls",
      .value = "OPACITY",
      .help = "Show the boundary of volumes, from 0, not at all, to 1, opaque",
      .limits = {.least = 0.0, .most = 1.0},
      .usual = "1 without --cloud and --unroll, else 0"}));
  table.push_back(row(volume, &VolumeSettings::nearWalls,
    {.group = group,
      .name = "near-walls",
      .value = "OPACITY",
      .help = "Opacity of the parts of --walls that are seen from outside, and so hide what is "
              "within: with 0 you look in, onto the walls behind",
      .limits = {.least = 0.0, .most = 1.0},
      .usual =
        "0 where --walls is not given, there is something within and no selection hides cells, "
        "else that of --walls"}));
  table.push_back(row<VolumeSettings, std::string>(volume, &VolumeSettings::wallColor,
    {.group = group,
      .name = "wall-color",
      .value = "COLOUR",
      .help = "Colour of --walls; data colours them like all else, as they are where a selection "
              "hides cells and --walls is not given",
      .offers = {"data"}},
    [](const std::string& name)
    {
      if (name != "data")
        colorOf(name);
    }));
  table.push_back(row(volume, &VolumeSettings::repeatAround,
    {.group = group,
      .name = "repeat-around",
      .value = "N",
      .help = "Show volumes and surfaces N times, evenly around the axis of --cut-axis: one sector "
              "as the whole wheel. Nothing is copied; cells and counts are those of the one that "
              "is there. Vectors turn with it",
      .limits = {.least = 1, .most = 360}}));
  table.push_back(row<VolumeSettings, std::vector<ShowRange>>(volume, &VolumeSettings::turns,
    {.group = group,
      .name = "turn",
      .value = "PART=RPM",
      .help = "Turn a volume or surface by so many turns a minute since time 0, in seconds, about "
              "the axis of --cut-axis, or the one that the data name: a rotor whose file says what "
              "flows around it at each step, but not where it stands. Above 0 by the right-hand "
              "rule. Parts are named as for --hide-part. Vectors turn with them. Nothing is copied "
              "or built anew from step to step; slices and cuts stay in place",
      .commas = false,
      .usual = "nothing turns"},
    checkTurns));
  table.push_back(row(volume, &VolumeSettings::edges,
    {.group = group,
      .name = "edges",
      .value = "PIXELS",
      .help = "Width of lines along the edges of cells: on slices, walls and surfaces. They fade "
              "where cells are only a few pixels wide",
      .limits = {.least = 0.0, .most = 20.0},
      .usual = "0, no lines"}));
}

} // namespace mote::app
