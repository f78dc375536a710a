#include "Scene.h"

#include <algorithm>

namespace mote
{

namespace
{

Box transformed(const Box& local, const Mat4d& toWorld)
{
  Box box;
  for (int corner = 0; !local.empty() && corner < 8; ++corner)
    box.add(transformPoint(toWorld,
      {corner & 1 ? local.upper.x : local.lower.x, corner & 2 ? local.upper.y : local.lower.y,
        corner & 4 ? local.upper.z : local.lower.z}));
  return box;
}

} // namespace

Box worldBounds(const SurfaceObject& object)
{
  return transformed(
    withSurface(object.surface, [](const auto& s) { return s.bounds(); }), object.toWorld);
}

Box Scene::bounds() const
{
  Box all;
  for (const SurfaceObject& object : surfaces)
    all.add(worldBounds(object));
  for (const CloudObject& cloud : clouds)
    all.add(transformed(meshOf(cloud).bounds(), cloud.toWorld));
  return all;
}

Scene Scene::unowned() const
{
  Scene copy = *this;
  for (SurfaceObject& object : copy.surfaces)
  {
    object.surface =
      withSurface(object.surface, [](const auto& s) -> Surface { return s.unowned(); });
    object.occlusion = mote::unowned(object.occlusion);
  }
  for (CloudObject& cloud : copy.clouds)
  {
    cloud.structure = mote::unowned(cloud.structure);
    cloud.field = mote::unowned(cloud.field);
    cloud.walk = mote::unowned(cloud.walk);
    cloud.hidden = mote::unowned(cloud.hidden);
  }
  return copy;
}

double occlusionReach(const Scene& scene)
{
  const double reach = scene.occlusion.reach;
  if (reach > 0.0)
    return reach;
  const Vec3d size = scene.bounds().size();
  return 0.1 * std::max({size.x, size.y, size.z});
}

double typicalRadius(const Scene& scene)
{
  std::vector<FeatureSize> all;
  double section = 0.0;
  for (const SurfaceObject& object : scene.surfaces)
  {
    const double scale = scaleOf(object.toWorld);
    for (const FeatureSize& part :
      withSurface(object.surface, [](const auto& s) { return s.featureSizes(); }))
    {
      all.push_back({scale * part.size, scale * scale * part.section});
      section += all.back().section;
    }
  }
  std::sort(all.begin(), all.end(),
    [](const FeatureSize& a, const FeatureSize& b) { return a.size < b.size; });
  double sum = 0.0;
  for (const FeatureSize& part : all)
    if ((sum += part.section) >= 0.5 * section)
      return part.size;
  return 0.0;
}

double pixelsOfError(const SurfaceObject& object)
{
  return withSurface(object.surface,
    [](const auto& s)
    {
      if constexpr (std::decay_t<decltype(s)>::mayErr)
        return s.pixelsOfError();
      else
        return 0.0;
    });
}

double pixelsOfError(const Scene& scene)
{
  double most = 0.0;
  for (const SurfaceObject& object : scene.surfaces)
    most = std::max(most, pixelsOfError(object));
  return most;
}

} // namespace mote
