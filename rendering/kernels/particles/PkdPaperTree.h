#pragma once

#include "IsParticleStructure.h"
#include "PkdTree.h"
#include "StoredParticles.h"

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <string>
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
/// relative to the middle of the set; rays are cast in double. Functions without a comment do what
/// IsParticleStructure says.
///
/// Source: Wald, Knoll, Johnson, Usher, Pascucci, Papka, "CPU Ray Tracing Large Particle Data with
/// Balanced P-k-d Trees", IEEE Vis 2015; the traversal is its Algorithm 2.
class PkdPaperTree : public StoredParticles
{
public:
  static std::string name() { return "pkd-paper"; }
  using Options = PkdPaperTreeOptions;

  /// Takes little memory besides what it leaves.
  void build(const ParticleSet& particles, const PkdPaperTreeOptions& options = {},
    const Progress& progress = {});
  void cast(RayPacket& packet, std::int32_t object) const;
  void cast(RayBundle& bundle, std::int32_t object) const;
  void occlude(RayPacket& packet, std::int32_t object) const;
  void occlude(RayBundle& bundle, std::int32_t object) const;
  /// Rays are cast one by one: any side will do.
  int bundleSide(const CameraRays&, int, int, int) const { return 16; }

  /// Takes 16 bytes a particle.
  void setAttributes(const std::vector<ParticleAttribute>& attributes);
  /// Looks at every particle, in parallel, and keeps a bit for each. Rays still pass by what is
  /// hidden.
  void setRanges(const ParticleRanges& ranges);
  void setVisibility(const std::function<bool(std::size_t slot)>& shown);
  bool isShown(std::size_t slot) const
  {
    return shown_.empty() || (shown_[slot / 64] >> (slot % 64) & 1) != 0;
  }
  std::size_t shownCount() const;
  void findNear(const Vec3d& point, double distance, std::vector<NearParticle>& found) const;

  Vec3d center(std::size_t slot) const
  {
    return origin_ + unit_ * Vec3d(number(slot, 0), number(slot, 1), number(slot, 2));
  }
  double radius(std::size_t slot) const { return unit_ * double(storedRadius(slot)); }
  std::uint64_t inputIndex(std::size_t slot) const;
  std::size_t bytes() const;

  /// Axis of the plane through the particle at `slot`, which has a child.
  int axis(std::size_t slot) const { return axes_[slot / 4] >> (2 * (slot % 4)) & 3; }

private:
  struct Builder;
  template <typename Tree>
  friend struct KdBuilder;
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

  float radius_ = 0.0f; ///< the largest, in unit(), and of all particles where they keep none
  bool ownRadii_ = false;
  int indexWords_ = 0;
  std::size_t wordsAParticle_ = 3; ///< x, y, z, the radius, the index's upper half, the lower
  RawVector<std::uint32_t> words_;
  RawVector<std::uint8_t> axes_; ///< four nodes a byte, of those that have children
  /// The largest radius in the subtree of each of the topmost nodes, of which the lowest are the
  /// roots of treelets; the first only where radii are all the same.
  RawVector<float> subtreeRadius_;

  // What is shown.
  RawVector<std::uint64_t> visible_; ///< a bit a particle, or empty: all are
  RawVector<std::uint64_t> shown_;   ///< the same, of what ranges leave
};

} // namespace mote
