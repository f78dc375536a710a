#pragma once

#include "../core/RawVector.h"
#include "HexMesh.h"
#include "HexRay.h"

#include <concepts>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace mote
{

/// How much there is of a structure.
struct HexStructureShape
{
  std::size_t nodes = 0;  ///< of a hierarchy; of a grid, macro cells and leaves
  std::size_t levels = 0; ///< of nodes
  /// Of a hierarchy, the sums of its nodes' and its leaves' areas, in squared units of the mesh; 0
  /// for a grid.
  double area = 0.0, leafArea = 0.0;
};

/// What every structure over a HexMesh offers. It works in the coordinates of a space, see
/// CartesianSpace.
///
/// One that is made without a mesh holds no cell. Its const functions may be called from any number
/// of threads.
template <typename S>
concept IsHexStructure = std::default_initializable<S> && std::copyable<S> &&
  requires(S made, const S held, const std::shared_ptr<const HexMesh> mesh,
    const typename S::Coordinates space, const typename S::Options options, const Vec3d p,
    const HexRay ray, bool (*const visit)(const CellSpan&), bool (*const keep)(const ScalarRange&),
    WalkCounts counts, std::vector<std::uint32_t> cells)
{
  // Its name in options and messages, and a phrase about it.
  requires std::convertible_to<decltype(S::name()), std::string>;
  requires std::convertible_to<decltype(S::summary()), std::string>;

  // Builds over the mesh, in parallel. The result does not depend on the number of threads.
  requires std::default_initializable<typename S::Options>;
  S(mesh, space, options);

  // The cell that holds a point, or HexMesh::noCell: cellAt(point, hint, counts). The hint is asked
  // first, if it is a cell; what is looked at is counted.
  requires std::same_as<decltype(held.cellAt(p)), std::uint32_t>;
  requires std::same_as<decltype(held.cellAt(p, HexMesh::noCell, counts)), std::uint32_t>;

  // Calls visit(CellSpan) for the parts of a ray in cells, in the order of tIn, until it answers
  // false. A cell is told of once for each of its parts. Where keep(ScalarRange) answers false for
  // a region that setRanges() told the range of, its cells are passed over; a range within one that
  // is not kept must not be kept either.
  held.forCellsAlong(ray, visit);
  held.forCellsAlong(ray, visit, keep, counts);

  // Appends cells, some more than once: all that a box in world coordinates meets, and others near
  // to it. See cellsWithin().
  held.gatherWithin(Box(), cells);

  // Takes the ranges of a scalar in every cell, for `keep` above. In parallel; nothing is rebuilt.
  made.setRanges(RawVector<ScalarRange>());

  // The mesh; memory without it, and what of that a copy does not share; references to cells, in
  // all and from the largest leaf; how much there is of it, counted when asked.
  requires std::same_as<decltype(held.mesh()), const HexMesh&>;
  requires std::same_as<decltype(held.bytes()), std::size_t>;
  requires std::same_as<decltype(held.ownBytes()), std::size_t>;
  requires std::same_as<decltype(held.references()), std::size_t>;
  requires std::same_as<decltype(held.largestLeaf()), std::size_t>;
  requires std::same_as<decltype(held.shape()), HexStructureShape>;
};

} // namespace mote
