#include "Table.h"

#include "base/Text.h"
#include "stage/Lighting.h"

namespace mote::app
{

namespace
{

const std::string lightGroup = "Light";
constexpr auto light = &Settings::light;

void addMainLightRows(std::vector<Row>& table)
{
  table.push_back(row<LightSettings, std::string>(light, &LightSettings::shadows,
    {.group = lightGroup,
      .name = "shadows",
      .value = "KIND",
      .help =
        "Shadows of the main light: none; hard, one light sample per camera ray; soft, about 64 "
        "light samples per pixel; or N from 1 to 64 for N x N light samples per camera ray",
      .offers = {"none", "hard", "soft"},
      .next = [](Settings& s, const Settings& asked)
      { s.light = withNextShadows(s.light, asked.light); },
      .told = [](const Settings& s) { return shadowsName(s.light); }},
    refusing(checkShadows)));
  table.push_back(row<LightSettings, std::string>(light, &LightSettings::place,
    {.group = lightGroup,
      .name = "light",
      .value = "PLACE",
      .help = "Direction of the main light. Seen from the viewer: " + joined(lightNames(), ", ") +
              ", or AZIMUTH,ELEVATION in degrees to the right and up. Or X,Y,Z, from the data "
              "towards the light, whichever way they are looked at. auto is left-top, nearer to "
              "the eye without shadows",
      .commas = false,
      .offers = lightNames()},
    refusing(checkLight)));
  table.push_back(row(light, &LightSettings::size,
    {.group = lightGroup,
      .name = "light-size",
      .value = "DEG",
      .help =
        "Size of the main light as seen from the data, in degrees: the larger, the softer its "
        "shadows. The sun has 0.5",
      .limits = {.least = 0.0, .most = 90.0}}));
  table.push_back(row(light, &LightSettings::intensity,
    {.group = lightGroup,
      .name = "light-intensity",
      .value = "F",
      .help = "Factor on the brightness of the main light",
      .limits = {.least = 0.0, .most = 10.0}}));
  table.push_back(row(light, &LightSettings::headlight,
    {.group = lightGroup,
      .name = "headlight",
      .value = "F",
      .help = "Factor on the brightness of the light that comes from the viewer and fills what the "
              "main light leaves dark; paths of light have none",
      .limits = {.least = 0.0, .most = 10.0}}));
}

void addSkyRows(std::vector<Row>& table)
{
  table.push_back(row<LightSettings, std::string>(light, &LightSettings::ambientOcclusion,
    {.group = lightGroup,
      .name = "ambient-occlusion",
      .value = "none|live|baked|N",
      .help =
        "Darkens crevices, as under an even sky: none; live, by 4 rays per camera ray; N rays, "
        "from 0 to 4096; or baked, looked up in precomputed maps of particles, which are read from "
        "FILE.moteao where mote bake wrote one, and else computed for what is seen",
      .alias = "--ao",
      .offers = {"none", "live", "baked"},
      .next = [](Settings& s, const Settings&) { s.light = withNextShading(s.light); },
      .told = [](const Settings& s) { return shadingName(s.light); }},
    refusing(checkAmbientOcclusion)));
  table.push_back(row(light, &LightSettings::occlusionReach,
    {.group = lightGroup,
      .name = "occlusion-reach",
      .value = "R",
      .help = "Length of the ambient-occlusion rays in the data's units: what is farther away "
              "darkens nothing",
      .limits = {.aboveZero = true},
      .usual = "a tenth of the data's longest side",
      .needs = "ambient-occlusion"}));
  table.push_back(row(light, &LightSettings::pathTrace,
    {.group = lightGroup,
      .name = "path-trace",
      .help = "Light that other particles reflect, too, under a sky that is bright above (+z) and "
              "dim below; the main light's shadows are as soft as --light-size says",
      .excludes = {"ambient-occlusion"}}));
}

} // namespace

void addLightRows(std::vector<Row>& table)
{
  addMainLightRows(table);
  addSkyRows(table);
}

} // namespace mote::app
