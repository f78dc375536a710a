#pragma once

#include "../particles/ParticleStructure.h"
#include "../shading/ColorMap.h"
#include "../shading/Light.h"
#include "../shading/OcclusionMaps.h"
#include "Volume.h"

#include <memory>
#include <optional>
#include <vector>

namespace mote
{

/// Where the colour of a particle comes from. Values and colours are views in *input* order, looked
/// up for the particles that are seen and no others.
struct ParticleColoring
{
  Vec4f constant{1.0f}; ///< where there are neither values nor direct colours
  ArrayView values;     ///< looked up in `map` where not empty
  int component = 0;    ///< of `values`, or ArrayView::magnitude
  ColorMap map;
  ArrayView direct; ///< 8-bit grey, grey+alpha, RGB or RGBA where not empty: used as they are
};

/// Particles placed in a scene.
struct ParticleObject
{
  std::shared_ptr<const ParticleStructure> structure;
  Mat4d toWorld{1.0}; ///< affine; spheres become ellipsoids where it scales unevenly
  ParticleColoring coloring;
  Material material;
  /// By slot of the structure, or null. Local shading takes the ambient light from them in place of
  /// rays; see OcclusionOptions for what has no map.
  std::shared_ptr<const OcclusionMaps> occlusion;
};

/// Rays that find how much of an even sky the surfaces see, where no maps of the particles tell it;
/// see docs/ambient-occlusion.md. Without such rays surfaces that no map knows see all of it.
struct OcclusionOptions
{
  static constexpr int mostRays = 4096;
  int rays = 0;       ///< a hit, for each sample of a film, up to mostRays; 0 or less: none
  double reach = 0.0; ///< world units that a ray goes, or infinity; 0 or less: occlusionReach()
};

/// Light by way of other surfaces, along paths; see PathTracer.
struct PathOptions
{
  /// Surfaces that light comes by before it reaches the camera, at most; 0: no paths, shading is
  /// local. 1 is light straight from sky and lights.
  int bounces = 0;
};

/// All that is traced into one image, in world coordinates.
struct Scene
{
  std::vector<ParticleObject> particles;
  std::vector<VolumeObject> volumes; ///< numbered after the particles in Film::object()
  std::vector<Light> lights = std::vector<Light>(1); ///< a headlight to begin with
  OcclusionOptions occlusion;                        ///< of the ambient light
  PathOptions paths;                                 ///< instead of local shading
  Sky sky;                                           ///< that paths end in
  /// Where clouds change so little from pixel to pixel that interpolation is right to within this,
  /// in [0, 1] of a colour, not every pixel is traced; see CloudSquare. 0: every pixel is.
  double cloudTolerance = 0.0;

  /// Of all objects; the bounds of a transformed object enclose its transformed box.
  Box bounds() const;
};

/// Radius in the world of a typical particle: half of the cross-section of all particles belongs to
/// smaller ones. Of a sample of them; 0 where there are none.
double typicalRadius(const Scene& scene);

/// What one ray meets first.
struct ScenePick
{
  std::size_t object = 0;     ///< index in Scene::particles
  std::uint64_t particle = 0; ///< input index
  double t = 0.0;             ///< in lengths of the direction given
  Vec3d position{0.0};
  Vec3d normal{0.0}; ///< unit length, outwards
};

/// Casts one ray. `direction` may have any length but 0.
std::optional<ScenePick> pick(const Scene& scene, const Vec3d& origin, const Vec3d& direction,
  double tMin = 0.0, double tMax = std::numeric_limits<double>::infinity());

} // namespace mote
