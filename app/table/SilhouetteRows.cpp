#include "Table.h"

#include "stage/Silhouettes.h"

namespace mote::app
{

namespace
{

std::function<void(const std::string&)> sentence(std::string (*check)(const std::string&))
{
  return [check](const std::string& text)
  {
    if (const std::string wrong = check(text); !wrong.empty())
      throw WrongValue{wrong};
  };
}

} // namespace

void addSilhouetteRows(std::vector<Row>& table)
{
  const std::string group = "Silhouettes";
  const auto silhouettes = &Settings::silhouettes;
  table.push_back(row<SilhouetteSettings, std::string>(silhouettes, &SilhouetteSettings::lines,
    {.group = group,
      .name = "silhouettes",
      .value = "on|off|RADII|%",
      .help = "Lines where depth jumps, by more than so many radii of a typical particle, or with "
              "% by more than a share of the scene's size; on means 10 radii. auto draws them "
              "where another of these options is given",
      .shape = Shape::OptionalOne},
    sentence(checkLines)));
  table.push_back(row<SilhouetteSettings, std::string>(silhouettes, &SilhouetteSettings::thickness,
    {.group = group,
      .name = "silhouette-thickness",
      .value = "W",
      .help = "Width of the lines in pixels, from 0.1 to 64; or LEAST:MOST, to have it grow with "
              "the step"},
    sentence(checkThickness)));
  table.push_back(row(silhouettes, &SilhouetteSettings::opacity,
    {.group = group,
      .name = "silhouette-opacity",
      .value = "A",
      .help = "Opacity of the least steps; it grows with the step",
      .limits = {.least = 0.0, .most = 1.0}}));
  table.push_back(row(silhouettes, &SilhouetteSettings::color,
    {.group = group,
      .name = "silhouette-color",
      .value = "COLOUR",
      .help = "Colour of the lines: a name or #rrggbb"}));
  table.push_back(row(silhouettes, &SilhouetteSettings::onPixels,
    {.group = group,
      .name = "silhouette-on-pixels",
      .help = "Draw on the farther pixels alone, crisply, and not about the border itself"}));
  table.push_back(row(silhouettes, &SilhouetteSettings::stepInPixels,
    {.group = group,
      .name = "silhouette-step-pixels",
      .value = "N",
      .help = "Draw no step that is less than the width of so many pixels at its distance",
      .limits = {.least = 0.0}}));
  table.push_back(row(silhouettes, &SilhouetteSettings::groups,
    {.group = group,
      .name = "silhouette-groups",
      .value = "NAME",
      .help = "Lines also between neighbours with different values of this array, such as type; or "
              "between each particle and the next, or each object (file)",
      .usual = "none"}));
  table.push_back(row(silhouettes, &SilhouetteSettings::noHulls,
    {.group = group, .name = "silhouette-no-hulls", .help = "No lines against the background"}));
}

} // namespace mote::app
