// What a line between two values of the scalar looks like. To be included by CellWalkSimd.cpp, once
// for every instruction set.

#if defined(MOTE_WALK_ROWS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_WALK_ROWS_INL
#undef MOTE_WALK_ROWS_INL
#else
#define MOTE_WALK_ROWS_INL
#endif

#include "WalkLanes-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{
namespace
{

/// 1 / x, where x is not 0 nor beyond 1e37: with the wide vectors' estimate, which is faster.
HWY_INLINE V reciprocal(V x)
{
  if constexpr (!isWide)
    return hn::Div(set(1.0f), x);
  const V r = hn::ApproximateReciprocal(x);
  return hn::Mul(r, hn::NegMulAdd(x, r, set(2.0f)));
}

/// e^-x for x >= 0.
HWY_INLINE V expOfMinus(V x)
{
  const D d;
  const hn::RebindToSigned<D> di;
  const V t = hn::Max(hn::Mul(x, set(-1.44269504f)), set(-126.0f));
  const V whole = hn::Round(t), f = hn::Sub(t, whole);
  V p = set(1.5252734e-5f);
  for (const float c :
    {1.5403530e-4f, 1.3333558e-3f, 9.6181291e-3f, 5.5504109e-2f, 0.24022651f, 0.69314718f, 1.0f})
    p = hn::MulAdd(p, f, set(c));
  const VI power = hn::Add(hn::ConvertTo(di, whole), hn::Set(di, 127));
  return hn::Mul(p, hn::BitCast(d, hn::ShiftLeft<23>(power)));
}

/// The rows of a WalkTransfer that values lie in, as WalkTransfer::rowOf().
HWY_INLINE VI rowsOf(const WalkTransfer& transfer, V value)
{
  const D d;
  const DI di;
  value = hn::Min(value, set(std::numeric_limits<float>::max()));
  const V at = hn::Mul(hn::Sub(value, set(transfer.binsFrom())), set(transfer.binsPer()));
  const V last = set(static_cast<float>(WalkTransfer::bins - 1));
  const V inside = hn::IfThenElseZero(hn::Gt(at, hn::Zero(d)), hn::Min(at, last));
  const WalkTransfer::Table table = transfer.table();
  const VI bin = hn::ConvertTo(di, inside);
  VI row = hn::GatherIndex(di, reinterpret_cast<const std::int32_t*>(table.bins), bin);
  M isBefore = hn::Le(hn::GatherIndex(d, table.ends, bin), value);
  row = hn::Sub(row, hn::VecFromMask(di, hn::RebindMask(di, isBefore)));
  while (HWY_UNLIKELY(!table.isFine && !hn::AllFalse(d, isBefore)))
  {
    isBefore = hn::Le(hn::GatherIndex(d, &table.rows->end, hn::ShiftLeft<4>(row)), value);
    row = hn::Sub(row, hn::VecFromMask(di, hn::RebindMask(di, isBefore)));
  }
  return row;
}

/// What is seen at values, extinction and extinction times colour, and integrals up to there.
struct Seen
{
  V value[4], integral[4];

  /// `rows` are those of rowsOf(), as many as a vector has numbers.
  HWY_INLINE Seen(const WalkTransfer::Row* of, V at, const std::uint32_t* rows)
  {
    V from[4], slope[4], other[4];
    loadFours([&](std::size_t k) { return of[rows[k]].value; }, from);
    loadFours([&](std::size_t k) { return of[rows[k]].slope; }, slope);
    loadFours([&](std::size_t k) { return of[rows[k]].integral; }, integral);
    loadFours([&](std::size_t k) { return &of[rows[k]].from; }, other);
    const V step = hn::Sub(at, other[0]), half = hn::Mul(set(0.5f), step);
    for (std::size_t c = 0; c < 4; ++c)
    {
      value[c] = hn::MulAdd(step, slope[c], from[c]);
      integral[c] = hn::MulAdd(step, hn::MulAdd(half, slope[c], from[c]), integral[c]);
    }
  }
};

/// The light of lines between two values.
struct LineLight
{
  V passing, light[3]; ///< what comes through; premultiplied colour
  M isRough;           ///< opacity or colour change too much for this to be exact

  /// `from` and `to` are what is seen at the ends, `mean` its mean, each extinction first; `isSame`
  /// where both ends lie in a row, `share` as in WalkTask.
  HWY_INLINE LineLight(
    const V (&from)[4], const V (&to)[4], const V (&mean)[4], V depth, M isSame, float share)
  {
    const D d;
    const V one = set(1.0f), tiny = set(1e-37f);
    const V thick = hn::Mul(mean[0], depth), square = hn::Mul(thick, thick);
    const V perFrom = reciprocal(hn::Max(from[0], tiny)), perTo = reciprocal(hn::Max(to[0], tiny));
    V change[3], most = hn::Zero(d);
    for (std::size_t c = 0; c < 3; ++c)
    {
      change[c] = hn::Sub(hn::Mul(to[c + 1], perTo), hn::Mul(from[c + 1], perFrom));
      most = hn::Max(most, hn::Abs(change[c]));
    }
    const V uneven = hn::MulAdd(hn::Abs(hn::Sub(to[0], from[0])), depth, square);
    isRough = hn::Or(
      hn::Gt(hn::Mul(most, uneven), set(share)), hn::AndNot(isSame, hn::Gt(square, set(share))));
    passing = expOfMinus(thick);
    const V weight = hn::Mul(hn::Sub(one, passing), reciprocal(hn::Max(mean[0], tiny)));
    // Of what is coloured evenly along the way, the front hides a part of the back: for an optical
    // depth x, x^2 / (12 + 6 x + 1.2 x^2) of the change of colour, as good as exact up to 2.
    const V hidden = hn::Mul(
      square, reciprocal(hn::MulAdd(set(1.2f), square, hn::MulAdd(set(6.0f), thick, set(12.0f)))));
    for (std::size_t c = 0; c < 3; ++c)
      light[c] = hn::NegMulAdd(hidden, change[c], hn::Mul(weight, mean[c + 1]));
  }
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
