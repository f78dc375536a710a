#include "Triangles.h"

#include "Particles.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mote::testing
{

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

using Real = glm::tvec3<long double>;

bool isFinite(const Vec3d& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Where a ray meets the plane of a triangle.
struct PlaneHit
{
  double t = infinity;
  double inside = -infinity; ///< distance from the border, negative outside
  double cosine = 0.0;       ///< between ray and normal
};

PlaneHit meetPlane(const std::array<Vec3d, 3>& triangle, const reference::Ray& ray)
{
  PlaneHit hit;
  const Real a = Real(triangle[0]) - Real(ray.origin), b = Real(triangle[1]) - Real(ray.origin),
             c = Real(triangle[2]) - Real(ray.origin), d(ray.direction);
  const Real normal = glm::cross(b - a, c - a);
  const long double size = glm::length(normal), along = glm::dot(normal, d);
  if (!(size > 0.0L) || along == 0.0L)
    return hit;
  const long double t = glm::dot(normal, a) / along;
  const Real p = t * d;
  hit.cosine = static_cast<double>(std::abs(along) / (size * glm::length(d)));
  long double inside = std::numeric_limits<long double>::infinity();
  const Real corners[3] = {a, b, c};
  for (int k = 0; k < 3; ++k)
  {
    const Real edge = corners[(k + 1) % 3] - corners[k];
    inside = std::min(
      inside, glm::dot(glm::cross(normal, edge), p - corners[k]) / (size * glm::length(edge)));
  }
  hit.inside = static_cast<double>(inside);
  if (t > ray.tMin && t < ray.tMax)
    hit.t = static_cast<double>(t);
  return hit;
}

double distanceFromSegment(const Vec3d& a, const Vec3d& b, const Vec3d& p)
{
  const Vec3d way = b - a;
  const double square = glm::dot(way, way);
  const double s = square > 0.0 ? std::clamp(glm::dot(p - a, way) / square, 0.0, 1.0) : 0.0;
  return glm::length(p - a - s * way);
}

} // namespace

std::int32_t Triangles::addPoint(const Vec3d& p)
{
  points.insert(points.end(), {p.x, p.y, p.z});
  return static_cast<std::int32_t>(points.size() / 3 - 1);
}

void Triangles::move(const std::function<Vec3d(const Vec3d&)>& to)
{
  for (std::size_t i = 0; i < pointCount(); ++i)
  {
    const Vec3d p = to(point(i));
    points[3 * i] = p.x;
    points[3 * i + 1] = p.y;
    points[3 * i + 2] = p.z;
  }
}

Triangles bumpySphere(int rings, const Vec3d& center, double radius)
{
  Triangles sphere;
  const int around = 2 * rings;
  const auto place = [&](int ring, int k)
  {
    const double theta = M_PI * ring / rings, phi = 2.0 * M_PI * k / around;
    const double r = radius * (1.0 + 0.05 * std::sin(9.0 * theta) * std::cos(7.0 * phi));
    return center + r * Vec3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                          std::cos(theta));
  };
  const std::int32_t top = sphere.addPoint(center + Vec3d(0.0, 0.0, radius));
  for (int ring = 1; ring < rings; ++ring)
    for (int k = 0; k < around; ++k)
      sphere.addPoint(place(ring, k));
  const std::int32_t bottom = sphere.addPoint(center - Vec3d(0.0, 0.0, radius));
  const auto at = [&](int ring, int k) { return 1 + (ring - 1) * around + k % around; };
  for (int k = 0; k < around; ++k)
  {
    sphere.add(top, at(1, k), at(1, k + 1));
    sphere.add(at(rings - 1, k + 1), at(rings - 1, k), bottom);
    for (int ring = 1; ring + 1 < rings; ++ring)
    {
      sphere.add(at(ring, k), at(ring + 1, k), at(ring, k + 1));
      sphere.add(at(ring, k + 1), at(ring + 1, k), at(ring + 1, k + 1));
    }
  }
  return sphere;
}

