#include "Picking.h"

#include "detail/HitsBehind.h"
#include "detail/SurfaceShader.h"

#include <algorithm>

namespace mote
{

namespace
{

bool isClear(const SceneRays& rays, const PassingRay& ray)
{
  const SurfaceObject& object = rays.surface(ray.object);
  if (!object.mayBeTransparent())
    return false;
  const Mat4d& toLocal = rays.toLocal(ray.object);
  const Vec3d local = transformPoint(toLocal, ray.origin + ray.t * ray.direction);
  const SurfaceShader shader(object);
  const Vec3d way = transformVector(toLocal, ray.direction);
  return shader.sideOpacity(ray.slot, local, way) * shader.colorOf(ray.slot, local).a == 0.0f;
}

template <typename Kind>
void takeColor(const Kind& surface, std::uint64_t slot, const Vec3d& local, ScenePick& found)
{
  surface.colorIndices(&slot, 1, &found.colorIndex);
  found.colorShares = {};
  found.colorShares[0] = {found.colorIndex, 1.0};
  if constexpr (Kind::hasValues)
    surface.values(&slot, &local, 1, &found.value.emplace());
  if constexpr (Kind::mayMixColors)
    if (surface.mixesColors())
    {
      ColorMix mix;
      surface.mixColors(&slot, &local, 1, mix);
      for (std::size_t k = 0; k < found.colorShares.size(); ++k)
        found.colorShares[k] = {mix.index[k][0], mix.share[k][0]};
      const auto less = [](const auto& a, const auto& b) { return a.second < b.second; };
      found.colorIndex =
        std::max_element(found.colorShares.begin(), found.colorShares.end(), less)->first;
    }
}

} // namespace

std::optional<ScenePick> pick(
  const Scene& scene, const Vec3d& origin, const Vec3d& direction, double tMin, double tMax)
{
  RayPacket packet;
  packet.count = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    packet.origin[axis][0] = origin[axis];
    packet.direction[axis][0] = direction[axis];
  }
  packet.tMin[0] = tMin;
  packet.t[0] = tMax;
  packet.slot[0] = RayPacket::noHit;
  packet.object[0] = -1;
  const SceneRays rays(scene, Vec3d(0.0));
  rays.cast(packet);
  std::vector<PassingRay> passing(1);
  PassingRay& ray = passing.front();
  ray.origin = origin;
  ray.direction = direction;
  ray.limit = tMax;
  ray.object = packet.object[0];
  ray.t = packet.t[0];
  ray.slot = packet.slot[0];
  ray.passed = {{ray.object, ray.slot}};
  while (ray.object >= 0 && isClear(rays, ray))
    findNextHits(rays, passing);
  if (ray.object < 0)
    return std::nullopt;

  ScenePick found;
  found.object = rays.surface(ray.object).id;
  found.along = rays.surface(ray.object).coloring.along;
  found.t = ray.t;
  found.position = origin + found.t * direction;
  const Mat4d& toLocal = rays.toLocal(ray.object);
  const Vec3d local = transformPoint(toLocal, found.position);
  withSurface(rays.surface(ray.object).surface,
    [&](const auto& s)
    {
      s.inputIds(&ray.slot, 1, &found.id);
      takeColor(s, ray.slot, local, found);
      const Vec3d normal = glm::transpose(Mat3d(toLocal)) * s.normalAt(ray.slot, local);
      const double length = glm::length(normal);
      found.normal = length > 0.0 ? normal / length : Vec3d(0.0);
    });
  const double distance = found.t * glm::length(direction);
  if (const auto face = cutFaceAt(rays.surface(ray.object), found.position, distance))
    found.normal = *face;
  return found;
}

} // namespace mote
