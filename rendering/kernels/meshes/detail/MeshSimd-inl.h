// What casting rays at clusters of triangles by SIMD shares. Included once per SIMD instruction
// set.

#if defined(MOTE_MESH_SIMD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_MESH_SIMD_INL_H
#undef MOTE_MESH_SIMD_INL_H
#else
#define MOTE_MESH_SIMD_INL_H
#endif

#include "RlodTreeParts.h"

#include <hwy/highway.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DI = hn::RebindToSigned<DF>;
using DU = hn::RebindToUnsigned<DF>;
using DB = hn::Rebind<std::uint8_t, DF>;
using DD = hn::CappedTag<double, 8>;
using DH = hn::Rebind<float, DD>; ///< as many floats as a vector has doubles
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;
using VD = hn::Vec<DD>;
using MF = hn::Mask<DF>;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr int lanes = static_cast<int>(hn::MaxLanes(DF()));
constexpr int laneSets = 16 / lanes; ///< vectors that hold a number for each of 16 things

HWY_INLINE VF all(float v)
{
  return hn::Set(DF(), v);
}

/// A mask of up to 32 lanes as bits, the first lane lowest.
template <typename D>
HWY_INLINE std::uint32_t bitsOf(D d, hn::Mask<D> mask)
{
  constexpr std::size_t count = hn::MaxLanes(D());
  // As large as what is written: so it never goes by the memory.
  using Word = std::conditional_t<count == 32, std::uint32_t,
    std::conditional_t<count == 16, std::uint16_t, std::uint8_t>>;
  static_assert(count == 32 || count == 16 || count <= 8);
  std::uint8_t bytes[8];
  hn::StoreMaskBits(d, mask, bytes);
  Word word;
  std::memcpy(&word, bytes, sizeof word);
  return word;
}
HWY_INLINE unsigned bitsOf(MF mask)
{
  return bitsOf(DF(), mask);
}

/// The lowest `count` bits, for counts up to 16: a damaged file may hold others, which take some.
HWY_INLINE unsigned lowest(unsigned count)
{
  return (1U << (count & 31U)) - 1U;
}

HWY_INLINE VI widened(const std::uint8_t* bytes)
{
  return hn::PromoteTo(DI(), hn::LoadU(DB(), bytes));
}

/// A number for each of 16 things.
struct Row
{
  alignas(64) float v[16];

  HWY_INLINE VF load(int set) const { return hn::Load(DF(), v + set * lanes); }
  HWY_INLINE void store(VF numbers, int set) { hn::Store(numbers, DF(), v + set * lanes); }
  /// The numbers at `indices`, which are below 16.
  HWY_INLINE VF at(VI indices) const
  {
#if HWY_CAP_GE512
    return hn::TableLookupLanes(load(0), hn::IndicesFromVec(DF(), indices));
#elif HWY_TARGET == HWY_AVX2
    // Gathers are slow: they go by the memory, lane by lane.
    const auto lower = hn::IndicesFromVec(DF(), hn::And(indices, hn::Set(DI(), 7)));
    const MF isUpper = hn::RebindMask(DF(), hn::Gt(indices, hn::Set(DI(), 7)));
    return hn::IfThenElse(
      isUpper, hn::TableLookupLanes(load(1), lower), hn::TableLookupLanes(load(0), lower));
#else
    return hn::GatherIndex(DF(), v, indices);
#endif
  }
};

/// Which points triangles of a cluster have as corners.
struct CornerIndices
{
  VI a, b, c;

  CornerIndices() = default;
  HWY_INLINE CornerIndices(const TriangleCluster& cluster, int set)
  {
    const DI d;
    const VI low = hn::Set(d, 15);
    const VI both = widened(cluster.corners01 + set * lanes);
    a = hn::And(both, low);
    b = hn::ShiftRight<4>(both);
#if HWY_CAP_GE512
    const hn::Half<DB> half;
    const auto packed = hn::LoadU(half, cluster.corner2);
    // Bytes are shifted by four as pairs of them.
    const hn::Repartition<std::uint16_t, decltype(half)> pairs;
    const auto shifted = hn::BitCast(half, hn::ShiftRight<4>(hn::BitCast(pairs, packed)));
    c = hn::And(hn::PromoteTo(d, hn::Combine(DB(), shifted, packed)), low);
#else
    const VI packed = widened(cluster.corner2 + set * lanes % 8);
    c = set * lanes < 8 ? hn::And(packed, low) : hn::ShiftRight<4>(packed);
#endif
  }
};

/// Those of all triangles of a cluster.
struct AllCornerIndices
{
  CornerIndices sets[laneSets];

  HWY_INLINE explicit AllCornerIndices(const TriangleCluster& cluster)
  {
    for (int set = 0; set < laneSets; ++set)
      sets[set] = CornerIndices(cluster, set);
  }
};

/// A corner of each of some triangles, seen along a ray: (u, v) is 0 where the ray passes.
struct Corner
{
  VF u, v;
};

/// The edge functions of triangles about a ray: e of an edge is minus e of the same edge the other
/// way round, to the last bit, and never has the wrong sign: fl(a b) < fl(c d) where a b < c d, or
/// both are equal. A ray hits where no two have different signs, 0 having any: so a ray that passes
/// within a fan of triangles around a corner hits one of them. This needs products that are rounded
/// before they are subtracted, hence -ffp-contract=off.
struct Edges
{
  VF a, b, c; ///< of the edges opposite to the corners

  HWY_INLINE Edges(const Corner& p, const Corner& q, const Corner& r)
    : a(edge(q, r))
    , b(edge(r, p))
    , c(edge(p, q))
  {
  }
  static HWY_INLINE VF edge(const Corner& p, const Corner& q)
  {
    return hn::Sub(hn::Mul(p.u, q.v), hn::Mul(q.u, p.v));
  }
  HWY_INLINE VF sum() const { return hn::Add(hn::Add(a, b), c); }
  HWY_INLINE MF hits(VF sum) const
  {
    const VF zero = hn::Zero(DF());
    const VF least = hn::Min(hn::Min(a, b), c), most = hn::Max(hn::Max(a, b), c);
    return hn::And(hn::Or(hn::Ge(least, zero), hn::Le(most, zero)), hn::Ne(sum, zero));
  }
  /// The same of triangles whose normals look the way of the ray, where `side` is 1; or -1, where
  /// u, v and the ray's direction are left-handed.
  HWY_INLINE MF hitsInner(VF sum, float side) const
  {
    return hn::And(hits(sum), hn::Gt(hn::Mul(sum, all(side)), hn::Zero(DF())));
  }
  /// What a linear function is where the rays meet the triangles' planes.
  HWY_INLINE VF at(VF sum, VF p, VF q, VF r) const
  {
    return hn::Div(hn::MulAdd(a, p, hn::MulAdd(b, q, hn::Mul(c, r))), sum);
  }
};

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
