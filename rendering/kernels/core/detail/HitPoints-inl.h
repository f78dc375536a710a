// Points and directions of a block's hits by SIMD: to be included by sources that are compiled once
// for every instruction set, within what foreach_target.h includes again and again.

#if defined(MOTE_HIT_POINTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_HIT_POINTS_INL
#undef MOTE_HIT_POINTS_INL
#else
#define MOTE_HIT_POINTS_INL
#endif

#include "../HitBlock.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using DD = hn::CappedTag<double, 8>;
using DH = hn::Rebind<float, DD>; ///< as many floats as a vector has doubles
using VD = hn::Vec<DD>;
using VH = hn::Vec<DH>;

template <typename V>
struct Three
{
  V x, y, z;
};

template <typename D, typename T>
HWY_INLINE Three<hn::Vec<D>> load(D d, const HitBlock::Triple<T>& from, int i)
{
  return {hn::Load(d, from.x + i), hn::Load(d, from.y + i), hn::Load(d, from.z + i)};
}

template <typename D, typename T>
HWY_INLINE void store(D d, const Three<hn::Vec<D>>& v, HitBlock::Triple<T>& to, int i)
{
  hn::Store(v.x, d, to.x + i);
  hn::Store(v.y, d, to.y + i);
  hn::Store(v.z, d, to.z + i);
}

template <typename V>
HWY_INLINE V dot(const Three<V>& a, const Three<V>& b)
{
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

template <typename V>
HWY_INLINE Three<V> scaled(const Three<V>& a, V by)
{
  return {hn::Mul(a.x, by), hn::Mul(a.y, by), hn::Mul(a.z, by)};
}

/// 1 / sqrt(a), or 0 where a is 0.
template <typename D>
HWY_INLINE hn::Vec<D> inverseRoot(D d, hn::Vec<D> a)
{
  using T = hn::TFromD<D>;
  const auto some = hn::Gt(a, hn::Zero(d));
  return hn::IfThenElseZero(
    some, hn::Div(hn::Set(d, T(1)), hn::Sqrt(hn::IfThenElse(some, a, hn::Set(d, T(1))))));
}

/// Points of rays `i` and following, from `origin` which need not be the bundle's own.
HWY_INLINE Three<VD> pointsOn(const RayBundle& rays, const Vec3d& origin, const HitBlock& b, int i)
{
  const DD d;
  const DH dh;
  const VD x = hn::PromoteTo(d, hn::Load(dh, b.rayX + i));
  const VD y = hn::PromoteTo(d, hn::Load(dh, b.rayY + i));
  const VD t = hn::Load(d, b.t + i);
  const bool fan = rays.kind == RayBundle::Kind::CommonOrigin;
  const auto along = [&](int k)
  {
    const VD from = hn::Set(d, origin[k]), direction = hn::Set(d, rays.direction[k]);
    const VD across = hn::MulAdd(x, hn::Set(d, rays.dx[k]), hn::Mul(y, hn::Set(d, rays.dy[k])));
    return fan ? hn::MulAdd(t, hn::Add(direction, across), from)
               : hn::MulAdd(t, direction, hn::Add(from, across));
  };
  return {along(0), along(1), along(2)};
}

HWY_INLINE Three<VH> narrowed(const Three<VD>& v)
{
  const DH d;
  return {hn::DemoteTo(d, v.x), hn::DemoteTo(d, v.y), hn::DemoteTo(d, v.z)};
}

/// Unit vectors from the hits towards the eye.
HWY_INLINE Three<VH> towardsEye(const RayBundle& rays, const HitBlock& b, int i)
{
  const DH d;
  const auto number = [&](double v) { return hn::Set(d, static_cast<float>(v)); };
  Three<VH> v = {number(-rays.direction.x), number(-rays.direction.y), number(-rays.direction.z)};
  if (rays.kind == RayBundle::Kind::CommonOrigin)
  {
    const VH x = hn::Load(d, b.rayX + i), y = hn::Load(d, b.rayY + i);
    v.x = hn::NegMulAdd(x, number(rays.dx.x), hn::NegMulAdd(y, number(rays.dy.x), v.x));
    v.y = hn::NegMulAdd(x, number(rays.dx.y), hn::NegMulAdd(y, number(rays.dy.y), v.y));
    v.z = hn::NegMulAdd(x, number(rays.dx.z), hn::NegMulAdd(y, number(rays.dy.z), v.z));
  }
  return scaled(v, inverseRoot(d, dot(v, v)));
}

HWY_INLINE Three<VH> transformed(const glm::mat3& m, const Three<VH>& v)
{
  const DH d;
  const auto row = [&](int k)
  {
    return hn::MulAdd(hn::Set(d, m[0][k]), v.x,
      hn::MulAdd(hn::Set(d, m[1][k]), v.y, hn::Mul(hn::Set(d, m[2][k]), v.z)));
  };
  return {row(0), row(1), row(2)};
}

/// Stores what follows from outward normals, of any length, in the surface's coordinates: unit
/// normals in the world towards the eye, toEye, sides; and positions where asked for. A normal of
/// length 0 stays 0.
HWY_INLINE void storePlaced(HitBlock& b, const HitPlacing& placing, Three<VH> normal, int i)
{
  const DH dh;
  if (placing.positions)
    store(DD(), pointsOn(placing.world, placing.worldOrigin, b, i), b.position, i);
  if (placing.normalToWorld != nullptr)
    normal = transformed(*placing.normalToWorld, normal);
  normal = scaled(normal, inverseRoot(dh, dot(normal, normal)));
  const Three<VH> eye = towardsEye(placing.world, b, i);
  const VH one = hn::Set(dh, 1.0f);
  const VH side = hn::IfThenElse(hn::Lt(dot(normal, eye), hn::Zero(dh)), hn::Neg(one), one);
  store(dh, scaled(normal, side), b.normal, i);
  store(dh, eye, b.toEye, i);
  hn::Store(side, dh, b.side + i);
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
