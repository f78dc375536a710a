// Many look-ups in occlusion maps at a time, compiled once for every SIMD instruction set.

#include "OcclusionLookUp.h"

#include <algorithm>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "occlusion/OcclusionLookUp.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DI = hn::Rebind<std::int32_t, DF>;
using DW = hn::Rebind<std::uint16_t, DF>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;

constexpr float pi = 3.14159265358979f;

HWY_INLINE VF set(float x)
{
  return hn::Set(DF(), x);
}

HWY_INLINE VI setInt(std::int32_t x)
{
  return hn::Set(DI(), x);
}

/// The polynomial of x with these coefficients, the highest power's first.
template <std::size_t N>
HWY_INLINE VF polynomial(VF x, const float (&coefficients)[N])
{
  VF sum = set(coefficients[0]);
  for (std::size_t k = 1; k < N; ++k)
    sum = hn::MulAdd(sum, x, set(coefficients[k]));
  return sum;
}

/// The arc cosine of x in [-1, 1], within 7e-5: Abramowitz and Stegun, 4.4.45.
HWY_INLINE VF arcCosine(VF x)
{
  static constexpr float coefficients[] = {-0.0187293f, 0.0742610f, -0.2121144f, 1.5707288f};
  const VF size = hn::Min(hn::Abs(x), set(1.0f));
  const VF angle = hn::Mul(hn::Sqrt(hn::Sub(set(1.0f), size)), polynomial(size, coefficients));
  return hn::IfThenElse(hn::Lt(x, hn::Zero(DF())), hn::Sub(set(pi), angle), angle);
}

/// The angle of (x, y), in [0, 2 pi], within 1e-4: the polynomial of four terms that errs least. 0
/// for (0, 0).
HWY_INLINE VF angleOf(VF x, VF y)
{
  static constexpr float coefficients[] = {-0.0389865f, 0.1462645f, -0.3211755f, 0.9992141f};
  const VF ax = hn::Abs(x), ay = hn::Abs(y);
  const VF most = hn::Max(hn::Max(ax, ay), set(1e-30f));
  const VF ratio = hn::Div(hn::Min(ax, ay), most);
  VF angle = hn::Mul(ratio, polynomial(hn::Mul(ratio, ratio), coefficients));
  const VF none = hn::Zero(DF());
  angle = hn::IfThenElse(hn::Gt(ay, ax), hn::Sub(set(0.5f * pi), angle), angle);
  angle = hn::IfThenElse(hn::Lt(x, none), hn::Sub(set(pi), angle), angle);
  return hn::IfThenElse(hn::Lt(y, none), hn::Sub(set(2.0f * pi), angle), angle);
}

/// Where look-ups lie in their maps: the two rows about each, and in these two texels.
struct Places
{
  struct Row
  {
    alignas(
      64) std::int32_t left[OcclusionLookUp::capacity]; ///< texel; across the seam the row's first
    /// The texel on the left, and on its right times 256.
    alignas(64) std::uint16_t pair[OcclusionLookUp::capacity];
    std::int32_t seam[OcclusionLookUp::capacity + 16]; ///< look-ups with the seam between the two
    int seams = 0;
  };
  Row row[2];                                         ///< above, below
  alignas(64) float down[OcclusionLookUp::capacity];  ///< share of the way to the row below
  alignas(64) float along[OcclusionLookUp::capacity]; ///< and to the next column
};

/// Of `count` numbers those from `i` on.
HWY_INLINE VF loadSome(const float* from, int i, int count)
{
  const DF d;
  if (i + static_cast<int>(hn::Lanes(d)) <= count)
    return hn::LoadU(d, from + i);
  alignas(64) float rest[16] = {};
  std::copy(from + i, from + count, rest);
  return hn::Load(d, rest);
}

HWY_INLINE void storeSome(VF v, float* to, int i, int count)
{
  const DF d;
  if (i + static_cast<int>(hn::Lanes(d)) <= count)
    return hn::StoreU(v, d, to + i);
  alignas(64) float rest[16];
  hn::Store(v, d, rest);
  std::copy(rest, rest + (count - i), to + i);
}

