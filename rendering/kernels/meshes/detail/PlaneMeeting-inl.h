// Where rays meet R-LODs, the planes that stand for triangles. Included once per SIMD instruction
// set.

#if defined(MOTE_PLANE_MEETING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_PLANE_MEETING_INL_H
#undef MOTE_PLANE_MEETING_INL_H
#else
#define MOTE_PLANE_MEETING_INL_H
#endif

#include "MeshSimd-inl.h"
#include "RlodPlanes.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// Levels of the error radii of 16 words, as radii.
HWY_INLINE VF errorRadii(const RlodWords& words, const ErrorLevels& levels, int set)
{
  const DU d;
  const auto level = hn::ShiftRight<RlodWords::indexBits>(hn::Load(d, words.word + set * lanes));
  return hn::BitCast(
    DF(), hn::Add(hn::Mul(level, hn::Set(d, levels.step)), hn::Set(d, levels.first)));
}

/// Where lines meet R-LODs, each line one. A line meets one at the point of its part in the
/// child's box that is nearest to the plane, if that is within the greatest deviation of what the
/// plane stands for: whatever of it the line meets lies there, so there are no holes.
struct PlaneMeeting
{
  static constexpr float rounding = 0x1p-20f; ///< of lengths, in the tree's unit

  VF enter, leave;  ///< steps along the line in the box
  VF height, slope; ///< over the plane: height + slope * step

  /// Steps along a line that goes `way` along an axis in one.
  static HWY_INLINE VF stepsPer(VF way)
  {
    const VF safe = hn::CopySign(hn::Max(hn::Abs(way), all(1e-18f)), way);
    const VF per = hn::ApproximateReciprocal(safe);
    return hn::Mul(per, hn::NegMulAdd(per, safe, all(2.0f)));
  }

  /// Leaves the steps at which a line that is `at` along an axis is between two bounds; `per` are
  /// stepsPer() its way.
  HWY_INLINE void within(VF at, VF per, VF low, VF high)
  {
    const VF a = hn::Mul(hn::Sub(low, at), per), b = hn::Mul(hn::Sub(high, at), per);
    enter = hn::Max(enter, hn::Min(a, b));
    leave = hn::Min(leave, hn::Max(a, b));
  }

  /// Lines whose point at z may be one of the surface that the R-LOD is part of: it is within twice
  /// the greatest deviation of the plane, or in the box, over which planes may reach beyond their
  /// triangles. NaN is nowhere.
  HWY_INLINE MF holds(VF deviation, VF z) const { return holds(deviation, z, z); }
  /// Likewise, `inBox` being the z nearest to it at which the line is known to be in the box or
  /// not.
  HWY_INLINE MF holds(VF deviation, VF z, VF inBox) const
  {
    const VF away = hn::Abs(hn::MulAdd(slope, z, height));
    const MF beside = hn::Le(away, hn::MulAdd(deviation, all(2.0f), all(rounding)));
    return hn::Or(beside, hn::And(hn::Le(enter, inBox), hn::Le(inBox, leave)));
  }

  /// Lines that meet their R-LOD; z becomes where.
  HWY_INLINE MF meets(VF deviation, VF& z) const
  {
    const VF safe = hn::CopySign(hn::Max(hn::Abs(slope), all(1e-18f)), slope);
    const VF last = hn::MulAdd(hn::Abs(leave), all(rounding), leave);
    z = hn::Min(hn::Max(hn::Div(hn::Neg(height), safe), enter), last);
    const VF away = hn::Abs(hn::MulAdd(slope, z, height));
    return hn::And(hn::Le(enter, last), hn::Le(away, hn::Add(deviation, all(rounding))));
  }
};

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
