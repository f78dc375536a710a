#pragma once

#include "../core/SurfaceKind.h"
#include "ParticleStructure.h"

#include <memory>

namespace mote
{

/// Particles as spheres: a SurfaceKind. Slots are those of the structure, ids the indices of the
/// input, and colours go by these too. Spheres are solids that are lit on both sides: whoever
/// stands inside one sees it lit from within.
///
/// Boxes that stand for many are lit as spheres are in the mean: as far from the eye as most of
/// what is seen of a sphere looks, and around it as the hit lies around the box's middle.
class ParticleSurface
{
public:
  static constexpr bool isConvex = true;
  static constexpr bool mayMixColors = false;
  static constexpr bool hasValues = false;
  static constexpr bool hasEdges = false;
  static constexpr bool mayErr = true;

  ParticleSurface() = default; ///< of no structure; to be given one before it is used
  /// `poe` is how many pixels of error bundles of a camera are allowed, where the structure has
  /// levels of detail: see PkdTree::cast(). To be 0 where the particles are not opaque, or have
  /// occlusion maps.
  explicit ParticleSurface(std::shared_ptr<const ParticleStructure> structure, double poe = 0.0)
    : structure_(std::move(structure))
    , poe_(poe)
  {
  }

  const std::shared_ptr<const ParticleStructure>& structure() const { return structure_; }

  Box bounds() const;
  double rounding() const;
  double pixelsOfError() const { return levels() != nullptr ? poe_ : 0.0; }
  double clearance(std::uint64_t slot, double cosine) const;
  std::uint64_t meanPlace(std::uint64_t slot) const
  {
    return PkdTree::isLod(slot) ? PkdTree::lodPlace(slot) : RayBundle::noHit;
  }
  void cast(RayBundle& rays, std::int32_t index) const;
  void cast(RayPacket& rays, std::int32_t index) const;
  void occlude(RayBundle& rays, std::int32_t index) const;
  void occlude(RayPacket& rays, std::int32_t index) const;
  int bundleSide(const CameraRays& rays, int x0, int y0, int size) const;
  void fetch(HitBlock& block) const;
  void place(HitBlock& block, const HitPlacing& placing) const;
  Vec3d normalAt(std::uint64_t slot, const Vec3d& point) const;
  Vec3d seenNormalAt(std::uint64_t slot, const Vec3d& point, const Vec3d& way) const;
  bool encloses(std::uint64_t slot, const Vec3d& point) const;
  double largestWidth() const; ///< of anything that may enclose a point
  void colorIndices(const std::uint64_t* slots, int count, std::uint64_t* indices) const
  {
    this->inputIds(slots, count, indices);
  }
  void inputIds(const std::uint64_t* slots, int count, std::uint64_t* ids) const;
  std::size_t slots() const;
  std::vector<FeatureSize> featureSizes() const;

  ParticleSurface unowned() const { return ParticleSurface(mote::unowned(structure_), poe_); }
  bool operator==(const ParticleSurface&) const = default;

private:
  /// The tree where it has levels of detail that hits may be on, else null.
  const PkdTree* levels() const;

  std::shared_ptr<const ParticleStructure> structure_;
  double poe_ = 0.0;
};

static_assert(SurfaceKind<ParticleSurface>);

} // namespace mote
