#include "Table.h"

#include "stage/Silhouettes.h"

namespace mote::app
{

void addSilhouetteRows(std::vector<Row>& table)
{
  const std::string group = "Silhouettes";
  const auto silhouettes = &Settings::silhouettes;
  table.push_back(row<SilhouetteSettings, std::string>(silhouettes, &SilhouetteSettings::lines,
    {.group = group,
      .name = "silhouettes",
      .value = "on|off|RADII|P%",
      .help =
        "Lines where depth jumps by more than RADII radii of a typical particle, or by more than P "
        "percent of the diagonal of the scene. on means 10 radii; auto draws lines where another "
        "option of silhouettes is given. The value follows an equals sign: --silhouettes=4",
      .shape = Shape::OptionalOne,
      .offers = {"auto", "on", "off"},
      .next = [](Settings& s, const Settings& asked)
      { s.silhouettes = toggled(s.silhouettes, asked.silhouettes); },
      .told = [](const Settings& s)
      { return std::string(areOn(s.silhouettes) ? "Silhouettes" : "No silhouettes"); }},
    refusing(checkLines)));
  table.push_back(row<SilhouetteSettings, std::string>(silhouettes, &SilhouetteSettings::thickness,
    {.group = group,
      .name = "silhouette-thickness",
      .value = "W",
      .help =
        "Width of the lines in pixels, from 0.1 to 64; LEAST:MOST has it grow with the depth jump"},
    refusing(checkThickness)));
  table.push_back(row(silhouettes, &SilhouetteSettings::opacity,
    {.group = group,
      .name = "silhouette-opacity",
      .value = "A",
      .help = "Opacity of lines at the smallest depth jumps; it grows to 1 with the jump",
      .limits = {.least = 0.0, .most = 1.0}}));
  table.push_back(row(silhouettes, &SilhouetteSettings::color,
    {.group = group,
      .name = "silhouette-color",
      .value = "COLOUR",
      .help = "Colour of the lines: a name or #rrggbb"}));
  table.push_back(row(silhouettes, &SilhouetteSettings::onPixels,
    {.group = group,
      .name = "silhouette-on-pixels",
      .help = "One-sided, pixel-sharp lines on the farther pixels, instead of smooth lines centred "
              "on the border"}));
  table.push_back(row(silhouettes, &SilhouetteSettings::stepInPixels,
    {.group = group,
      .name = "silhouette-step-pixels",
      .value = "N",
      .help = "Ignore depth jumps smaller than the width of N pixels at that distance",
      .limits = {.least = 0.0}}));
  table.push_back(row(silhouettes, &SilhouetteSettings::groups,
    {.group = group,
      .name = "silhouette-groups",
      .value = "NAME",
      .help = "Lines also between neighbours that differ in this array of integers, such as type; "
              "particle outlines every particle, object every data set",
      .offers = {"particle", "object"},
      .usual = "none"}));
  table.push_back(row(silhouettes, &SilhouetteSettings::noHulls,
    {.group = group, .name = "silhouette-no-hulls", .help = "No lines against the background"}));
}

} // namespace mote::app
