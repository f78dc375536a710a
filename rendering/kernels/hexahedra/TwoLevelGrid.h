#pragma once

#include "CartesianSpace.h"
#include "CylindricalSpace.h"
#include "IsHexStructure.h"

#include <memory>
#include <string>
#include <vector>

namespace mote
{

struct TwoLevelGridOptions
{
  double lambda1 = 1.0 / 16.0; ///< macro cells per cell
  double lambda2 = 4.0;        ///< leaves per reference of a macro cell
  /// Refer to a cell from a leaf only where the cell's CellOutline meets it, rather than from all
  /// that its bounds overlap, as published: fewer references, in a longer build.
  bool trimmed = false;
};

/// A grid of macro cells, each with a grid of its own: Kalojanov, Billeter, Slusallek, "Two-Level
/// Grids for Ray Tracing on GPUs", 2011, over the coordinates of a space. Cells are referred to
/// from all leaves that their bounds overlap. Where that would be very many for a cell, as for
/// cells that are flat or lie all over one another, the grid is coarser, which keeps its memory
/// within a few kilobytes a cell.
///
/// The resolution along a coordinate is a region's side times cbrt(lambda n / volume), of n cells
/// or references in it; in (r, theta, h) the sides are d_r, d_theta (2 r + d_r) / 2 and d_h (Wang,
/// Elshehaly, Cao). Leaves hold references in the order of cell numbers.
///
/// Functions without a comment do what IsHexStructure says; queries are in TwoLevelGridWalk.h.
template <typename Space>
class TwoLevelGrid
{
public:
  static std::string name() { return std::string(Space::prefix) + "grid"; }
  static std::string summary() { return std::string("two-level grid over ") + Space::axes; }
  using Coordinates = Space;
  using Options = TwoLevelGridOptions;

  TwoLevelGrid() = default;
  /// Throws Error where there are more than 2^32 - 1 references or leaves.
  TwoLevelGrid(
    std::shared_ptr<const HexMesh> mesh, const Space& space, const TwoLevelGridOptions& options);

  const HexMesh& mesh() const { return *mesh_; }
  template <typename Counts = NoCounts>
  std::uint32_t cellAt(
    const Vec3d& p, std::uint32_t hint = HexMesh::noCell, Counts&& counts = {}) const;
  template <typename Visit, typename Keep = KeepAll, typename Counts = NoCounts>
  void forCellsAlong(
    const HexRay& ray, const Visit& visit, const Keep& keep = {}, Counts&& counts = {}) const;
  void gatherWithin(const Box& box, std::vector<std::uint32_t>& cells) const;
  void setRanges(const RawVector<ScalarRange>& ofCells);

  std::size_t bytes() const;
  std::size_t ownBytes() const { return bytes(); }
  std::size_t references() const { return references_.size(); }
  std::size_t largestLeaf() const;
  HexStructureShape shape() const;

private:
  /// A macro cell: its leaves begin at `leaf`; n along each coordinate.
  struct Macro
  {
    std::uint32_t leaf = 0;
    std::array<std::uint8_t, 3> n{1, 1, 1};
    std::array<int, 3> resolution() const { return {n[0], n[1], n[2]}; }
  };
  /// The cells that overlap each macro cell, in the order of their numbers: what a new scalar's
  /// ranges are found from, a few percent of the memory.
  struct MacroLists
  {
    RawVector<std::uint32_t> starts, cells;
  };

  std::size_t leaves() const { return starts_.empty() ? 0 : starts_.size() - 1; }
  void layOutMacros(const RawVector<SpaceBounds>& bounds, double lambda);
  std::size_t countReferences(const RawVector<SpaceBounds>& bounds) const;
  template <typename Visit>
  void forCellSteps(std::size_t cell, const Lattice& lattice, const typename Space::Steps& steps,
    const LatticeRange& range, const Visit& visit) const;
  void listMacros(const RawVector<SpaceBounds>& bounds);
  void layOutLeaves(double lambda);
  template <typename Visit>
  bool forLeaves(std::size_t m, const RawVector<SpaceBounds>& bounds, std::size_t most,
    const Visit& visit) const;
  void countLeaves(std::size_t m, const RawVector<SpaceBounds>& bounds);
  void fillLeaves(const RawVector<SpaceBounds>& bounds);
  Lattice macroLattice(const std::array<int, 3>& at, const Macro& macro) const
  {
    return Space::within(top_, at[0], at[1], at[2], macro.resolution());
  }

  std::shared_ptr<const HexMesh> mesh_;
  Space space_;
  Lattice top_;
  typename Space::Region extent_;
  double size_ = 0.0; ///< of the mesh
  bool trimmed_ = false;
  RawVector<Macro> macros_;
  MacroLists lists_;
  RawVector<std::uint32_t> starts_; ///< of the leaves' references; one more than leaves
  RawVector<std::uint32_t> references_;
  RawVector<ScalarRange> ranges_; ///< of the macro cells, or empty
};

using CartesianGrid = TwoLevelGrid<CartesianSpace>;
using CylindricalGrid = TwoLevelGrid<CylindricalSpace>;

} // namespace mote
