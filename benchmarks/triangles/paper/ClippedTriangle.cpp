#include "ClippedTriangle.h"

#include <algorithm>

namespace mote::bench
{

void ClippedTriangle::clip(const float low[3], const float high[3])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    cut(axis, low[axis], 1.0);
    cut(axis, high[axis], -1.0);
  }
}

/// Keeps what lies above the bound, or for a sign of -1 below.
void ClippedTriangle::cut(int axis, double bound, double sign)
{
  double above[capacity];
  bool cuts = false;
  for (int k = 0; k < count_; ++k)
  {
    above[k] = sign * (points_[k][axis] - bound);
    cuts = cuts || above[k] < 0.0;
  }
  if (!cuts)
    return;
  Vec3d kept[capacity + 1];
  int count = 0;
  for (int k = 0; k < count_; ++k)
  {
    const int next = k + 1 < count_ ? k + 1 : 0;
    if (above[k] >= 0.0)
      kept[count++] = points_[k];
    if ((above[k] < 0.0) == (above[next] < 0.0))
      continue;
    const double share = above[k] / (above[k] - above[next]);
    Vec3d& point = kept[count++];
    point = points_[k] + share * (points_[next] - points_[k]);
    point[axis] = bound;
  }
  count_ = std::min(count, capacity); // of a convex polygon there are no more
  std::copy_n(kept, count_, points_);
}

} // namespace mote::bench
