#pragma once

#include "../core/Camera.h"
#include "../core/Progress.h"
#include "../core/RawVector.h"
#include "../core/RayBundle.h"
#include "../core/RayPacket.h"
#include "NearParticle.h"
#include "ParticleRanges.h"
#include "ParticleSet.h"
#include "PkdTree.h"

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <vector>

namespace mote
{

/// How a PkdPaperTree is built.
struct PkdPaperTreeOptions
{
  PkdTreeOptions::Split split = PkdTreeOptions::Split::MaximumExtent;
  bool keepIndices = true; ///< keep the way back to the input index: 4 or 8 bytes a particle
};

/// The P-k-d tree as it was published: a left-balanced k-d tree whose nodes are the particles,
/// in heap order and without pointers, cast through ray by ray.
///
/// The children of particle i are the particles 2i + 1 and 2i + 2; a plane through its centre,
/// across an axis that two bits name, parts those below it. Spheres reach over the plane by the
/// largest radius below the node, which is known of the topmost nodes and of each treelet of up to
/// 4095 particles. The axes have an array of their own: in the low bits of a coordinate, where the
/// authors put them, they would change the order that the tree relies on.
///
/// It is what the PkdTree is measured by: simple, small, and not fast. Coordinates are float
/// relative to the middle of the set; rays are cast in double.
///
/// Source: Wald, Knoll, Johnson, Usher, Pascucci, Papka, "CPU Ray Tracing Large Particle Data with
/// Balanced P-k-d Trees", IEEE Vis 2015; the traversal is its Algorithm 2.
class PkdPaperTree
{
public:
  /// Builds over `particles`, in parallel, and forgets what was there, ranges and visibility
  /// included; memory is reused. Takes little memory besides what it leaves. Throws Error for a
  /// malformed set (see examine()); stops early, leaving the tree empty, when `progress` answers
  /// false. The result does not depend on the number of threads.
  void build(const ParticleSet& particles, const PkdPaperTreeOptions& options = {},
    const Progress& progress = {});

  /// Finds for each ray the nearest hit with tMin < t < its t, and where there is one writes t,
  /// slot and `object`. Of coincident spheres the one with the smallest input index is hit. A ray
  /// that starts inside a sphere hits its far side. Thread-safe.
  void cast(RayPacket& packet, std::int32_t object) const;
  void cast(RayBundle& bundle, std::int32_t object) const;

  /// Looks for anything between the ends of the rays: t of each ray that meets a sphere with tMin <
  /// t < its t becomes -infinity. What the ray starts or ends on does not count: the particle
  /// `slot`, where the ray's `object` is this one. slot and object stay as they are. Thread-safe.
  void occlude(RayPacket& packet, std::int32_t object) const;
  void occlude(RayBundle& bundle, std::int32_t object) const;

  /// Side in pixels of the bundles that are cast fastest: rays are cast one by one, and any will
  /// do.
  int bundleSide(const CameraRays&, int, int, int) const { return 16; }

  /// Keeps up to four attributes for setRanges(), in float, 16 bytes a particle; none forgets
  /// them. `attributes` are in input order and need kept indices; nothing is viewed after the call.
  /// Throws Error where an attribute has not one tuple a particle of the input.
  void setAttributes(const std::vector<ParticleAttribute>& attributes);

  /// Shows only the particles with all values in range, besides what setVisibility() hides. A
  /// change looks at every particle, in parallel, and keeps a bit for each. Rays still pass by what
  /// is hidden. Attributes compare as float: limits are rounded inwards, so that for values that
  /// are float the answer is exact.
  void setRanges(const ParticleRanges& ranges);

  /// Shows only the particles whose slots `shown` accepts, without a rebuild; called from several
  /// threads. An empty function shows all again.
  void setVisibility(const std::function<bool(std::size_t slot)>& shown);

  /// Whether visibility and ranges leave the particle at `slot` shown.
  bool isShown(std::size_t slot) const
  {
    return shown_.empty() || (shown_[slot / 64] >> (slot % 64) & 1) != 0;
  }
  /// Adds to `found` the shown particles whose spheres come closer to `point`, in the input's
  /// coordinates, than `distance`, in no special order. Thread-safe.
  void findNear(const Vec3d& point, double distance, std::vector<NearParticle>& found) const;

  std::size_t size() const { return count_; }
  const ParticleStatistics& statistics() const { return statistics_; }
  const Vec3d& origin() const { return origin_; }
  double unit() const { return unit_; }
  /// Centre (in the input's coordinates) and radius of the particle at `slot`, as stored: rounded
  /// to float relative to origin().
  Vec3d center(std::size_t slot) const
  {
    return origin_ + unit_ * Vec3d(number(slot, 0), number(slot, 1), number(slot, 2));
  }
  double radius(std::size_t slot) const { return unit_ * double(storedRadius(slot)); }
  /// Index in the input of the particle at `slot`; the slot itself where indices were not kept.
  std::uint64_t inputIndex(std::size_t slot) const;
  /// Memory of the structure and of the particles stored in it.
  std::size_t bytes() const;

  /// Axis of the plane through the particle at `slot`, which has a child.
  int axis(std::size_t slot) const { return axes_[slot / 4] >> (2 * (slot % 4)) & 3; }

private:
  friend struct PkdPaperTreeBuilder;
  template <bool ANY>
  friend class PkdPaperRay;

  void clear();
  void findShown();
  template <bool ANY, typename Rays, typename Place>
  void castRays(Rays& rays, std::int32_t object, const Place& place) const;

  float number(std::size_t slot, std::size_t k) const
  {
    return std::bit_cast<float>(words_[slot * wordsAParticle_ + k]);
  }
  float storedRadius(std::size_t slot) const { return ownRadii_ ? number(slot, 3) : radius_; }

  ParticleStatistics statistics_;
  Vec3d origin_{0.0};
  double unit_ = 1.0;   ///< a power of two: scaling by it rounds nothing
  float radius_ = 0.0f; ///< the largest, in unit(), and of all particles where they keep none
  bool ownRadii_ = false;
  std::size_t indexWords_ = 0;
  std::size_t wordsAParticle_ = 3; ///< x, y, z, the radius, the index's upper half, the lower
  std::size_t count_ = 0;
  RawVector<std::uint32_t> words_;
  RawVector<std::uint8_t> axes_; ///< four nodes a byte, of those that have children
  /// The largest radius in the subtree of each of the topmost nodes, of which the lowest are the
  /// roots of treelets; the first only where radii are all the same.
  RawVector<float> subtreeRadius_;

  // What is shown.
  ParticleRanges ranges_;
  RawVector<std::array<float, 4>> values_; ///< attributes by slot, or empty
  RawVector<std::uint64_t> visible_;       ///< a bit a particle, or empty: all are
  RawVector<std::uint64_t> shown_;         ///< the same, of what ranges leave
};

} // namespace mote
