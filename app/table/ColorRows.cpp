#include "Table.h"

#include "stage/ColorMaps.h"

#include <algorithm>

namespace mote::app
{

void addColorRows(std::vector<Row>& table)
{
  const std::string group = "Colour";
  const auto color = &Settings::color;
  table.push_back(row(color, &ColorSettings::array,
    {.group = group,
      .name = "color-by",
      .value = "NAME",
      .help = "Array that colours: NAME, or NAME:COMPONENT (a number from 0, or its name) or "
              "NAME:magnitude of an array with several components; point:NAME or cell:NAME where "
              "points and cells both have it; x, y or z for a coordinate; none for one colour",
      .alias = "-c",
      .usual = "the most informative array that varies"}));
  table.push_back(row(color, &ColorSettings::map,
    {.group = group,
      .name = "color-map",
      .value = "NAME",
      .help = "Colour map of the values",
      .alias = "-m",
      .words = colorMapNames(),
      .usual = "viridis; of an array of types the elements' colours, or else types"}));
  table.push_back(row<ColorSettings, std::vector<double>>(color, &ColorSettings::range,
    {.group = group,
      .name = "range",
      .value = "LO HI",
      .help = "Values at the two ends of the colour map",
      .count = 2,
      .usual = "the least and greatest value of the array"},
    [](const std::vector<double>& range)
    {
      if (range.size() == 2 && !(range[0] < range[1]))
        throw WrongValue{"LO must be less than HI"};
    }));
  table.push_back(row(color, &ColorSettings::reversed,
    {.group = group,
      .name = "reverse",
      .help = "The colour map from its last colour to its first; not that of types"}));
  table.push_back(row(color, &ColorSettings::logarithmic,
    {.group = group, .name = "log", .help = "Logarithmic colours"}));
  table.push_back(row<ColorSettings, std::vector<int>>(color, &ColorSettings::types,
    {.group = group,
      .name = "types",
      .value = "TYPE,...",
      .help = "Types that get the first colours of the colour map types, in this order; so that "
              "they have the same colours in pictures of other data",
      .usual = "in ascending order"},
    [](const std::vector<int>& types)
    {
      for (const int type : types)
        if (std::count(types.begin(), types.end(), type) > 1)
          throw WrongValue{"type " + std::to_string(type) + " is given twice"};
    }));
  table.push_back(row(color, &ColorSettings::typeNames,
    {.group = group,
      .name = "type-names",
      .value = "TYPE=NAME,...",
      .help = "Names of types, such as 1=Cu,2=Zr, for legends and lists. Types that all are named "
              "after chemical elements have the elements' colours",
      .usual = "as the data name them"}));
}

} // namespace mote::app
