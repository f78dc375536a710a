#pragma once

#include "../core/SurfaceKind.h"
#include "ParticleStructure.h"

#include <memory>

namespace mote
{

/// Particles as spheres: a SurfaceKind. Slots are those of the structure, ids the indices of the
/// input, and colours go by these too. Spheres are solids that are lit on both sides: whoever
/// stands inside one sees it lit from within.
class ParticleSurface
{
public:
  static constexpr bool isConvex = true;
  static constexpr bool mayMixColors = false;
  static constexpr bool mayErr = false;

  ParticleSurface() = default; ///< of no structure; to be given one before it is used
  explicit ParticleSurface(std::shared_ptr<const ParticleStructure> structure)
    : structure_(std::move(structure))
  {
  }

  const std::shared_ptr<const ParticleStructure>& structure() const { return structure_; }

  Box bounds() const;
  double rounding() const;
  void cast(RayBundle& rays, std::int32_t index) const;
  void cast(RayPacket& rays, std::int32_t index) const;
  void occlude(RayBundle& rays, std::int32_t index) const;
  void occlude(RayPacket& rays, std::int32_t index) const;
  int bundleSide(const CameraRays& rays, int x0, int y0, int size) const;
  void fetch(HitBlock& block) const;
  void place(HitBlock& block, const HitPlacing& placing) const;
  Vec3d normalAt(std::uint64_t slot, const Vec3d& point) const;
  bool encloses(std::uint64_t slot, const Vec3d& point) const;
  void colorIndices(const std::uint64_t* slots, int count, std::uint64_t* indices) const
  {
    this->inputIds(slots, count, indices);
  }
  void inputIds(const std::uint64_t* slots, int count, std::uint64_t* ids) const;
  std::size_t slots() const;
  std::vector<FeatureSize> featureSizes() const;

  ParticleSurface unowned() const { return ParticleSurface(mote::unowned(structure_)); }
  bool operator==(const ParticleSurface&) const = default;

private:
  std::shared_ptr<const ParticleStructure> structure_;
};

static_assert(SurfaceKind<ParticleSurface>);

} // namespace mote
