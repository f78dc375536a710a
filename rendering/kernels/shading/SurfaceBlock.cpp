// Geometry and light of many hits at a time, compiled once for every SIMD instruction set.

#include "SurfaceBlock.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/SurfaceBlock.cpp"
#include <hwy/foreach_target.h>
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
using DF = hn::CappedTag<float, 16>;
using VF = hn::Vec<DF>;

template <typename V>
struct Three
{
  V x, y, z;
};

template <typename D, typename T>
HWY_INLINE Three<hn::Vec<D>> load(D d, const SurfaceBlock::Triple<T>& from, int i)
{
  return {hn::Load(d, from.x + i), hn::Load(d, from.y + i), hn::Load(d, from.z + i)};
}

template <typename D, typename T>
HWY_INLINE void store(D d, const Three<hn::Vec<D>>& v, SurfaceBlock::Triple<T>& to, int i)
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
HWY_INLINE Three<VD> pointsOn(
  const RayBundle& rays, const Vec3d& origin, const SurfaceBlock& b, int i)
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

HWY_INLINE Three<VD> fromOrigin(const Three<VD>& v, const Vec3d& origin)
{
  const DD d;
  return {hn::Sub(v.x, hn::Set(d, origin.x)), hn::Sub(v.y, hn::Set(d, origin.y)),
    hn::Sub(v.z, hn::Set(d, origin.z))};
}

HWY_INLINE Three<VH> narrowed(const Three<VD>& v)
{
  const DH d;
  return {hn::DemoteTo(d, v.x), hn::DemoteTo(d, v.y), hn::DemoteTo(d, v.z)};
}

/// Unit vectors from the hits towards the eye.
HWY_INLINE Three<VH> towardsEye(const RayBundle& rays, const SurfaceBlock& b, int i)
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

void place(SurfaceBlock& b, const SurfacePlacing& placing, float ambient)
{
  const DD d;
  const DH dh;
  for (int i = 0; i < b.count; i += static_cast<int>(hn::Lanes(d)))
  {
    if (placing.positions)
      store(d, pointsOn(*placing.world, placing.worldOrigin, b, i), b.position, i);
    const Three<VD> point = pointsOn(*placing.local, Vec3d(0.0), b, i);
    const Three<VD> center = fromOrigin(load(d, b.center, i), placing.local->origin);
    const Three<VD> outward = {
      hn::Sub(point.x, center.x), hn::Sub(point.y, center.y), hn::Sub(point.z, center.z)};
    // In radii: squares of very small or very large numbers would leave float's range.
    Three<VH> n = narrowed(scaled(outward, hn::Div(hn::Set(d, 1.0), hn::Load(d, b.radius + i))));
    if (placing.normalToWorld != nullptr)
      n = transformed(*placing.normalToWorld, n);
    n = scaled(n, inverseRoot(dh, dot(n, n)));
    const Three<VH> eye = towardsEye(*placing.world, b, i);
    const VH one = hn::Set(dh, 1.0f);
    const VH side = hn::IfThenElse(hn::Lt(dot(n, eye), hn::Zero(dh)), hn::Neg(one), one);
    store(dh, scaled(n, side), b.normal, i);
    store(dh, eye, b.toEye, i);
    hn::Store(side, dh, b.side + i);
    const VH even = hn::Set(dh, ambient);
    store(dh, Three<VH>{even, even, even}, b.even, i);
    const VH none = hn::Zero(dh);
    store(dh, Three<VH>{none, none, none}, b.highlight, i);
  }
}

/// Cosine and shine of the hits from unit vectors towards the light.
template <typename D>
HWY_INLINE void face(D d, SurfaceBlock& b, const Three<hn::Vec<D>>& toLight, bool specular, int i)
{
  const auto n = load(d, b.normal, i);
  const auto cosine = dot(n, toLight);
  const auto lit = hn::Gt(cosine, hn::Zero(d));
  hn::Store(hn::IfThenElseZero(lit, cosine), d, b.cosine + i);
  if (!specular)
    return;
  const auto eye = load(d, b.toEye, i);
  const auto shine = hn::MulSub(hn::Add(cosine, cosine), dot(n, eye), dot(toLight, eye));
  const auto shines = hn::And(lit, hn::Gt(shine, hn::Zero(d)));
  hn::Store(hn::IfThenElseZero(shines, shine), d, b.shine + i);
}

void facePoint(SurfaceBlock& b, const Vec3d& place, bool specular)
{
  const DD d;
  for (int i = 0; i < b.count; i += static_cast<int>(hn::Lanes(d)))
  {
    const Three<VD> at = load(d, b.position, i);
    const Three<VD> v = {hn::Sub(hn::Set(d, place.x), at.x), hn::Sub(hn::Set(d, place.y), at.y),
      hn::Sub(hn::Set(d, place.z), at.z)};
    face(DH(), b, narrowed(scaled(v, inverseRoot(d, dot(v, v)))), specular, i);
  }
}

