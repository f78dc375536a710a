// What is marked over the data.

#include "Table.h"

namespace mote::app
{

void addMarkRows(std::vector<Row>& table)
{
  const std::string group = "Marks";
  table.push_back(
    row<MarkSettings, std::vector<std::string>>(&Settings::marks, &MarkSettings::picked,
      {.group = group,
        .name = "picked",
        .value = "ID,LO:HI,...",
        .help =
          "Mark the particles and cells with these ids, as if they were picked in the window: "
          "particles with a veil, cells with their edges, and two or three with a ruler in this "
          "order. Ids are those of --hide-ids",
        .invalidates = Invalidates::Picture,
        .usual = "none"},
      [](const std::vector<std::string>& words) { ValuesOf<IdRanges>::parse(words, {}); }));
  table.push_back(row(&Settings::marks, &MarkSettings::trajectories,
    {.group = group,
      .name = "trajectories",
      .value = "ID,LO:HI,...",
      .help =
        "Show the paths of the particles with these ids through all time steps as lines, with "
        "gaps where they leave a periodic box on one side and come in on the other",
      .invalidates = Invalidates::Picture,
      .usual = "none"}));
}

} // namespace mote::app
