#include "Picking.h"

#include "detail/HitsBehind.h"
#include "detail/SurfaceShader.h"

namespace mote
{

namespace
{

bool isClear(const SurfaceObject& object, std::uint64_t slot)
{
  const bool mayBe = object.material.opacity == 0.0f || object.coloring.mayBeTransparent();
  return mayBe && object.material.opacity * SurfaceShader(object).colorOf(slot).a == 0.0f;
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
  while (ray.object >= 0 && isClear(rays.surface(ray.object), ray.slot))
    findNextHits(rays, passing);
  if (ray.object < 0)
    return std::nullopt;

  ScenePick found;
  found.object = rays.surface(ray.object).id;
  found.t = ray.t;
  found.position = origin + found.t * direction;
  const Mat4d& toLocal = rays.toLocal(ray.object);
  withSurface(rays.surface(ray.object).surface,
    [&](const auto& s)
    {
      s.inputIds(&ray.slot, 1, &found.id);
      s.colorIndices(&ray.slot, 1, &found.colorIndex);
      const Vec3d normal = glm::transpose(Mat3d(toLocal)) *
                           s.normalAt(ray.slot, transformPoint(toLocal, found.position));
      const double length = glm::length(normal);
      found.normal = length > 0.0 ? normal / length : Vec3d(0.0);
    });
  return found;
}

} // namespace mote
