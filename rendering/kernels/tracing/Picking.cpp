#include "Picking.h"

#include "detail/SceneRays.h"

namespace mote
{

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
  const std::int32_t index = packet.object[0];
  if (index < 0)
    return std::nullopt;

  ScenePick found;
  found.object = rays.surface(index).id;
  found.t = packet.t[0];
  found.position = origin + found.t * direction;
  const Mat4d& toLocal = rays.toLocal(index);
  withSurface(rays.surface(index).surface,
    [&](const auto& s)
    {
      s.inputIds(packet.slot, 1, &found.id);
      s.colorIndices(packet.slot, 1, &found.colorIndex);
      const Vec3d normal = glm::transpose(Mat3d(toLocal)) *
                           s.normalAt(packet.slot[0], transformPoint(toLocal, found.position));
      const double length = glm::length(normal);
      found.normal = length > 0.0 ? normal / length : Vec3d(0.0);
    });
  return found;
}

} // namespace mote
