// Edges of one row of a depth image, compiled once for every SIMD instruction set.

#include "SilhouetteRows.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "imaging/SilhouetteRows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, EdgePixels::spare>;
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
  const auto shares = [&](V neighbour, float code)
  { return hn::IfThenElseZero(hn::Gt(hn::Sub(n.center, neighbour), least), hn::Set(d, code)); };
  const V beside = hn::Add(shares(n.right, 1.0f), shares(n.left, -1.0f));
  const V above = hn::Add(shares(n.up, 7.0f), shares(n.down, -7.0f));
  const V rising = hn::Add(shares(n.upRight, 8.0f), shares(n.downLeft, -8.0f));
  const V falling = hn::Add(shares(n.upLeft, 6.0f), shares(n.downRight, -6.0f));
  return hn::Add(
    hn::Add(hn::Add(beside, above), hn::Add(rising, falling)), hn::Set(d, 24.0f)); // (0, 0)
}

/// Edges among the pixels of a vector at x; appends them.
template <typename D>
HWY_INLINE void findStepsAt(
  D d, const DistanceRows& rows, const StepLimit& limit, int x, int side, EdgePixels& found)
{
  using V = hn::Vec<D>;
  const hn::RebindToSigned<D> di;
  const Neighbours<D> n(d, rows, x, side);
  const V infinity = hn::Inf(d);
  const V four =
    hn::Add(pairStep(d, n.center, n.left, n.right), pairStep(d, n.center, n.down, n.up));
  const V slanted = hn::Add(
    pairStep(d, n.center, n.downLeft, n.upRight), pairStep(d, n.center, n.upLeft, n.downRight));
  const V eight = hn::Add(four, slanted);
  const V least = hn::Max(hn::Set(d, limit.least), hn::Mul(hn::Set(d, limit.share), n.center));
  const V third = hn::Set(d, 1.0f / 3.0f);
  const auto isStep = hn::And(hn::Gt(eight, least), hn::Gt(four, hn::Mul(least, third)));
  const V nearest = hn::Min(hn::Min(n.left, n.right), hn::Min(n.down, n.up));
  // A background pixel has no step of its own, so the two cannot both hold.
  const auto isHull = hn::And(hn::Gt(n.center, nearest), hn::Eq(n.center, infinity));
  const auto isEdge = limit.hulls ? hn::Or(isStep, isHull) : isStep;
  if (HWY_LIKELY(hn::AllFalse(d, isEdge)))
    return;
  const V mean = hn::Mul(eight, hn::Set(d, 0.125f));
  const V code = directionCode(d, n, hn::IfThenZeroElse(isHull, mean));
  const V step = hn::IfThenElse(isHull, infinity, hn::Mul(eight, third));
  const int end = found.count;
  hn::CompressStore(hn::Iota(di, x), hn::RebindMask(di, isEdge), di, found.x.data() + end);
  hn::CompressStore(step, isEdge, d, found.step.data() + end);
  found.count += static_cast<int>(hn::CompressStore(
    hn::ConvertTo(di, code), hn::RebindMask(di, isEdge), di, found.direction.data() + end));
}

void steps(const DistanceRows& rows, const StepLimit& limit, int width, int begin, int end,
  EdgePixels& found)
{
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  found.count = 0;
  int x = begin;
  if (x == 0 && x < end)
    findStepsAt(D1(), rows, limit, x++, 0, found);
  const int inner = std::min(end, width - 1);
  for (; x + lanes <= inner; x += lanes)
    findStepsAt(d, rows, limit, x, 1, found);
  for (; x < inner; ++x)
    findStepsAt(D1(), rows, limit, x, 1, found);
  for (; x < end; ++x)
    findStepsAt(D1(), rows, limit, x, 0, found);
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

/// The pixel at x, if it is an edge by group.
void findGroupAt(
  const DistanceRows& rows, const GroupRows& groups, int x, int side, EdgePixels& found)
{
  const float distance = rows.row[x];
  const std::uint64_t group = groups.row[x];
  const auto isNear = [&](const float* row, const std::uint64_t* groupRow, int at)
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
  const int downLeft = isNear(rows.down, groups.down, x - side);
  const int downRight = isNear(rows.down, groups.down, x + side);
  const int upLeft = isNear(rows.up, groups.up, x - side);
  const int upRight = isNear(rows.up, groups.up, x + side);
  found.x[found.count] = x;
  found.step[found.count] = std::numeric_limits<float>::infinity();
  found.direction[found.count] = (right + downRight + upRight - left - downLeft - upLeft + 3) +
                                 7 * (up + upLeft + upRight - down - downLeft - downRight + 3);
  ++found.count;
}

void groupChanges(const DistanceRows& rows, const GroupRows& groups, int width, int begin, int end,
  EdgePixels& found)
{
  const DG d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  found.count = 0;
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

void findSteps(const DistanceRows& rows, const StepLimit& limit, int width, int begin, int end,
  EdgePixels& found)
{
  HWY_DYNAMIC_DISPATCH(steps)(rows, limit, width, begin, end, found);
}

void findGroupChanges(const DistanceRows& rows, const GroupRows& groups, int width, int begin,
  int end, EdgePixels& found)
{
  HWY_DYNAMIC_DISPATCH(groupChanges)(rows, groups, width, begin, end, found);
}

} // namespace mote

#endif
