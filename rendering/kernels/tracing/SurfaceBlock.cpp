// The light of many hits at a time, compiled once for every SIMD instruction set.

#include "detail/SurfaceBlock.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracing/SurfaceBlock.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "../core/detail/HitPoints-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

using DF = hn::CappedTag<float, 16>;
using VF = hn::Vec<DF>;

void begin(SurfaceBlock& b, float ambient)
{
  const DF d;
  const VF even = hn::Set(d, ambient), none = hn::Zero(d);
  for (int i = 0; i < b.count; i += static_cast<int>(hn::Lanes(d)))
  {
    store(d, Three<VF>{even, even, even}, b.even, i);
    store(d, Three<VF>{none, none, none}, b.highlight, i);
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
  HitBlock::Triple<float>& sum, const float* by, const Vec3f& color, int count)
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

void finish(SurfaceBlock& b, const Material& m, float times)
{
  const DF d;
  const VF one = hn::Set(d, 1.0f), opacity = hn::Set(d, times);
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

void measureWidth(SurfaceBlock& block, const RayBundle& rays, const RayBundle& world)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < rays.count; ++i)
    if (rays.object[i] >= 0)
      nearest = std::min(nearest, rays.t[i]);
  if (!std::isfinite(nearest))
    return;
  block.width = world.footprint + nearest * world.footprintPerT;
  block.widthPerLength = world.footprintPerT / glm::length(world.direction);
}

HWY_EXPORT(begin);
HWY_EXPORT(facePoint);
HWY_EXPORT(faceFar);
HWY_EXPORT(faceEye);
HWY_EXPORT(addEven);
HWY_EXPORT(addHighlight);
HWY_EXPORT(finish);

void beginLight(SurfaceBlock& block, float ambient)
{
  HWY_DYNAMIC_DISPATCH(begin)(block, ambient);
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

void finishSurfaces(SurfaceBlock& block, const Material& material, float opacity)
{
  HWY_DYNAMIC_DISPATCH(finish)(block, material, opacity);
}

} // namespace mote

#endif
