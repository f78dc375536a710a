// What lines cover, pixel by pixel, compiled once for every SIMD instruction set.

#include "detail/LineStamps.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "imaging/LineStamps.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using DB = hn::CappedTag<std::uint8_t, 64>;
constexpr int coveredColumns = SilhouetteFinder::coveredColumns;
using VB = hn::Vec<DB>;

/// Whether a row has silhouette pixels in the columns [x - reach, x + lanes + reach).
HWY_INLINE bool hasSilhouettes(const std::uint8_t* code, int x, int reach)
{
  const DB d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  VB all = hn::And(hn::LoadU(d, code + x - reach), hn::LoadU(d, code + x + reach));
  for (int i = x - reach + lanes; i < x + reach; i += lanes)
    all = hn::And(all, hn::LoadU(d, code + i));
  return !hn::AllTrue(d, hn::Eq(all, hn::Set(d, SilhouetteRow::none)));
}

/// p / 254 for products of bytes, the factor 254 exactly: p / 254 = (p + p / 127) / 256, of which
/// the parts of p / 127 lose less than 2 by rounding.
constexpr unsigned rest = 2;

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE VB product(VB a, VB b)
{
  const unsigned p = unsigned(hn::GetLane(a)) * hn::GetLane(b);
  return hn::Set(DB(), static_cast<std::uint8_t>((p + (p >> 7) + (p >> 14) + rest) >> 8));
}

HWY_INLINE VB lookUp(const std::uint8_t* table, VB code)
{
  const std::uint8_t place = hn::GetLane(code);
  return hn::Set(DB(), place < SilhouetteRow::directions ? table[place] : std::uint8_t(0));
}

#else

HWY_INLINE VB product(VB a, VB b)
{
  const DB d;
  const hn::Repartition<std::uint16_t, DB> wide;
  const auto a16 = hn::BitCast(wide, a), b16 = hn::BitCast(wide, b);
  const auto low = hn::Set(wide, std::uint16_t(0xff));
  const auto share = [&](auto p)
  {
    const auto part = hn::Add(hn::ShiftRight<7>(p), hn::ShiftRight<14>(p));
    return hn::ShiftRight<8>(hn::Add(p, hn::Add(part, hn::Set(wide, std::uint16_t(rest)))));
  };
  const auto even = share(hn::Mul(hn::And(a16, low), hn::And(b16, low)));
  const auto odd = share(hn::Mul(hn::ShiftRight<8>(a16), hn::ShiftRight<8>(b16)));
  return hn::BitCast(d, hn::Or(hn::ShiftLeft<8>(odd), even));
}

/// 0 for codes with the highest bit.
HWY_INLINE VB lookUp(const std::uint8_t* table, VB code)
{
  return hn::TableLookupBytesOr0(hn::LoadDup128(DB(), table), code);
}

#endif

/// The coverage of 16 pixels or less, as floats.
HWY_INLINE void convert(const std::uint8_t* bytes, float* out)
{
  const hn::CappedTag<float, 16> df;
  const hn::Rebind<std::int32_t, decltype(df)> di;
  const hn::Rebind<std::uint8_t, decltype(df)> db;
  const auto unit = hn::Set(df, 1.0f / SilhouetteRow::opaque);
  for (int i = 0; i < coveredColumns; i += static_cast<int>(hn::Lanes(df)))
    hn::Store(
      hn::Mul(hn::ConvertTo(df, hn::PromoteTo(di, hn::LoadU(db, bytes + i))), unit), df, out + i);
}

/// Adds the coverage of `count` pixels of the row from column `x` of `out` on.
HWY_INLINE void addCoverage(VB cover, int x, int count, const CoverRow& out)
{
  alignas(64) std::uint8_t bytes[64 + coveredColumns] = {};
  hn::Store(cover, DB(), bytes);
  for (int i = 0; i < count; i += coveredColumns)
  {
    std::uint64_t some[coveredColumns / 8];
    std::memcpy(some, bytes + i, sizeof(some));
    if ((some[0] | some[1]) == 0)
      continue;
    alignas(64) float shares[coveredColumns];
    convert(bytes + i, shares);
    float* to = out.coverage + x + i;
    const int end = std::min(coveredColumns, count - i);
    if (out.covered != nullptr)
    {
      out.covered[(x + i) / coveredColumns] = 1;
      std::copy_n(shares, end, to);
    }
    else
      for (int k = 0; k < end; ++k)
        to[k] = std::max(to[k], shares[k]);
  }
}

/// The rows that reach into one, from `first` on.
struct RowsAround
{
  std::vector<SilhouetteRow> rows;
  std::vector<std::uint8_t>
    counts; ///< whether each has silhouettes near the pixels that are looked at
  int first;
};

