// What commands may be told besides the settings of the picture.

#include "Table.h"

#include "base/Text.h"
#include "stage/Silhouettes.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace mote::app
{

namespace
{

using Rows = std::vector<Row>;
constexpr auto output = &Settings::output;

} // namespace

Row outputRow(const std::string& command, const std::string& help, bool required)
{
  return row(&Settings::output, &OutputSettings::file,
    {.group = "Output",
      .name = "output",
      .value = "FILE",
      .help = help,
      .alias = "-o",
      .command = command,
      .required = required});
}

Row allStepsRow(const std::string& command, const std::string& help)
{
  return row(&Settings::output, &OutputSettings::allSteps,
    {.group = "Output",
      .name = "all-steps",
      .help = help,
      .excludes = {"step", "time"},
      .command = command});
}

namespace
{

Row sessionRow(const std::string& command)
{
  return row(output, &OutputSettings::session,
    {.group = "Output",
      .name = "save-session",
      .value = "FILE",
      .help = "Write all of this as a session, .json, which mote and mote render open as they do "
              "data",
      .command = command});
}

void addPictureCommands(Rows& table)
{
  table.push_back(sessionRow("mote"));
  table.push_back(row(output, &OutputSettings::preview,
    {.group = "Output",
      .name = "preview",
      .help = "Show nothing before the structure is built. Else large sets begin with a preview: "
              "a part of the particles, enlarged, and a line that says so",
      .command = "mote"}));
  table.push_back(row(output, &OutputSettings::panel,
    {.group = "Output",
      .name = "panel",
      .help = "Begin without the panel at the window's side; the Tab key shows and hides it",
      .command = "mote"}));
  table.push_back(row(output, &OutputSettings::uiScale,
    {.group = "Output",
      .name = "ui-scale",
      .value = "F",
      .help = "Factor on the size of the window's texts and controls; the legend has --font-scale",
      .invalidates = Invalidates::Nothing,
      .limits = {.least = 0.5, .most = 4.0},
      .usual = "as the display says: its dots per inch over 96",
      .command = "mote"}));
  table.push_back(row(output, &OutputSettings::size,
    {.group = "Output",
      .name = "picture-size",
      .value = "WxH",
      .help = "Width and height in pixels of the pictures and films that the window saves; letters "
              "grow with them",
      .usual = "those of the view",
      .command = "mote"}));
  table.push_back(outputRow("render",
    "Picture to write: .png, .jpg or .tif; or .exr with colour, depth, normal and particle id, the "
    "background transparent",
    true));
  table.push_back(allStepsRow("render",
    "Write one picture per time step: out.png gives out.0001.png, out.0002.png ... All have the "
    "frame of the last step and one range of colours; unless --range gives it, the steps are read "
    "twice to find it"));
  table.push_back(sessionRow("render"));
}

void addInfo(Rows& table)
{
  table.push_back(row(output, &OutputSettings::json,
    {.group = "Output",
      .name = "json",
      .help = "Print a JSON array, one object a data set, instead",
      .command = "info"}));
}

void addConvert(Rows& table)
{
  table.push_back(row(output, &OutputSettings::pieces,
    {.group = "Conversion",
      .name = "pieces",
      .value = "N",
      .help = "Pieces of a .pvtp or .pvtu file, each compact in space and in a file of its own in "
              "a folder beside it: ranks of ParaView read some each",
      .limits = {.least = 1, .most = 65536},
      .usual = "8",
      .command = "convert"}));
  table.push_back(allStepsRow("convert",
    "Write one file per time step: out.mote gives out.0001.mote, out.0002.mote ..., which mote "
    "opens together as a series. Radii from the spacing are those of the last step"));
  table.push_back(row<OutputSettings, std::string>(output, &OutputSettings::memory,
    {.group = "Conversion",
      .name = "memory",
      .value = "SIZE",
      .help = "Memory for particles, such as 500M or 4G; a bare number is bytes. What does not fit "
              "goes to scratch files beside the output, which are gone at the end",
      .usual = "half of the machine's",
      .command = "convert"},
    [](const std::string& text)
    {
      if (!text.empty() && bytesOf(text) == 0)
        throw WrongValue{"'" + text + "' is no size above zero such as 500M or 4G"};
    }));
}

void addBake(Rows& table)
{
  const std::string group = "Baking", command = "bake";
  const auto bake = &Settings::bake;
  table.push_back(outputRow(command,
    "File to write, .moteao. By default FILE.moteao, or FILE.STEP.moteao where FILE has several "
    "time steps, which is where mote looks for it",
    false));
  table.push_back(allStepsRow(command,
    "Bake every time step, with the radii of the last one where they come from the spacing: "
    "FILE.1.moteao, FILE.2.moteao ..., or -o out.moteao gives out.0001.moteao ..."));
  table.push_back(row<BakeSettings, int>(bake, &BakeSettings::side,
    {.group = group,
      .name = "side",
      .value = "N",
      .help = "Texels along a side of the largest maps: 1, 2, 4, 8, 16 or 32",
      .limits = {.least = 1, .most = 32},
      .command = command},
    [](int side)
    {
      if ((side & (side - 1)) != 0)
        throw WrongValue{"must be 1, 2, 4, 8, 16 or 32, not " + std::to_string(side)};
    }));
  table.push_back(row(bake, &BakeSettings::samples,
    {.group = group,
      .name = "samples",
      .value = "N",
      .help = "Occlusion rays per texel",
      .limits = {.least = 1, .most = 65536},
      .command = command}));
  table.push_back(row(bake, &BakeSettings::reach,
    {.group = group,
      .name = "occlusion-reach",
      .value = "R",
      .help = "How far rays go, in the data's units: what is farther away darkens nothing",
      .limits = {.aboveZero = true},
      .usual = "a tenth of the data's longest side",
      .command = command}));
  table.push_back(row(bake, &BakeSettings::tolerance,
    {.group = group,
      .name = "tolerance",
      .value = "E",
      .help = "Error that a particle's smaller map may have, as a share of the light of the sky; 0 "
              "gives all maps the same size",
      .limits = {.least = 0.0, .most = 1.0},
      .command = command}));
}

/// Why the text is no length nor percentage.
std::string checkLength(const std::string& text)
{
  const bool isWord = text == "on" || text == "off" || text == "auto";
  if (!isWord && checkLines(text).empty())
    return {};
  return "'" + text + "' is neither a length such as 2.5 nor a percentage such as 1%";
}

void addDepth(Rows& table)
{
  const std::string group = "Depth", command = "silhouettes";
  const auto image = &Settings::depthImage;
  table.push_back(row(image, &DepthImageSettings::depth,
    {.group = group,
      .name = "depth",
      .value = "NAME",
      .help = "Channel of the depths, as vtkMoteImageReader names it",
      .usual = "depth, which is Z in the file, or the only channel",
      .command = command}));
  table.push_back(row(image, &DepthImageSettings::viewAngle,
    {.group = group,
      .name = "view-angle",
      .value = "A",
      .help = "Angle between bottom and top, in degrees",
      .limits = {.least = 1e-6, .most = 179.0},
      .command = command}));
  table.push_back(row(image, &DepthImageSettings::alongRays,
    {.group = group,
      .name = "along-rays",
      .help = "Depths are distances from the eye, and not along the view axis",
      .command = command}));
  table.push_back(row(image, &DepthImageSettings::height,
    {.group = group,
      .name = "orthographic",
      .value = "HEIGHT",
      .help = "The view is orthographic and so high, in world units",
      .limits = {.aboveZero = true},
      .usual = "perspective",
      .excludes = {"view-angle", "along-rays"},
      .command = command}));
  table.push_back(row(image, &DepthImageSettings::farDepth,
    {.group = group,
      .name = "far",
      .value = "D",
      .help = "Depths from here on are background, as those that are not finite are anyway",
      .limits = {.aboveZero = true},
      .usual = "none",
      .command = command}));
}

void addSilhouettesCommand(Rows& table)
{
  const std::string command = "silhouettes";
  const auto image = &Settings::depthImage;
  table.push_back(
    outputRow(command, "Picture to write: .png, .jpg, .tif or .exr; with lines drawn", true));
  table.push_back(
    row<SilhouetteSettings, std::string>(&Settings::silhouettes, &SilhouetteSettings::lines,
      {.group = "Silhouettes",
        .name = "threshold",
        .value = "STEP",
        .help = "Least step of depth that is drawn: a length in world units, or with % a share of "
                "the diagonal of what the image shows",
        .usual = "1%",
        .command = command},
      refusing(checkLength)));
  table.push_back(row(image, &DepthImageSettings::reduction,
    {.group = "Output",
      .name = "reduce",
      .value = "N",
      .help = "Make one pixel of a square of N times N, for smooth lines from a larger image",
      .limits = {.least = 1, .most = 64},
      .command = command}));
  table.push_back(row(image, &DepthImageSettings::linesAlone,
    {.group = "Output",
      .name = "lines-only",
      .help = "Draw on white, and not over the image's colours",
      .command = command}));
  addDepth(table);
}

} // namespace

std::uint64_t bytesOf(const std::string& text)
{
  std::uint64_t bytes = 0;
  std::string size = text;
  try
  {
    // It turns the text into one without a unit, or says why not; or throws that.
    if (!text.starts_with('-') && CLI::AsSizeValue(false)(size).empty() &&
        CLI::detail::lexical_cast(size, bytes))
      return bytes;
  }
  catch (const CLI::Error&)
  {
  }
  return 0;
}

const std::vector<Row>& commandTable()
{
  static const Rows table = []
  {
    Rows rows;
    for (const auto add : {addPictureCommands, addTimeRows, addPlotRows, addRecordingRows,
           addFilmRows, addConvert, addInfo, addSilhouettesCommand, addBake, addMeasureRows})
      add(rows);
    return rows;
  }();
  return table;
}

} // namespace mote::app
