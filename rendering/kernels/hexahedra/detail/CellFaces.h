#pragma once

// What a line's crossings with the faces of one cell are found from; see CrossingLine. Only for
// sources of this folder.

#include "../CellCrossings.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace mote
{

/// A cell's corners in the line's frame: the line is x = y = 0, and its parameter t is proportional
/// to z. Bit i of `right` and `above` says whether corner i has x > 0 and y > 0. `points` are the
/// corners' places in the mesh, coordinate by coordinate.
struct CellFrame
{
  std::array<double, 8> x, y, z;
  std::array<std::array<double, 8>, 3> points;
  unsigned right = 0, above = 0;

  void add(unsigned i, const Vec3d& point, const Vec3d& p)
  {
    for (std::size_t k = 0; k < 3; ++k)
      points[k][i] = point[static_cast<int>(k)];
    x[i] = p.x;
    y[i] = p.y;
    z[i] = p.z;
    right |= static_cast<unsigned>(p.x > 0.0) << i;
    above |= static_cast<unsigned>(p.y > 0.0) << i;
  }
  /// Whether all corners are on one side of the line, as seen along x or y.
  bool isBeside() const { return right == 0 || right == 0xff || above == 0 || above == 0xff; }
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

/// Six windings, a byte each, counted from 4 so that no byte borrows from the next.
class Windings
{
public:
  Windings() = default;
  /// Of the edges that pass the half-line upwards and downwards, in their own direction.
  Windings(unsigned up, unsigned down);
  int of(unsigned face) const { return static_cast<int>(bytes_ >> 8 * face & 0xffU) - 4; }
  /// Bit 8 f is set where the winding of face f is not 0.
  std::uint64_t passed() const
  {
    const std::uint64_t differing = bytes_ ^ 0x040404040404U;
    return (differing | differing >> 1) & 0x010101010101U; // windings are -2 to 2
  }

private:
  std::uint64_t bytes_ = 0x040404040404U;
};

/// What sets of six edges add to the windings: the first six, and the last.
using EdgeWindings = std::array<std::array<std::uint64_t, 64>, 2>;
constexpr EdgeWindings makeEdgeWindings()
{
  EdgeWindings sums{};
  for (unsigned e = 0; e < 12; ++e)
    for (unsigned set = 0; set < 64; ++set)
      if ((set >> e % 6 & 1U) != 0)
        sums[e / 6][set] +=
          (std::uint64_t(1) << 8 * edgeFaces[e][0]) - (std::uint64_t(1) << 8 * edgeFaces[e][1]);
  return sums;
}
constexpr EdgeWindings edgeWindings = makeEdgeWindings();

inline Windings::Windings(unsigned up, unsigned down)
  : bytes_(0x040404040404U + edgeWindings[0][up & 63U] + edgeWindings[1][up >> 6 & 63U] -
           edgeWindings[0][down & 63U] - edgeWindings[1][down >> 6 & 63U])
{
}

/// A face's corners in an order that depends on their places in the mesh alone, the same for all
/// lines. `sense` is +1 or -1: whether that is the order that was given or the other way round.
struct FaceOrder
{
  std::array<std::size_t, 4> corners;
  int sense;
  bool isTriangle; ///< the last corner is the first

  /// `given` are a face's, see faceCorners.
  FaceOrder(const CellFrame& f, const std::uint8_t (&given)[4]);
};

/// The orders of corners that do not coincide.
struct FaceOrders
{
  /// By bits: 0 to 3 whether a corner comes before the next one, 4 and 5 whether the first
  /// and the second come before the one across. Odd where the corners are the other way round.
  std::array<std::uint8_t, 64> of{};
  std::uint8_t corners[6][8][4]{};
};
constexpr FaceOrders makeFaceOrders()
{
  FaceOrders orders;
  for (unsigned set = 0; set < 64; ++set)
  {
    const auto bit = [&](unsigned i) { return (set >> i & 1U) != 0; };
    // Of two beside each other the lesser, and of these two.
    const unsigned i = bit(0) ? 0 : 1, j = bit(2) ? 2 : 3;
    const bool iLess = i == 0 && j == 2   ? bit(4)
                       : i == 1 && j == 3 ? bit(5)
                       : i == 0           ? !bit(3)
                                          : bit(1);
    const unsigned least = iLess ? i : j;
    const bool turned = least % 2 == 0 ? bit(5) == (least == 2) : bit(4) == (least == 1);
    orders.of[set] = static_cast<std::uint8_t>(2 * least + (turned ? 1 : 0));
  }
  for (unsigned f = 0; f < 6; ++f)
    for (unsigned which = 0; which < 8; ++which)
      for (unsigned k = 0; k < 4; ++k)
        orders.corners[f][which][k] =
          faceCorners[f][(which / 2 + (which % 2 != 0 ? 4 - k : k)) % 4];
  return orders;
}
constexpr FaceOrders faceOrders = makeFaceOrders();

/// Whether the line passes a face twice whose winding number is 0.
bool isFoldPassed(const CellFrame& frame, unsigned face);

/// Where the line is in the cell. True where it is anywhere.
bool intersectFrame(const CellFrame& frame, double inverse, CellIntervals& intervals);

/// Where the line passes `face`, of which the frame holds the corners: there where it leaves the
/// cell (`leaving` is 1) or enters it (-1).
FacePoint facePointOf(const CellFrame& frame, std::uint8_t face, int leaving);

} // namespace mote
