#include "ViewOptions.h"

#include "Checks.h"
#include "ColorMaps.h"
#include "Colors.h"
#include "Framing.h"
#include "Lighting.h"
#include "Selection.h"
#include "Text.h"

#include <vtkMoteParticleMapper.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

std::array<int, 2> parseSize(const std::string& text)
{
  const std::size_t sign = text.find_first_of("xX");
  double width = 0.0, height = 0.0;
  if (sign == std::string::npos || !parseNumber(text.substr(0, sign), width) ||
      !parseNumber(text.substr(sign + 1), height) || width != std::floor(width) ||
      height != std::floor(height))
    throw CLI::ValidationError("--size", "'" + text + "' is no size like 1920x1080");
  if (std::min(width, height) < 1.0 || std::max(width, height) > 65536.0)
    throw CLI::ValidationError(
      "--size", "width and height may go from 1 to 65536 pixels, unlike " + text);
  return {static_cast<int>(width), static_cast<int>(height)};
}

std::string checkStep(const std::string& text)
{
  double number = 0.0;
  if (text == "first" || text == "last" ||
      (parseNumber(text, number) && number >= 1.0 && number == static_cast<int>(number)))
    return {};
  return "'" + text + "' is neither a number from 1 nor first nor last";
}

std::map<int, double> parseTypeRadii(const std::vector<std::string>& entries)
{
  std::map<int, double> radii;
  for (const std::string& entry : entries)
  {
    const std::size_t sign = entry.find('=');
    double type = 0.0, radius = 0.0;
    if (sign == std::string::npos || !parseNumber(entry.substr(0, sign), type) ||
        !parseNumber(entry.substr(sign + 1), radius) || type != static_cast<int>(type) ||
        radius <= 0.0)
      throw CLI::ValidationError(
        "--type-radius", "'" + entry + "' is not of the form TYPE=RADIUS, such as 1=0.5");
    radii[static_cast<int>(type)] = radius;
  }
  return radii;
}

std::vector<Color> parseBackground(const std::vector<std::string>& names)
{
  std::vector<Color> colors;
  if (names.size() > 2)
    throw CLI::ValidationError("--background", "one or two colours are possible");
  for (const std::string& name : names)
  {
    Color color;
    if (!parseColor(name, color))
      throw CLI::ValidationError(
        "--background", "'" + name + "' is no colour: give a name (white, navy) or #rrggbb");
    colors.push_back(color);
  }
  return colors;
}

std::string checkOrder(const std::vector<double>& range)
{
  return range.size() == 2 && !(range[0] < range[1]) ? "LO must be less than HI" : "";
}

std::vector<ShowRange> parseShow(const std::vector<std::string>& entries)
{
  std::vector<ShowRange> ranges;
  for (const std::string& entry : entries)
  {
    try
    {
      ranges.push_back(parseShowRange(entry));
    }
    catch (const std::string& sentence)
    {
      throw CLI::ValidationError("--show", sentence);
    }
    const std::string& name = ranges.back().name;
    if (std::count_if(ranges.begin(), ranges.end(), [&](const auto& r) { return r.name == name; }) >
        1)
      throw CLI::ValidationError("--show", "'" + name + "' has two ranges, and one is possible");
  }
  if (ranges.size() > 8)
    throw CLI::ValidationError(
      "--show", "at most eight ranges are possible, not " + std::to_string(ranges.size()));
  return ranges;
}

/// For every option that takes a number: it must be finite, and perhaps above zero.
CLI::Validator number(bool aboveZero)
{
  return {[aboveZero](std::string& text) -> std::string
    {
      double value = 0.0;
      if (!parseNumber(text, value))
        return "'" + text + "' is no finite number";
      return aboveZero && value <= 0.0 ? "must be above zero, not " + text : "";
    },
    "", "number"};
}

void addSelectionOptions(CLI::App& app, ViewOptions& o)
{
  const std::string group = "Selection";
  app
    .add_option_function<std::vector<std::string>>(
      "--show", [&o](const std::vector<std::string>& entries) { o.show = parseShow(entries); },
      "Show only particles with a value from LO to HI of x, y, z, radius (as drawn) or an array, "
      "named as in --color-by; LO or HI may be left out, and type=2 is one value. Up to eight "
      "times, of which four for arrays: what lies in all ranges is shown")
    ->expected(1)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
    ->type_name("NAME=LO:HI")
    ->group(group);
  auto* shown =
    app
      .add_option_function<std::vector<double>>(
        "--show-range",
        [&o](const std::vector<double>& range)
        {
          if (range.size() == 2 && range[0] > range[1])
            throw CLI::ValidationError("--show-range", "LO must not be greater than HI");
          o.showRange = range;
        },
        "Hide particles with values outside LO to HI")
      ->check(number(false))
      ->expected(2)
      ->type_name("LO HI")
      ->group(group);
  app
    .add_option("--show-by", o.showBy,
      "Array that --show-range speaks of, named as in --color-by. By default the one that colours")
    ->needs(shown)
    ->type_name("NAME")
    ->group(group);
}

