#include "SceneRays.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace mote
{

Box Scene::bounds() const
{
  Box all;
  const auto add = [&](const Box& local, const Mat4d& toWorld)
  {
    for (int corner = 0; !local.empty() && corner < 8; ++corner)
      all.add(transformPoint(toWorld,
        {corner & 1 ? local.upper.x : local.lower.x, corner & 2 ? local.upper.y : local.lower.y,
          corner & 4 ? local.upper.z : local.lower.z}));
  };
  for (const ParticleObject& object : particles)
    add(withStructure(*object.structure, [](const auto& s) { return s.statistics().bounds; }),
      object.toWorld);
  for (const VolumeObject& volume : volumes)
    add(withStructure(*volume.structure, [](const auto& s) { return s.mesh().bounds(); }),
      volume.toWorld);
  return all;
}

double typicalRadius(const Scene& scene)
{
  constexpr std::size_t most = 512;               // of an object: each is a miss of the cache
  std::vector<std::pair<double, double>> samples; // radius, and the cross-section it stands for
  double all = 0.0;
  for (const ParticleObject& object : scene.particles)
    withStructure(*object.structure,
      [&](const auto& s)
      {
        const double scale = std::cbrt(std::abs(glm::determinant(Mat3d(object.toWorld))));
        const std::size_t count = std::min(s.size(), most);
        for (std::size_t k = 0; k < count; ++k)
        {
          const double radius = scale * s.radius(k * s.size() / count);
          samples.emplace_back(radius, radius * radius * double(s.size()) / double(count));
          all += samples.back().second;
        }
      });
  std::sort(samples.begin(), samples.end());
  double sum = 0.0;
  for (const auto& [radius, section] : samples)
    if ((sum += section) >= 0.5 * all)
      return radius;
  return 0.0;
}

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
  SceneRays(scene, Vec3d(0.0)).cast(packet);
  if (packet.object[0] < 0)
    return std::nullopt;

  ScenePick found;
  found.object = static_cast<std::size_t>(packet.object[0]);
  found.t = packet.t[0];
  found.position = origin + found.t * direction;
  const ParticleObject& object = scene.particles[found.object];
  const Mat4d toLocal = glm::inverse(object.toWorld);
  withStructure(*object.structure,
    [&](const auto& s)
    {
      found.particle = s.inputIndex(packet.slot[0]);
      const Vec3d local = transformPoint(toLocal, found.position) - s.center(packet.slot[0]);
      found.normal = glm::normalize(glm::transpose(Mat3d(toLocal)) * local);
    });
  return found;
}

} // namespace mote
