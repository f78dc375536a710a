#include "Table.h"

#include "base/Text.h"

#include <vtkMoteExpression.h>

#include <algorithm>

namespace mote::app
{

namespace
{

void checkStep(const std::string& text)
{
  double number = 0.0;
  if (text != "first" && text != "last" &&
      !(parseNumber(text, number) && number >= 1.0 && number == static_cast<int>(number)))
    throw WrongValue{"'" + text + "' is neither a number from 1 nor first nor last"};
}

void checkCalculations(const std::vector<Calculation>& calculations)
{
  for (const Calculation& one : calculations)
  {
    for (const char* taken : {"x", "y", "z", "none", "radius"})
      if (one.name == taken)
        throw WrongValue{"'" + one.name + "' has a meaning of its own; choose another name"};
    if (std::count_if(calculations.begin(), calculations.end(),
          [&](const Calculation& other) { return other.name == one.name; }) > 1)
      throw WrongValue{"'" + one.name + "' is given twice"};
    if (const std::string problem = vtkMoteExpression::Check(one.expression); !problem.empty())
      throw WrongValue{problem};
  }
}

void checkPartNames(const std::vector<std::string>& names)
{
  if (std::find(names.begin(), names.end(), "") != names.end())
    throw WrongValue{"the name of a part has at least one letter"};
}

} // namespace

void addDataRows(std::vector<Row>& table)
{
  const std::string group = "Data";
  const auto data = &Settings::data;
  table.push_back(row<DataSettings, std::string>(data, &DataSettings::step,
    {.group = group,
      .name = "step",
      .value = "N",
      .help = "Time step: a number from 1, first or last",
      .invalidates = Invalidates::Data},
    checkStep));
  table.push_back(row(data, &DataSettings::time,
    {.group = group,
      .name = "time",
      .value = "T",
      .help = "Time step by its time, in the data's units: the latest one at or before T",
      .invalidates = Invalidates::Data,
      .usual = "--step decides",
      .excludes = {"step"}}));
  table.push_back(row(data, &DataSettings::positions,
    {.group = group,
      .name = "positions",
      .value = "KIND",
      .help =
        "Where particles of a periodic box are drawn: file, as read; wrapped into the box; or "
        "unwrapped by their image numbers, the arrays ix, iy and iz",
      .invalidates = Invalidates::Structure,
      .words = {"file", "wrapped", "unwrapped"}}));
  table.push_back(row(data, &DataSettings::lines,
    {.group = group,
      .name = "lines",
      .value = "KIND",
      .help = "How data of lines alone, such as streamlines and fibres, are drawn: as tubes, whose "
              "radius is that of --radius, or their points as particles",
      .invalidates = Invalidates::Structure,
      .words = {"tubes", "particles"}}));
  table.push_back(row<DataSettings, std::vector<Calculation>>(data, &DataSettings::calculations,
    {.group = group,
      .name = "calculate",
      .value = "NAME=EXPRESSION",
      .help = "Make an array NAME from others, as in speed=sqrt(vx^2 + vy^2), to colour or choose "
              "by: arrays by their names, 'in quotes' where these have other characters than "
              "letters, digits and _, components as v.x or v.0, x, y, z of points, + - * / ^, "
              "< <= > >= == !=, && || !, A ? B : C, sqrt, abs, exp, ln, sin, min, max...; on "
              "cells also gradient(p).x, vorticity(U).z, divergence(U), q_criterion(U). May be "
              "given several times, and take earlier ones",
      .invalidates = Invalidates::Shading,
      .commas = false,
      .usual = "none"},
    checkCalculations));
  table.push_back(row(&Settings::selection, &SelectionSettings::hiddenData,
    {.group = group,
      .name = "hide-data",
      .value = "N,...",
      .help = "Hide whole data sets, by their numbers from 1, in the order of the files and of "
              "the blocks in each: as mote info lists them",
      .limits = {.least = 1},
      .usual = "none"}));
  table.push_back(row<SelectionSettings, std::vector<std::string>>(&Settings::selection,
    &SelectionSettings::hiddenParts,
    {.group = group,
      .name = "hide-part",
      .value = "NAME",
      .help =
        "Hide the parts of this name: blocks and patches as mote info lists them, or files. * "
        "stands for any letters. May be given several times",
      .commas = false,
      .usual = "none"},
    checkPartNames));
  table.push_back(row<SelectionSettings, std::vector<std::string>>(&Settings::selection,
    &SelectionSettings::shownParts,
    {.group = group,
      .name = "show-part",
      .value = "NAME",
      .help = "Show the parts of this name, whatever hides them; * stands for any letters. "
              "Surfaces beside a volume in one file, such as the patches of an OpenFOAM case, are "
              "seen only so. May be given several times",
      .commas = false,
      .usual = "none"},
    checkPartNames));
  table.push_back(row(data, &DataSettings::threads,
    {.group = group,
      .name = "threads",
      .value = "N",
      .help = "Number of threads; 0 stands for all cores",
      .invalidates = Invalidates::Nothing,
      .limits = {.least = 0, .most = 4096},
      .usual = "0"}));
}

} // namespace mote::app
