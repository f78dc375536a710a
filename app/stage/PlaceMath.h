#pragma once

#include <array>

namespace mote::app
{

/// A place in the world, or a way.
using Vec = std::array<double, 3>;

inline double dot(const Vec& a, const Vec& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// a + factor b
inline Vec sum(const Vec& a, double factor, const Vec& b)
{
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

} // namespace mote::app
