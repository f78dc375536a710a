#include "Table.h"

#include "base/Failure.h"
#include "base/Text.h"
#include "settings/Values.h"
#include "stage/ColorMapFile.h"
#include "stage/ColorMaps.h"

#include <algorithm>
#include <filesystem>

namespace mote::app
{

namespace
{

const std::string colorGroup = "Colour";
constexpr auto color = &Settings::color;

/// Throws WrongValue for what is neither a map's name nor a file of one.
void requireColorMap(const std::string& map)
{
  const std::vector<std::string>& names = colorMapNames();
  if (map.empty() || std::find(names.begin(), names.end(), map) != names.end())
    return;
  std::error_code error;
  if (map.find_first_of("./:") == map.npos && !std::filesystem::exists(map, error))
    throw WrongValue{"'" + map + "' is none of " + joined(names, ", ") + ", and no file"};
  try
  {
    keptColorMapFile(map);
  }
  catch (const Failure& failure)
  {
    throw WrongValue{failure.what()};
  }
}

void addTypeRows(std::vector<Row>& table)
{
  table.push_back(row<ColorSettings, std::vector<int>>(color, &ColorSettings::types,
    {.group = colorGroup,
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
    {.group = colorGroup,
      .name = "type-names",
      .value = "TYPE=NAME,...",
      .help = "Names of types, such as 1=Cu,2=Zr, for legends and lists. Types that all are named "
              "after chemical elements have the elements' colours",
      .usual = "as the data name them"}));
  table.push_back(row(color, &ColorSettings::typeColors,
    {.group = colorGroup,
      .name = "type-colors",
      .value = "TYPE=COLOUR,...",
      .help = "Colours of types, such as 1=tomato,2=#3060c0; other types keep theirs",
      .usual = "the elements', or those of the colour map types"}));
}

} // namespace

void addColorRows(std::vector<Row>& table)
{
  table.push_back(row(color, &ColorSettings::array,
    {.group = colorGroup,
      .name = "color-by",
      .value = "NAME",
      .help = "Array that colours: NAME, or NAME:COMPONENT (a number from 0, or its name) or "
              "NAME:magnitude of an array with several components; point:NAME or cell:NAME where "
              "points and cells both have it; x, y or z for a coordinate; none for one colour",
      .alias = "-c",
      .usual = "the most informative array that varies"}));
  table.push_back(row<ColorSettings, std::string>(color, &ColorSettings::map,
    {.group = colorGroup,
      .name = "color-map",
      .value = "NAME",
      .help = "Colour map of the values: " + joined(colorMapNames(), ", ") +
              ". Or a file: JSON as ParaView exports maps, of which FILE:MAP names one, or a text "
              "with a colour in each line: red, green and blue from 0 to 1 or from 0 to 255, or "
              "#rrggbb",
      .alias = "-m",
      .offers = colorMapNames(),
      .namesFile = true,
      .usual = "viridis; of an array of types the elements' colours, or else types"},
    requireColorMap));
  table.push_back(row<ColorSettings, std::vector<double>>(color, &ColorSettings::range,
    {.group = colorGroup,
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
  table.push_back(row<ColorSettings, std::vector<double>>(color, &ColorSettings::percentiles,
    {.group = colorGroup,
      .name = "percentiles",
      .value = "LO HI",
      .help = "The colour map goes from one percentile of the values to another, as in 1 99, which "
              "leaves outliers out of the range: they have the colours of its ends, and the legend "
              "shows that there are some. Hidden values count, too. Types have none",
      .count = 2,
      .limits = {0.0, 100.0},
      .usual = "0 100: from the least to the greatest value",
      .excludes = {"range"}},
    [](const std::vector<double>& shares)
    {
      if (shares.size() == 2 && !(shares[0] < shares[1]))
        throw WrongValue{"LO must be less than HI"};
    }));
  table.push_back(row<ColorSettings, std::string>(color, &ColorSettings::plain,
    {.group = colorGroup,
      .name = "plain-color",
      .value = "COLOUR",
      .help = "Colour of particles and surfaces that no array colours"},
    [](const std::string& name) { colorOf(name); }));
  table.push_back(row(color, &ColorSettings::reversed,
    {.group = colorGroup,
      .name = "reverse",
      .help = "The colour map from its last colour to its first; not that of types"}));
  table.push_back(row(color, &ColorSettings::logarithmic,
    {.group = colorGroup,
      .name = "log",
      .help = "Logarithmic colours. Of an array with values at or below 0 they begin at the least "
              "one above it, or at a millionth of the greatest if that is more"}));
  addTypeRows(table);
}

} // namespace mote::app
