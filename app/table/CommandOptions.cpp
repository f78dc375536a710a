#include "CommandOptions.h"

#include <CLI/CLI.hpp>

namespace mote::app
{

void addWindowOptions(CLI::App& app, GivenSettings& given)
{
  addAllSettings(app, given);
  addCommandSettings(app, given, "mote");
}

void addRenderOptions(CLI::App& app, GivenSettings& given)
{
  addAllSettings(app, given);
  addCommandSettings(app, given, "render");
}

void addAnimateOptions(CLI::App& app, GivenSettings& given)
{
  addAllSettings(app, given);
  addCommandSettings(app, given, "animate");
  app.get_option("--size")->description("Width and height in pixels. Default: 1280x720");
}

void addConvertOptions(CLI::App& app, GivenSettings& given)
{
  addFiles(app, given.settings);
  addSettings(app, given, {"Data"});
  app.get_option("FILE")->description("Files to read, as elsewhere, and last the file to write: "
                                      ".mote, .vtp, .vtu, .vtm, .pvtp, .pvtu, .xyz or .xyz.gz");
  addSettings(
    app, given, {"Radius", "form", "show", "where", "hide-ids", "only-ids", "cut", "cut-axis"});
  addCommandSettings(app, given, "convert");
}

void addInfoOptions(CLI::App& app, GivenSettings& given)
{
  addFiles(app, given.settings);
  addSettings(app, given, {"Data"});
  addCommandSettings(app, given, "info");
}

void addAverageOptions(CLI::App& app, GivenSettings& given)
{
  addFiles(app, given.settings);
  addSettings(app, given, {"Data"});
  addCommandSettings(app, given, "average");
  addSettings(
    app, given, {"color-by", "color-map", "range", "log", "title", "legend-format", "font-scale"});
  app.get_option("--color-by")
    ->description("Column of the table that colours the picture. Default: the average, of a vector "
                  "its magnitude");
}

void addImageSilhouetteOptions(CLI::App& app, GivenSettings& given)
{
  Settings& settings = given.settings;
  // Narrow lines, grey where steps are small, from 1 % of what the image shows on.
  settings.silhouettes.lines = "1%";
  settings.silhouettes.thickness = "1";
  settings.silhouettes.opacity = 0.3;
  app
    .add_option("IMAGE", settings.data.files, "Image with depths, such as an .exr from any program")
    ->required()
    ->expected(1)
    ->type_name("");
  addCommandSettings(app, given, "silhouettes");
  addSettings(app, given,
    {"silhouette-thickness", "silhouette-opacity", "silhouette-color", "silhouette-on-pixels",
      "silhouette-step-pixels", "silhouette-groups", "silhouette-no-hulls", "threads"},
    "silhouette-");
}

void addBakeOptions(CLI::App& app, GivenSettings& given)
{
  addFiles(app, given.settings);
  addSettings(app, given, {"Data", "Radius"});
  addCommandSettings(app, given, "bake");
}

void addIntegrateOptions(CLI::App& app, GivenSettings& given)
{
  addFiles(app, given.settings);
  addSettings(app, given, {"Data", "slice", "cut-axis", "show", "where"});
  addCommandSettings(app, given, "integrate");
  app.get_option("--show")->description(
    "Only cells whose middle, or mean of an array, lies in a range: NAME=LO:HI. May be given "
    "several times");
  app.get_option("--where")->description(
    "Only cells for which EXPRESSION holds, such as \"sqrt(x^2 + y^2) < 0.05\", with x, y, z of "
    "their middles");
  app.get_option("--slice")->description(
    "Sections, by planes across x, y, z or a direction of three numbers, as in 1,1,0=5, by "
    "cylinders about the axis of --cut-axis at radii r, by planes across it at heights h, or by "
    "half planes at angles in degrees, which end at the axis");
  addSettings(app, given, {"range", "font-scale"});
  app.get_option("--range")->description(
    "Least and greatest value at the axis of a picture's curves. Default: theirs");
}

void addProbeOptions(CLI::App& app, GivenSettings& given)
{
  addFiles(app, given.settings);
  addSettings(app, given, {"Data"});
  addCommandSettings(app, given, "probe");
  addSettings(app, given, {"color-by", "range", "title", "font-scale"});
  app.get_option("--color-by")
    ->description("Array that a picture shows, where --curves names none. Default: the most "
                  "telling one");
  app.get_option("--range")->description(
    "Least and greatest value at the picture's axis. Default: those along the line");
}

} // namespace mote::app
