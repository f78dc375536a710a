#pragma once

#include "../core/StoredArray.h"
#include "BundleFrustum.h"
#include "CartesianSpace.h"
#include "CylindricalSpace.h"
#include "HexField.h"
#include "IsHexStructure.h"

#include <memory>
#include <string>
#include <vector>

namespace mote
{

class BundleSpans;

struct HexBvhOptions
{
  int leafSize = 1; ///< cells that a leaf has at most, at least 1
};

/// A hierarchy of bounds over the coordinates of a space, split by the surface-area heuristic over
/// 16 bins along each coordinate (Wald, "On fast Construction of SAH-based Bounding Volume
/// Hierarchies", 2007), with the areas of Wang, Elshehaly and Cao in (r, theta, h). A cell is in
/// one leaf; bounds that reach over the seam go on above 2 pi. The result does not depend on the
/// number of threads. Copies share all but the ranges of a scalar.
///
/// Functions without a comment do what IsHexStructure says; queries are in HexBvhWalk.h and
/// HexBvhBundle.h.
template <typename Space>
class HexBvh
{
public:
  static std::string name() { return std::string(Space::prefix) + "bvh"; }
  static std::string summary() { return std::string("hierarchy of bounds over ") + Space::axes; }
  using Coordinates = Space;
  using Options = HexBvhOptions;

  HexBvh() = default;
  HexBvh(std::shared_ptr<const HexMesh> mesh, const Space& space, const HexBvhOptions& options);

  const HexMesh& mesh() const { return *mesh_; }
  template <typename Counts = NoCounts>
  std::uint32_t cellAt(
    const Vec3d& p, std::uint32_t hint = HexMesh::noCell, Counts&& counts = {}) const;
  template <typename Visit, typename Keep = KeepAll, typename Counts = NoCounts>
  void forCellsAlong(
    const HexRay& ray, const Visit& visit, const Keep& keep = {}, Counts&& counts = {}) const;
  /// forCellsAlong() for 1 to 64 rays at once, which have their origin or their direction in
  /// common: visit(ray, ValuedSpan) tells each ray's spans in forCellsAlong()'s order, several of a
  /// ray at a time, until it answers false for the ray. Values are of `field`, which may be null
  /// and else has values at points. `spans` is room to work in. False where these rays must go one
  /// at a time; then nothing was told. In HexBvhBundle.h, for Cartesian bounds only.
  template <typename Visit, typename Keep = KeepAll>
  bool forCellsAlongBundle(const HexRay* rays, int count, const BundleFrustum::Sides& sides,
    const HexField* field, BundleSpans& spans, const Visit& visit, const Keep& keep = {}) const;
  void gatherWithin(const Box& box, std::vector<std::uint32_t>& cells) const;
  void setRanges(const RawVector<ScalarRange>& ofCells);

  std::size_t bytes() const;
  std::size_t ownBytes() const { return ranges_.capacity() * sizeof(ScalarRange); }
  std::size_t references() const { return cells_.size(); }
  std::size_t largestLeaf() const;
  HexStructureShape shape() const;

private:
  /// A leaf has `count` cells from `first` on; an inner node, of count 0, the nodes first and
  /// first + 1.
  struct Node
  {
    typename Space::Region region;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  class Builder;

  /// Levels of the tree whose halves are refreshed at a time: 256 pieces of work.
  static constexpr int parallelLevels = 8;

  static void compact(RawVector<Node>& nodes);
  void setRangesBelow(std::uint32_t root, const RawVector<ScalarRange>& ofCells, int levels);

  std::shared_ptr<const HexMesh> mesh_;
  Space space_;
  double size_ = 0.0; ///< of the mesh
  StoredArray<Node> nodes_;
  StoredArray<std::uint32_t> cells_;
  RawVector<ScalarRange> ranges_; ///< of the nodes, or empty
};

using CartesianBvh = HexBvh<CartesianSpace>;
using CylindricalBvh = HexBvh<CylindricalSpace>;

} // namespace mote
