#include "Segment.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mote::imaging
{

Rect rectAround(const double a[2], const double b[2], double beside)
{
  return {static_cast<int>(std::floor(std::min(a[0], b[0]) - beside)),
    static_cast<int>(std::floor(std::min(a[1], b[1]) - beside)),
    static_cast<int>(std::ceil(std::max(a[0], b[0]) + beside)),
    static_cast<int>(std::ceil(std::max(a[1], b[1]) + beside))};
}

double nearestShare(const double a[2], const double b[2], double x, double y)
{
  const double way[2] = {b[0] - a[0], b[1] - a[1]};
  const double length = way[0] * way[0] + way[1] * way[1];
  return length > 0.0 ? std::clamp(((x - a[0]) * way[0] + (y - a[1]) * way[1]) / length, 0.0, 1.0)
                      : 0.0;
}

double distanceTo(const double a[2], const double b[2], double x, double y)
{
  const double t = nearestShare(a, b, x, y);
  return std::hypot(x - a[0] - t * (b[0] - a[0]), y - a[1] - t * (b[1] - a[1]));
}

bool clipped(const double from[2], const double to[2], const Rect& rect, double a[2], double b[2])
{
  const double low[2] = {double(rect.x0), double(rect.y0)};
  const double high[2] = {double(rect.x1), double(rect.y1)};
  double begin = 0.0, end = 1.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double way = to[axis] - from[axis];
    double first = (low[axis] - from[axis]) / way, last = (high[axis] - from[axis]) / way;
    if (way == 0.0)
    {
      if (from[axis] < low[axis] || from[axis] > high[axis])
        return false;
      continue;
    }
    if (first > last)
      std::swap(first, last);
    begin = std::max(begin, first);
    end = std::min(end, last);
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    a[axis] = std::clamp(from[axis] + begin * (to[axis] - from[axis]), low[axis], high[axis]);
    b[axis] = std::clamp(from[axis] + end * (to[axis] - from[axis]), low[axis], high[axis]);
  }
  return begin <= end;
}

} // namespace mote::imaging
