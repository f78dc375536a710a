#include "detail/CloudSquare.h"

#include <algorithm>

namespace mote
{

RayColor CloudSquare::between(const RayColor (&corners)[4], double u, double v)
{
  const double weights[4] = {(1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v, u * v};
  RayColor sum{Vec3d(0.0), 0.0};
  for (int i = 0; i < 4; ++i)
  {
    sum.color += weights[i] * corners[i].color;
    sum.transmittance += weights[i] * corners[i].transmittance;
  }
  return sum;
}

double CloudSquare::difference(const RayColor& a, const RayColor& b)
{
  const Vec3d d = glm::abs(a.color - b.color);
  return std::max({d.x, d.y, d.z, std::abs(a.transmittance - b.transmittance)});
}

/// Interpolates the pixels that are not traced, those on the far sides as well: what lies behind
/// them fills or traces them again.
void CloudSquare::fill(int x, int y, int size, const RayColor (&corners)[4])
{
  for (int j = 0; j <= size; ++j)
    for (int i = 0; i <= size; ++i)
      if (!known_[index(x + i, y + j)])
        colors_[index(x + i, y + j)] = between(corners, double(i) / size, double(j) / size);
}

} // namespace mote
