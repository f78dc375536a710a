// Silhouette pixels of one row of a depth image, compiled once for every SIMD instruction set.

#include "detail/SilhouetteSteps.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "imaging/SilhouetteSteps.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DG = hn::CappedTag<std::uint64_t, 8>;
using D1 = hn::CappedTag<float, 1>; ///< for the pixels that whole vectors leave over

/// A pixel of each lane and the eight around it.
template <typename D>
struct Neighbours
{
  using V = hn::Vec<D>;
  V center, left, right, down, up, downLeft, downRight, upLeft, upRight;

  /// Those beside lie `side` columns away: 0 at the image's border, where they count not.
  HWY_INLINE Neighbours(D d, const DistanceRows& rows, int x, int side)
    : center(hn::LoadU(d, rows.row + x))
    , left(hn::LoadU(d, rows.row + x - side))
    , right(hn::LoadU(d, rows.row + x + side))
    , down(hn::LoadU(d, rows.down + x))
    , up(hn::LoadU(d, rows.up + x))
    , downLeft(hn::LoadU(d, rows.down + x - side))
    , downRight(hn::LoadU(d, rows.down + x + side))
    , upLeft(hn::LoadU(d, rows.up + x - side))
    , upRight(hn::LoadU(d, rows.up + x + side))
  {
  }
};

/// How much farther the centre is than two opposite neighbours together; 0 if one is background.
template <typename D, typename V>
HWY_INLINE V pairStep(D d, V center, V a, V b)
{
  const V sum = hn::Add(hn::Sub(center, a), hn::Sub(center, b));
  return hn::IfThenElseZero(hn::Gt(sum, hn::Set(d, -std::numeric_limits<float>::max())), sum);
}

/// Code of the direction of the neighbours that are nearer than the centre by more than `least`.
template <typename D, typename V = hn::Vec<D>>
HWY_INLINE V directionCode(D d, const Neighbours<D>& n, V least)
{
  const V one = hn::Set(d, 1.0f), zero = hn::Zero(d);
  const auto isNear = [&](V neighbour)
  { return hn::IfThenElseZero(hn::Gt(hn::Sub(n.center, neighbour), least), one); };
  const V rising = hn::Sub(isNear(n.upRight), isNear(n.downLeft));
  const V falling = hn::Sub(isNear(n.upLeft), isNear(n.downRight));
  const V x = hn::Add(hn::Sub(isNear(n.right), isNear(n.left)), hn::Sub(rising, falling));
  const V y = hn::Add(hn::Sub(isNear(n.up), isNear(n.down)), hn::Add(rising, falling));
  const V ax = hn::Abs(x), ay = hn::Abs(y);
  // Sectors of 22.5 degrees from 0 to 90, bounded by the tangents of 11.25, 33.75 ... degrees.
  V code = zero;
  for (const float tangent : {0.19891237f, 0.66817864f, 1.49660576f, 5.02733949f})
    code = hn::Add(code, hn::IfThenElseZero(hn::Gt(ay, hn::Mul(ax, hn::Set(d, tangent))), one));
  code = hn::IfThenElse(hn::Lt(x, zero), hn::Sub(hn::Set(d, 8.0f), code), code);
  code = hn::IfThenElse(hn::Lt(y, zero), hn::Sub(hn::Set(d, 16.0f), code), code);
  const V none = hn::Set(d, static_cast<float>(SilhouetteRow::round));
  return hn::IfThenElse(hn::Eq(hn::Add(ax, ay), zero), none, code);
}

template <typename D, typename V = hn::Vec<D>>
HWY_INLINE void storeBytes(D d, V values, std::uint8_t* out)
{
  const hn::Rebind<std::uint8_t, D> db;
  const hn::RebindToSigned<D> di;
  hn::StoreU(hn::DemoteTo(db, hn::ConvertTo(di, values)), db, out);
}

/// Levels and opacities of silhouette pixels with these steps.
template <typename D, typename V = hn::Vec<D>>
HWY_INLINE void storeGrades(
  D d, V step, const SilhouetteGrades& grades, std::uint8_t* level, std::uint8_t* opacity)
{
  const auto number = [&](float v) { return hn::Set(d, v); };
  const V one = number(1.0f), half = number(0.5f);
  // Steps below the threshold's own are no weaker; the logarithm wants finite numbers.
  const V share = hn::Min(hn::Max(hn::Mul(step, number(grades.perStep)), one), number(1e30f));
  const V strength = hn::Min(hn::Mul(hn::Log2(d, share), number(grades.perLog)), one);
  const V least = number(grades.leastOpacity);
  const V opaque = hn::MulAdd(strength, hn::Sub(one, least), least);
  storeBytes(d, hn::MulAdd(strength, number(SilhouetteRow::levels - 1.0f), half), level);
  storeBytes(d, hn::MulAdd(opaque, number(SilhouetteRow::opaque), half), opacity);
}

