// The rays of a bundle against R-LODs, the planes that stand for a node's children. Included once
// per SIMD instruction set.

#if defined(MOTE_PLANE_CAST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_PLANE_CAST_INL_H
#undef MOTE_PLANE_CAST_INL_H
#else
#define MOTE_PLANE_CAST_INL_H
#endif

#include "BundleRays-inl.h"
#include "PlaneMeeting-inl.h"
#include "RlodTreeView.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// Tests R-LODs. Those that cover few rays of a square are tested many at a time, each with a ray
/// of its own; others one at a time with the rays of a block.
///
/// Rays that look for anything in the way end on a surface: R-LODs that hold their end are passed
/// over, since they stand for that surface.
template <typename Policy>
class PlaneCaster
{
public:
  PlaneCaster(const RlodTreeView& view, const BundleFrame& frame, BundleRays& rays)
    : view_(view)
    , frame_(frame)
    , rays_(rays)
    , half_(0.5f * float(rays.lastCell))
    , first_(std::nextafter(frame.first, infinity))
    , smallest_(frame.side > 0 && !Policy::any ? 24.5f : 0.0f)
  {
  }

  /// Tests those of a node's children that `bits` tells, which have the rectangles `rects`.
  void cast(std::uint32_t index, const Rect* rects, unsigned bits)
  {
    const RlodNode& node = view_.nodes[index];
    const RlodPlanes& planes = view_.planes[index];
    for (int set = 0; set < laneSets; ++set, bits >>= lanes)
    {
      const unsigned some = bits & lowest(lanes);
      if (some == 0)
        continue;
      Lines lines(node, planes, frame_, set);
      const std::uint32_t first =
        static_cast<std::uint32_t>(RlodTree::lodSlot(index, static_cast<unsigned>(set * lanes)));
      const unsigned small = some & castSmall(lines, rects + set * lanes, some, first);
      if (some == small)
        continue;
      const LineRows rows(lines);
      for (unsigned left = some & ~small; left != 0; left &= left - 1)
      {
        const int lane = std::countr_zero(left);
        castLarge(rows, lane, rects[set * lanes + lane], first);
      }
    }
  }

private:
  /// The R-LODs of some children: boxes, counted from the frame's Q, and how high lines run over
  /// their planes: height at z = 0 and slope, each [0] + x [1] + y [2].
  struct Lines
  {
    VF low[3], high[3], height[3], slope[3], deviation;

    HWY_INLINE Lines() {}
    HWY_INLINE Lines(
      const RlodNode& node, const RlodPlanes& planes, const BundleFrame& frame, int set)
    {
      const DF d;
      deviation = hn::Load(d, planes.deviation + set * lanes);
      height[0] = hn::Neg(hn::Load(d, planes.offset + set * lanes));
      height[1] = height[2] = slope[0] = slope[1] = slope[2] = hn::Zero(d);
      for (int axis = 0; axis < 3; ++axis)
      {
        const VF scale = all(node.scale[axis]), from = all(node.origin[axis] - frame.q[axis]);
        const auto bound = [&](const std::uint8_t* row)
        { return hn::MulAdd(hn::ConvertTo(d, widened(row + set * lanes)), scale, from); };
        low[axis] = hn::Sub(bound(node.low(axis)), all(PlaneMeeting::rounding));
        high[axis] = hn::Add(bound(node.high(axis)), all(PlaneMeeting::rounding));
        const VF normal = hn::Load(d, planes.normal[axis] + set * lanes);
        height[0] = hn::MulAdd(normal, all(frame.q[axis]), height[0]);
        for (int k = 0; k < 3; ++k)
        {
          height[k] = hn::MulAdd(normal, all(frame.at[k][axis]), height[k]);
          slope[k] = hn::MulAdd(normal, all(frame.way[k][axis]), slope[k]);
        }
      }
    }
  };

  /// One of them, for all lines. Numbers come from memory: taking them out of vectors is slow.
  struct LineRows
  {
    Row low[3], high[3], height[3], slope[3], deviation;

    HWY_INLINE explicit LineRows(const Lines& lines)
    {
      for (int k = 0; k < 3; ++k)
      {
        low[k].store(lines.low[k], 0);
        high[k].store(lines.high[k], 0);
        height[k].store(lines.height[k], 0);
        slope[k].store(lines.slope[k], 0);
      }
      deviation.store(lines.deviation, 0);
    }
    HWY_INLINE Lines only(int lane) const
    {
      Lines lines;
      for (int k = 0; k < 3; ++k)
      {
        lines.low[k] = all(low[k].v[lane]);
        lines.high[k] = all(high[k].v[lane]);
        lines.height[k] = all(height[k].v[lane]);
        lines.slope[k] = all(slope[k].v[lane]);
      }
      lines.deviation = all(deviation.v[lane]);
      return lines;
    }
  };

  /// Where lines run along an axis: at z = 0, and how many steps of z a step along it takes.
  struct Course
  {
    VF at[3], per[3];

