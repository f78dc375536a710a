// What `mote animate` may be told, and who makes films in the window.

#include "Table.h"

#include "base/Text.h"

#include <sstream>

namespace mote::app
{

namespace
{

/// Why the text names no time steps.
std::string checkSteps(const std::string& text)
{
  return text.empty() || text == "all" || stepRange(text)
           ? ""
           : "'" + text + "' is neither all nor a range of steps such as 2:9 or 1:100:10";
}

} // namespace

void addFilmRows(std::vector<Row>& table)
{
  const std::string group = "Film", command = "animate";
  const auto film = &Settings::film;
  table.push_back(outputRow(command,
    "Film to write: .ogv, which needs nothing else; .mp4, .mkv, .webm, .mov, .avi or .gif by the "
    "program ffmpeg; or a picture for each frame, with its number's place in the name: "
    "frames-%04d.png",
    true));
  table.push_back(row(film, &FilmSettings::orbit,
    {.group = group,
      .name = "orbit",
      .value = "DEG",
      .help = "Turn the camera to the right around the data by so many degrees, evenly over the "
              "film; 360 comes round to where it began"}));
  table.push_back(row<FilmSettings, std::string>(film, &FilmSettings::steps,
    {.group = group,
      .name = "steps",
      .value = "A:B[:STRIDE]",
      .help = "Time steps to show: all, or from the A-th, counted from 1, to the B-th, every "
              "STRIDE-th of them",
      .usual = "all, where nothing else moves; else the one that is chosen"},
    refusing(checkSteps)));
  table.push_back(row(film, &FilmSettings::framesPerStep,
    {.group = group,
      .name = "frames-per-step",
      .value = "N",
      .help = "Frames that show the same time step",
      .limits = {.least = 1, .most = 10000},
      .usual = "1; in a video so many that it takes 2 s, and as long as the camera's way"}));
  table.push_back(row(film, &FilmSettings::keyFrames,
    {.group = group,
      .name = "key-frames",
      .value = "FILES",
      .help = "Go on to the views of these sessions of the same data, one after the other: the "
              "camera, and settings that are numbers, go smoothly from one to the next",
      .usual = "none"}));
  table.push_back(row(film, &FilmSettings::frames,
    {.group = group,
      .name = "frames",
      .value = "N",
      .help = "Frames of the film, over which orbit, time steps and key frames are spread",
      .limits = {.least = 1, .most = 1000000},
      .usual = "those of --frames-per-step; 2 s a key frame; 10 s a full turn"}));
  table.push_back(row(film, &FilmSettings::rate,
    {.group = group,
      .name = "rate",
      .value = "N",
      .help = "Frames a second of the film",
      .limits = {.least = 1, .most = 240}}));
  table.push_back(row(film, &FilmSettings::quality,
    {.group = group,
      .name = "quality",
      .value = "WORD",
      .help = "Of films: better ones are larger",
      .words = {"low", "medium", "high"}}));
  for (Row& row : table)
    if (row.group == group)
      row.command = command;
}

std::optional<StepRange> stepRange(const std::string& text)
{
  StepRange range;
  int* const parts[] = {&range.first, &range.last, &range.stride};
  std::istringstream words(text);
  std::size_t count = 0;
  for (std::string word; std::getline(words, word, ':'); ++count)
  {
    double number = 0.0;
    if (count == 3 || (word.empty() && count == 2))
      return {};
    if (word.empty())
      continue; // from the first, or to the last
    if (!parseNumber(word, number) || number < 1.0 || number > 1e9 ||
        number != static_cast<int>(number))
      return {};
    *parts[count] = static_cast<int>(number);
  }
  if (count == 1 && text.find(':') == text.npos)
    range.last = range.first;
  if (text.find_first_not_of(':') == text.npos || (range.last > 0 && range.last < range.first))
    return {};
  return range;
}

} // namespace mote::app