/// Whether the pixels beside that are nearer are so by about a third of the limit together, or by
/// anything if this one is background; others, which are most, are no silhouette
/// pixels.
template <typename D, typename V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> isBehindOthers(D d, const DistanceRows& rows, V least, int x, int side)
{
  const V center = hn::LoadU(d, rows.row + x);
  const V left = hn::Min(hn::LoadU(d, rows.row + x - side), center);
  const V right = hn::Min(hn::LoadU(d, rows.row + x + side), center);
  const V down = hn::Min(hn::LoadU(d, rows.down + x), center);
  const V up = hn::Min(hn::LoadU(d, rows.up + x), center);
  const V sum = hn::Add(hn::Add(hn::Sub(center, left), hn::Sub(center, right)),
    hn::Add(hn::Sub(center, down), hn::Sub(center, up)));
  const V nearest = hn::Min(hn::Min(left, right), hn::Min(down, up));
  // A little less, for rounding. All of them infinite is background alone.
  return hn::Or(hn::Gt(sum, hn::Mul(least, hn::Set(d, 0.99f / 3.0f))),
    hn::And(hn::Eq(center, hn::Inf(d)), hn::Lt(nearest, center)));
}

/// Adds the silhouette pixels of a vector at x.
template <typename D>
HWY_INLINE void findStepsAt(D d, const DistanceRows& rows, const StepLimit& limit,
  const SilhouetteGrades& grades, int x, int side, const SilhouetteRow& found)
{
  using V = hn::Vec<D>;
  const V least =
    hn::Max(hn::Set(d, limit.least), hn::Mul(hn::Set(d, limit.share), hn::LoadU(d, rows.row + x)));
  if (HWY_LIKELY(hn::AllFalse(d, isBehindOthers(d, rows, least, x, side))))
    return;
  const Neighbours<D> n(d, rows, x, side);
  const V infinity = hn::Inf(d);
  const V four =
    hn::Add(pairStep(d, n.center, n.left, n.right), pairStep(d, n.center, n.down, n.up));
  const V slanted = hn::Add(
    pairStep(d, n.center, n.downLeft, n.upRight), pairStep(d, n.center, n.upLeft, n.downRight));
  const V eight = hn::Add(four, slanted);
  const V third = hn::Set(d, 1.0f / 3.0f);
  const auto isStep = hn::And(hn::Gt(eight, least), hn::Gt(four, hn::Mul(least, third)));
  const V nearest = hn::Min(hn::Min(n.left, n.right), hn::Min(n.down, n.up));
  // A background pixel has no step of its own, so the two cannot both hold.
  const auto isHull = hn::And(hn::Gt(n.center, nearest), hn::Eq(n.center, infinity));
  const auto isBorder = limit.hulls ? hn::Or(isStep, isHull) : isStep;
  if (HWY_LIKELY(hn::AllFalse(d, isBorder)))
    return;
  // A pit of one pixel: all around it is nearer by more than a step.
  const V farthest = hn::Max(hn::Max(hn::Max(n.left, n.right), hn::Max(n.down, n.up)),
    hn::Max(hn::Max(n.downLeft, n.upRight), hn::Max(n.upLeft, n.downRight)));
  const V nearer = hn::IfThenElse(isHull, infinity, hn::Sub(n.center, hn::Mul(least, third)));
  const auto isSilhouette = hn::And(isBorder, hn::Ge(farthest, nearer));
  if (hn::AllFalse(d, isSilhouette))
    return;
  *found.any = true;
  const V mean = hn::Mul(eight, hn::Set(d, 0.125f));
  const V code = directionCode(d, n, hn::IfThenZeroElse(isHull, mean));
  const V none = hn::Set(d, static_cast<float>(SilhouetteRow::none));
  storeBytes(d, hn::IfThenElse(isSilhouette, code, none), found.code + x);
  if (grades.graded)
    storeGrades(d, hn::IfThenElse(isHull, infinity, hn::Mul(eight, third)), grades, found.level + x,
      found.opacity + x);
}

void steps(const DistanceRows& rows, const StepLimit& limit, const SilhouetteGrades& grades,
  int width, int begin, int end, const SilhouetteRow& found)
{
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int x = begin;
  if (x == 0 && x < end)
    findStepsAt(D1(), rows, limit, grades, x++, 0, found);
  const int inner = std::min(end, width - 1);
  for (; x + lanes <= inner; x += lanes)
    findStepsAt(d, rows, limit, grades, x, 1, found);
  for (; x < inner; ++x)
    findStepsAt(D1(), rows, limit, grades, x, 1, found);
  for (; x < end; ++x)
    findStepsAt(D1(), rows, limit, grades, x, 0, found);
}

