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
  bool assumesOcclusion = false; ///< of what nobody asks rays or maps for
};

} // namespace mote