Triangles randomTriangles(std::size_t count, std::uint64_t seed, double size)
{
  Random random(seed);
  Triangles all;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vec3d a = random.inBox(Vec3d(-1.0), Vec3d(1.0));
    const Vec3d b = a + size * random.inBox(Vec3d(-1.0), Vec3d(1.0));
    all.add(a, b, a + size * random.inBox(Vec3d(-1.0), Vec3d(1.0)));
  }
  return all;
}

TriangleOracle::TriangleOracle(const Triangles& triangles, double share)
{
  Box box;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    triangles_.push_back(triangles.of(i));
    const auto& t = triangles_.back();
    finite_.push_back(isFinite(t[0]) && isFinite(t[1]) && isFinite(t[2]));
    if (finite_.back())
      for (const Vec3d& p : t)
        box.add(p);
  }
  const Vec3d size = box.size();
  slack_ = share * std::max({size.x, size.y, size.z});
}

double TriangleOracle::nearest(const reference::Ray& ray) const
{
  double t = infinity;
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    if (finite_[i])
      if (const PlaneHit hit = meetPlane(triangles_[i], ray); hit.inside >= 0.0)
        t = std::min(t, hit.t);
  return t;
}

double TriangleOracle::nearestSure(const reference::Ray& ray) const
{
  double t = infinity;
  const double length = glm::length(ray.direction);
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    if (finite_[i])
    {
      const PlaneHit hit = meetPlane(triangles_[i], ray);
      // Beside a steep triangle the slack is a long way along the ray, and across the border.
      const double along = slack_ / std::max(hit.cosine, 1e-30);
      if (hit.inside > along && hit.t - along / length > ray.tMin &&
          hit.t + along / length < ray.tMax)
        t = std::min(t, hit.t + along / length);
    }
  return t;
}

bool TriangleOracle::mayHit(const reference::Ray& ray) const
{
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    if (finite_[i])
    {
      const PlaneHit hit = meetPlane(triangles_[i], ray);
      const double along = slack_ / std::max(hit.cosine, 1e-30);
      if (hit.t < infinity && hit.inside > -along)
        return true;
    }
  return false;
}

double distanceFrom(const std::array<Vec3d, 3>& t, const Vec3d& p)
{
  double distance = infinity;
  for (int k = 0; k < 3; ++k)
    distance = std::min(distance, distanceFromSegment(t[k], t[(k + 1) % 3], p));
  const Vec3d normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double size = glm::length(normal);
  if (!(size > 0.0))
    return distance;
  for (int k = 0; k < 3; ++k)
    if (glm::dot(glm::cross(normal, t[(k + 1) % 3] - t[k]), p - t[k]) < 0.0)
      return distance;
  return std::min(distance, std::abs(glm::dot(normal, p - t[0])) / size);
}

void TriangleOracle::judge(
  const reference::Ray& ray, double t, std::size_t triangle, CastReport& report) const
{
  ++report.rays;
  const bool isHit = triangle != reference::Hit::none;
  report.hits += isHit;
  const double sure = nearestSure(ray);
  bool right = !isHit ? sure == infinity : triangle < triangles_.size() && finite_[triangle];
  double distance = 0.0;
  if (isHit && right)
  {
    distance = distanceFrom(triangles_[triangle], ray.origin + t * ray.direction);
    right = t > ray.tMin && t < ray.tMax && distance <= slack_ && t <= sure;
  }
  if (right)
    return;
  ++report.wrong;
  if (!report.complaint.empty())
    return;
  std::ostringstream text;
  text.precision(17);
  text << describe(ray) << ": answered t " << t << " on triangle "
       << static_cast<std::ptrdiff_t>(triangle) << " (off it by " << distance
       << "); the reference says t " << nearest(ray) << ", surely " << sure << ", with a slack of "
       << slack_;
  report.complaint = text.str();
}

} // namespace mote::testing
