// The rays that walk in step, a SIMD lane each. To be included by CellWalkSimd.cpp, once for every
// instruction set.

#if defined(MOTE_WALK_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_WALK_LANES_INL
#undef MOTE_WALK_LANES_INL
#else
#define MOTE_WALK_LANES_INL
#endif

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
constexpr std::size_t lanes = 16;
using Floats = float[lanes];

/// Sixteen rays on their way. Lanes whose rays have come to their ends keep their last numbers.
struct alignas(64) Lanes
{
  Floats x, y, dx, dy, from, to, length;
  Floats z, value, transmittance, color[3];
  Floats outZ, outValue;         ///< where they leave their cells
  Floats depth, partIn, partOut; ///< what of the way through the cell counts; depth in the world
  Floats quarter[3];             ///< the values at a quarter of it, half and three quarters
  Floats bend, cellValue;
  Floats rate;       ///< of what is seen with the scalar, in the cell; of lanes that bend
  Floats outU, outV; ///< where on the exit face
  Floats at, atValue[4], atIntegral[4];              ///< where an integral begins, see WalkTransfer
  float goalValue[lanes][4], goalIntegral[lanes][4]; ///< and where it ends
  Floats cornerX[4], cornerY[4], cornerZ[4], cornerValue[4]; ///< of the exit face, about the rays
  Floats runZ, runColor[4];                                  ///< where the rays came into the mesh
  Floats lastTransmittance; ///< of the last step; for who asks for runs
  std::uint32_t row[lanes], goalRow[lanes], bin[lanes], cell[lanes], behind[lanes], entry[lanes];
  std::int32_t left[lanes];
  std::uint32_t inFace[lanes], outFace[lanes];
  std::uint32_t active; ///< a bit each
  std::size_t first;    ///< the ray of the first lane; the others follow

  std::size_t ray(std::size_t lane) const { return first + lane; }
};

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

/// Points about the rays from `first` on: the first two of three coordinates in the order of
/// WalkRays.
template <int axis>
HWY_INLINE void placeAbout(const Lanes& l, std::size_t first, const V (&p)[3], V& x, V& y)
{
  const D d;
  x = hn::Sub(hn::Sub(p[(axis + 1) % 3], hn::Load(d, l.x + first)),
    hn::Mul(hn::Load(d, l.dx + first), p[axis]));
  y = hn::Sub(hn::Sub(p[(axis + 2) % 3], hn::Load(d, l.y + first)),
    hn::Mul(hn::Load(d, l.dy + first), p[axis]));
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
