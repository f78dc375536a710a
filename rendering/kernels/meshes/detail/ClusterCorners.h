#pragma once

#include "../TriangleMesh.h"
#include "RlodTreeParts.h"

#include <algorithm>
#include <cstdint>

namespace mote
{

/// Different corners of some triangles, numbered in the order in which they come.
class ClusterCorners
{
public:
  static constexpr int capacity = 16;

  ClusterCorners() { clear(); }
  void clear()
  {
    std::fill_n(first_, buckets, none);
    count_ = 0;
  }
  int count() const { return count_; }
  std::uint32_t point(int number) const { return points_[number]; }

  /// The number of a point, or -1 where there would be more than 16.
  int numberOf(std::uint32_t point)
  {
    std::uint8_t& first = first_[point % buckets];
    for (std::uint8_t k = first; k != none; k = next_[k])
      if (points_[k] == point)
        return k;
    if (count_ == capacity)
      return -1;
    points_[count_] = point;
    next_[count_] = first;
    first = static_cast<std::uint8_t>(count_);
    return count_++;
  }

  /// Whether it has room for all corners of a triangle; those that have come stay.
  bool add(const TriangleMesh::Corners& corners)
  {
    return numberOf(corners[0]) >= 0 && numberOf(corners[1]) >= 0 && numberOf(corners[2]) >= 0;
  }

private:
  static constexpr std::uint32_t buckets = 64;
  static constexpr std::uint8_t none = 255;

  std::uint8_t first_[buckets]; ///< of a chain of points of the same bucket
  std::uint8_t next_[capacity];
  std::uint32_t points_[capacity];
  int count_ = 0;
};

} // namespace mote
