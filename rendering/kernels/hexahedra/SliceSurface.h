#pragma once

#include "../core/SurfaceKind.h"
#include "HexField.h"
#include "HexStructure.h"
#include "HiddenCells.h"

#include <memory>
#include <vector>

namespace mote
{

class CellFinder;

/// Where a mesh is sliced, in its coordinates.
struct SliceShape
{
  enum class Kind
  {
    Plane,     ///< through `point`, across `axis`
    HalfPlane, ///< that ends at the axis through `point` and goes towards `out`: a meridional plane
    Cylinder,  ///< of `radius` about the axis through `point`
    /// The same cylinder, rolled out onto the plane that touches it towards `out`. There the places
    /// of hits are, while values are those of the cylinder. It goes half a turn to either side.
    Unrolled
  };

  Kind kind = Kind::Plane;
  Vec3d point{0.0};
  Vec3d axis{0.0, 0.0, 1.0}; ///< of any length but 0
  Vec3d out{1.0, 0.0, 0.0};  ///< not along the axis; what of it is across counts
  double radius = 1.0;       ///< above 0

  bool operator==(const SliceShape&) const = default;
};

/// Cells of a mesh where planes and cylinders slice them, with the values of a trilinear field: a
/// SurfaceKind. Nothing is built: each ray is met with the shapes, and the cell is found that holds
/// the place. Slots name shape and cell, ids are cells of the input. Both sides are alike.
/// Where faces of cells lie in a shape, values are those of the cells on the side of its normal.
/// Hits no farther than rounding() behind what a ray has met take its place: slices that lie in
/// walls are seen, where scenes have them behind the walls.
///
/// Edges are where the shapes meet faces of cells; those between the parts that a polyhedron is cut
/// into are none.
class SliceSurface
{
public:
  static constexpr bool isConvex = false;
  static constexpr bool mayMixColors = false;
  static constexpr bool hasValues = true;
  static constexpr bool hasEdges = true;
  static constexpr bool mayErr = false;

  SliceSurface() = default; ///< of no structure
  /// The field is on the structure's mesh. Hidden cells, null for none, are not there, nor are
  /// cells with a NaN unless `showsNaN`. Throws Error for more than 2^31 shapes, an axis or a
  /// direction without length, and a radius that is not above 0.
  SliceSurface(std::shared_ptr<const HexStructure> structure, std::shared_ptr<const HexField> field,
    const std::vector<SliceShape>& shapes, std::shared_ptr<const HiddenCells> hidden = nullptr,
    bool showsNaN = false);

  Box bounds() const { return {lower_, upper_}; }
  /// Of what there is to see, as far as the mesh's points tell; takes a look at all of them.
  Box tightBounds() const;
  double rounding() const;
  void cast(RayBundle& rays, std::int32_t index) const;
  void cast(RayPacket& rays, std::int32_t index) const;
  void occlude(RayBundle& rays, std::int32_t index) const;
  void occlude(RayPacket& rays, std::int32_t index) const;
  int bundleSide(const CameraRays&, int, int, int) const { return 16; } ///< rays go one by one
  void fetch(HitBlock&) const {}
  void place(HitBlock& block, const HitPlacing& placing) const;
  Vec3d normalAt(std::uint64_t slot, const Vec3d& point) const;
  bool encloses(std::uint64_t, const Vec3d&) const { return false; }
  void colorIndices(const std::uint64_t* slots, int count, std::uint64_t* indices) const
  {
    this->inputIds(slots, count, indices);
  }
  /// As the user's scalar has them.
  void values(const std::uint64_t* slots, const Vec3d* points, int count, double* values) const;
  void edges(const std::uint64_t* slots, const Vec3d* points, const Vec3d* ways, int count,
    EdgeSeen* found) const;
  void inputIds(const std::uint64_t* slots, int count, std::uint64_t* ids) const;
  std::size_t slots() const { return 0; }
  std::vector<FeatureSize> featureSizes() const { return {}; }

  /// Throws Error for an axis or a direction without length, and a radius that is not above 0.
  static void check(const SliceShape& shape) { framed(shape); }

  /// The place in the mesh that a hit's point stands for: the point itself, but where rolled out.
  Vec3d meshPoint(std::uint64_t slot, const Vec3d& point) const;

  SliceSurface unowned() const;
  bool operator==(const SliceSurface&) const = default;

private:
  /// A shape in axes of unit length, with the third along its axis and the first outwards.
  struct Frame
  {
    SliceShape shape;
    Mat3d axes{1.0};

    bool operator==(const Frame&) const = default;
  };

  /// Where a ray passes a shape.
  struct Meeting
  {
    Vec3d place; ///< in the mesh
    double t;
    int ray;
  };

  static Frame framed(const SliceShape& shape);
  CellFinder finder() const;
  template <typename Rays, typename Take>
  void meetEach(Rays& rays, bool winsTies, const Take& take) const;
  template <typename Rays>
  void castEach(Rays& rays, std::int32_t index) const;
  template <typename Rays>
  void occludeEach(Rays& rays) const;
  template <typename Rays>
  void meetAll(const Frame& frame, const Rays& rays, bool winsTies,
    Meeting (&met)[2][Rays::capacity], int (&counts)[2]) const;
  Box boundsOf(const Frame& frame, double left, double right) const;
  static int meet(const Frame& frame, const Vec3d& origin, const Vec3d& way, double t[2]);
  static bool mayHold(const Frame& frame, const HexCorners& corners, double margin);
  static std::uint32_t cellBeside(
    CellFinder& cells, const Frame& frame, const Vec3d& place, double margin);
  static Vec3d meshPoint(const Frame& frame, const Vec3d& point)
  {
    return frame.shape.kind == SliceShape::Kind::Unrolled ? unrolledPoint(frame, point) : point;
  }
  static Vec3d unrolledPoint(const Frame& frame, const Vec3d& point);
  static Vec3d normalAt(const Frame& frame, const Vec3d& point);
  static Vec3d radial(const Frame& frame, const Vec3d& point);
  static Vec3d unrolled(const Frame& frame, const Vec3d& point, const Vec3d& gradient);
  static std::uint32_t cellOf(std::uint64_t slot) { return static_cast<std::uint32_t>(slot); }
  const Frame& frameOf(std::uint64_t slot) const { return frames_[slot >> 32]; }

  std::shared_ptr<const HexStructure> structure_;
  std::shared_ptr<const HexField> field_;
  std::shared_ptr<const HiddenCells> hidden_; ///< null: none
  std::vector<Frame> frames_;
  bool showsNaN_ = false;
  Vec3d lower_ = Box().lower, upper_ = Box().upper; ///< bounds()
};

static_assert(SurfaceKind<SliceSurface>);

} // namespace mote
