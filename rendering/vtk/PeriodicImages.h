#pragma once

#include "kernels/core/Box.h"
#include "kernels/core/Vec.h"

#include <algorithm>
#include <vector>

namespace mote
{

/// Where the images of a periodic scene stand: all whole combinations, below `counts`, of the three
/// vectors that `vectors` has one after the other. Counts below 1 are 1. The first is zero.
inline std::vector<Vec3d> imageOffsets(const int counts[3], const double vectors[9])
{
  const auto along = [&](int v, int steps)
  {
    return static_cast<double>(steps) *
           Vec3d(vectors[3 * v], vectors[3 * v + 1], vectors[3 * v + 2]);
  };
  std::vector<Vec3d> offsets;
  for (int c = 0; c < std::max(1, counts[2]); ++c)
    for (int b = 0; b < std::max(1, counts[1]); ++b)
      for (int a = 0; a < std::max(1, counts[0]); ++a)
        offsets.push_back(along(0, a) + along(1, b) + along(2, c));
  return offsets;
}

/// Bounds of a box and its images.
inline Box withImages(const Box& box, const int counts[3], const double vectors[9])
{
  Box all = box;
  if (!box.empty())
    for (const Vec3d& offset : imageOffsets(counts, vectors))
      all.add(Box{box.lower + offset, box.upper + offset});
  return all;
}

} // namespace mote