/// Places look-ups `i` and following in a row of maps with `last` + 1 texels along a side.
HWY_INLINE void placeInRow(VI row, VI column, VI last, VI shift, int i, Places::Row& to)
{
  const DI di;
  const VI left = hn::And(column, last);
  const auto isSeam = hn::Eq(left, last);
  const VI start = hn::Shl(row, shift);
  hn::Store(hn::Add(start, hn::IfThenZeroElse(isSeam, left)), di, to.left + i);
  if (!hn::AllFalse(di, isSeam))
    to.seams +=
      static_cast<int>(hn::CompressStore(hn::Iota(di, i), isSeam, di, to.seam + to.seams));
}

void place(
  const OcclusionLookUp& b, const float* nx, const float* ny, const float* nz, Places& places)
{
  const DF d;
  const DI di;
  for (int i = 0; i < b.count; i += static_cast<int>(hn::Lanes(d)))
  {
    const VI shift = hn::Load(di, b.shift + i);
    const VI n = hn::Shl(setInt(1), shift), last = hn::Sub(n, setInt(1));
    const VF side = hn::ConvertTo(d, n);
    const VF polar = arcCosine(loadSome(nz, i, b.count));
    const VF around = angleOf(loadSome(nx, i, b.count), loadSome(ny, i, b.count));
    const VF v = hn::MulSub(hn::Mul(polar, set(1.0f / pi)), side, set(0.5f));
    const VF u = hn::MulSub(hn::Mul(around, set(0.5f / pi)), side, set(0.5f));
    const VF row = hn::Floor(v), column = hn::Floor(u);
    hn::Store(hn::Sub(v, row), d, places.down + i);
    hn::Store(hn::Sub(u, column), d, places.along + i);
    const VI above = hn::ConvertTo(di, row), left = hn::ConvertTo(di, column);
    const VI below = hn::Add(above, setInt(1)), zero = hn::Zero(di);
    // Beyond a pole lies the same row, half-way round.
    const VI opposite = hn::Add(left, hn::ShiftRight<1>(n));
    placeInRow(hn::Max(above, zero), hn::IfThenElse(hn::Lt(above, zero), opposite, left), last,
      shift, i, places.row[0]);
    placeInRow(hn::Min(below, last), hn::IfThenElse(hn::Gt(below, last), opposite, left), last,
      shift, i, places.row[1]);
  }
}

/// Reads the texels of a row, two at a time.
void read(const OcclusionLookUp& b, Places::Row& row)
{
  for (int i = 0; i < b.count; ++i)
    std::memcpy(row.pair + i, b.map[i] + row.left[i], 2);
  for (int k = 0; k < row.seams && row.seam[k] < b.count; ++k)
  {
    const int i = row.seam[k];
    const std::uint8_t* first = b.map[i] + row.left[i];
    row.pair[i] = static_cast<std::uint16_t>(first[(1 << b.shift[i]) - 1] | first[0] << 8);
  }
}

void blend(const OcclusionLookUp& b, const float* nx, const float* ny, const float* nz,
  float maximum, float* values)
{
  Places places;
  place(b, nx, ny, nz, places);
  read(b, places.row[0]);
  read(b, places.row[1]);
  const DF d;
  const DI di;
  for (int i = 0; i < b.count; i += static_cast<int>(hn::Lanes(d)))
  {
    const VF along = hn::Load(d, places.along + i), down = hn::Load(d, places.down + i);
    const auto inRow = [&](int row)
    {
      const VI pair = hn::PromoteTo(di, hn::Load(DW(), places.row[row].pair + i));
      const VF left = hn::ConvertTo(d, hn::And(pair, setInt(255)));
      const VF right = hn::ConvertTo(d, hn::ShiftRight<8>(pair));
      const VF square = hn::Mul(left, left);
      return hn::MulAdd(along, hn::MulSub(right, right, square), square);
    };
    const VF upper = inRow(0), lower = inRow(1);
    const VF sum = hn::MulAdd(down, hn::Sub(lower, upper), upper);
    const VF value = hn::Mul(hn::Mul(sum, set(1.0f / (255.0f * 255.0f))), set(maximum));
    storeSome(value, values, i, b.count);
  }
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote
{

HWY_EXPORT(blend);

void OcclusionLookUp::blend(
  const float* nx, const float* ny, const float* nz, float maximum, float* values) const
{
  HWY_DYNAMIC_DISPATCH(blend)(*this, nx, ny, nz, maximum, values);
}

} // namespace mote

#endif
