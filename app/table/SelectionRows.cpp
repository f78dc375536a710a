#include "Table.h"

#include <vtkMoteExpression.h>

#include <algorithm>

namespace mote::app
{

namespace
{

void checkRanges(const std::vector<ShowRange>& ranges)
{
  for (const ShowRange& range : ranges)
    if (std::count_if(ranges.begin(), ranges.end(),
          [&](const ShowRange& other) { return other.name == range.name; }) > 1)
      throw WrongValue{"'" + range.name + "' is given twice; join its ranges, as in type=1,3:5"};
  if (ranges.size() > 8)
    throw WrongValue{"at most eight ranges are possible, not " + std::to_string(ranges.size())};
}

const std::string selectionGroup = "Selection";
constexpr auto selection = &Settings::selection;

void addIdRows(std::vector<Row>& table)
{
  const std::string ids = ": 7, or 7:12 for all from 7 to 12; 2/7:12 of the second data set alone. "
                          "Ids are those of the array id (or ids, ParticleIds, GlobalIds, ...) "
                          "where there is one, else particles count from 0, as cells do";
  table.push_back(row(selection, &SelectionSettings::hidden,
    {.group = selectionGroup,
      .name = "hide-ids",
      .value = "ID,LO:HI,...",
      .help = "Hide particles and cells by their ids" + ids,
      .usual = "none"}));
  table.push_back(row(selection, &SelectionSettings::only,
    {.group = selectionGroup,
      .name = "only-ids",
      .value = "ID,LO:HI,...",
      .help = "Show only the particles or cells with these ids" + ids,
      .usual = "all"}));
}

} // namespace

void addSelectionRows(std::vector<Row>& table)
{
  table.push_back(
    row<SelectionSettings, std::vector<ShowRange>>(selection, &SelectionSettings::ranges,
      {.group = selectionGroup,
        .name = "show",
        .value = "NAME=LO:HI,...",
        .help =
          "Show only what has a value from LO to HI: particles and cells by x, y, z, radius (of "
          "particles, as drawn) or an array, named as in --color-by. LO or HI may be left "
          "out; type=2 is one value, and type=1,3:5 several. May be given up to eight times, "
          "of particles four of them for arrays: what lies in all ranges is shown. Cells "
          "have the mean over their points; the array that colours a volume cuts through "
          "cells",
        .commas = false,
        .usual = "all"},
      checkRanges));
  table.push_back(row<SelectionSettings, std::string>(selection, &SelectionSettings::where,
    {.group = selectionGroup,
      .name = "where",
      .value = "EXPRESSION",
      .help = "Show only particles and cells for which EXPRESSION holds, as in \"c_pe > -3 && "
              "type == 2\"; names and operators are those of --calculate. In a cell what is of "
              "points counts as the mean over its points",
      .usual = "all"},
    [](const std::string& expression)
    {
      const std::string problem = expression.empty() ? "" : vtkMoteExpression::Check(expression);
      if (!problem.empty())
        throw WrongValue{problem};
    }));
  addIdRows(table);
  table.push_back(row<SelectionSettings, std::vector<double>>(selection, &SelectionSettings::range,
    {.group = selectionGroup,
      .name = "show-range",
      .value = "LO HI",
      .help = "Hide particles and cells with values outside LO to HI of the array of --show-by",
      .count = 2,
      .usual = "all"},
    [](const std::vector<double>& range)
    {
      if (range.size() == 2 && range[0] > range[1])
        throw WrongValue{"LO must not be greater than HI"};
    }));
  table.push_back(row(selection, &SelectionSettings::array,
    {.group = selectionGroup,
      .name = "show-by",
      .value = "NAME",
      .help = "Array of --show-range, named as in --color-by",
      .usual = "the one that colours",
      .needs = "show-range"}));
}

} // namespace mote::app
