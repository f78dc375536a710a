#pragma once

#include "VolumeTask.h"

#include <kernels/hexahedra/HexStructure.h>
#include <kernels/hexahedra/WalkCells.h>

#include <memory>
#include <string>
#include <vector>

namespace mote::bench
{

/// One row of the table of structures.
struct HexMethodEntry
{
  std::string name;
  std::string summary;
  HexStructureKind kind;
};

/// Every alternative of HexStructure.
const std::vector<HexMethodEntry>& hexMethods();

/// Throws Error where there is none of this name.
const HexMethodEntry& hexMethodNamed(const std::string& name);

/// A structure over an input and what it takes.
struct BuiltHexStructure
{
  std::string method;
  double lambda2 = 0.0; ///< of grids
  std::shared_ptr<HexStructure> structure;
  std::shared_ptr<const WalkCells> walk; ///< camera rays go from cell to cell; or null
  double buildSeconds = 0.0;             ///< median
  double frameChangeSeconds = 0.0;       ///< to take other values: field and ranges; median
  double megabytes = 0.0;                ///< of 1e6 bytes, without the mesh
  std::size_t references = 0, largestLeaf = 0;
  HexStructureShape shape{};
};

/// Asks the structure for its memory, references and shape.
void describe(BuiltHexStructure& built);

struct HexStructureRequest
{
  const HexMethodEntry* method;
  double lambda2 = 4.0;
  bool trimmed = false; ///< of a grid
};

/// The structure, with the input's axis or one that is found.
std::shared_ptr<HexStructure> makeStructure(
  const HexInput& input, const HexStructureRequest& request);

/// The method by which camera rays go from cell to cell.
extern const Named walkMethod;

/// What that takes: to find out which cells share faces, and for a scalar. `structure` is for what
/// else a volume needs.
BuiltHexStructure buildWalk(const VolumeTask& task, std::shared_ptr<HexStructure> structure);

/// Builds the structures in one race.
std::vector<BuiltHexStructure> buildStructures(
  const VolumeTask& task, const std::vector<HexStructureRequest>& requests);

} // namespace mote::bench
