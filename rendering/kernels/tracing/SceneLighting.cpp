#include "detail/SceneLighting.h"

#include <algorithm>

namespace mote
{

std::vector<ShadedLight> shadedLights(const Scene& scene, const Vec3d& reference, int filmSample)
{
  std::vector<ShadedLight> lights;
  const auto casts = [](const Light& l) { return l.shadows && l.kind != Light::Kind::Headlight; };
  const bool anyShadows = std::any_of(scene.lights.begin(), scene.lights.end(), casts);
  const Vec3d middle = anyShadows ? scene.bounds().center() : Vec3d(0.0);
  for (const Light& light : scene.lights)
  {
    ShadedLight shaded;
    shaded.samples = lightSamples(light, middle, filmSample);
    if (shaded.samples.empty() || light.color == Vec3f(0.0f))
      continue;
    if (light.kind == Light::Kind::Point)
      for (LightSample& sample : shaded.samples)
        sample.place -= reference;
    shaded.color = light.color / static_cast<float>(shaded.samples.size());
    shaded.shadows = casts(light);
    lights.push_back(std::move(shaded));
  }
  return lights;
}

SceneLighting::SceneLighting(const Scene& scene, const Vec3d& reference, int filmSample)
  : lights(shadedLights(scene, reference, filmSample))
  , assumesOcclusion(scene.occlusion.isAssumed && scene.occlusion.rays <= 0)
{
  const bool anyShadows =
    std::any_of(lights.begin(), lights.end(), [](const auto& light) { return light.shadows; });
  const bool anyOcclusion = scene.occlusion.rays > 0;
  if (anyShadows || anyOcclusion)
    rays.emplace(scene, reference);
  if (anyShadows)
    shadows.emplace(*rays);
  if (anyOcclusion)
    occlusion.emplace(*rays, filmSample);
}

} // namespace mote
