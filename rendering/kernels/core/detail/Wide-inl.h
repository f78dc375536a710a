// What AVX-512 does in one instruction and Highway does not name: on vectors of 16 floats or 32-bit
// integers. To be included by sources that are compiled once for every instruction set; other sets
// find nothing here. These are the only intrinsics of the kernels.

#if defined(MOTE_WIDE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_WIDE_INL
#undef MOTE_WIDE_INL
#else
#define MOTE_WIDE_INL
#endif

#include <hwy/highway.h>

#include <cstdint>

#if HWY_TARGET <= HWY_AVX3

#include <immintrin.h>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{
namespace wide
{

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, 16>;
using DI = hn::RebindToSigned<D>;
using V = hn::Vec<D>;
using VI = hn::Vec<DI>;
using M = hn::Mask<D>;
using MI = hn::Mask<DI>;

/// Number i of the answer is number places[i] of `from`.
HWY_INLINE V pick(V from, VI places)
{
  return V{_mm512_permutexvar_ps(places.raw, from.raw)};
}
/// The same of two vectors: places from 16 on are in the second.
HWY_INLINE V pick(V first, V second, VI places)
{
  return V{_mm512_permutex2var_ps(first.raw, places.raw, second.raw)};
}

/// Four rows of four floats, one behind the other; rows are aligned to 16 bytes.
HWY_INLINE V rows(const float* a, const float* b, const float* c, const float* d)
{
  __m512 all = _mm512_castps128_ps512(_mm_load_ps(a));
  all = _mm512_mask_broadcast_f32x4(all, 0x00f0, _mm_load_ps(b));
  all = _mm512_mask_broadcast_f32x4(all, 0x0f00, _mm_load_ps(c));
  return V{_mm512_mask_broadcast_f32x4(all, 0xf000, _mm_load_ps(d))};
}

/// The integers at base[index], where the mask says so; else 0, and nothing is read.
template <typename T>
HWY_INLINE VI gather(MI mask, const T* base, VI index)
{
  static_assert(sizeof(T) == 4);
  return VI{_mm512_mask_i32gather_epi32(_mm512_setzero_si512(), mask.raw, index.raw, base, 4)};
}
/// The same of bytes. The three behind the last one are read as well.
HWY_INLINE VI gather(MI mask, const std::uint8_t* base, VI index)
{
  const __m512i words =
    _mm512_mask_i32gather_epi32(_mm512_setzero_si512(), mask.raw, index.raw, base, 1);
  return VI{_mm512_and_si512(words, _mm512_set1_epi32(0xff))};
}

/// A lane each, the first in the lowest bit.
HWY_INLINE std::uint16_t bitsOf(M mask)
{
  return static_cast<std::uint16_t>(mask.raw);
}
HWY_INLINE std::uint16_t bitsOf(MI mask)
{
  return static_cast<std::uint16_t>(mask.raw);
}
HWY_INLINE MI lanesOf(std::uint16_t bits)
{
  return MI{static_cast<__mmask16>(bits)};
}
/// Stores the lanes of the mask and leaves the others.
HWY_INLINE void storeWhere(MI mask, VI value, void* to)
{
  _mm512_mask_store_epi32(to, mask.raw, value.raw);
}

} // namespace wide
} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
#endif
