#include "CastOracle.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mote::testing
{

using reference::Hit;
using reference::Ray;
using reference::Sphere;
using reference::SphereTree;

void CastReport::add(const CastReport& other)
{
  rays += other.rays;
  hits += other.hits;
  wrong += other.wrong;
  if (complaint.empty())
    complaint = other.complaint;
}

namespace
{

std::vector<Sphere> resized(std::vector<Sphere> spheres, double by)
{
  for (Sphere& sphere : spheres)
    sphere.radius += by;
  std::erase_if(spheres, [](const Sphere& sphere) { return !(sphere.radius > 0.0); });
  return spheres;
}

} // namespace

CastOracle::CastOracle(const ParticleSet& particles, double slack)
  : particles_(particles)
  , slack_(slack)
  , exact_(reference::validSpheres(particles))
  , grown_(resized(reference::validSpheres(particles), slack))
  , shrunk_(resized(reference::validSpheres(particles), -slack))
{
}

CastOracle CastOracle::forFloat(const ParticleSet& particles, double share)
{
  Box bounds;
  for (const Sphere& sphere : reference::validSpheres(particles))
  {
    bounds.add(sphere.center - Vec3d(sphere.radius));
    bounds.add(sphere.center + Vec3d(sphere.radius));
  }
  const Vec3d size = bounds.size();
  return CastOracle(particles, share * std::max({size.x, size.y, size.z}));
}

void CastOracle::judge(const Ray& ray, double t, std::size_t particle, CastReport& report) const
{
  ++report.rays;
  const bool isHit = particle != Hit::none;
  report.hits += isHit;
  // From within a sphere a larger one is left later: order the three answers.
  const double infinity = std::numeric_limits<double>::infinity();
  const double answers[3] = {grown_.cast(ray).t, exact_.cast(ray).t, shrunk_.cast(ray).t};
  const auto [low, high] = std::minmax_element(answers, answers + 3);
  const double length = glm::length(ray.direction);
  const double margin = slack_ / length;
  const double answer = isHit ? t : infinity;
  bool right = answer >= *low - margin && answer <= *high + margin;
  double distance = 0.0;
  if (isHit)
  {
    const Vec3d point = (ray.origin - particles_.position(particle)) + t * ray.direction;
    distance = glm::length(point) - particles_.radiusOf(particle);
    right = right && t > ray.tMin && t < ray.tMax && std::abs(distance) <= slack_;
  }
  if (right)
    return;
  ++report.wrong;
  if (!report.complaint.empty())
    return;
  std::ostringstream text;
  text.precision(17);
  text << describe(ray) << ": answered t " << answer << " on particle "
       << static_cast<std::ptrdiff_t>(particle) << " (off its surface by " << distance
       << "); the reference says t " << answers[1] << " on "
       << static_cast<std::ptrdiff_t>(exact_.cast(ray).particle) << ", " << *low << " to " << *high
       << " with a slack of " << slack_;
  report.complaint = text.str();
}

std::string describe(const Ray& ray)
{
  std::ostringstream text;
  text.precision(17);
  text << "ray from " << ray.origin.x << ' ' << ray.origin.y << ' ' << ray.origin.z << " along "
       << ray.direction.x << ' ' << ray.direction.y << ' ' << ray.direction.z << ", t in "
       << ray.tMin << " to " << ray.tMax;
  return text.str();
}

Ray rayOf(const RayPacket& packet, int i)
{
  return {{packet.origin[0][i], packet.origin[1][i], packet.origin[2][i]},
    {packet.direction[0][i], packet.direction[1][i], packet.direction[2][i]}, packet.tMin[i],
    packet.t[i]};
}

Ray rayOf(const RayBundle& bundle, int i)
{
  return {bundle.originOf(i), bundle.directionOf(i), bundle.tMin, bundle.t[i]};
}

RayPacket emptyPacket()
{
  RayPacket packet = {};
  packet.count = 0;
  return packet;
}

void addRay(
  RayPacket& packet, const Vec3d& origin, const Vec3d& direction, double tMin, double tMax)
{
  const int i = packet.count++;
  for (int axis = 0; axis < 3; ++axis)
  {
    packet.origin[axis][i] = origin[axis];
    packet.direction[axis][i] = direction[axis];
  }
  packet.tMin[i] = tMin;
  packet.t[i] = tMax;
  packet.slot[i] = RayPacket::noHit;
  packet.object[i] = -1;
}

Camera lookAt(const Vec3d& eye, const Vec3d& target, double viewAngle)
{
  Camera camera;
  camera.position = eye;
  camera.forward = target - eye;
  const Vec3d f = camera.forward;
  const bool isUpright = std::abs(f.y) > 0.9 * glm::length(f);
  camera.up = isUpright ? Vec3d(0.0, 0.0, 1.0) : Vec3d(0.0, 1.0, 0.0);
  camera.viewAngle = viewAngle;
  return camera;
}

} // namespace mote::testing
