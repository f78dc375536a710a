#include "Table.h"

#include <vtkMoteParticleMapper.h>

#include <functional>
#include <numeric>

namespace mote::app
{

namespace
{

constexpr double mostImages = 4096;

void checkImages(const std::vector<int>& counts)
{
  if (std::accumulate(counts.begin(), counts.end(), 1.0, std::multiplies<>()) > mostImages)
    throw WrongValue{"at most 4096 images are possible"};
}

} // namespace

void addParticleRows(std::vector<Row>& table)
{
  const std::string group = "Radius";
  const auto particles = &Settings::particles;
  const auto structure = Invalidates::Structure;
  table.push_back(row(particles, &ParticleSettings::radius,
    {.group = group,
      .name = "radius",
      .value = "R|NAME",
      .help = "Radius of the particles: a number, the name of an array of radii, spacing (half the "
              "typical distance between neighbours) or auto (an array named radius or radii, "
              "half of one named diameter, else as spacing)",
      .invalidates = structure,
      .alias = "-r",
      .offers = {"auto", "spacing"}}));
  table.push_back(row(particles, &ParticleSettings::typeRadius,
    {.group = group,
      .name = "type-radius",
      .value = "TYPE=R,...",
      .help = "Radii by the array 'type', such as 1=0.5,2=0.7. Other types get the number of "
              "--radius, or 0.5 without it",
      .invalidates = structure,
      .limits = {.aboveZero = true},
      .usual = "none"}));
  table.push_back(row(particles, &ParticleSettings::radiusScale,
    {.group = group,
      .name = "radius-scale",
      .value = "F",
      .help = "Factor on every radius; 0.5 where the array holds diameters",
      .invalidates = structure,
      .limits = {.aboveZero = true}}));
  table.push_back(row(particles, &ParticleSettings::structure,
    {.group = "Structure",
      .name = "structure",
      .value = "NAME",
      .help = "Acceleration structure of particles. auto takes the coherent grid up to 100 million "
              "particles, and the P-k-d tree above and for .mote files. pkd-paper is that tree as "
              "it was published, to compare with",
      .invalidates = structure,
      .words = vtkMoteParticleMapper::GetStructureNames()}));
  table.push_back(row(particles, &ParticleSettings::form,
    {.group = "Structure",
      .name = "form",
      .value = "NAME",
      .help = "How the pkd-tree stores the particles' centres. Refused where it would move them by "
              "more than a twentieth of the smallest radius. auto takes the form of a .mote file, "
              "and else exact",
      .invalidates = structure,
      .words = vtkMoteParticleMapper::GetStructureForms()}));
  table.push_back(row<ParticleSettings, std::vector<int>>(particles, &ParticleSettings::replicate,
    {.group = "Structure",
      .name = "replicate",
      .value = "A,B,C",
      .help = "Draw so many images of the particles along each edge of their simulation box, as in "
              "3,3,1; the first is that of the file. Images take no memory",
      .count = 3,
      .limits = {.least = 1, .most = mostImages},
      .usual = "1,1,1"},
    checkImages));
}

} // namespace mote::app
