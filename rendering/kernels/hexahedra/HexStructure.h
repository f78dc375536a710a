#pragma once

#include "HexBvhWalk.h"
#include "TwoLevelGridWalk.h"

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace mote
{

/// Every structure over a HexMesh: which cell holds a point, and which cells a ray passes. A new
/// one is one more alternative here and one more entry in HexStructure.cpp.
///
/// All offer cellAt(), forCellsAlong(), setRanges(), mesh(), bytes(), references() and
/// largestLeaf(); see TwoLevelGrid.h for what they do, and ask through withStructure(), once a tile
/// rather than once a ray.
using HexStructure = std::variant<CylindricalGrid, CartesianGrid, CylindricalBvh, CartesianBvh>;

/// Which structure to build, in the order of the alternatives.
enum class HexStructureKind
{
  CylindricalGrid,
  CartesianGrid,
  CylindricalBvh,
  CartesianBvh
};

struct HexStructureOptions
{
  HexStructureKind kind = HexStructureKind::CylindricalGrid;
  TwoLevelGridOptions grid;
  HexBvhOptions bvh;
  std::optional<CylinderAxis> axis; ///< found where it is not given, see findAxis()
};

/// Builds the structure that the options name. Throws Error for an axis without direction and, for
/// grids, where there would be too many references.
std::shared_ptr<HexStructure> makeHexStructure(
  std::shared_ptr<const HexMesh> mesh, const HexStructureOptions& options = {});

/// The names of the structures, for options and messages, in the order of HexStructureKind.
const std::vector<std::string>& hexStructureNames();

/// Calls `visit` with the structure that the variant holds.
template <typename Visit>
decltype(auto) withStructure(const HexStructure& structure, const Visit& visit)
{
  return std::visit(visit, structure);
}

inline const HexMesh& meshOf(const HexStructure& structure)
{
  return withStructure(structure, [](const auto& s) -> const HexMesh& { return s.mesh(); });
}

/// The cell of `structure` that holds `p`, see TwoLevelGrid::cellAt().
std::uint32_t cellAt(
  const HexStructure& structure, const Vec3d& p, std::uint32_t hint = HexMesh::noCell);

/// The cells that meet `box`, and of those beside it some whose corners' bounds do, in the order of
/// their numbers. (Beside it: a cell that lies aslant misses parts of its bounds.) Bounds that
/// touch count as meeting.
std::vector<std::uint32_t> cellsWithin(const HexStructure& structure, const Box& box);

/// Tells the structure the ranges of a field, see TwoLevelGrid::setRanges().
void setRanges(HexStructure& structure, const HexField& field);

} // namespace mote
