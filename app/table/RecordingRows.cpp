// What is recorded of the window, and played.

#include "Table.h"

namespace mote::app
{

void addRecordingRows(std::vector<Row>& table)
{
  const std::string group = "Recording";
  const auto output = &Settings::output;
  table.push_back(row(output, &OutputSettings::record,
    {.group = group,
      .name = "record",
      .value = "FILE",
      .help = "Write all that is done in the window to this file, a line for each change, so that "
              "--play does it again",
      .invalidates = Invalidates::Nothing,
      .usual = "none",
      .command = "mote"}));
  table.push_back(row(output, &OutputSettings::play,
    {.group = group,
      .name = "play",
      .value = "FILE",
      .help = "Do again what --record wrote, with the data that it names, or with those that are "
              "given. Escape stops",
      .invalidates = Invalidates::Nothing,
      .usual = "none",
      .command = "mote"}));
  table.push_back(row(output, &OutputSettings::playSpeed,
    {.group = group,
      .name = "play-speed",
      .value = "F",
      .help = "Factor on the speed of --play; 0: as fast as it goes",
      .invalidates = Invalidates::Nothing,
      .limits = {.least = 0.0, .most = 1000.0},
      .command = "mote"}));
  table.push_back(row(output, &OutputSettings::play,
    {.group = group,
      .name = "play",
      .value = "FILE",
      .help = "Draw what the window showed at the end of this recording of mote --record, with the "
              "data that it names, or with those that are given",
      .usual = "none",
      .command = "render"}));
}

} // namespace mote::app
