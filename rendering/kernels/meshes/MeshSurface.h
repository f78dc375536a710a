#pragma once

#include "../core/ArrayView.h"
#include "../core/SurfaceKind.h"
#include "RlodTree.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace mote
{

/// What a mesh looks like, besides its shape.
struct MeshLook
{
  /// Normals of the points, three components of any length, for smooth shading; empty: every
  /// triangle is flat. Numbers behind a view must outlive the surface.
  ArrayView normals;
  /// Which points count, triangle by triangle; needed for `normals` and `mixesColors`.
  std::shared_ptr<const MeshCorners> corners;
  /// The cell of the input that each triangle is of, whole numbers; empty: triangles are cells.
  ArrayView cells;
  /// Colours are those of points, mixed where a triangle is hit; else those of cells.
  bool mixesColors = false;
  /// Which sides of each triangle of the input are edges of its cell: bit 0 from the first corner
  /// to the second, 1 to the third, 2 back to the first. Null: all.
  std::shared_ptr<const std::vector<std::uint8_t>> edges;
  /// Pixels of error that rays are allowed which are told how far they lie apart, where the tree
  /// has R-LODs: see RlodTree::cast(). To be 0 where the triangles are not opaque: behind an R-LOD
  /// they would be met once more.
  double poe = 0.0;
  /// Rays of cast() meet triangles from their inner side alone, and pass through the others: to be
  /// looked into. `poe` does not count then. Occlusion rays meet both.
  bool isInner = false;

  bool operator==(const MeshLook&) const = default;
};

/// Triangles as a surface: a SurfaceKind. Slots are those of the tree, ids the cells of the input,
/// and colours go by these or by points. Both sides are alike: normals look at whoever sees them.
///
/// Smooth normals are interpolated between the corners. Where they look away from an eye that the
/// triangle itself faces, near outlines, they look straight across.
class MeshSurface
{
public:
  static constexpr bool isConvex = false;
  static constexpr bool mayMixColors = true;
  static constexpr bool hasValues = false;
  static constexpr bool hasEdges = true;
  static constexpr bool mayErr = true;

  MeshSurface() = default; ///< of no triangles; to be given some before it is used
  explicit MeshSurface(std::shared_ptr<const RlodTree> tree, MeshLook look = {})
    : tree_(std::move(tree))
    , look_(std::move(look))
  {
  }

  Box bounds() const { return tree_->bounds(); }
  double rounding() const;
  double pixelsOfError() const { return tree_->hasLods() && !look_.isInner ? look_.poe : 0.0; }
  double clearance(std::uint64_t slot, double cosine) const;
  std::uint64_t meanPlace(std::uint64_t slot) const
  {
    return RlodTree::isLod(slot) ? RlodTree::lodPlace(slot) : RlodTree::noHit;
  }
  void cast(RayBundle& rays, std::int32_t index) const { this->castRays(rays, index); }
  void cast(RayPacket& rays, std::int32_t index) const { this->castRays(rays, index); }
  void occlude(RayBundle& rays, std::int32_t index) const
  {
    tree_->occlude(rays, index, look_.poe);
  }
  void occlude(RayPacket& rays, std::int32_t index) const
  {
    tree_->occlude(rays, index, look_.poe);
  }
  int bundleSide(const CameraRays&, int, int, int) const { return 16; } ///< docs/triangles.md
  void fetch(HitBlock& block) const;
  void place(HitBlock& block, const HitPlacing& placing) const;
  Vec3d normalAt(std::uint64_t slot, const Vec3d& point) const;
  Vec3d seenNormalAt(std::uint64_t slot, const Vec3d& point, const Vec3d& way) const;
  bool encloses(std::uint64_t, const Vec3d&) const { return false; }
  void colorIndices(const std::uint64_t* slots, int count, std::uint64_t* indices) const
  {
    this->inputIds(slots, count, indices);
  }
  bool mixesColors() const { return look_.mixesColors && look_.corners; }
  void mixColors(const std::uint64_t* slots, const Vec3d* points, int count, ColorMix& mix) const;
  void edges(const std::uint64_t* slots, const Vec3d* points, const Vec3d* ways, int count,
    EdgeSeen* found) const;
  void inputIds(const std::uint64_t* slots, int count, std::uint64_t* ids) const;
  std::size_t slots() const { return 0; }
  std::vector<FeatureSize> featureSizes() const { return {}; }

  MeshSurface unowned() const;
  bool operator==(const MeshSurface&) const = default;

private:
  template <typename Rays>
  void castRays(Rays& rays, std::int32_t index) const
  {
    if (look_.isInner)
      tree_->castInner(rays, index);
    else
      tree_->cast(rays, index, look_.poe);
  }
  bool isSmooth() const { return !look_.normals.empty() && look_.corners; }
  std::array<double, 3> sharesAt(std::uint64_t slot, const Vec3d& point) const;
  MeshCorners::Corners pointsOf(std::uint64_t slot) const
  {
    return (*look_.corners)[tree_->inputIndex(slot)];
  }
  Vec3d smoothNormal(std::uint64_t slot, const Vec3d& point, const Vec3d& flat) const;

  std::shared_ptr<const RlodTree> tree_;
  MeshLook look_;
};

static_assert(SurfaceKind<MeshSurface>);

} // namespace mote
