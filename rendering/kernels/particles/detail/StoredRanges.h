#pragma once

#include "../../core/Vec.h"
#include "../ParticleRanges.h"

#include <cmath>
#include <limits>

namespace mote
{

/// The limited ones among a structure's ranges, in the numbers that it stores.
struct StoredRanges
{
  int limits = 0;
  int value[ParticleRanges::count]; ///< which of the eight values
  float lower[ParticleRanges::count], upper[ParticleRanges::count];

  StoredRanges(const ParticleRanges& ranges, const Vec3d& origin, double unit, bool attributes)
  {
    for (int k = 0; k < ParticleRanges::count; ++k)
    {
      if (!ranges.isLimited(k) || (k > 3 && !attributes))
        continue;
      const double shift = k < 3 ? origin[k] : 0.0, scale = k < 4 ? unit : 1.0;
      value[limits] = k;
      lower[limits] = inwards((ranges.lower[k] - shift) / scale, +1.0f);
      upper[limits] = inwards((ranges.upper[k] - shift) / scale, -1.0f);
      ++limits;
    }
  }

  /// `v` as a float that is not outside of it in the direction given.
  static float inwards(double v, float direction)
  {
    const auto f = static_cast<float>(v);
    const bool outside = direction > 0.0f ? double(f) < v : double(f) > v;
    return outside ? std::nextafter(f, direction * std::numeric_limits<float>::infinity()) : f;
  }

  /// `record` are x y z r, `values` the attributes.
  bool contain(const float* record, const float* values) const
  {
    for (int k = 0; k < limits; ++k)
    {
      const float v = value[k] < 4 ? record[value[k]] : values[value[k] - 4];
      if (!(v >= lower[k] && v <= upper[k]))
        return false;
    }
    return true;
  }
};

} // namespace mote
