// The rays that walk in step, a SIMD lane each. To be included by CellWalkSimd.cpp, once for every
// instruction set.

#if defined(MOTE_WALK_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_WALK_LANES_INL
#undef MOTE_WALK_LANES_INL
#else
#define MOTE_WALK_LANES_INL
#endif

#include "../../core/detail/Wide-inl.h"
#include "WalkPatch-inl.h"
#include "WalkTask.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{
namespace
{

using D4 = hn::CappedTag<float, 4>;
using V4 = hn::Vec<D4>;
using DI = hn::RebindToSigned<D>;
using VI = hn::Vec<DI>;
constexpr std::size_t lanes = 32;               ///< no more than bits of `active`
constexpr bool isWide = HWY_TARGET <= HWY_AVX3; ///< a vector holds 16 numbers
using Floats = float[lanes];

/// Rays on their way. Lanes whose rays have come to their ends keep their last numbers.
struct alignas(64) Lanes
{
  Floats x, y, dx, dy, from, to, length;
  Floats z, value, transmittance, color[3];
  Floats outZ, outValue;          ///< where they leave their cells
  Floats depth, partIn, partOut;  ///< what of the way through the cell counts; depth in the world
  Floats quarter[3];              ///< the values at a quarter of it, half and three quarters
  Floats mid[3], way[3], step[3]; ///< of lanes that bend, see WalkBends
  Floats bend, cellValue;
  Floats rate;       ///< of what is seen with the scalar, in the cell; of lanes that bend
  Floats outU, outV; ///< where on the exit face
  Floats at, atValue[4], atIntegral[4]; ///< where an integral begins, see WalkTransfer
  /// The corners of the exit face about the rays: wide, a row for each ray; else, of each lane.
  float face[isWide ? lanes : 1][16];
  Floats cornerX[4], cornerY[4], cornerZ[4], cornerValue[4];
  float rayXY[isWide ? lanes : 1][16], raySlope[isWide ? lanes : 1][16]; ///< eight times each
  Floats runZ, runColor[4]; ///< where the rays came into the mesh
  Floats lastTransmittance; ///< of the last step; for who asks for runs
  std::uint32_t row[lanes], goalRow[lanes], cell[lanes], behind[lanes], entry[lanes];
  std::int32_t left[lanes];
  std::uint32_t inFace[lanes], outFace[lanes];
  std::uint32_t before[lanes]; ///< the cells that the rays came from; wide lanes know them
  std::uint32_t active;        ///< a bit each
  std::size_t first;           ///< the ray of the first lane; the others follow

  std::size_t ray(std::size_t lane) const { return first + lane; }
};

/// The winding numbers of a cell's faces are kept in four bits each, counted from 4. What an edge
/// adds that passes the half-line y = 0, x > 0 upwards:
constexpr std::uint32_t windingOf(std::size_t edge)
{
  return (1U << 4 * edgeFaces[edge][0]) - (1U << 4 * edgeFaces[edge][1]);
}
constexpr std::uint32_t noWindings = 0x444444U;

/// What sets of six edges add, the first six and the last.
struct EdgeSums
{
  std::uint32_t of[2][64];
};
constexpr EdgeSums makeEdgeSums()
{
  EdgeSums sums{};
  for (unsigned e = 0; e < 12; ++e)
    for (unsigned bits = 0; bits < 64; ++bits)
      if ((bits >> e % 6 & 1U) != 0)
        sums.of[e / 6][bits] += windingOf(e);
  return sums;
}
constexpr EdgeSums edgeSums = makeEdgeSums();

/// What the faces wind about the ray: of corners above it, and edges that turn counter-clockwise
/// about it, and clockwise.
HWY_INLINE std::uint32_t windingsOf(unsigned above, unsigned left, unsigned right)
{
  const unsigned mixed = cornerBits.mixed[above], first = cornerBits.first[above];
  const unsigned up = mixed & ~first & left, down = mixed & first & right;
  return edgeSums.of[0][up & 63U] + edgeSums.of[1][up >> 6] - edgeSums.of[0][down & 63U] -
         edgeSums.of[1][down >> 6];
}

HWY_INLINE unsigned bitsOf(hn::Mask<D4> mask)
{
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(D4(), mask, bits);
  return bits[0];
}
HWY_INLINE std::uint32_t maskOf(M mask)
{
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(D(), mask, bits);
  return bits[0] | static_cast<std::uint32_t>(bits[1]) << 8;
}
/// Lanes of which the bit is set.
HWY_INLINE M lanesOf(std::uint32_t bits)
{
  const hn::RebindToUnsigned<D> du;
  const auto own = hn::Shl(hn::Set(du, 1), hn::Iota(du, 0));
  return hn::RebindMask(D(), hn::TestBit(hn::Set(du, bits), own));
}

/// Four numbers of each of the rows at(0) and those that follow, one row behind the other.
template <typename DN, typename At>
HWY_INLINE hn::Vec<DN> loadRows(DN d, const At& at, std::size_t first = 0, std::size_t step = 1)
{
  if constexpr (hn::MaxLanes(d) <= 4)
    return hn::Load(d, at(first));
#if HWY_TARGET <= HWY_AVX3
  else if constexpr (hn::MaxLanes(d) == 16)
    return wide::rows(at(first), at(first + step), at(first + 2 * step), at(first + 3 * step));
#endif
  else
  {
    const hn::Half<DN> half;
    const std::size_t middle = first + step * hn::MaxLanes(half) / 4;
    return hn::Combine(d, loadRows(half, at, middle, step), loadRows(half, at, first, step));
  }
}
/// Four numbers of a row for each lane.
template <typename At>
HWY_INLINE void loadFours(const At& at, V (&to)[4])
{
  const D d;
  const hn::Repartition<double, D> pairs;
  const V a = loadRows(d, at, 0, 4), b = loadRows(d, at, 1, 4);
  const V c = loadRows(d, at, 2, 4), e = loadRows(d, at, 3, 4);
  const auto abLow = hn::BitCast(pairs, hn::InterleaveLower(d, a, b));
  const auto ceLow = hn::BitCast(pairs, hn::InterleaveLower(d, c, e));
  const auto abHigh = hn::BitCast(pairs, hn::InterleaveUpper(d, a, b));
  const auto ceHigh = hn::BitCast(pairs, hn::InterleaveUpper(d, c, e));
  to[0] = hn::BitCast(d, hn::InterleaveLower(pairs, abLow, ceLow));
  to[1] = hn::BitCast(d, hn::InterleaveUpper(pairs, abLow, ceLow));
  to[2] = hn::BitCast(d, hn::InterleaveLower(pairs, abHigh, ceHigh));
  to[3] = hn::BitCast(d, hn::InterleaveUpper(pairs, abHigh, ceHigh));
}

/// Calls visit(k) for each lane of which the bit is set.
template <typename Visit>
HWY_INLINE void forLanes(std::uint32_t bits, const Visit& visit)
{
  for (; bits != 0; bits &= bits - 1)
    visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