    HWY_INLINE Course() {}
    HWY_INLINE Course(const BundleFrame& frame, VF x, VF y)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto along = [&](const float(&from)[3][3])
        {
          return hn::MulAdd(
            x, all(from[1][axis]), hn::MulAdd(y, all(from[2][axis]), all(from[0][axis])));
        };
        at[axis] = along(frame.at);
        per[axis] = PlaneMeeting::stepsPer(along(frame.way));
      }
    }
  };

  /// Lines through the picture's places (x, y), and R-LODs.
  HWY_INLINE PlaneMeeting meetingOf(const Lines& lines, const Course& course, VF x, VF y) const
  {
    const auto over = [&](const VF(&from)[3])
    { return hn::MulAdd(x, from[1], hn::MulAdd(y, from[2], from[0])); };
    PlaneMeeting meeting = {all(first_), all(infinity), over(lines.height), over(lines.slope)};
    for (int axis = 0; axis < 3; ++axis)
      meeting.within(course.at[axis], course.per[axis], lines.low[axis], lines.high[axis]);
    return meeting;
  }

  /// Tests those that cover few rays of a square, and answers which these are.
  unsigned castSmall(const Lines& lines, const Rect* rects, unsigned wanted, std::uint32_t first)
  {
    const DF d;
    const DU du;
    const auto rect = hn::LoadU(du, rects);
    const auto cell = [&](auto shifted)
    { return hn::ConvertTo(d, hn::BitCast(DI(), hn::And(shifted, hn::Set(du, 255)))); };
    const VF x0 = cell(rect), x1 = cell(hn::ShiftRight<8>(rect));
    const VF y0 = cell(hn::ShiftRight<16>(rect)), y1 = cell(hn::ShiftRight<24>(rect));
    const VF one = all(1.0f), half = all(half_);
    const VF count = hn::Mul(hn::Add(hn::Sub(x1, x0), one), hn::Add(hn::Sub(y1, y0), one));
    const unsigned small = wanted & bitsOf(hn::Le(count, all(smallest_)));
    if (small == 0)
      return 0;
    std::uint8_t bytes[8] = {
      static_cast<std::uint8_t>(small), static_cast<std::uint8_t>(small >> 8)};
    MF some = hn::LoadMaskBits(d, bytes);
    VF x = x0, y = y0;
    do
    {
      VF z;
      const VF atX = hn::Sub(x, half), atY = hn::Sub(y, half);
      const PlaneMeeting meeting = meetingOf(lines, Course(frame_, atX, atY), atX, atY);
      const MF hits = hn::And(some, meeting.meets(lines.deviation, z));
      if (!hn::AllFalse(d, hits))
        rays_.template keepEach<Policy>(bitsOf(hits), x, y, z, frame_.first, first);
      x = hn::Add(x, one);
      const MF ends = hn::Gt(x, x1);
      x = hn::IfThenElse(ends, x0, x);
      y = hn::IfThenElse(ends, hn::Add(y, one), y);
      some = hn::And(some, hn::Le(y, y1));
    } while (!hn::AllFalse(d, some));
    return small;
  }

  void castLarge(const LineRows& some, int lane, Rect rect, std::uint32_t first)
  {
    const Lines lines = some.only(lane);
    const std::uint32_t slot = first + static_cast<std::uint32_t>(lane);
    unsigned blocks = rays_.blocksOf(rect) & lowest(static_cast<unsigned>(rays_.blocks));
    for (; blocks != 0; blocks &= blocks - 1)
    {
      const int block = std::countr_zero(blocks);
      prepare(block);
      for (int i = 16 * block; i < 16 * block + 16; i += lanes)
      {
        Course course;
        for (int axis = 0; axis < 3; ++axis)
        {
          course.at[axis] = hn::Load(DF(), at_[axis] + i);
          course.per[axis] = hn::Load(DF(), per_[axis] + i);
        }
        VF z;
        const PlaneMeeting meeting =
          meetingOf(lines, course, hn::Load(DF(), rays_.x + i), hn::Load(DF(), rays_.y + i));
        MF hits = meeting.meets(lines.deviation, z);
        if constexpr (Policy::any)
          hits = hn::AndNot(meeting.holds(lines.deviation, hn::Load(DF(), rays_.z + i)), hits);
        rays_.template keepBlock<Policy>(hits, z, i, frame_.first, slot);
      }
    }
  }

  /// Keeps where the rays of a block run: many R-LODs ask.
  HWY_INLINE void prepare(int block)
  {
    if ((prepared_ >> block & 1U) != 0)
      return;
    prepared_ |= 1U << block;
    for (int i = 16 * block; i < 16 * block + 16; i += lanes)
    {
      const Course course(frame_, hn::Load(DF(), rays_.x + i), hn::Load(DF(), rays_.y + i));
      for (int axis = 0; axis < 3; ++axis)
      {
        hn::Store(course.at[axis], DF(), at_[axis] + i);
        hn::Store(course.per[axis], DF(), per_[axis] + i);
      }
    }
  }

  const RlodTreeView& view_;
  const BundleFrame& frame_;
  BundleRays& rays_;
  float half_;
  float first_;           ///< the nearest z that counts
  float smallest_;        ///< rays that one covers at most to be tested beside others
  unsigned prepared_ = 0; ///< blocks of which the following is known
  alignas(64) float at_[3][BundleRays::capacity], per_[3][BundleRays::capacity];
};

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
