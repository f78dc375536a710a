#include "Table.h"

#include <vtkMoteVolumeMapper.h>

namespace mote::app
{

namespace
{

/// Sessions of earlier versions say true or false.
Row cloudRow(const std::string& group)
{
  Row cloud = row(&Settings::volume, &VolumeSettings::cloud,
    {.group = group,
      .name = "cloud",
      .value = "WHEN",
      .help = "Whether the volume itself is seen, as a cloud of the opacities of --opacity: on, "
              "off, or auto, where --opacity, --opacity-unit or --lit is given",
      .words = {"on", "off", "auto"}});
  cloud.set = [set = cloud.set](Settings& s, const std::vector<std::string>& words)
  {
    std::vector<std::string> now = words;
    for (std::string& word : now)
      word = word == "true" ? "on" : word == "false" ? "off" : word;
    set(s, now);
  };
  cloud.next = [](Settings& s, const Settings&)
  {
    const bool isUsual = !s.volume.opacity.empty() || s.volume.opacityUnit || s.volume.lit;
    const bool isOn = s.volume.cloud == "on" || (s.volume.cloud == "auto" && isUsual);
    s.volume.cloud = !isOn ? "on" : isUsual ? "off" : "auto";
  };
  cloud.told = [](const Settings& s)
  { return s.volume.cloud == "on" ? "The cloud of volumes" : "Walls and slices of volumes"; };
  return cloud;
}

void addAppearanceRows(std::vector<Row>& table)
{
  const std::string group = "Volume";
  const auto volume = &Settings::volume;
  table.push_back(row(volume, &VolumeSettings::cells,
    {.group = group,
      .name = "cells",
      .value = "KIND",
      .help = "How the 3D cells of unstructured grids are shown: volume needs an array of numbers "
              "to colour by, surface shows their outer faces, and auto is volume where there is "
              "such an array, else surface",
      .invalidates = Invalidates::Data,
      .words = {"auto", "volume", "surface"}}));
  table.push_back(row(volume, &VolumeSettings::opacity,
    {.group = group,
      .name = "opacity",
      .value = "VALUE=OPACITY,...",
      .help =
        "Opacity transfer function: opacities from 0 to 1 at values of the array that colours, "
        "linear in between, such as 20=0,50=0.4. A value with % is a share of the colours' range",
      .usual = "the least and greatest values are the most opaque, common ones faint"}));
  table.push_back(row(volume, &VolumeSettings::opacityUnit,
    {.group = group,
      .name = "opacity-unit",
      .value = "LENGTH",
      .help = "Path length, in the data's units, over which a volume reaches the opacities of "
              "--opacity. The larger, the more transparent",
      .limits = {.aboveZero = true},
      .usual = "a tenth of the scene's diagonal"}));
  table.push_back(row(volume, &VolumeSettings::isoValues,
    {.group = group,
      .name = "iso",
      .value = "VALUE,...",
      .help = "Opaque isosurfaces where the array that colours, or that of --iso-array, has these "
              "values; an array of cells counts by its means at points",
      .usual = "none"}));
  table.push_back(row(volume, &VolumeSettings::isoArray,
    {.group = group,
      .name = "iso-array",
      .value = "NAME",
      .help = "The array that isosurfaces follow, named as in --color-by; they have the colours "
              "of the one that colours",
      .usual = "the array that colours"}));
  table.push_back(cloudRow(group));
  table.push_back(row(volume, &VolumeSettings::lit,
    {.group = group,
      .name = "lit",
      .help = "Light volumes by their gradient; isosurfaces are always lit"}));
  table.push_back(row<VolumeSettings, std::string>(volume, &VolumeSettings::nanColor,
    {.group = group,
      .name = "nan-color",
      .value = "COLOUR",
      .help = "Colour of cells and particles with a value that is not a number",
      .usual = "grey; cells are left out"},
    [](const std::string& name)
    {
      if (!name.empty())
        colorOf(name);
    }));
}

void addIntegrationRows(std::vector<Row>& table)
{
  const std::string group = "Volume";
  const auto volume = &Settings::volume;
  table.push_back(row(volume, &VolumeSettings::integrator,
    {.group = group,
      .name = "integrator",
      .value = "NAME",
      .help = "How a volume is integrated along a ray. cell-by-cell goes exactly through the "
              "cells, to --tolerance; trilinear and inverse-distance take samples, "
              "--sample-distance apart, with that interpolation",
      .words = vtkMoteVolumeMapper::GetIntegratorNames()}));
  table.push_back(row(volume, &VolumeSettings::sampleDistance,
    {.group = group,
      .name = "sample-distance",
      .value = "LENGTH",
      .help = "Distance between samples along a ray, in the data's units, of the integrators "
              "trilinear and inverse-distance",
      .limits = {.aboveZero = true},
      .usual = "half the mean cell size"}));
  table.push_back(row(volume, &VolumeSettings::tolerance,
    {.group = group,
      .name = "tolerance",
      .value = "ERROR",
      .help = "Largest error of a colour, which goes from 0 to 1, that the integrator cell-by-cell "
              "may make",
      .limits = {.most = 1.0, .aboveZero = true}}));
  table.push_back(row(volume, &VolumeSettings::cloudTolerance,
    {.group = group,
      .name = "cloud-tolerance",
      .value = "ERROR",
      .help = "Interpolate pixels of a volume between traced ones where the estimated error of a "
              "colour, which goes from 0 to 1, is at most this. 0 traces every pixel",
      .limits = {.least = 0.0, .most = 1.0}}));
  table.push_back(row(volume, &VolumeSettings::structure,
    {.group = group,
      .name = "cell-structure",
      .value = "NAME",
      .help = "Acceleration structure of cells: a grid or a bounding volume hierarchy (bvh), in "
              "cylindrical (cyl) or Cartesian (cart) coordinates",
      .invalidates = Invalidates::Structure,
      .words = vtkMoteVolumeMapper::GetStructureNames(),
      .usual = "cartbvh"}));
}

} // namespace

void addVolumeRows(std::vector<Row>& table)
{
  addAppearanceRows(table);
  addIntegrationRows(table);
}

} // namespace mote::app
