#pragma once

#include <kernels/core/Box.h>
#include <kernels/core/RawVector.h>
#include <kernels/core/RayBundle.h>
#include <kernels/core/RayPacket.h>
#include <kernels/meshes/RlodTree.h>
#include <kernels/meshes/TriangleMesh.h>
#include <kernels/meshes/detail/RlodPlanes.h>

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace mote::bench
{

/// A node of a kd-tree, in 8 bytes. Children lie side by side.
struct RlodPaperNode
{
  std::uint32_t link; ///< 2 bits: the axis of the splitting plane, 3 for leaves; 30 bits: see below
  std::uint32_t value; ///< where the plane is, a float's bits; of leaves how many triangles

  static RlodPaperNode inner(int axis, float split, std::size_t children)
  {
    return {static_cast<std::uint32_t>(children << 2 | unsigned(axis)),
      std::bit_cast<std::uint32_t>(split)};
  }
  static RlodPaperNode leaf(std::size_t first, std::size_t count)
  {
    return {static_cast<std::uint32_t>(first << 2 | 3U), static_cast<std::uint32_t>(count)};
  }
  bool isLeaf() const { return (link & 3U) == 3U; }
  int axis() const { return static_cast<int>(link & 3U); }
  float split() const { return std::bit_cast<float>(value); }
  /// The lower child, whose neighbour is the upper one; of leaves the first of their references.
  std::uint32_t first() const { return link >> 2; }
};
static_assert(sizeof(RlodPaperNode) == 8);

/// A plane that stands for what a node holds of its triangles.
struct RlodPaperPlane
{
  float normal[3], offset;
  float low[3], high[3];  ///< extents of the clipped triangles
  float spread;           ///< root of the smallest eigenvalue: deviation from the plane, on average
  float deviation;        ///< and at most
  std::uint32_t triangle; ///< that speaks for all

  static constexpr std::uint32_t none = (1U << RlodWords::indexBits) - 1; ///< index of no plane
};

/// All that casting reads; coordinates are those of the mesh.
struct RlodPaperArrays
{
  RawVector<RlodPaperNode> nodes;
  RawVector<std::uint32_t> references; ///< of leaves to triangles
  RawVector<std::array<Vec3f, 3>> triangles;
  RawVector<std::uint32_t> ids; ///< their places in the input
  RawVector<RlodPaperPlane> planes;
  RawVector<std::uint32_t> words; ///< of nodes: 5 bits of error radius, 27 bits of plane; or empty
  ErrorLevels levels;
  Vec3f lower{0.0f}, upper{0.0f}; ///< of all triangles
};

/// The structure of R-LODs as it was published, which the RlodTree is measured by: a kd-tree built
/// by the surface-area heuristic with splits that cut off empty space, triangles being clipped to
/// boxes before they are counted, with a plane that stands for the triangles at every third level
/// of its inner nodes. Rays are cast one by one, or 16 at a time by SIMD.
///
/// Source: Yoon, Lauterbach, Manocha, "R-LODs: Fast LOD-based Ray Tracing of Massive Models", The
/// Visual Computer 22 (2006). See docs/triangles.md. What functions without a comment do, those of
/// RlodTree say.
class RlodPaperTree
{
public:
  /// Which rays meet a plane: those that do so in the extents expanded by the spread, as published;
  /// or as in RlodTree those that come within the greatest deviation in the extents.
  enum class Rule : std::uint8_t
  {
    Published,
    Clamped
  };

  void build(const TriangleMesh& mesh);
  void makeLods();
  void setRule(Rule rule) { rule_ = rule; }

  bool hasLods() const { return !arrays_.words.empty(); }
  std::size_t size() const { return arrays_.ids.size(); }
  std::size_t nodeCount() const { return arrays_.nodes.size(); }
  std::size_t bytes() const;
  double unit() const { return unit_; }
  const Vec3d& origin() const { return origin_; }
  const RlodPaperArrays& arrays() const { return arrays_; }

  struct Counts
  {
    std::uint64_t nodes = 0, triangles = 0, lods = 0;
    /// Which these were; each empty, or as long as there are.
    std::vector<bool> seenNodes, seenPlanes, seenTriangles;
  };
  /// `together`: how many rays go through the tree together, 1 or 16.
  static constexpr int packetRays = 16;
  void cast(
    RayBundle& bundle, std::int32_t object, double poe = 0.0, int together = packetRays) const;
  void cast(
    RayPacket& packet, std::int32_t object, double poe = 0.0, int together = packetRays) const;
  void cast(RayBundle& bundle, std::int32_t object, double poe, int together, Counts& counts) const;
  void occlude(RayBundle& bundle, std::int32_t object, int together = packetRays) const;
  void occlude(RayPacket& packet, std::int32_t object, int together = packetRays) const;

  /// Slots are indices of triangles in the tree's own order, or of planes with RlodTree's bit.
  static bool isLod(std::uint64_t slot) { return RlodTree::isLod(slot); }
  std::vector<std::uint64_t> lodSlots() const;
  std::vector<std::uint64_t> slotsBelow(std::uint64_t slot) const;
  std::uint64_t inputIndex(std::uint64_t slot) const;
  std::array<Vec3f, 3> localCorners(std::uint64_t slot) const;
  Vec3f normal(std::uint64_t slot) const;
  void normals(const std::uint64_t* slots, int count, float* const normals[3]) const;
  void inputIndices(const std::uint64_t* slots, int count, std::uint64_t* indices) const;
  const RlodPaperPlane& plane(std::uint64_t slot) const
  {
    return arrays_.planes[slot & ~RlodTree::lodBit];
  }
  float error(std::uint64_t slot) const; ///< of an R-LOD's slot, as it is quantised

private:
  RlodPaperArrays arrays_;
  RawVector<std::uint32_t> planeNodes_; ///< nodes that planes are of: for slotsBelow() alone
  Vec3d origin_{0.0};
  double unit_ = 1.0;
  Rule rule_ = Rule::Published;
};

/// How an RlodPaperTree is asked to cast.
struct RlodPaperCast
{
  int together;
  double poe;
  bool clamped;
  RlodPaperTree::Counts* counts; ///< or none
};

} // namespace mote::bench