template <typename D>
HWY_INLINE void distancesAt(
  D d, const DepthImage& image, const float* depth, double y, int x, float* out)
{
  using V = hn::Vec<D>;
  const V value = hn::LoadU(d, depth + x);
  const auto isSurface = hn::And(hn::Lt(value, hn::Set(d, image.background)),
    hn::Le(hn::Abs(value), hn::Set(d, std::numeric_limits<float>::max())));
  V distance = value;
  if (!image.alongRays && (image.dx != 0.0 || image.dy != 0.0))
  {
    const auto number = [&](double v) { return hn::Set(d, static_cast<float>(v)); };
    const V column = hn::Add(hn::Iota(d, 0), number(x + 0.5));
    const V tangent = hn::MulAdd(column, number(image.dx), number(image.x0));
    distance = hn::Mul(value, hn::Sqrt(hn::MulAdd(tangent, tangent, number(1.0 + y * y))));
  }
  hn::StoreU(hn::IfThenElse(isSurface, distance, hn::Inf(d)), d, out + x);
}

void distances(const DepthImage& image, int row, int begin, int end, float* out)
{
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const std::ptrdiff_t stride = image.depthStride != 0 ? image.depthStride : image.width;
  const float* depth = image.depth + row * stride;
  const double y = image.y0 + (row + 0.5) * image.dy;
  int x = begin;
  for (; x + lanes <= end; x += lanes)
    distancesAt(d, image, depth, y, x, out);
  for (; x < end; ++x)
    distancesAt(D1(), image, depth, y, x, out);
}

/// Adds the pixel at x where a nearer neighbour is of another group.
void findGroupAt(
  const DistanceRows& rows, const GroupRows& groups, int x, int side, const SilhouetteRow& found)
{
  const float distance = rows.row[x];
  const std::uint64_t group = groups.row[x];
  const auto isNear = [&](const float* row, const std::uint64_t* groupRow, int at) -> int
  {
    return groupRow[at] != group && row[at] < std::numeric_limits<float>::infinity() &&
           (row[at] < distance || (row[at] == distance && groupRow[at] < group));
  };
  if (!(distance < std::numeric_limits<float>::infinity()))
    return;
  const int left = isNear(rows.row, groups.row, x - side);
  const int right = isNear(rows.row, groups.row, x + side);
  const int down = isNear(rows.down, groups.down, x), up = isNear(rows.up, groups.up, x);
  if (left + right + down + up == 0)
    return;
  const int rising =
    isNear(rows.up, groups.up, x + side) - isNear(rows.down, groups.down, x - side);
  const int falling =
    isNear(rows.up, groups.up, x - side) - isNear(rows.down, groups.down, x + side);
  const int dx = right - left + rising - falling, dy = up - down + rising + falling;
  const long sector = std::lround(std::atan2(dy, dx) * (SilhouetteRow::directions / (2.0 * M_PI)));
  found.code[x] = dx == 0 && dy == 0
                    ? SilhouetteRow::round
                    : static_cast<std::uint8_t>(sector & (SilhouetteRow::directions - 1));
  found.level[x] = SilhouetteRow::levels - 1;
  found.opacity[x] = SilhouetteRow::opaque;
  *found.any = true;
}

void groupChanges(const DistanceRows& rows, const GroupRows& groups, int width, int begin, int end,
  const SilhouetteRow& found)
{
  const DG d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int x = begin;
  if (x == 0 && x < end)
    findGroupAt(rows, groups, x++, 0, found);
  const int inner = std::min(end, width - 1);
  for (; x + lanes <= inner; x += lanes)
  {
    const auto center = hn::LoadU(d, groups.row + x);
    const auto changes = [&](const std::uint64_t* at)
    { return hn::Xor(center, hn::LoadU(d, at + x)); };
    const auto any = hn::Or(hn::Or(changes(groups.row - 1), changes(groups.row + 1)),
      hn::Or(changes(groups.down), changes(groups.up)));
    if (hn::AllTrue(d, hn::Eq(any, hn::Zero(d))))
      continue;
    for (int i = x; i < x + lanes; ++i)
      findGroupAt(rows, groups, i, 1, found);
  }
  for (; x < inner; ++x)
    findGroupAt(rows, groups, x, 1, found);
  for (; x < end; ++x)
    findGroupAt(rows, groups, x, 0, found);
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote
{

HWY_EXPORT(distances);
HWY_EXPORT(steps);
HWY_EXPORT(groupChanges);

void rayDistances(const DepthImage& image, int y, int begin, int end, float* out)
{
  HWY_DYNAMIC_DISPATCH(distances)(image, y, begin, end, out);
}

void findSteps(const DistanceRows& rows, const StepLimit& limit, const SilhouetteGrades& grades,
  int width, int begin, int end, const SilhouetteRow& found)
{
  HWY_DYNAMIC_DISPATCH(steps)(rows, limit, grades, width, begin, end, found);
}

void findGroupChanges(const DistanceRows& rows, const GroupRows& groups, int width, int begin,
  int end, const SilhouetteRow& found)
{
  HWY_DYNAMIC_DISPATCH(groupChanges)(rows, groups, width, begin, end, found);
}

} // namespace mote

#endif
