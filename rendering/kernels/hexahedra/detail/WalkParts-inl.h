// What rays gather of their cells. To be included by CellWalkSimd.cpp, once for every instruction
// set.

#if defined(MOTE_WALK_PARTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_WALK_PARTS_INL
#undef MOTE_WALK_PARTS_INL
#else
#define MOTE_WALK_PARTS_INL
#endif

#include "WalkBends-inl.h"
#include "WalkRows-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{
namespace
{

/// Integrates what lies on the rays within their cells, from the value on one face to that on the
/// next one.
template <int axis>
class WalkParts
{
public:
  WalkParts(WalkTask& task, Lanes& lanesOfTask)
    : task_(task)
    , l_(lanesOfTask)
    , transfer_(*task.transfer)
    , bends_(task, lanesOfTask)
  {
  }

  /// Says that the value where a lane's next part begins is not where its last one ended.
  void begin(std::uint32_t which) { isFresh_ |= which; }

  /// Finds where the rays leave their cells, and adds what lies before.
  HWY_INLINE void add()
  {
    isClipped_ = isBent_ = isHalved_ = isQuartered_ = isFine_ = isDone_ = 0;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(D()))
      leave(first);
    // Lanes in hidden cells come to the values on the far faces, and gather nothing before.
    std::uint32_t isHidden = 0;
    if (task_.hidden != nullptr)
      forLanes(l_.active,
        [&](std::size_t k) { isHidden |= ((*task_.hidden)[l_.cell[k]] ? 1U : 0U) << k; });
    isClipped_ &= l_.active;
    isBent_ &= l_.active & ~isHidden;
    if (HWY_UNLIKELY(isClipped_ != 0))
      clip();
    if (task_.cells->isOfCells())
      isFresh_ = l_.active;
    if (HWY_UNLIKELY(task_.isAllSeldom))
      isDone_ = l_.active & ~isHidden;
    else if (isBent_ != 0)
      bend();
    forLanes(isFine_, [&](std::size_t k) { isDone_ &= ~(addFine(k) ? 1U << k : 0U); });
    forLanes(isDone_,
      [&](std::size_t k) { addSeldom(k, l_.z[k], l_.outZ[k], l_.partIn[k], l_.partOut[k]); });
    if (isFresh_ != 0)
      forLanes(isFresh_, [&](std::size_t k) { start(k); });
    isFresh_ = 0;
    isDone_ |= isFine_ | isHidden;
    if ((isHalved_ | isQuartered_) != 0)
    {
      if (isQuartered_ != 0)
        integrate<1>(l_.quarter[0], isQuartered_);
      integrate<2>(l_.quarter[1], isHalved_ | isQuartered_);
      if (isQuartered_ != 0)
        integrate<3>(l_.quarter[2], isQuartered_);
    }
    integrate<4>(l_.partOut, l_.active);
  }

private:
  HWY_INLINE void leave(std::size_t first)
  {
    const D d;
    FaceCorners c;
    if constexpr (isWide)
    {
      loadFours([&](std::size_t k) { return l_.face[first + k]; }, c.x);
      loadFours([&](std::size_t k) { return l_.face[first + k] + 4; }, c.y);
      loadFours([&](std::size_t k) { return l_.face[first + k] + 8; }, c.z);
      loadFours([&](std::size_t k) { return l_.face[first + k] + 12; }, c.value);
    }
    else
      for (std::size_t i = 0; i < 4; ++i)
      {
        c.x[i] = hn::Load(d, l_.cornerX[i] + first);
        c.y[i] = hn::Load(d, l_.cornerY[i] + first);
        c.z[i] = hn::Load(d, l_.cornerZ[i] + first);
        c.value[i] = hn::Load(d, l_.cornerValue[i] + first);
      }
    const PatchPlace place = passPatch(c.x, c.y, task_.isBackwards);
    hn::Store(place.u, d, l_.outU + first);
    hn::Store(place.v, d, l_.outV + first);
    V z = place.of(c.z), value = place.of(c.value);
    if (task_.isBackwards)
      z = hn::Neg(z);
    const V in = hn::Load(d, l_.z + first);
    V before = hn::Load(d, l_.value + first);
    if (task_.cells->isOfCells())
      before = value = hn::Load(d, l_.cellValue + first);
    z = hn::Max(z, in);
    hn::Store(z, d, l_.outZ + first);
    hn::Store(value, d, l_.outValue + first);
    const V from = hn::Load(d, l_.from + first), to = hn::Load(d, l_.to + first);
    const V depth = hn::Max(hn::Sub(hn::Min(z, to), hn::Max(in, from)), hn::Zero(d));
    hn::Store(hn::Mul(depth, hn::Load(d, l_.length + first)), d, l_.depth + first);
    hn::Store(before, d, l_.partIn + first);
    hn::Store(value, d, l_.partOut + first);
    const V through = hn::Load(d, l_.transmittance + first);
    const V error = hn::Mul(hn::Mul(hn::Load(d, l_.bend + first), set(task_.rate)), through);
    isBent_ |= maskOf(hn::And(hn::Ge(error, set(task_.allowed)), hn::Gt(depth, hn::Zero(d))))
               << first;
    isClipped_ |= maskOf(hn::Or(hn::Lt(in, from), hn::Gt(z, to))) << first;
  }
  /// Cuts parts off that lie before or behind what is wanted of the rays.
  void clip()
  {
    forLanes(isClipped_,
      [&](std::size_t k)
      {
        const float in = l_.z[k], change = l_.partOut[k] - l_.partIn[k], before = l_.partIn[k];
        const auto at = [&](float z)
        {
          const float share = (z - in) / (l_.outZ[k] - in);
          return share > 0.0f ? before + std::min(share, 1.0f) * change : before;
        };
        l_.partIn[k] = at(l_.from[k]);
        if (l_.outZ[k] > l_.to[k])
          l_.partOut[k] = at(l_.to[k]);
      });
    isFresh_ |= isClipped_;
  }

