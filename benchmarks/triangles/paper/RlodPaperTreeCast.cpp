// Casting rays through an RlodPaperTree, compiled once for every SIMD instruction set.

#include "RlodPaperTree.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "triangles/paper/RlodPaperTreeCast.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "PaperWalk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote::bench
{
namespace HWY_NAMESPACE
{

template <bool ANY, typename Rays>
void castTogether(
  const RlodPaperTree& tree, Rays& rays, std::int32_t object, const RlodPaperCast& how)
{
  if (how.together == 1)
    castRays<1, ANY>(tree, rays, object, how);
  else
    castRays<RlodPaperTree::packetRays, ANY>(tree, rays, object, how);
}

void castBundle(
  const RlodPaperTree& tree, RayBundle& rays, std::int32_t object, const RlodPaperCast& how)
{
  castTogether<false>(tree, rays, object, how);
}
void occludeBundle(
  const RlodPaperTree& tree, RayBundle& rays, std::int32_t object, const RlodPaperCast& how)
{
  castTogether<true>(tree, rays, object, how);
}
void castPacket(
  const RlodPaperTree& tree, RayPacket& rays, std::int32_t object, const RlodPaperCast& how)
{
  castTogether<false>(tree, rays, object, how);
}
void occludePacket(
  const RlodPaperTree& tree, RayPacket& rays, std::int32_t object, const RlodPaperCast& how)
{
  castTogether<true>(tree, rays, object, how);
}

} // namespace HWY_NAMESPACE
} // namespace mote::bench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote::bench
{

HWY_EXPORT(castBundle);
HWY_EXPORT(occludeBundle);
HWY_EXPORT(castPacket);
HWY_EXPORT(occludePacket);

void RlodPaperTree::cast(RayBundle& bundle, std::int32_t object, double poe, int together) const
{
  if (size() > 0)
    HWY_DYNAMIC_DISPATCH(castBundle)
  (*this, bundle, object, {together, poe, rule_ == Rule::Clamped, nullptr});
}

void RlodPaperTree::cast(
  RayBundle& bundle, std::int32_t object, double poe, int together, Counts& counts) const
{
  if (size() > 0)
    HWY_DYNAMIC_DISPATCH(castBundle)
  (*this, bundle, object, {together, poe, rule_ == Rule::Clamped, &counts});
}

void RlodPaperTree::cast(RayPacket& packet, std::int32_t object, double poe, int together) const
{
  if (size() > 0)
    HWY_DYNAMIC_DISPATCH(castPacket)
  (*this, packet, object, {together, poe, rule_ == Rule::Clamped, nullptr});
}

void RlodPaperTree::occlude(RayBundle& bundle, std::int32_t object, int together) const
{
  if (size() > 0)
    HWY_DYNAMIC_DISPATCH(occludeBundle)(*this, bundle, object, {together, 0.0, false, nullptr});
}

void RlodPaperTree::occlude(RayPacket& packet, std::int32_t object, int together) const
{
  if (size() > 0)
    HWY_DYNAMIC_DISPATCH(occludePacket)(*this, packet, object, {together, 0.0, false, nullptr});
}

} // namespace mote::bench

#endif