/// An option whose words are checked by a function that says what is wrong with them.
CLI::Validator words(std::string (*check)(const std::string&))
{
  return {[check](std::string& text) { return check(text); }, "", "words"};
}

void addLightOptions(CLI::App& app, ViewOptions& o)
{
  const std::string group = "Light";
  app
    .add_option("--shadows", o.shadows,
      "Shadows of the main light: none, hard, soft; or the number of light samples a side, such as "
      "4 for 4 x 4 for every ray of a pixel")
    ->check(words(checkShadows))
    ->type_name("KIND")
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--light", o.light,
      "Where the main light is. As the viewer sees it: " + joined(lightNames(), ", ") +
        ", or AZIMUTH,ELEVATION in degrees to the right and up. Or X,Y,Z: in that direction from "
        "the data, however they are looked at. By default left-top, nearer to the eye without "
        "shadows")
    ->check(words(checkLight))
    ->type_name("PLACE")
    ->group(group);
  app
    .add_option("--light-size", o.lightSize,
      "Size of the main light as the data see it, in degrees up to 90: the larger, the softer its "
      "shadows. The sun has 0.5")
    ->check(number(false))
    ->check(isNumber())
    ->check(CLI::Range(0.0, 90.0).description(""))
    ->type_name("DEG")
    ->capture_default_str()
    ->group(group);
  auto* occlusion =
    app
      .add_option("--ambient-occlusion,--ao", o.ambientOcclusion,
        "Light of an even sky, which crevices see less of: none; live, found by rays, or by so "
        "many rays for every ray of a pixel (live means 4); or baked, looked up in maps of the "
        "particles, from FILE.moteao where mote bake wrote one, and else made of what is seen")
      ->check(words(checkAmbientOcclusion))
      ->type_name("none|live|baked|N")
      ->capture_default_str()
      ->group(group);
  app
    .add_option("--occlusion-reach", o.occlusionReach,
      "How far those rays go, in the data's units: what is farther away darkens nothing. By "
      "default a tenth of the data's longest side")
    ->check(number(true))
    ->needs(occlusion)
    ->type_name("R")
    ->group(group);
  app
    .add_flag("--path-trace", o.pathTrace,
      "Light by way of other particles, under a sky that is bright above (+z) and dim below, with "
      "the shadows of the main light as soft as --light-size says")
    ->excludes(occlusion)
    ->group(group);
}

void addCameraOptions(CLI::App& app, ViewOptions& o)
{
  const std::string group = "Camera";
  app
    .add_option("--view", o.view,
      "Side to look from: " + joined(viewNames(), ", ") +
        ". iso has z up, iso-y y. 'auto' looks along the thin axis of flat data, as iso-y at "
        "surface "
        "meshes and as iso at all else")
    ->check(CLI::IsMember(viewNames()).description(""))
    ->type_name("SIDE")
    ->capture_default_str()
    ->group(group);
  app.add_option("--azimuth", o.azimuth, "Then walk around to the right by so many degrees")
    ->check(number(false))
    ->type_name("DEG")
    ->group(group);
  app.add_option("--elevation", o.elevation, "Then climb by so many degrees")
    ->check(number(false))
    ->type_name("DEG")
    ->group(group);
  app.add_option("--zoom", o.zoom, "Factor on the size of what is seen")
    ->check(number(true))
    ->type_name("F")
    ->group(group);
  app.add_flag("--orthographic", o.orthographic, "Parallel projection instead of perspective")
    ->group(group);
}

void addPictureOptions(CLI::App& app, ViewOptions& o)
{
  const std::string group = "Picture";
  app
    .add_option_function<std::string>(
      "--size,-s", [&o](const std::string& text) { o.size = parseSize(text); },
      "Width and height in pixels")
    ->type_name("WxH")
    ->group(group);
  app
    .add_option("--samples", o.samples,
      "Rays a pixel; more make smoother edges. By default 16, with --path-trace 64, and at "
      "most 4096 with --noise")
    ->check(CLI::Range(1, 65536).description(""))
    ->type_name("N")
    ->group(group);
  app
    .add_option("--noise", o.noise,
      "Cast rays until the picture's standard error is down to this, where colours go from 0 to "
      "1: 0.01 looks smooth. --samples is then the most")
    ->check(number(true))
    ->check(isNumber())
    ->check(CLI::Range(0.0, 1.0).description(""))
    ->type_name("LEVEL")
    ->group(group);
  app
    .add_option_function<std::vector<std::string>>(
      "--background,-b",
      [&o](const std::vector<std::string>& names) { o.background = parseBackground(names); },
      "Colour behind: a name or #rrggbb, or two with a comma for bottom and top")
    ->delimiter(',')
    ->type_name("COLOUR[,TOP]")
    ->group(group);
  app
    .add_flag_function(
      "--no-legend", [&o](std::int64_t) { o.legend = false; }, "No colour legend")
    ->group(group);
  app.add_option("--title", o.title, "Title of the colour legend. By default the array's name")
    ->type_name("TEXT")
    ->group(group);
}

} // namespace

