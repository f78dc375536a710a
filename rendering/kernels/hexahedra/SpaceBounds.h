#pragma once

#include "../core/Box.h"

#include <array>
#include <cmath>
#include <limits>

namespace mote
{

/// Bounds in the three coordinates of a space, (x, y, z) or (r, theta, h), in float and rounded
/// outwards.
struct SpaceBounds
{
  std::array<float, 3> lower{std::numeric_limits<float>::infinity(),
    std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};
  std::array<float, 3> upper{-std::numeric_limits<float>::infinity(),
    -std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};

  SpaceBounds() = default;
  SpaceBounds(const Vec3d& from, const Vec3d& to)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto i = static_cast<std::size_t>(k);
      lower[i] =
        std::nextafter(static_cast<float>(from[k]), -std::numeric_limits<float>::infinity());
      upper[i] = std::nextafter(static_cast<float>(to[k]), std::numeric_limits<float>::infinity());
    }
  }

  bool empty() const { return lower[0] > upper[0]; }
  void add(const SpaceBounds& b)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      lower[k] = b.lower[k] < lower[k] ? b.lower[k] : lower[k];
      upper[k] = b.upper[k] > upper[k] ? b.upper[k] : upper[k];
    }
  }
  Vec3d from() const { return {lower[0], lower[1], lower[2]}; }
  Vec3d to() const { return {upper[0], upper[1], upper[2]}; }
};

/// A lattice over a space: n[k] steps along coordinate k from `lower`.
struct Lattice
{
  Vec3d lower{0.0};
  Vec3d step{1.0};
  std::array<int, 3> n{1, 1, 1};

  int size() const { return n[0] * n[1] * n[2]; }
  int index(int i, int j, int k) const { return (k * n[1] + j) * n[0] + i; }
  /// The step along coordinate k with the value x, within the lattice.
  int clampedAt(int k, double x) const
  {
    const double i = std::floor((x - lower[k]) / step[k]);
    const int last = n[static_cast<std::size_t>(k)] - 1;
    return i > 0.0 ? (i < last ? static_cast<int>(i) : last) : 0;
  }
};

/// Steps of a lattice, from first to last, along each coordinate. Of a wrapping coordinate the last
/// may lie behind the end.
struct LatticeRange
{
  std::array<int, 3> first{}, last{};

  bool isOne() const { return first == last; }
};

} // namespace mote
