// Where rays pass bilinear faces, a ray in each SIMD lane. To be included by sources that are
// compiled once for every instruction set.

#if defined(MOTE_WALK_PATCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_WALK_PATCH_INL_H
#undef MOTE_WALK_PATCH_INL_H
#else
#define MOTE_WALK_PATCH_INL_H
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{
namespace
{

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

HWY_INLINE V set(float x)
{
  return hn::Set(D(), x);
}

/// The corners of a face about the rays, which are x = y = 0.
struct FaceCorners
{
  V x[4], y[4], z[4], value[4];
};

/// Where on a face: weights of the second and third corner against the first and fourth, and of the
/// last two against the first two.
struct PatchPlace
{
  V u, v;

  HWY_INLINE V of(const V (&corner)[4]) const
  {
    const V near = hn::MulAdd(u, hn::Sub(corner[1], corner[0]), corner[0]);
    const V far = hn::MulAdd(u, hn::Sub(corner[2], corner[3]), corner[3]);
    return hn::MulAdd(v, hn::Sub(far, near), near);
  }
};

HWY_INLINE V crossed(V ax, V ay, V bx, V by)
{
  return hn::MulSub(ax, by, hn::Mul(ay, bx));
}

/// Where the rays pass, of the two places at most, the one at which the face is counter-clockwise,
/// or clockwise. The roots of CellFaces.cpp, in float: u from areas, v then along the line of u.
HWY_INLINE PatchPlace passPatch(const V (&x)[4], const V (&y)[4], bool clockwise)
{
  const D d;
  const V zero = hn::Zero(d), one = set(1.0f), half = set(0.5f);
  const V ac = crossed(x[0], y[0], x[2], y[2]), be = crossed(x[1], y[1], x[3], y[3]);
  const V h0 = crossed(x[0], y[0], x[3], y[3]), h2 = crossed(x[1], y[1], x[2], y[2]);
  const V h1 = hn::Mul(half, hn::Add(ac, be));
  const V root = hn::Sqrt(hn::Max(zero, hn::MulSub(h1, h1, hn::Mul(h0, h2))));
  const M rises = hn::Ge(h1, zero);
  const V q = hn::IfThenElse(rises, hn::Neg(hn::Add(h1, root)), hn::Sub(root, h1));
  const M first = clockwise ? rises : hn::Not(rises);
  const V n = hn::IfThenElse(first, q, h0), m = hn::IfThenElse(first, h2, q);
  const V sum = hn::Add(n, m);
  PatchPlace place;
  place.u = hn::IfThenElse(hn::Eq(sum, zero), half, hn::Div(n, sum));
  place.u = hn::Min(hn::Max(place.u, zero), one);
  const V nx = hn::MulAdd(place.u, hn::Sub(x[1], x[0]), x[0]);
  const V ny = hn::MulAdd(place.u, hn::Sub(y[1], y[0]), y[0]);
  const V mx = hn::Sub(hn::MulAdd(place.u, hn::Sub(x[2], x[3]), x[3]), nx);
  const V my = hn::Sub(hn::MulAdd(place.u, hn::Sub(y[2], y[3]), y[3]), ny);
  const V along = hn::Neg(hn::MulAdd(nx, mx, hn::Mul(ny, my)));
  const V square = hn::Max(hn::MulAdd(mx, mx, hn::Mul(my, my)), set(1e-37f));
  place.v = hn::Min(hn::Max(hn::Div(along, square), zero), one);
  return place;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