void addColorOptions(CLI::App& app, ViewOptions& o)
{
  const std::string group = "Colour";
  app
    .add_option("--color-by,-c", o.colorBy,
      "Array that colours: NAME, or NAME:COMPONENT (a number from 0, or its name) or "
      "NAME:magnitude for one with several components; 'none' for one colour. By default an array "
      "that varies: a number, else a vector's magnitude, else the type")
    ->type_name("NAME")
    ->group(group);
  app
    .add_option("--color-map,-m", o.colorMap,
      "Colours: " + joined(colorMapNames(), ", ") +
        ". By default viridis, and types for an array of types")
    ->check(CLI::IsMember(colorMapNames()).description(""))
    ->type_name("NAME")
    ->group(group);
  app
    .add_option_function<std::vector<double>>(
      "--range",
      [&o](const std::vector<double>& range)
      {
        if (const std::string error = checkOrder(range); !error.empty())
          throw CLI::ValidationError("--range", error);
        o.range = range;
      },
      "Values at the two ends of the colours. By default the array's least and greatest")
    ->check(number(false))
    ->expected(2)
    ->type_name("LO HI")
    ->group(group);
  app.add_flag("--log", o.logarithmic, "Logarithmic colours")->group(group);
}

void addReadOptions(CLI::App& app, ViewOptions& o)
{
  app
    .add_option("FILE", o.files,
      "Files to read. LAMMPS dumps, VTK and .mote files that differ only in the digits of a number "
      "are steps of one series")
    ->type_name("");
  const std::string group = "Data";
  auto* step =
    app.add_option("--step", o.step, "Time step: a number from 1, first or last")
      ->check(CLI::Validator([](std::string& text) { return checkStep(text); }, "", "step"))
      ->type_name("N")
      ->capture_default_str()
      ->group(group);
  app.add_option("--time", o.time, "Time step by its time: the nearest at or before T")
    ->check(number(false))
    ->type_name("T")
    ->excludes(step)
    ->group(group);
  app.add_option("--threads", o.threads, "Threads to work with. By default all")
    ->check(CLI::Range(0, 4096).description(""))
    ->type_name("N")
    ->group(group);
}

CLI::Option* addVectorOption(CLI::App& app, const std::string& name,
  std::optional<std::array<double, 3>>& value, const std::string& help)
{
  return app
    .add_option_function<std::vector<double>>(
      name,
      [&value](const std::vector<double>& v) {
        value = {v[0], v[1], v[2]};
      },
      help)
    ->delimiter(',')
    ->check(number(false))
    ->expected(3)
    ->type_name("X,Y,Z");
}

void addRadiusOptions(CLI::App& app, ViewOptions& o)
{
  const std::string group = "Radius";
  app
    .add_option("--radius,-r", o.radius,
      "Radius of the particles: a number, the name of an array of radii, 'spacing' (half the "
      "typical distance between neighbours) or 'auto' (an array named radius, half of one named "
      "diameter, else as spacing)")
    ->type_name("R|NAME")
    ->capture_default_str()
    ->group(group);
  app
    .add_option_function<std::vector<std::string>>(
      "--type-radius",
      [&o](const std::vector<std::string>& entries) { o.typeRadius = parseTypeRadii(entries); },
      "Radii by the array 'type': 1=0.5,2=0.7. Other types get the number of --radius")
    ->delimiter(',')
    ->type_name("TYPE=R,...")
    ->group(group);
  app
    .add_option("--radius-scale", o.radiusScale,
      "Factor on every radius; 0.5 where the array holds diameters")
    ->check(number(true))
    ->type_name("F")
    ->group(group);
}

void addFormOption(CLI::App& app, ViewOptions& o)
{
  const std::vector<std::string> names = vtkMoteParticleMapper::GetStructureForms();
  app
    .add_option("--form", o.form,
      "What the pkd-tree keeps centres of particles in: " + joined(names, ", ") +
        ". Refused where it would move particles by more than a twentieth of the smallest radius. "
        "By default as a .mote file has it, else exact")
    ->check(CLI::IsMember(names).description(""))
    ->type_name("NAME")
    ->group("Structure");
}

namespace
{

void addStructureOptions(CLI::App& app, ViewOptions& o)
{
  const std::vector<std::string> names = vtkMoteParticleMapper::GetStructureNames();
  app
    .add_option("--structure", o.structure,
      "What rays are cast through: " + joined(names, ", ") +
        ". By default the coherent grid up to 100 million particles, the P-k-d tree above, and for "
        ".mote files")
    ->check(CLI::IsMember(names).description(""))
    ->type_name("NAME")
    ->group("Structure");
  addFormOption(app, o);
}

} // namespace

void addViewOptions(CLI::App& app, ViewOptions& o)
{
  addReadOptions(app, o);
  addColorOptions(app, o);
  addSelectionOptions(app, o);
  addRadiusOptions(app, o);
  addStructureOptions(app, o);
  addVolumeOptions(app, o.volume);
  addCameraOptions(app, o);
  addLightOptions(app, o);
  addSilhouetteOptions(app, o.silhouettes);
  addPictureOptions(app, o);
}

} // namespace mote::app
