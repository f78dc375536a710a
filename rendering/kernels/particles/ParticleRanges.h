#pragma once

#include "../core/ArrayView.h"

#include <array>
#include <limits>

namespace mote
{

/// A value that every particle has beside its centre and radius, in input order.
struct ParticleAttribute
{
  ArrayView values;
  int component = 0; ///< or ArrayView::magnitude
};

/// Bounds on the eight values of a particle: x, y, z of its centre and its radius, in the input's
/// coordinates, and its up to four attributes. Both ends of a range belong to it; a NaN lies in no
/// range but the unlimited one.
struct ParticleRanges
{
  static constexpr int count = 8;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, count> lower;
  std::array<double, count> upper;

  ParticleRanges()
  {
    lower.fill(-infinity);
    upper.fill(infinity);
  }
  bool isLimited(int value) const { return lower[value] > -infinity || upper[value] < infinity; }
};

} // namespace mote
