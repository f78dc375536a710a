#include "Table.h"

#include "settings/ErrorBudget.h"

#include <vtkMoteColorLegend.h>

namespace mote::app
{

namespace
{

const std::string pictureGroup = "Picture";
constexpr auto picture = &Settings::picture;
constexpr auto invalidates = Invalidates::Picture;

void addBudgetRows(std::vector<Row>& table)
{
  table.push_back(row<PictureSettings, std::string>(picture, &PictureSettings::error,
    {.group = pictureGroup,
      .name = "error",
      .value = "BUDGET",
      .help =
        "Error that the picture may have, and that the program then shares out. 1% is of "
        "colours, root mean square: samples are taken until the noise is small enough, and "
        "volumes are integrated and interpolated as roughly as that allows. 0.5px is of "
        "places: half of it is for levels of detail of triangles and of four million particles "
        "and more, where --lod-error is 0, and while the view moves resolution falls no "
        "further than the rest allows",
      .invalidates = Invalidates::Shading,
      .usual = "none",
      .excludes = {"noise"}},
    [](const std::string& text)
    {
      if (const std::string problem = text.empty() ? "" : checkError(text); !problem.empty())
        throw WrongValue{problem};
    }));
  table.push_back(row(picture, &PictureSettings::fps,
    {.group = pictureGroup,
      .name = "fps",
      .value = "N",
      .help = "Frames a second that the window shows while the view moves or a control is dragged: "
              "resolution falls as far as that takes, and no further than --error says",
      .invalidates = Invalidates::Nothing,
      .limits = {.least = 1.0, .most = 120.0},
      .usual = "about 12"}));
}

void addQualityRows(std::vector<Row>& table)
{
  table.push_back(row(picture, &PictureSettings::size,
    {.group = pictureGroup,
      .name = "size",
      .value = "WxH",
      .help = "Width and height in pixels",
      .invalidates = invalidates,
      .alias = "-s",
      .usual = "1280x960"}));
  table.push_back(row(picture, &PictureSettings::samples,
    {.group = pictureGroup,
      .name = "samples",
      .value = "N",
      .help =
        "Samples per pixel: more give smoother edges and less noise. With --noise, at most so many",
      .invalidates = invalidates,
      .limits = {.least = 1, .most = 65536},
      .usual = "16; 64 with --path-trace; at most 4096 with --noise"}));
  table.push_back(row(picture, &PictureSettings::noise,
    {.group = pictureGroup,
      .name = "noise",
      .value = "LEVEL",
      .help = "Take samples until the standard error of the picture, whose colours go from 0 to 1, "
              "falls to LEVEL; 0.01 looks smooth",
      .invalidates = invalidates,
      .limits = {.most = 1.0, .aboveZero = true},
      .usual = "off: all samples are taken"}));
  table.push_back(row(picture, &PictureSettings::lodError,
    {.group = pictureGroup,
      .name = "lod-error",
      .value = "PIXELS",
      .help =
        "Levels of detail: groups of triangles that err by less than so many pixels are drawn as "
        "planes of their mean colour, and groups of particles as boxes. That is faster where many "
        "fall into a pixel, and outlines are rougher. Shadows, occlusion and reflections take "
        "planes too, but no boxes; picks ask triangles and particles themselves. Particles need "
        "the P-k-d tree, which auto structures are then. 0 "
        "is exact",
      .invalidates = Invalidates::Shading,
      .limits = {.least = 0.0, .most = 64.0},
      .inDecades = true}));
  table.push_back(row<PictureSettings, std::vector<Color>>(picture, &PictureSettings::background,
    {.group = pictureGroup,
      .name = "background",
      .value = "COLOUR[,TOP]",
      .help = "Background: a colour by name or #rrggbb, or two with a comma for a gradient from "
              "bottom to top",
      .invalidates = invalidates,
      .alias = "-b",
      .usual = "a dark grey gradient"},
    [](const std::vector<Color>& colors)
    {
      if (colors.size() > 2)
        throw WrongValue{"one or two colours are possible"};
    }));
}

/// What lies over the picture.
void addLabelRows(std::vector<Row>& table)
{
  table.push_back(row(picture, &PictureSettings::legend,
    {.group = pictureGroup,
      .name = "legend",
      .help = "No colour legend",
      .invalidates = invalidates}));
  table.push_back(row(picture, &PictureSettings::title,
    {.group = pictureGroup,
      .name = "title",
      .value = "TEXT",
      .help = "Title of the colour legend",
      .invalidates = invalidates,
      .usual = "the array's name"}));
  table.push_back(row(picture, &PictureSettings::legendSide,
    {.group = pictureGroup,
      .name = "legend-side",
      .value = "SIDE",
      .help = "Side of the picture where the legend stands",
      .invalidates = invalidates,
      .words = {"right", "left"}}));
  table.push_back(row<PictureSettings, std::string>(picture, &PictureSettings::legendFormat,
    {.group = pictureGroup,
      .name = "legend-format",
      .value = "FORMAT",
      .help = "printf format of the legend's numbers, such as %.2f",
      .invalidates = invalidates,
      .usual = "as short as the values allow"},
    [](const std::string& format)
    {
      if (!vtkMoteColorLegend::IsLabelFormat(format))
        throw WrongValue{"'" + format + "' is no printf format of one number, such as %.2f"};
    }));
  table.push_back(row(picture, &PictureSettings::fontScale,
    {.group = pictureGroup,
      .name = "font-scale",
      .value = "F",
      .help = "Factor on the size of the legend's and the caption's letters",
      .invalidates = invalidates,
      .limits = {.least = 0.25, .most = 4.0}}));
  table.push_back(row(picture, &PictureSettings::caption,
    {.group = pictureGroup,
      .name = "caption",
      .value = "TEXT",
      .help = "Line at the lower left; '' for none",
      .invalidates = invalidates,
      .usual = "file, particles and time"}));
  table.push_back(row(picture, &PictureSettings::box,
    {.group = pictureGroup,
      .name = "box",
      .help = "No box around the data in the window; pictures have none",
      .invalidates = invalidates}));
  table.push_back(row(picture, &PictureSettings::axes,
    {.group = pictureGroup,
      .name = "axes",
      .help = "No axes in the corner of the window; pictures have none",
      .invalidates = invalidates}));
  table.push_back(row(picture, &PictureSettings::handles,
    {.group = pictureGroup,
      .name = "handles",
      .value = "WHEN",
      .help = "Outlines and marks of slices and of faces of cuts in the window, by which they are "
              "dragged: on, off, or auto, while Slices or Cuts is open in the panel; pictures have "
              "none",
      .invalidates = invalidates,
      .words = {"auto", "on", "off"}}));
}

} // namespace

void addPictureRows(std::vector<Row>& table)
{
  addQualityRows(table);
  addBudgetRows(table);
  addLabelRows(table);
}

} // namespace mote::app
