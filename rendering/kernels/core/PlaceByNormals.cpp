// How placed hits look, compiled once for every SIMD instruction set.

#include "PlaceByNormals.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/PlaceByNormals.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "detail/HitPoints-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

void placeBlock(HitBlock& b, const HitPlacing& placing)
{
  const DD d;
  const DH dh;
  for (int i = 0; i < b.count; i += static_cast<int>(hn::Lanes(d)))
  {
    const Three<VD> normal = {
      hn::Load(d, b.own[0] + i), hn::Load(d, b.own[1] + i), hn::Load(d, b.own[2] + i)};
    storePlaced(b, placing, narrowed(normal), i);
    const Three<VH> found = load(dh, b.normal, i), eye = load(dh, b.toEye, i);
    const auto none = hn::Eq(dot(found, found), hn::Zero(dh));
    const auto either = [&](VH a, VH e) { return hn::IfThenElse(none, e, a); };
    store(dh, Three<VH>{either(found.x, eye.x), either(found.y, eye.y), either(found.z, eye.z)},
      b.normal, i);
    hn::Store(hn::Set(dh, 1.0f), dh, b.side + i);
  }
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote
{

HWY_EXPORT(placeBlock);

void placeByNormals(HitBlock& block, const HitPlacing& placing)
{
  HWY_DYNAMIC_DISPATCH(placeBlock)(block, placing);
}

} // namespace mote

#endif
