#pragma once

#include "../scene/Scene.h"
#include "SurfaceBlock.h"

#include <vector>

namespace mote
{

class ShadowCaster;

/// A light of the scene as its samples, their places counted from the tracer's reference point.
struct ShadedLight
{
  std::vector<LightSample> samples;
  Vec3f color{1.0f}; ///< of one sample
  bool shadows = false;
};

/// The lights of a scene that light anything, for one sample of a film.
std::vector<ShadedLight> shadedLights(const Scene& scene, const Vec3d& reference, int filmSample);

/// Shades hits on the particles of one object by its material, colours and the scene's lights.
/// Spheres are lit on both sides: whoever stands inside one sees it lit from within.
class ParticleShader
{
public:
  /// `object` must stay where it is while the shader lives.
  explicit ParticleShader(const ParticleObject& object);

  /// Takes the hits on object `index` of the bundle into the block. `local` tells where the rays
  /// run in the object's coordinates; rays whose `skipped` is not 0 are left out.
  void gather(const RayBundle& local, std::int32_t index, const std::uint8_t* skipped,
    SurfaceBlock& block) const;

  /// Shades what gather() took: fills everything that the block holds for `world`, the bundle in
  /// world coordinates, `worldOrigin` being its origin from the reference point. Input indices are
  /// filled where `indices`, or the colours, ask for them. `shadows` may be null where no light
  /// casts any; `footprint` as in ShadowCaster::remove().
  void shade(SurfaceBlock& block, const RayBundle& local, const RayBundle& world,
    const Vec3d& worldOrigin, const std::vector<ShadedLight>& lights, const ShadowCaster* shadows,
    double footprint, bool indices) const;

private:
  void fillColors(SurfaceBlock& block) const;

  const ParticleObject& object_;
  glm::mat3 normalToWorld_{1.0f};
  bool isIdentity_ = false;
};

} // namespace mote
