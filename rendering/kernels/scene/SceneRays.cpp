#include "SceneRays.h"

#include <glm/matrix.hpp>

#include <algorithm>

namespace mote
{

SceneRays::SceneRays(const Scene& scene, const Vec3d& reference)
  : scene_(scene)
  , reference_(reference)
{
  const auto round = [this](const Vec3d& size, const Mat4d& toWorld)
  {
    const Mat3d stretch(toWorld);
    rounding_.push_back(
      surfaceError * std::max({size.x, size.y, size.z}) *
      std::max({glm::length(stretch[0]), glm::length(stretch[1]), glm::length(stretch[2])}));
  };
  for (const ParticleObject& object : scene.particles)
  {
    toLocal_.push_back(glm::inverse(object.toWorld));
    round(
      withStructure(*object.structure, [](const auto& s) { return s.statistics().bounds.size(); }),
      object.toWorld);
  }
  for (const VolumeObject& volume : scene.volumes)
    round(withStructure(*volume.structure, [](const auto& s) { return s.mesh().bounds().size(); }),
      volume.toWorld);
}

/// Calls visit(structure, packet, index) for each object, the packet holding the rays in the
/// object's coordinates; their answers come back into `rays`.
template <typename Visit>
void SceneRays::forObjects(RayPacket& rays, const Visit& visit) const
{
  RayPacket local;
  local.count = rays.count;
  std::copy_n(rays.tMin, rays.count, local.tMin);
  std::copy_n(rays.t, rays.count, local.t);
  std::copy_n(rays.slot, rays.count, local.slot);
  std::copy_n(rays.object, rays.count, local.object);
  for (std::size_t k = 0; k < toLocal_.size(); ++k)
  {
    const Mat3d linear(toLocal_[k]);
    const Vec3d origin = transformPoint(toLocal_[k], reference_);
    for (int i = 0; i < rays.count; ++i)
    {
      const Vec3d from =
        origin + linear * Vec3d(rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]);
      const Vec3d way =
        linear * Vec3d(rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]);
      for (int axis = 0; axis < 3; ++axis)
      {
        local.origin[axis][i] = from[axis];
        local.direction[axis][i] = way[axis];
      }
    }
    withStructure(*scene_.particles[k].structure,
      [&](const auto& s) { visit(s, local, static_cast<std::int32_t>(k)); });
  }
  std::copy_n(local.t, rays.count, rays.t);
  std::copy_n(local.slot, rays.count, rays.slot);
  std::copy_n(local.object, rays.count, rays.object);
}

void SceneRays::cast(RayPacket& rays) const
{
  forObjects(rays,
    [](const auto& structure, RayPacket& local, std::int32_t k) { structure.cast(local, k); });
}

void SceneRays::occlude(RayPacket& rays) const
{
  forObjects(rays,
    [](const auto& structure, RayPacket& local, std::int32_t k) { structure.occlude(local, k); });
}

} // namespace mote
