#include "Table.h"

#include "base/Text.h"

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
