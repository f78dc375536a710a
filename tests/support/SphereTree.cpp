#include "SphereTree.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>

namespace mote::reference
{

namespace
{
constexpr std::size_t leafSize = 8;
constexpr std::size_t parallelSize = 1 << 16; // below that a task costs more than it saves
} // namespace

SphereTree::SphereTree(std::vector<Sphere> spheres)
  : spheres_(std::move(spheres))
{
  while ((spheres_.size() >> depth_) > leafSize)
    ++depth_;
  bounds_.resize(std::size_t{2} << depth_);
  if (!spheres_.empty())
    build(1, 0, {0, spheres_.size()});
}

void SphereTree::build(std::size_t node, int level, Range range)
{
  const auto begin = spheres_.begin() + static_cast<std::ptrdiff_t>(range.first);
  const auto end = spheres_.begin() + static_cast<std::ptrdiff_t>(range.last);
  const double infinity = std::numeric_limits<double>::infinity();
  Bounds& b = bounds_[node];
  b = {Vec3d(infinity), Vec3d(-infinity)};
  if (level == depth_)
  {
    for (auto s = begin; s != end; ++s)
    {
      b.lower = glm::min(b.lower, s->center - Vec3d(s->radius));
      b.upper = glm::max(b.upper, s->center + Vec3d(s->radius));
    }
    return;
  }

  Vec3d lower(infinity), upper(-infinity);
  for (auto s = begin; s != end; ++s)
  {
    lower = glm::min(lower, s->center);
    upper = glm::max(upper, s->center);
  }
  const Vec3d size = upper - lower;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t middle = range.middle();
  std::nth_element(begin, spheres_.begin() + static_cast<std::ptrdiff_t>(middle), end,
    [axis](const Sphere& a, const Sphere& c) { return a.center[axis] < c.center[axis]; });
  const auto left = [&] { build(2 * node, level + 1, {range.first, middle}); };
  const auto right = [&] { build(2 * node + 1, level + 1, {middle, range.last}); };
  if (range.last - range.first > parallelSize)
    tbb::parallel_invoke(left, right);
  else
  {
    left();
    right();
  }
  b.lower = glm::min(bounds_[2 * node].lower, bounds_[2 * node + 1].lower);
  b.upper = glm::max(bounds_[2 * node].upper, bounds_[2 * node + 1].upper);
}

bool SphereTree::mayMeet(const Ray& ray, const Bounds& b, double tMax, double& tIn) const
{
  tIn = ray.tMin;
  double tOut = tMax;
  for (int axis = 0; axis < 3; ++axis)
  {
    // A share of the coordinates covers the rounding of centre +- radius.
    const double margin = 1e-15 * (std::abs(b.lower[axis]) + std::abs(b.upper[axis]));
    const double low = b.lower[axis] - margin - ray.origin[axis];
    const double high = b.upper[axis] + margin - ray.origin[axis];
    const double d = ray.direction[axis];
    if (d == 0.0)
    {
      if (low > 0.0 || high < 0.0)
        return false;
      continue;
    }
    const double t0 = low / d, t1 = high / d;
    tIn = std::max(tIn, std::min(t0, t1));
    tOut = std::min(tOut, std::max(t0, t1));
  }
  // Every t above is right to a few units of its last place.
  const double slack = 1e-14;
  return tIn - slack * std::abs(tIn) <= tOut + slack * std::abs(tOut);
}

void SphereTree::visit(const Ray& ray, std::size_t node, int level, Range range, Hit& hit) const
{
  if (level == depth_)
  {
    for (std::size_t i = range.first; i < range.last; ++i)
      meet(ray, spheres_[i], hit);
    return;
  }
  const Range ranges[2] = {{range.first, range.middle()}, {range.middle(), range.last}};
  double tIn[2];
  bool wanted[2];
  for (int side = 0; side < 2; ++side)
    wanted[side] = mayMeet(ray, bounds_[2 * node + static_cast<std::size_t>(side)],
      std::min(ray.tMax, hit.t), tIn[side]);
  const int nearer = wanted[0] && wanted[1] && tIn[1] < tIn[0] ? 1 : 0;
  for (const int side : {nearer, 1 - nearer})
  {
    const std::size_t child = 2 * node + static_cast<std::size_t>(side);
    double unused = 0.0;
    if (wanted[side] && mayMeet(ray, bounds_[child], std::min(ray.tMax, hit.t), unused))
      visit(ray, child, level + 1, ranges[side], hit);
  }
}

Hit SphereTree::cast(const Ray& ray) const
{
  Hit hit;
  if (!spheres_.empty())
    visit(ray, 1, 0, {0, spheres_.size()}, hit);
  return hit;
}

} // namespace mote::reference
