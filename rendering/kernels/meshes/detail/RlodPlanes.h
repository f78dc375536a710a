#pragma once

#include "RlodTreeParts.h"

#include <bit>
#include <cstddef>
#include <cstdint>

namespace mote
{

/// The R-LODs of a node's children, whose places are those of the children: planes, in the tree's
/// coordinates, that stand for all triangles below. Children that do not exist have zeros.
///
/// The normal is as long as the mean of the triangles' unit normals (evenness), which costs no
/// room: heights over the plane, offset and deviation are all that much smaller, and compare the
/// same.
struct alignas(64) RlodPlanes
{
  float normal[3][RlodNode::fanout];        ///< as long as the evenness, 0.25 to 1
  float offset[RlodNode::fanout];           ///< dot(normal, p) of the plane's points
  float deviation[RlodNode::fanout];        ///< no point of the triangles is higher over the plane
  std::uint32_t triangle[RlodNode::fanout]; ///< index in the input of one that speaks for all
};

/// Beside them, in one line of a cache: what decides whether they are taken, and the cluster of the
/// triangle that speaks for each. Apart from the planes, since it is read far more often.
struct alignas(64) RlodWords
{
  /// The highest 5 bits: the error radius, as a level. The lowest 27: a cluster below the child.
  std::uint32_t word[RlodNode::fanout];

  static constexpr int indexBits = 27;
  static constexpr std::uint32_t levels = 32;
  static_assert(RlodNode::mostIndices <= 1U << indexBits);

  std::uint32_t level(unsigned child) const { return word[child] >> indexBits; }
  std::uint32_t cluster(unsigned child) const { return word[child] & ((1U << indexBits) - 1U); }
};

/// Error radii in 32 levels, even in the bits of a float: each is about the same share larger than
/// the one before.
struct ErrorLevels
{
  std::uint32_t first = 0, step = 1; ///< bits of the smallest as a float, and from each to the next

  ErrorLevels() = default;
  /// Levels for errors from `least` to `most`, which are above 0.
  ErrorLevels(float least, float most)
    : first(std::bit_cast<std::uint32_t>(least))
    , step((std::bit_cast<std::uint32_t>(most) - first) / (RlodWords::levels - 1) + 1)
  {
  }
  float radius(std::uint32_t level) const { return std::bit_cast<float>(first + level * step); }
  /// The lowest level that is not below an error within the range.
  std::uint32_t levelOf(float error) const
  {
    return (std::bit_cast<std::uint32_t>(error) - first + step - 1) / step;
  }
};

} // namespace mote
