#include "Table.h"

#include <vtkMoteVolumeMapper.h>

namespace mote::app
{

namespace
{

void addAppearanceRows(std::vector<Row>& table)
{
  const std::string group = "Volume";
  const auto volume = &Settings::volume;
  table.push_back(row(volume, &VolumeSettings::cells,
    {.group = group,
      .name = "cells",
      .value = "KIND",
      .help = "How cells are shown: as a volume or by their surface. auto shows a volume where "
              "there is an array to colour it by",
      .invalidates = Invalidates::Data,
      .words = {"auto", "volume", "surface"}}));
  table.push_back(row(volume, &VolumeSettings::opacity,
    {.group = group,
      .name = "opacity",
      .value = "VALUE=OPACITY,...",
      .help = "Opacity at values of the array that colours, linear between them: 20=0,50=0.4; a "
              "value with % is a share of the colours' range",
      .usual = "0%=0.5,25%=0.08,50%=0.02,75%=0.08,100%=0.5"}));
  table.push_back(row(volume, &VolumeSettings::opacityUnit,
    {.group = group,
      .name = "opacity-unit",
      .value = "LENGTH",
      .help = "Length over which the opacities hold, in the data's units: twice as far hides twice "
              "over",
      .limits = {.aboveZero = true},
      .usual = "a tenth of the scene's diagonal"}));
  table.push_back(row(volume, &VolumeSettings::isoValues,
    {.group = group,
      .name = "iso",
      .value = "VALUE,...",
      .help = "Opaque isosurfaces where the array that colours has these values",
      .usual = "none"}));
  table.push_back(row(volume, &VolumeSettings::cloud,
    {.group = group, .name = "cloud", .help = "Only the isosurfaces, without the volume"}));
  table.push_back(row(volume, &VolumeSettings::lit,
    {.group = group,
      .name = "lit",
      .help = "Light volumes by their gradient; isosurfaces are always lit"}));
  table.push_back(row<VolumeSettings, std::string>(volume, &VolumeSettings::nanColor,
    {.group = group,
      .name = "nan-color",
      .value = "COLOUR",
      .help = "Colour of cells with a value that is not a number",
      .usual = "not shown"},
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
      .help = "How a volume is integrated along a ray",
      .words = vtkMoteVolumeMapper::GetIntegratorNames()}));
  table.push_back(row(volume, &VolumeSettings::sampleDistance,
    {.group = group,
      .name = "sample-distance",
      .value = "LENGTH",
      .help = "Distance of samples along a ray",
      .limits = {.aboveZero = true},
      .usual = "half a mean cell"}));
  table.push_back(row(volume, &VolumeSettings::tolerance,
    {.group = group,
      .name = "tolerance",
      .value = "ERROR",
      .help = "Error of a colour, from 0 to 1, that the integrator cell-by-cell may make",
      .limits = {.most = 1.0, .aboveZero = true}}));
  table.push_back(row(volume, &VolumeSettings::cloudTolerance,
    {.group = group,
      .name = "cloud-tolerance",
      .value = "ERROR",
      .help = "Error of a colour, from 0 to 1, where pixels of a volume are interpolated rather "
              "than traced. 0 traces every pixel",
      .limits = {.least = 0.0, .most = 1.0}}));
  table.push_back(row(volume, &VolumeSettings::structure,
    {.group = group,
      .name = "cell-structure",
      .value = "NAME",
      .help = "Acceleration structure of cells",
      .invalidates = Invalidates::Structure,
      .words = vtkMoteVolumeMapper::GetStructureNames(),
      .usual = "chosen by the mesh"}));
}

} // namespace

void addVolumeRows(std::vector<Row>& table)
{
  addAppearanceRows(table);
  addIntegrationRows(table);
}

} // namespace mote::app
