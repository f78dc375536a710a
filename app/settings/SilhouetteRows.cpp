#include "Table.h"

#include "Text.h"

namespace mote::app
{

void addSilhouetteRows(std::vector<Row>& table)
{
  const std::string group = "Silhouettes";
  const auto silhouettes = &Settings::silhouettes;
  table.push_back(row<SilhouetteSettings, std::string>(silhouettes, &SilhouetteSettings::lines,
    {.group = group,
      .name = "silhouettes",
      .value = "on|off|RADII",
      .help = "Lines where depth jumps, by more than so many radii of a typical particle; on means "
              "10 radii. auto draws them where another of these options is given",
      .shape = Shape::OptionalOne},
    [](const std::string& text)
    {
      double radii = 0.0;
      if (text != "on" && text != "off" && text != "auto" &&
          !(parseNumber(text, radii) && radii >= 0.0))
        throw WrongValue{"'" + text + "' is neither on nor off nor a number of radii of at least "
                                      "0, such as in --silhouettes=4"};
    }));
  table.push_back(row(silhouettes, &SilhouetteSettings::thickness,
    {.group = group,
      .name = "silhouette-thickness",
      .value = "PIXELS",
      .help = "Width of the lines in pixels",
      .limits = {.least = 0.1, .most = 64.0}}));
  table.push_back(row(silhouettes, &SilhouetteSettings::color,
    {.group = group,
      .name = "silhouette-color",
      .value = "COLOUR",
      .help = "Colour of the lines: a name or #rrggbb"}));
  table.push_back(row(silhouettes, &SilhouetteSettings::groups,
    {.group = group,
      .name = "silhouette-groups",
      .value = "NAME",
      .help = "Lines also between neighbours with different values of this array, such as type; or "
              "between each particle and the next, or each object (file)",
      .usual = "none"}));
}

} // namespace mote::app
