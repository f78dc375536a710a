#pragma once

#include "VolumeTask.h"

#include <kernels/hexahedra/HexStructure.h>

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
  double buildSeconds = 0.0;       ///< median
  double frameChangeSeconds = 0.0; ///< to take other values: field and ranges; median
  double megabytes = 0.0;          ///< of 1e6 bytes, without the mesh
  std::size_t references = 0, largestLeaf = 0;
};

struct HexStructureRequest
{
  const HexMethodEntry* method;
  double lambda2 = 4.0;
};

/// Builds the structures in one race. The axis is the input's, or found.
std::vector<BuiltHexStructure> buildStructures(
  const VolumeTask& task, const std::vector<HexStructureRequest>& requests);

} // namespace mote::bench
