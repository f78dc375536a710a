#include "Table.h"

#include "base/Text.h"
#include "stage/Lighting.h"

namespace mote::app
{

namespace
{

/// A check of words that says what is wrong with them as one of WrongValue.
std::function<void(const std::string&)> sentence(std::string (*check)(const std::string&))
{
  return [check](const std::string& text)
  {
    if (const std::string wrong = check(text); !wrong.empty())
      throw WrongValue{wrong};
  };
}

} // namespace

void addLightRows(std::vector<Row>& table)
{
  const std::string group = "Light";
  const auto light = &Settings::light;
  table.push_back(row<LightSettings, std::string>(light, &LightSettings::shadows,
    {.group = group,
      .name = "shadows",
      .value = "KIND",
      .help = "Shadows of the main light: none, hard or soft; or the number of light samples a "
              "side, such as 4 for 4 x 4 light samples per camera ray"},
    sentence(checkShadows)));
  table.push_back(row<LightSettings, std::string>(light, &LightSettings::place,
    {.group = group,
      .name = "light",
      .value = "PLACE",
      .help = "Where the main light is. As the viewer sees it: " + joined(lightNames(), ", ") +
              ", or AZIMUTH,ELEVATION in degrees to the right and up. Or X,Y,Z: in that direction "
              "from the data, however they are looked at. auto is left-top, nearer to the eye "
              "without shadows",
      .commas = false},
    sentence(checkLight)));
  table.push_back(row(light, &LightSettings::size,
    {.group = group,
      .name = "light-size",
      .value = "DEG",
      .help =
        "Size of the main light as seen from the data, in degrees: the larger, the softer its "
        "shadows. The sun has 0.5",
      .limits = {.least = 0.0, .most = 90.0}}));
  table.push_back(row<LightSettings, std::string>(light, &LightSettings::ambientOcclusion,
    {.group = group,
      .name = "ambient-occlusion",
      .value = "none|live|baked|N",
      .help = "Light of an even sky, of which crevices see less: none; live, found by 4 rays per "
              "camera ray, or by N; or baked, looked up in precomputed maps of the particles, from "
              "FILE.moteao where mote bake wrote one, and else made of what is seen",
      .alias = "--ao"},
    sentence(checkAmbientOcclusion)));
  table.push_back(row(light, &LightSettings::occlusionReach,
    {.group = group,
      .name = "occlusion-reach",
      .value = "R",
      .help = "Length of the ambient-occlusion rays in the data's units: what is farther away "
              "darkens nothing",
      .limits = {.aboveZero = true},
      .usual = "a tenth of the data's longest side",
      .needs = "ambient-occlusion"}));
  table.push_back(row(light, &LightSettings::pathTrace,
    {.group = group,
      .name = "path-trace",
      .help = "Light that other particles reflect, too, under a sky that is bright above (+z) and "
              "dim below; the main light's shadows are as soft as --light-size says",
      .excludes = "ambient-occlusion"}));
}

} // namespace mote::app
