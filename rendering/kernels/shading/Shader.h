#pragma once

#include "AmbientOcclusion.h"
#include "ShadowCaster.h"

#include <optional>
#include <vector>

namespace mote
{

/// A light of the scene as its samples, their places counted from the tracer's reference point.
struct ShadedLight
{
  std::vector<LightSample> samples;
  Vec3f color{1.0f}; ///< of one sample
  bool shadows = false;
};

/// The lights of a scene that light anything, for one sample of a film.
std::vector<ShadedLight> shadedLights(const Scene& scene, const Vec3d& reference, int filmSample);

/// All that lights a scene in one sample of a film.
struct SceneLighting
{
  /// `reference` is the point in the world that positions count from. The scene must outlive this.
  SceneLighting(const Scene& scene, const Vec3d& reference, int filmSample);
  SceneLighting(const SceneLighting&) = delete;
  SceneLighting& operator=(const SceneLighting&) = delete;

  std::vector<ShadedLight> lights;
  std::optional<SceneRays> rays; ///< where shadows or occlusion cast any
  std::optional<ShadowCaster> shadows;
  std::optional<AmbientOcclusion> occlusion;
};

/// Lights a block that is placed: fills everything that is left. Positions must be filled where
/// needsPositions() says so, seeds where the lighting has occlusion; `footprint` is as in
/// ShadowCaster::remove(). `shares` are open shares of the sky that maps tell, a hit each, NaN
/// where they know nothing; null: where they know nothing of any. What is unknown is filled.
void lightSurfaces(SurfaceBlock& block, const Material& material, const SceneLighting& lighting,
  double footprint, float* shares = nullptr);
bool needsPositions(const Material& material, const SceneLighting& lighting);

/// Where the rays of a bundle run.
struct BundlePlacing
{
  const RayBundle& local; ///< in the coordinates of the object that is shaded
  const RayBundle& world; ///< in the world
  Vec3d worldOrigin{0.0}; ///< of `world`, from the reference point
  double footprint = 0.0; ///< as in ShadowCaster::remove()
};

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

  /// Shades what gather() took: fills everything that the block holds. Input indices are filled
  /// where `indices`, or the colours, ask for them; seeds must be filled where the lighting has
  /// occlusion.
  void shade(SurfaceBlock& block, const BundlePlacing& placing, const SceneLighting& lighting,
    bool indices) const;

  /// What shade() does before any light: fills colours, normals, sides and, where asked for,
  /// positions.
  void place(SurfaceBlock& block, const BundlePlacing& placing, bool positions, bool indices) const;

  /// Colour of the particle at a slot of the structure.
  Vec4f colorOf(std::uint64_t slot) const;

  /// Unit normal in the world, outwards, of that particle at a point in the object's coordinates.
  Vec3f normalAt(std::uint64_t slot, const Vec3d& local) const;

private:
  void lookUpShares(const SurfaceBlock& block, const OcclusionLookUp& found, float* shares) const;
  bool usesMaps() const { return object_.occlusion && object_.material.ambient > 0.0f; }
  void fillColors(const std::uint64_t* particles, int count, float (*colors)[4]) const;
  bool needsIndices() const;

  const ParticleObject& object_;
  glm::mat3 normalToWorld_{1.0f};
  glm::mat3 normalToLocal_{1.0f}; ///< times any factor
  bool isIdentity_ = false;
};

} // namespace mote
