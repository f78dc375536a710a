#pragma once

#include "Cloud.h"
#include "Surface.h"

#include <vector>

namespace mote
{

/// Rays that find how much of an even sky the surfaces see, where no maps tell it; see
/// docs/ambient-occlusion.md. Without such rays surfaces that no map knows see all of it, or where
/// it is assumed as much as they see in the mean in dense sets.
struct OcclusionOptions
{
  static constexpr int mostRays = 4096;
  int rays = 0;           ///< a hit, for each sample of a film, up to mostRays; 0 or less: none
  double reach = 0.0;     ///< world units that a ray goes, or infinity; 0 or less: occlusionReach()
  bool isAssumed = false; ///< where there are no rays

  bool operator==(const OcclusionOptions&) const = default;
};

/// Light by way of other surfaces, along paths; see PathTracer.
struct PathOptions
{
  /// Surfaces that light comes by before it reaches the camera, at most; 0: no paths, shading is
  /// local. 1 is light straight from sky and lights.
  int bounces = 0;

  bool operator==(const PathOptions&) const = default;
};

/// All that is traced into one image, in world coordinates. Surfaces are what a ray hits, clouds
/// what it goes through. Two scenes that are equal look the same; see SurfaceObject::revision.
struct Scene
{
  std::vector<SurfaceObject> surfaces;
  std::vector<CloudObject> clouds;
  std::vector<Light> lights = std::vector<Light>(1); ///< a headlight to begin with
  OcclusionOptions occlusion;                        ///< of the ambient light
  PathOptions paths;                                 ///< instead of local shading
  Sky sky;                                           ///< that paths end in
  /// Where clouds change so little from pixel to pixel that interpolation is right to within this,
  /// in [0, 1] of a colour, not every pixel is traced; see CloudSquare. 0: every pixel is.
  double cloudTolerance = 0.0;

  /// Of all objects; the bounds of a transformed object enclose its transformed box.
  Box bounds() const;

  bool operator==(const Scene&) const = default;
  /// A scene that equals this one and keeps no data alive: to be compared, not traced.
  Scene unowned() const;
};

/// Bounds in the world that enclose a surface's transformed box.
Box worldBounds(const SurfaceObject& object);

/// The reach in world units that the scene's options mean: a tenth of the longest side of its
/// bounds where they give none.
double occlusionReach(const Scene& scene);

/// Radius in the world of a typical particle: half of the cross-section of all particles belongs to
/// smaller ones. Of a sample of them; 0 where there are none.
double typicalRadius(const Scene& scene);

/// How many pixels hits of the camera's rays on a surface may lie off, 0 where they are exact; of a
/// scene the most of any.
double pixelsOfError(const SurfaceObject& object);
double pixelsOfError(const Scene& scene);

} // namespace mote
