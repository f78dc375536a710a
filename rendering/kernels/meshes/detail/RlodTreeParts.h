#pragma once

#include <cstddef>
#include <cstdint>

namespace mote
{

/// An inner node of an RlodTree: up to 16 children, first those that are clusters, then those that
/// are nodes; each kind lies in one row. Child k is within origin + scale * (low(axis)[k] to
/// high(axis)[k]): boxes are rounded outwards, as float computes that with a fused multiply-add and
/// without. Children that do not exist have turned bounds on every axis.
struct alignas(64) RlodNode
{
  static constexpr int fanout = 16;
  static constexpr std::uint32_t mostIndices = 1U << 27;

  float origin[3];
  float scale[3];
  std::uint32_t firstNode : 27;
  std::uint32_t children : 5;
  std::uint32_t firstCluster : 27;
  std::uint32_t clusters : 5;
  std::uint8_t bounds[6][fanout]; ///< three rows of least ones, three of greatest

  std::uint8_t* low(int axis) { return bounds[axis]; }
  std::uint8_t* high(int axis) { return bounds[3 + axis]; }
  const std::uint8_t* low(int axis) const { return bounds[axis]; }
  const std::uint8_t* high(int axis) const { return bounds[3 + axis]; }
  /// The node that child k is, which is not a cluster.
  std::uint32_t nodeOf(unsigned k) const { return firstNode + k - clusters; }
};
static_assert(sizeof(RlodNode) == 128);

/// A leaf of an RlodTree: up to 16 triangles that have no more than 16 corners together. Whoever
/// casts rays needs nothing else. Points beyond those in use repeat the first; triangles beyond
/// `count` have all corners at point 0.
struct alignas(32) TriangleCluster
{
  static constexpr int capacity = 16;

  float point[3][capacity];
  std::uint8_t corners01[capacity];   ///< corner 0 in the lower half of a byte, corner 1 above
  std::uint8_t corner2[capacity / 2]; ///< of triangles 0 to 7 in the lower halves, of 8 to 15 above
  std::uint32_t firstId;              ///< of the triangles' places in the tree's input indices
  std::uint8_t count;

  unsigned corner(int triangle, int which) const
  {
    if (which < 2)
      return corners01[triangle] >> (4 * which) & 15U;
    return corner2[triangle % 8] >> (triangle / 8 * 4) & 15U;
  }
};
static_assert(sizeof(TriangleCluster) == 224);

} // namespace mote