void faceFar(SurfaceBlock& b, const Vec3d& towards, bool specular)
{
  const DF d;
  const Three<VF> v = {hn::Set(d, static_cast<float>(towards.x)),
    hn::Set(d, static_cast<float>(towards.y)), hn::Set(d, static_cast<float>(towards.z))};
  for (int i = 0; i < b.count; i += static_cast<int>(hn::Lanes(d)))
    face(d, b, v, specular, i);
}

void faceEye(SurfaceBlock& b, bool specular)
{
  const DF d;
  for (int i = 0; i < b.count; i += static_cast<int>(hn::Lanes(d)))
    face(d, b, load(d, b.toEye, i), specular, i);
}

HWY_INLINE void addScaled(
  SurfaceBlock::Triple<float>& sum, const float* by, const Vec3f& color, int count)
{
  const DF d;
  const VF r = hn::Set(d, color.x), g = hn::Set(d, color.y), b = hn::Set(d, color.z);
  for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d)))
  {
    const VF share = hn::Load(d, by + i);
    const Three<VF> old = load(d, sum, i);
    store(d,
      Three<VF>{
        hn::MulAdd(share, r, old.x), hn::MulAdd(share, g, old.y), hn::MulAdd(share, b, old.z)},
      sum, i);
  }
}

void addEven(SurfaceBlock& b, const Vec3f& color)
{
  addScaled(b.even, b.cosine, color, b.count);
}

void addHighlight(SurfaceBlock& b, const Vec3f& color)
{
  addScaled(b.highlight, b.shine, color, b.count);
}

void finish(SurfaceBlock& b, const Material& m)
{
  const DF d;
  const VF one = hn::Set(d, 1.0f), opacity = hn::Set(d, m.opacity);
  const bool specular = m.specular > 0.0f;
  for (int i = 0; i < b.count; i += static_cast<int>(hn::Lanes(d)))
  {
    Three<VF> color;
    VF alpha;
    hn::LoadInterleaved4(d, b.color[i], color.x, color.y, color.z, alpha);
    alpha = hn::Mul(alpha, opacity);
    const Three<VF> even = load(d, b.even, i);
    Three<VF> sum = {hn::Mul(color.x, even.x), hn::Mul(color.y, even.y), hn::Mul(color.z, even.z)};
    if (specular)
    {
      const Three<VF> h = load(d, b.highlight, i);
      sum.x = hn::MulAdd(hn::Set(d, m.specularColor.x), h.x, sum.x);
      sum.y = hn::MulAdd(hn::Set(d, m.specularColor.y), h.y, sum.y);
      sum.z = hn::MulAdd(hn::Set(d, m.specularColor.z), h.z, sum.z);
    }
    const auto limited = [&](VF v) { return hn::Mul(hn::Min(v, one), alpha); };
    hn::StoreInterleaved4(limited(sum.x), limited(sum.y), limited(sum.z), alpha, d, b.out[i]);
  }
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote
{

HWY_EXPORT(place);
HWY_EXPORT(facePoint);
HWY_EXPORT(faceFar);
HWY_EXPORT(faceEye);
HWY_EXPORT(addEven);
HWY_EXPORT(addHighlight);
HWY_EXPORT(finish);

void placeSurfaces(SurfaceBlock& block, const SurfacePlacing& placing, float ambient)
{
  HWY_DYNAMIC_DISPATCH(place)(block, placing, ambient);
}

void faceLight(SurfaceBlock& block, const LightSample& sample, bool specular)
{
  switch (sample.kind)
  {
  case Light::Kind::Headlight:
    HWY_DYNAMIC_DISPATCH(faceEye)(block, specular);
    break;
  case Light::Kind::Directional:
    HWY_DYNAMIC_DISPATCH(faceFar)(block, sample.place, specular);
    break;
  case Light::Kind::Point:
    HWY_DYNAMIC_DISPATCH(facePoint)(block, sample.place, specular);
    break;
  }
}

void addLight(SurfaceBlock& block, const Vec3f& color, const Material& material)
{
  if (material.diffuse > 0.0f)
    HWY_DYNAMIC_DISPATCH(addEven)(block, color * material.diffuse);
  if (!(material.specular > 0.0f))
    return;
  if (material.specularPower != 1.0f)
    for (int i = 0; i < block.count; ++i)
      if (block.shine[i] > 0.0f)
        block.shine[i] = std::pow(block.shine[i], material.specularPower);
  HWY_DYNAMIC_DISPATCH(addHighlight)(block, color * material.specular);
}

void finishSurfaces(SurfaceBlock& block, const Material& material)
{
  HWY_DYNAMIC_DISPATCH(finish)(block, material);
}

} // namespace mote

#endif
