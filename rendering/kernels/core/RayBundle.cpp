#include "RayBundle.h"

#include <algorithm>

namespace mote
{

void copyRays(const RayBundle& from, int first, int count, RayBundle& to)
{
  // x and y count from the part's own middle.
  const auto [lowX, highX] = std::minmax_element(from.x + first, from.x + first + count);
  const auto [lowY, highY] = std::minmax_element(from.y + first, from.y + first + count);
  const float x = 0.5f * (*lowX + *highX), y = 0.5f * (*lowY + *highY);
  const Vec3d shift = double(x) * from.dx + double(y) * from.dy;
  const bool common = from.kind == RayBundle::Kind::CommonOrigin;
  to.kind = from.kind;
  to.count = count;
  to.side = 0;
  to.origin = common ? from.origin : from.origin + shift;
  to.direction = common ? from.direction + shift : from.direction;
  to.dx = from.dx;
  to.dy = from.dy;
  to.tMin = from.tMin;
  to.footprint = from.footprint;
  to.footprintPerT = from.footprintPerT;
  for (int i = 0; i < count; ++i)
  {
    to.x[i] = from.x[first + i] - x;
    to.y[i] = from.y[first + i] - y;
  }
  std::copy_n(from.t + first, count, to.t);
  std::copy_n(from.slot + first, count, to.slot);
  std::copy_n(from.object + first, count, to.object);
}

void acrossAxes(const Vec3d& v, Vec3d& a, Vec3d& b)
{
  const Vec3d size = glm::abs(v);
  Vec3d axis(0.0);
  axis[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1.0;
  const Vec3d unit = v / glm::length(v);
  a = glm::normalize(glm::cross(unit, axis));
  b = glm::cross(unit, a);
}

} // namespace mote
