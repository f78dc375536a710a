#pragma once

// What a line's crossings with the faces of one cell are found from; see CrossingLine. Only for
// CellCrossings*.cpp and CellFaces.cpp.

#include "CellCrossings.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace mote
{

/// A cell's corners in the line's frame: the line is x = y = 0, and its parameter t is proportional
/// to z. Bit i of `right` and `above` says whether corner i has x > 0 and y > 0.
struct CellFrame
{
  std::array<double, 8> x, y, z;
  unsigned right = 0, above = 0;

  void add(unsigned i, double px, double py, double pz)
  {
    x[i] = px;
    y[i] = py;
    z[i] = pz;
    right |= static_cast<unsigned>(px > 0.0) << i;
    above |= static_cast<unsigned>(py > 0.0) << i;
  }
};

/// A passed face: t, and +1 for leaving the cell, -1 for entering.
struct Crossing
{
  double t;
  int leaving;
  std::uint8_t face;
};

struct Crossings
{
  std::array<Crossing, 12> of;
  int count = 0;

  void add(double t, int leaving, unsigned face)
  {
    of[static_cast<std::size_t>(count++)] = {t, leaving, static_cast<std::uint8_t>(face)};
  }
};

/// The corners of the faces, counter-clockwise seen from outside.
constexpr std::uint8_t faceCorners[6][4] = {
  {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 4, 7, 3}, {1, 2, 6, 5}};
constexpr std::uint8_t edgeCorners[12][2] = {
  {0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
/// The faces that have the edge in its own direction and against it.
constexpr std::uint8_t edgeFaces[12][2] = {
  {2, 0}, {5, 0}, {3, 0}, {4, 0}, {1, 2}, {1, 5}, {1, 3}, {1, 4}, {4, 2}, {2, 5}, {5, 3}, {3, 4}};

/// What 8 bits, one a corner, say about edges and faces.
struct CornerBits
{
  std::array<std::uint16_t, 256> first{}; ///< the edge's first corner's bit
  std::array<std::uint16_t, 256> mixed{}; ///< whether the edge's corners differ
  std::array<std::uint8_t, 256> mixedFaces{};
};
constexpr CornerBits makeCornerBits()
{
  CornerBits bits;
  for (unsigned set = 0; set < 256; ++set)
  {
    for (unsigned e = 0; e < 12; ++e)
    {
      const unsigned i = set >> edgeCorners[e][0] & 1U, j = set >> edgeCorners[e][1] & 1U;
      bits.first[set] = static_cast<std::uint16_t>(bits.first[set] | i << e);
      bits.mixed[set] = static_cast<std::uint16_t>(bits.mixed[set] | (i ^ j) << e);
    }
    for (unsigned f = 0; f < 6; ++f)
    {
      unsigned sum = 0;
      for (const std::uint8_t corner : faceCorners[f])
        sum += set >> corner & 1U;
      bits.mixedFaces[set] =
        static_cast<std::uint8_t>(bits.mixedFaces[set] | (sum % 4 != 0 ? 1U : 0U) << f);
    }
  }
  return bits;
}
constexpr CornerBits cornerBits = makeCornerBits();

/// A face's corners in an order that depends on their places alone. `sense` is +1 or -1: whether
/// that is the order that was given or the other way round.
struct FaceOrder
{
  std::array<std::size_t, 4> corners;
  int sense;
  bool isTriangle; ///< the last corner is the first

  /// `given` are a face's, see faceCorners.
  FaceOrder(const CellFrame& f, const std::uint8_t (&given)[4]);
};

/// All passed faces of a cell, with z for t.
void findCrossings(const CellFrame& frame, Crossings& crossings);

/// From passed faces, which it sorts, to intervals: where more were entered than left.
bool toIntervals(Crossings& crossings, CellIntervals& intervals);

/// Where the line passes `face`, of which the frame holds the corners: there where it leaves the
/// cell (`leaving` is 1) or enters it (-1).
FacePoint facePointOf(const CellFrame& frame, std::uint8_t face, int leaving);

} // namespace mote