  /// Of lanes whose values may be too far from a line, finds those that are not, and those that are
  /// as good as two or four lines. The others are integrated one at a time.
  void bend()
  {
    std::uint32_t bent = 0;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(D()))
      bent |= findRates(first) << first;
    isBent_ &= bent;
    if (isBent_ == 0)
      return;
    const auto good = bends_.find(isBent_ & ~isClipped_);
    isHalved_ = good.two & ~good.line;
    isQuartered_ = good.four & ~(good.two | good.line);
    isFine_ = good.fine & ~(good.four | good.two | good.line);
    isDone_ |= isBent_ & ~(good.four | good.line);
  }

  /// How fast what is seen changes in the cells of these lanes; gives those that are no lines then.
  HWY_INLINE std::uint32_t findRates(std::size_t first)
  {
    const D d;
    const V in = hn::Load(d, l_.partIn + first), out = hn::Load(d, l_.partOut + first);
    const V bend = hn::Load(d, l_.bend + first), far = set(std::numeric_limits<float>::max());
    const V lower = hn::Sub(hn::Min(in, out), bend), upper = hn::Add(hn::Max(in, out), bend);
    const V rate = hn::IfThenElse(hn::Le(bend, far), rateIn(lower, upper), far);
    hn::Store(rate, d, l_.rate + first);
    const V error = hn::Mul(hn::Mul(rate, bend), hn::Load(d, l_.transmittance + first));
    return maskOf(hn::Not(hn::Lt(error, set(task_.allowed))));
  }
  /// How fast what is seen changes between two values, at most; see WalkTransfer::Rates.
  HWY_INLINE V rateIn(const V& lower, const V& upper) const
  {
    const D d;
    const DI di;
    const WalkTransfer::Rates rates = transfer_.rates();
    const auto binOf = [&](const V& value)
    {
      const V at = hn::Mul(hn::Sub(value, set(transfer_.binsFrom())), set(rates.binsPer));
      const V last = set(static_cast<float>(WalkTransfer::coarseBins - 1));
      return hn::ConvertTo(di, hn::IfThenElseZero(hn::Gt(at, hn::Zero(d)), hn::Min(at, last)));
    };
    const VI one = hn::Set(di, 1), first = binOf(lower), last = hn::Max(binOf(upper), first);
    const V count = hn::ConvertTo(d, hn::Add(hn::Sub(last, first), one));
    const VI level = hn::Sub(hn::ShiftRight<23>(hn::BitCast(di, count)), hn::Set(di, 127));
    const VI row = hn::ShiftLeft<6>(level);
    static_assert(WalkTransfer::coarseBins == 64);
    const VI end = hn::Add(hn::Sub(last, hn::Shl(one, level)), one);
    const V rate = hn::Max(hn::GatherIndex(d, rates.most, hn::Add(row, first)),
      hn::GatherIndex(d, rates.most, hn::Add(row, end)));
    if (!rates.hasSteps)
      return rate;
    const V steps = hn::Sub(hn::GatherIndex(d, rates.stepsBefore, hn::Add(last, one)),
      hn::GatherIndex(d, rates.stepsBefore, first));
    const V more = hn::Add(rate, hn::Div(steps, hn::Sub(upper, lower)));
    return hn::IfThenElse(hn::Gt(steps, hn::Zero(d)), more, rate);
  }

  /// Adds a part of a ray by CellIntegral.
  void addSeldom(std::size_t k, float z0, float z1, float value0, float value1)
  {
    ++task_.seldomParts;
    float color[4] = {l_.color[0][k], l_.color[1][k], l_.color[2][k], l_.transmittance[k]};
    const float from = l_.from[k], to = l_.to[k];
    const WalkPart part{static_cast<int>(l_.ray(k)), l_.cell[k],
      {std::max(z0, from), std::min(z1, to)}, {value0, value1},
      {z0 < from || z0 != l_.z[k], z1 > to || z1 != l_.outZ[k]}, l_.bend[k]};
    if (part.z[0] < part.z[1])
      task_.seldom->add(part, color);
    for (std::size_t c = 0; c < 3; ++c)
      l_.color[c][k] = color[c];
    l_.transmittance[k] = color[3];
  }

  /// Begins at a value.
  void start(std::size_t k)
  {
    const float value = l_.partIn[k];
    const std::uint32_t r = transfer_.rowOf(value);
    const WalkTransfer::Row& row = transfer_.row(r);
    l_.row[k] = r;
    l_.at[k] = value;
    const float step = value - row.from;
    for (std::size_t c = 0; c < 4; ++c)
    {
      const float rise = step * row.slope[c];
      l_.atValue[c][k] = row.value[c] + rise;
      l_.atIntegral[c][k] = row.integral[c] + step * (row.value[c] + 0.5f * rise);
    }
  }

  /// How much of its way a lane goes at a time, in quarters.
  HWY_INLINE int strideOf(std::size_t k) const
  {
    return (isQuartered_ >> k & 1U) != 0 ? 1 : (isHalved_ >> k & 1U) != 0 ? 2 : 4;
  }

  /// Lets lanes go on to the values `goal`, which they have at so many quarters of their ways.
  template <int quarters>
  HWY_INLINE void integrate(const Floats& goal, std::uint32_t which)
  {
    isSeldom_ = 0;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(D()))
      hn::Store(rowsOf(transfer_, hn::Load(D(), goal + first)), DI(),
        reinterpret_cast<std::int32_t*>(l_.goalRow + first));
    which &= ~isDone_;
    if (transfer_.hasSolid())
      forLanes(which, [&](std::size_t k)
        { isSeldom_ |= (transfer_.isSolid(l_.row[k], l_.goalRow[k]) ? 1U : 0U) << k; });
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(D()))
      gather<quarters == 4>(goal, which >> first, first);
    forLanes(isSeldom_,
      [&](std::size_t k)
      {
        const int before = quarters - strideOf(k);
        const float z = l_.z[k], step = 0.25f * (l_.outZ[k] - z);
        addSeldom(k, before == 0 ? z : z + static_cast<float>(before) * step,
          quarters == 4 ? l_.outZ[k] : z + static_cast<float>(quarters) * step,
          before == 0 ? l_.partIn[k] : l_.quarter[std::max(before, 1) - 1][k], goal[k]);
      });
  }

  template <bool isAll>
  HWY_INLINE void gather(const Floats& goal, std::uint32_t which, std::size_t first)
  {
    const D d;
    const DI di;
    const VI row = hn::Load(di, reinterpret_cast<const std::int32_t*>(l_.row + first));
    const VI goalRow = hn::Load(di, reinterpret_cast<const std::int32_t*>(l_.goalRow + first));
    const M isSame = hn::RebindMask(d, hn::Eq(row, goalRow));
    const V end = hn::Load(d, goal + first);
    const V perChange = reciprocal(hn::Sub(end, hn::Load(d, l_.at + first)));
    const Seen to(transfer_.table().rows, end, l_.goalRow + first);
    V from[4], mean[4];
    for (std::size_t c = 0; c < 4; ++c)
    {
      from[c] = hn::Load(d, l_.atValue[c] + first);
      const V across =
        hn::Mul(hn::Sub(to.integral[c], hn::Load(d, l_.atIntegral[c] + first)), perChange);
      mean[c] = hn::IfThenElse(isSame, hn::Mul(set(0.5f), hn::Add(from[c], to.value[c])), across);
    }
    const M goes = lanesOf(which);
    const auto keep = [&](V value, float* at)
    { hn::Store(isAll ? value : hn::IfThenElse(goes, value, hn::Load(d, at)), d, at); };
    for (std::size_t c = 0; c < 4; ++c)
    {
      keep(to.value[c], l_.atValue[c] + first);
      keep(to.integral[c], l_.atIntegral[c] + first);
    }
    keep(end, l_.at + first);
    const VI rows = isAll ? goalRow : hn::IfThenElse(hn::RebindMask(di, goes), goalRow, row);
    hn::Store(rows, di, reinterpret_cast<std::int32_t*>(l_.row + first));
    const V share = hn::IfThenElse(lanesOf(isQuartered_ >> first), set(0.25f),
      hn::IfThenElse(lanesOf(isHalved_ >> first), set(0.5f), set(1.0f)));
    const V depth = hn::Mul(hn::Load(d, l_.depth + first), share);
    const LineLight line(from, to.value, mean, depth, isSame, task_.share);
    const std::uint32_t seldom = (maskOf(line.isRough) | isSeldom_ >> first) & which;
    isSeldom_ |= seldom << first;
    this->addLight(lanesOf(which & ~seldom), line, first);
  }

  /// Adds lines to the rays that are `plain`.
  HWY_INLINE void addLight(const M& plain, const LineLight& line, std::size_t first)
  {
    const D d;
    const V through = hn::Load(d, l_.transmittance + first);
    for (std::size_t c = 0; c < 3; ++c)
    {
      const V color = hn::Load(d, l_.color[c] + first);
      const V added = hn::MulAdd(through, line.light[c], color);
      hn::Store(hn::IfThenElse(plain, added, color), d, l_.color[c] + first);
    }
    hn::Store(
      hn::IfThenElse(plain, hn::Mul(through, line.passing), through), d, l_.transmittance + first);
  }

  /// Adds a lane's part as lines side by side, one in each lane of a vector: for lanes that bend
  /// too much for four. False where a line is too rough, and nothing is added.
  HWY_INLINE bool addFine(std::size_t k)
  {
    const D d;
    const DI di;
    constexpr std::size_t count = WalkBends<axis>::fineLines;
    // Values at the ends of lines; one is before the first.
    alignas(64) float ends[count], starts[count], light[3][count], passing[count];
    if (!bends_.fineAt(k, ends))
      return false;
    starts[0] = l_.partIn[k];
    std::copy_n(ends, count - 1, starts + 1);
    const V depth = set(l_.depth[k] / static_cast<float>(count));
    std::uint32_t rough = 0;
    for (std::size_t first = 0; first < count; first += hn::Lanes(d))
    {
      const V at = hn::Load(d, starts + first), end = hn::Load(d, ends + first);
      alignas(64) std::uint32_t row[hn::MaxLanes(D())], endRow[hn::MaxLanes(D())];
      const VI in = rowsOf(transfer_, at), out = rowsOf(transfer_, end);
      hn::Store(in, di, reinterpret_cast<std::int32_t*>(row));
      hn::Store(out, di, reinterpret_cast<std::int32_t*>(endRow));
      for (std::size_t i = 0; transfer_.hasSolid() && i < hn::Lanes(d); ++i)
        if (transfer_.isSolid(row[i], endRow[i]))
          return false;
      const M isSame = hn::RebindMask(d, hn::Eq(in, out));
      const Seen from(transfer_.table().rows, at, row), to(transfer_.table().rows, end, endRow);
      const V perChange = reciprocal(hn::Sub(end, at));
      V mean[4];
      for (std::size_t c = 0; c < 4; ++c)
        mean[c] = hn::IfThenElse(isSame, hn::Mul(set(0.5f), hn::Add(from.value[c], to.value[c])),
          hn::Mul(hn::Sub(to.integral[c], from.integral[c]), perChange));
      const LineLight line(from.value, to.value, mean, depth, isSame, task_.share);
      rough |= maskOf(line.isRough);
      hn::Store(line.passing, d, passing + first);
      for (std::size_t c = 0; c < 3; ++c)
        hn::Store(line.light[c], d, light[c] + first);
    }
    if (rough != 0)
      return false;
    float through = l_.transmittance[k], color[3] = {};
    for (std::size_t i = 0; i < count; ++i)
    {
      for (std::size_t c = 0; c < 3; ++c)
        color[c] += through * light[c][i];
      through *= passing[i];
    }
    for (std::size_t c = 0; c < 3; ++c)
      l_.color[c][k] += color[c];
    l_.transmittance[k] = through;
    return true;
  }

  WalkTask& task_;
  Lanes& l_;
  const WalkTransfer& transfer_;
  WalkBends<axis> bends_;
  /// A bit each lane: what is known of a part is not what the last one ended with; it is cut; it is
  /// no line; it is two, or four, or as many as fit side by side; it has been added, or is added
  /// one at a time.
  std::uint32_t isFresh_ = 0, isClipped_ = 0, isBent_ = 0, isHalved_ = 0, isQuartered_ = 0,
                isFine_ = 0, isDone_ = 0, isSeldom_ = 0;
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