/// What they cover of the pixels at x and following.
HWY_INLINE VB coverageAt(
  const RowsAround& around, const LineStamps& stamps, bool opacities, int y, int x)
{
  const DB d;
  const bool graded = stamps.levels().size() > 1;
  const VB round = hn::Set(d, SilhouetteRow::round);
  VB sum = hn::Zero(d);
  for (std::size_t level = 0; level < stamps.levels().size(); ++level)
    for (const StampPixel& pixel : stamps.levels()[level])
    {
      const int row = y - pixel.y - around.first;
      if (row < 0 || row >= static_cast<int>(around.rows.size()) || around.counts[row] == 0)
        continue;
      const SilhouetteRow& from = around.rows[row];
      const std::ptrdiff_t at = x - pixel.x;
      const VB code = hn::LoadU(d, from.code + at);
      VB value = hn::Or(lookUp(pixel.coverage, code),
        hn::IfThenElseZero(hn::Eq(code, round), hn::Set(d, pixel.round)));
      if (graded)
        value = hn::IfThenElseZero(
          hn::Eq(hn::LoadU(d, from.level + at), hn::Set(d, static_cast<std::uint8_t>(level))),
          value);
      if (opacities)
        value = product(value, hn::LoadU(d, from.opacity + at));
      sum = hn::Max(sum, value);
    }
  return sum;
}

void cover(SilhouetteRows& found, const LineStamps& stamps, bool opacities, int y, int firstRow,
  int lastRow, int begin, int end, const CoverRow& out)
{
  const int lanes = static_cast<int>(hn::Lanes(DB())), reach = stamps.reach();
  RowsAround around = {{}, {}, std::max(firstRow, y - reach)};
  bool some = false;
  for (int row = around.first; row <= std::min(lastRow, y + reach); ++row)
  {
    around.rows.push_back(found[row]);
    some = some || *around.rows.back().any;
  }
  around.counts.resize(around.rows.size());
  if (out.covered != nullptr)
    std::fill_n(out.covered, (end - begin + coveredColumns - 1) / coveredColumns, std::uint8_t{0});
  for (int x = begin; some && x < end; x += lanes)
  {
    bool any = false;
    for (std::size_t k = 0; k < around.rows.size(); ++k)
    {
      around.counts[k] = *around.rows[k].any && hasSilhouettes(around.rows[k].code, x, reach);
      any = any || around.counts[k] != 0;
    }
    if (!any)
      continue;
    addCoverage(
      coverageAt(around, stamps, opacities, y, x), x - begin, std::min(lanes, end - x), out);
  }
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote
{

HWY_EXPORT(cover);

namespace
{

/// The share of a pixel at (x, y) that the piece of line at (0, 0) covers, which is turned
/// towards the unit vector (nx, ny); (0, 0) for one without direction.
double coverageOf(int x, int y, double nx, double ny, double thickness, bool centered)
{
  // The border runs between the pixel and that beside it to which it is turned the most, so the
  // distance from the pixel's centre is even between 0 and this.
  const double most = std::max(std::abs(nx), std::abs(ny));
  const bool moved = centered && most > 0.0;
  const double away = moved ? 0.5 * most : 0.0;
  // Pieces of a diagonal are 1.41 pixels apart, and meet; those along an axis are 1 pixel apart,
  // and must not stick out at the line's end.
  const double half = moved ? 1.7 * (1.0 / most - 1.0) : 0.0;
  const double along = std::abs(nx * y - ny * x);
  const double distance =
    moved ? std::hypot(nx * x + ny * y - away, std::max(0.0, along - half)) : std::hypot(x, y);
  // A line thinner than a pixel is as wide as one, and fainter.
  const double radius = 0.5 * std::max(1.0, thickness) + 0.5;
  return std::clamp(radius - distance, 0.0, 1.0) * std::clamp(thickness, 0.0, 1.0);
}

std::vector<StampPixel> makeStamp(double thickness, bool centered)
{
  const auto rounded = [](double coverage)
  { return static_cast<std::uint8_t>(std::lround(coverage * SilhouetteRow::opaque)); };
  std::vector<StampPixel> stamp;
  const int reach = static_cast<int>(std::ceil(0.5 * thickness + 2.0));
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x)
    {
      StampPixel pixel = {x, y, {}, rounded(coverageOf(x, y, 0.0, 0.0, thickness, centered))};
      int most = pixel.round;
      for (int k = 0; k < SilhouetteRow::directions; ++k)
      {
        const double angle = 2.0 * M_PI * k / SilhouetteRow::directions;
        pixel.coverage[k] =
          rounded(coverageOf(x, y, std::cos(angle), std::sin(angle), thickness, centered));
        most = std::max<int>(most, pixel.coverage[k]);
      }
      if (most > 0)
        stamp.push_back(pixel);
    }
  return stamp;
}

} // namespace

LineStamps::LineStamps(const SilhouetteOptions& options)
{
  const bool graded = options.leastThickness != 1.0;
  const int count = graded ? SilhouetteRow::levels : 1;
  for (int level = 0; level < count; ++level)
  {
    const double strength = graded ? level / (count - 1.0) : 1.0;
    const double share = options.leastThickness + strength * (1.0 - options.leastThickness);
    levels_.push_back(makeStamp(share * options.thickness * options.reduction, options.centered));
    for (const StampPixel& pixel : levels_.back())
      reach_ = std::max({reach_, std::abs(pixel.x), std::abs(pixel.y)});
  }
}

void coverRow(SilhouetteRows& found, const LineStamps& stamps, bool opacities, int y, int firstRow,
  int lastRow, int begin, int end, const CoverRow& out)
{
  HWY_DYNAMIC_DISPATCH(cover)
  (found, stamps, opacities, y, firstRow, lastRow, begin, end, out);
}

} // namespace mote

#endif
