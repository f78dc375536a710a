#include "Reference.h"

#include <cmath>

namespace mote::reference
{

std::vector<Sphere> validSpheres(const ParticleSet& particles)
{
  std::vector<Sphere> spheres;
  spheres.reserve(particles.count());
  for (std::size_t i = 0; i < particles.count(); ++i)
  {
    const Vec3d c = particles.position(i);
    const double r = particles.radiusOf(i);
    if (std::isfinite(c.x + c.y + c.z) && std::isfinite(r) && r > 0.0)
      spheres.push_back({c, r, i});
  }
  return spheres;
}

void meet(const Ray& ray, const Sphere& sphere, Hit& hit)
{
  using Real = long double;
  const Real dx = ray.direction.x, dy = ray.direction.y, dz = ray.direction.z;
  const Real fx = sphere.center.x - Real(ray.origin.x);
  const Real fy = sphere.center.y - Real(ray.origin.y);
  const Real fz = sphere.center.z - Real(ray.origin.z);
  const Real length2 = dx * dx + dy * dy + dz * dz;
  const Real middle = (fx * dx + fy * dy + fz * dz) / length2;
  // From the ray's point nearest to the centre to the centre.
  const Real px = fx - middle * dx, py = fy - middle * dy, pz = fz - middle * dz;
  const Real left = Real(sphere.radius) * sphere.radius - (px * px + py * py + pz * pz);
  if (!(left >= 0))
    return;
  const Real half = std::sqrt(left / length2);
  auto t = static_cast<double>(middle - half);
  if (!(t > ray.tMin))
    t = static_cast<double>(middle + half);
  if (!(t > ray.tMin) || !(t < ray.tMax))
    return;
  if (t < hit.t || (t == hit.t && sphere.particle < hit.particle))
    hit = {t, sphere.particle};
}

Hit bruteForce(const std::vector<Sphere>& spheres, const Ray& ray)
{
  Hit hit;
  for (const Sphere& sphere : spheres)
    meet(ray, sphere, hit);
  return hit;
}

Ray cameraRay(const CameraRays& rays, double x, double y)
{
  return {rays.originAt(x, y), rays.directionAt(x, y), rays.tMin, rays.tMax};
}

} // namespace mote::reference
