#include "detail/BundleFrame.h"

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

/// Where a ray enters the box, or passes it, from `from` on, as a point of the box in float.
Vec3f entryOf(const Vec3d& origin, const Vec3d& direction, double from, const RlodTreeView& view)
{
  double enter = from;
  for (int axis = 0; axis < 3; ++axis)
    if (direction[axis] != 0.0)
    {
      const double a = (view.lower[axis] - origin[axis]) / direction[axis];
      const double b = (view.upper[axis] - origin[axis]) / direction[axis];
      enter = std::max(enter, std::min(a, b));
    }
  const Vec3d at = origin + enter * direction;
  return Vec3f(glm::clamp(at, view.lower, view.upper));
}

} // namespace

void BundleFrame::measure(const RayBundle& bundle)
{
  const bool square = bundle.side >= 4 && bundle.count == bundle.side * bundle.side;
  side = square ? bundle.side : 0;
  xShift = yShift = 0.0f;
  xScale = yScale = 1.0f;
  if (square)
    return;
  const auto fit = [&](const float* values, float& shift, float& scale)
  {
    const auto [low, high] = std::minmax_element(values, values + bundle.count);
    const float width = *high - *low;
    shift = *low + 0.5f * width;
    scale = width > 0.0f ? 15.0f / width : 1.0f;
  };
  fit(bundle.x, xShift, xScale);
  fit(bundle.y, yShift, yScale);
}

Tolerance BundleFrame::tolerance(
  const RlodTreeView& view, const RayBundle& bundle, double poe) const
{
  const double perZ = bundle.footprintPerT / speed, factor = radiiPerPixel * poe / view.unit;
  return {static_cast<float>(factor * (bundle.footprint + zOfQ * perZ)),
    static_cast<float>(factor * perZ)};
}

void BundleFrame::placeLines(const Lines& rays, const Vec3f& entry, bool fan)
{
  const double t = zOfQ / speed;
  const Vec3d rest = rays.origin + t * rays.direction - Vec3d(entry);
  for (int axis = 0; axis < 3; ++axis)
  {
    at[0][axis] = static_cast<float>(rest[axis]);
    way[0][axis] = static_cast<float>(rays.direction[axis] / speed);
    for (int k = 0; k < 2; ++k)
    {
      at[k + 1][axis] = static_cast<float>((fan ? t : 1.0) * rays.spread[k][axis]);
      way[k + 1][axis] = fan ? static_cast<float>(rays.spread[k][axis] / speed) : 0.0f;
    }
  }
}

bool BundleFrame::place(const RlodTreeView& view, const RayBundle& bundle, bool withLines)
{
  measure(bundle);
  const bool fan = bundle.kind == RayBundle::Kind::CommonOrigin;
  const double perUnit = 1.0 / view.unit;
  Vec3d origin = (bundle.origin - view.origin) * perUnit;
  Vec3d direction = bundle.direction * perUnit;
  const Vec3d dx = bundle.dx * (perUnit / xScale), dy = bundle.dy * (perUnit / yScale);
  const Vec3d shift = (double(xShift) * bundle.dx + double(yShift) * bundle.dy) * perUnit;
  (fan ? direction : origin) += shift;
  speed = glm::length(direction);
  const double volume = glm::dot(glm::cross(dx, dy), direction);
  if (!(std::abs(volume) > 0.02 * glm::length(dx) * glm::length(dy) * speed))
    return false;
  handedness = volume > 0.0 ? 1.0f : -1.0f;

  // p = origin + t direction + (x dx + y dy) (t or 1): these are the rows of the inverse.
  const Vec3d toT = glm::cross(dx, dy) / volume;
  const Vec3d toX = glm::cross(dy, direction) / volume, toY = glm::cross(direction, dx) / volume;
  const Vec3f entry = entryOf(origin, direction, std::max(0.0, bundle.tMin), view);
  const Vec3d toQ = Vec3d(entry) - origin;
  const double distance = glm::dot(toT, toQ) * speed;
  // The tree's size, or its distance, is about 1 in s: so nothing is too large for float.
  const double weight = fan ? 1.0 / std::max(1.0, std::abs(distance)) : 0.0;
  const double perX = fan ? weight * speed : 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    q[axis] = entry[axis];
    perAxis[axis][0] = static_cast<float>(toX[axis] * perX);
    perAxis[axis][1] = static_cast<float>(toY[axis] * perX);
    perAxis[axis][2] = static_cast<float>(toT[axis] * speed);
    perAxis[axis][3] = 0.0f;
  }
  atQ[0] = static_cast<float>(glm::dot(toX, toQ) * perX);
  atQ[1] = static_cast<float>(glm::dot(toY, toQ) * perX);
  atQ[2] = atQ[3] = 0.0f;
  weightAtQ = fan ? static_cast<float>(weight * distance) : 1.0f;
  weightPerZ = static_cast<float>(weight);
  zOfQ = distance;
  first = static_cast<float>(bundle.tMin * speed - distance);
  if (withLines)
    placeLines({origin, direction, {dx, dy}}, entry, fan);
  return true;
}

} // namespace mote
