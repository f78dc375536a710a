#pragma once

#include "stage/Input.h"
#include "table/CommandLine.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
} // namespace CLI

namespace mote::app
{

/// What mote bake is asked for.
struct BakeOptions
{
  GivenSettings given; ///< files, step and radii of it
  std::string output;
  int side = 0;            ///< texels along a side; 0: as vtkMoteAmbientOcclusionBaker has it
  int samples = 0;         ///< rays a texel; 0: likewise
  double reach = 0.0;      ///< 0: choose
  double tolerance = -1.0; ///< below 0: as the filter has it; 0: all maps of the same size
};

void addBakeOptions(CLI::App& app, BakeOptions& options);

/// Writes the occlusion maps of the particles of a file.
void bake(const BakeOptions& options);

/// Adds the maps that mote bake has written beside their files, if there are any, to the particles
/// among the data. A file that cannot be read is a warning.
void addOcclusionMaps(const std::vector<NamedData>& data);

} // namespace mote::app
