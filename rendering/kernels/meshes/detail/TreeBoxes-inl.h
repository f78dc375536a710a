// The rays of a packet against boxes of an RlodTree, one ray and 16 boxes at a time. Included once
// per SIMD instruction set.

#if defined(MOTE_TREE_BOXES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_TREE_BOXES_INL_H
#undef MOTE_TREE_BOXES_INL_H
#else
#define MOTE_TREE_BOXES_INL_H
#endif

#include "TreeRays-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// 16 boxes in float: those of a node's children, made once for all rays that visit it.
struct TreeBoxes
{
  static constexpr std::uint32_t greatest = 16; ///< where the greatest bounds of an axis begin

  alignas(64) float bounds[3][2 * greatest]; ///< of each axis the least and the greatest

  TreeBoxes() = default;
  HWY_INLINE explicit TreeBoxes(const RlodNode& node)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const VF scale = all(node.scale[axis]), origin = all(node.origin[axis]);
      for (int set = 0; set < laneSets; ++set)
      {
        const auto bound = [&](const std::uint8_t* row)
        { return hn::MulAdd(hn::ConvertTo(DF(), widened(row + set * lanes)), scale, origin); };
        hn::Store(bound(node.low(axis)), DF(), low(axis) + set * lanes);
        hn::Store(bound(node.high(axis)), DF(), high(axis) + set * lanes);
      }
    }
  }

  float* low(int axis) { return bounds[axis]; }
  float* high(int axis) { return bounds[axis] + greatest; }
  const float* low(int axis) const { return bounds[axis]; }
  const float* high(int axis) const { return bounds[axis] + greatest; }
};

/// The least depths at which any of some rays enters each of 16 boxes.
class LeastDepths
{
public:
  HWY_INLINE LeastDepths()
  {
    for (int set = 0; set < laneSets; ++set)
      depths_.store(all(infinity), set);
  }
  HWY_INLINE void take(VF enter, MF met, int set)
  {
    depths_.store(hn::Min(depths_.load(set), hn::IfThenElse(met, enter, all(infinity))), set);
  }
  float of(int k) const { return depths_.v[k]; }

private:
  Row depths_;
};
/// Nobody asks.
struct NoDepths
{
  HWY_INLINE void take(VF, MF, int) {}
  float of(int) const { return 0.0f; }
};

/// Those of one ray, which tells them to others too.
template <typename Others>
struct RowDepths
{
  Others& others;
  Row z;

  HWY_INLINE explicit RowDepths(Others& told)
    : others(told)
  {
  }
  HWY_INLINE void take(VF enter, MF met, int set)
  {
    z.store(enter, set);
    others.take(enter, met, set);
  }
};

/// What a packet's rays are to boxes: z = inverse * bound - of Q.
class BoxRays
{
public:
  BoxRays(const TreeRays& rays, int count)
    : rays_(rays)
  {
    const DF d;
    const DU u;
    for (int i = 0; i < count; i += lanes)
      for (int axis = 0; axis < 3; ++axis)
      {
        const VF inverse = hn::Load(d, rays.inverse[axis] + i);
        const VF at = hn::Mul(hn::Load(d, rays.q[axis] + i), inverse);
        // Of Q, of the numbers here and of boxes, and of the triangles' own formula.
        const VF error = hn::Mul(all(0x1p-18f), hn::Abs(inverse));
        hn::Store(hn::Neg(hn::Add(at, error)), d, enter_[axis] + i);
        hn::Store(hn::Sub(error, at), d, leave_[axis] + i);
        const auto backward = hn::RebindMask(u, hn::Lt(inverse, hn::Zero(d)));
        hn::Store(
          hn::IfThenElseZero(backward, hn::Set(u, TreeBoxes::greatest)), u, nearSide_[axis] + i);
      }
  }

  /// Boxes that a ray meets before its end, as bits; `depths` learn where it enters them.
  template <typename Depths>
  HWY_INLINE unsigned met(const TreeBoxes& boxes, int i, Depths& depths) const
  {
    return metBy(boxes, i, [&](VF enter, VF, MF met, int set) { depths.take(enter, met, set); });
  }
  /// Likewise; `near` and `far` become where it enters and leaves them.
  HWY_INLINE unsigned met(const TreeBoxes& boxes, int i, Row& near, Row& far) const
  {
    return metBy(boxes, i,
      [&](VF enter, VF leave, MF, int set)
      {
        near.store(enter, set);
        far.store(leave, set);
      });
  }

private:
  static constexpr int capacity = TreeRays::capacity;

  template <typename Keep>
  HWY_INLINE unsigned metBy(const TreeBoxes& boxes, int i, const Keep& keep) const
  {
    unsigned bits = 0;
    for (int set = 0; set < laneSets; ++set)
    {
      VF enter = all(rays_.first[i]), leave = all(rays_.best[i]);
      for (int axis = 0; axis < 3; ++axis)
      {
        const std::uint32_t side = nearSide_[axis][i];
        const VF inverse = all(rays_.inverse[axis][i]);
        const float* bounds = boxes.bounds[axis] + set * lanes;
        const VF near = hn::Load(DF(), bounds + side);
        const VF far = hn::Load(DF(), bounds + (side ^ TreeBoxes::greatest));
        enter = hn::Max(enter, hn::MulAdd(near, inverse, all(enter_[axis][i])));
        leave = hn::Min(leave, hn::MulAdd(far, inverse, all(leave_[axis][i])));
      }
      const MF met = hn::Le(enter, leave);
      keep(enter, leave, met, set);
      bits |= bitsOf(met) << (set * lanes);
    }
    return bits;
  }

  const TreeRays& rays_;
  alignas(64) float enter_[3][capacity], leave_[3][capacity]; ///< z of the origin, wider by errors
  alignas(64) std::uint32_t nearSide_[3][capacity]; ///< where bounds begin that it meets first
};

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
