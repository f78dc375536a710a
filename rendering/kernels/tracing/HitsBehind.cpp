#include "detail/HitsBehind.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace mote
{

namespace
{

void put(const SceneRays& scene, const PassingRay& ray, RayPacket& packet)
{
  const int k = packet.count++;
  for (int axis = 0; axis < 3; ++axis)
  {
    packet.origin[axis][k] = ray.origin[axis];
    packet.direction[axis][k] = ray.direction[axis];
  }
  // Rounding must not let the ray meet again where it stands, for ever: steps that double leave it.
  // Convex things are known again by their slot, once at their far side; what touches them there
  // must not be passed over.
  const bool isConvex = withSurface(scene.surface(ray.object).surface,
    [](const auto& s) { return std::decay_t<decltype(s)>::isConvex; });
  packet.tMin[k] = ray.t;
  if (!isConvex || ray.again > 2)
    packet.tMin[k] += std::ldexp(
      scene.rounding(ray.object) / glm::length(ray.direction), std::max(0, ray.again - 3));
  packet.t[k] = ray.limit;
  packet.slot[k] = RayPacket::noHit;
  packet.object[k] = -1;
}

/// Takes a hit to the ray. False where it has been there before, and goes on.
bool take(const SceneRays& scene, const RayPacket& packet, int k, PassingRay& ray)
{
  ray.object = packet.object[k];
  if (ray.object < 0)
    return true;
  const double gained = (packet.t[k] - ray.t) * glm::length(ray.direction);
  ray.again = gained > scene.rounding(ray.object) ? 0 : ray.again + 1;
  ray.t = packet.t[k];
  ray.slot = packet.slot[k];
  const std::pair hit(ray.object, ray.slot);
  if (std::find(ray.passed.rbegin(), ray.passed.rend(), hit) != ray.passed.rend())
    return false;
  ray.passed.push_back(hit);
  return true;
}

} // namespace

void findNextHits(
  const SceneRays& scene, std::vector<PassingRay>& rays, double footprint, double footprintPerT)
{
  std::vector<PassingRay*> waiting;
  for (PassingRay& ray : rays)
    waiting.push_back(&ray);
  RayPacket packet;
  packet.footprint = footprint;
  packet.footprintPerT = footprintPerT;
  while (!waiting.empty())
  {
    const auto count = std::min<std::size_t>(waiting.size(), RayPacket::capacity);
    packet.count = 0;
    for (std::size_t k = 0; k < count; ++k)
      put(scene, *waiting[k], packet);
    scene.cast(packet);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < count; ++k)
      if (!take(scene, packet, static_cast<int>(k), *waiting[k]))
        waiting[kept++] = waiting[k];
    waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(kept),
      waiting.begin() + static_cast<std::ptrdiff_t>(count));
  }
}

} // namespace mote
