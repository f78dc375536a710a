#pragma once

#include "HexBvhWalk.h"
#include "TwoLevelGridWalk.h"

#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace mote
{

// One by one, so that the compiler names what a listed structure lacks.
template <IsHexStructure Structure>
using CheckedHexStructure = Structure;
template <typename... Structures>
using HexStructureOf = std::variant<CheckedHexStructure<Structures>...>;

/// Every structure over a HexMesh: which cell holds a point, and which cells a ray passes. What
/// they offer is written at IsHexStructure; ask through withStructure(), once a tile rather than
/// once a ray. docs/architecture.md says how one is added.
using HexStructure = HexStructureOf<CylindricalGrid, CartesianGrid, CylindricalBvh, CartesianBvh>;

/// Which structure to build, in the order of the alternatives.
enum class HexStructureKind
{
  CylindricalGrid,
  CartesianGrid,
  CylindricalBvh,
  CartesianBvh
};
static_assert(
  std::variant_size_v<HexStructure> == static_cast<std::size_t>(HexStructureKind::CartesianBvh) + 1,
  "HexStructureKind names the alternatives of HexStructure in their order.");

struct HexStructureOptions
{
  HexStructureKind kind = HexStructureKind::CylindricalGrid;
  TwoLevelGridOptions grid;
  HexBvhOptions bvh;
  std::optional<CylinderAxis> axis; ///< found where it is not given, see findAxis()

  /// Those of a structure.
  template <typename Structure>
  const typename Structure::Options& of() const
  {
    return std::get<const typename Structure::Options&>(std::tie(grid, bvh));
  }
};

/// Builds the structure that the options name. Throws Error for an axis without direction and, for
/// grids, where there would be too many references.
std::shared_ptr<HexStructure> makeHexStructure(
  std::shared_ptr<const HexMesh> mesh, const HexStructureOptions& options = {});

/// The names of the structures, for options and messages, in the order of HexStructureKind.
const std::vector<std::string>& hexStructureNames();

/// Whether a structure of this kind lies about an axis.
bool isCylindrical(HexStructureKind kind);

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

/// The cell of `structure` that holds `p`, see IsHexStructure.
std::uint32_t cellAt(
  const HexStructure& structure, const Vec3d& p, std::uint32_t hint = HexMesh::noCell);

/// The cells that meet `box`, and of those beside it some whose corners' bounds do, in the order of
/// their numbers. (Beside it: a cell that lies aslant misses parts of its bounds.) Bounds that
/// touch count as meeting.
std::vector<std::uint32_t> cellsWithin(const HexStructure& structure, const Box& box);

/// Tells the structure the ranges of a field, see IsHexStructure.
void setRanges(HexStructure& structure, const HexField& field);

} // namespace mote
