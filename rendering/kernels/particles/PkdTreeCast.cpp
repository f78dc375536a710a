// Casting rays through a PkdTree, compiled once for every SIMD instruction set.

#include "detail/BundleCast.h"
#include "detail/PkdTreeView.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "particles/PkdTreeCast.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "detail/PkdTreeNearest-inl.h"
#include "detail/PkdTreeOcclusion-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

bool treeBundleNearest(const PkdTreeView& view, RayBundle& bundle, std::int32_t object)
{
  return castTreeBundle<NearestPolicy>(view, bundle, object);
}

struct LodPolicy : NearestPolicy
{
  static constexpr bool lods = true;
};

bool treeBundleLods(const PkdTreeView& view, RayBundle& bundle, std::int32_t object, double poe)
{
  return castTreeBundle<LodPolicy>(view, bundle, object, poe);
}

bool treeBundleAny(const PkdTreeView& view, RayBundle& bundle, std::int32_t object)
{
  return castTreeBundle<AnyPolicy>(view, bundle, object);
}

void treePacketNearest(const PkdTreeView& view, RayPacket& packet, std::int32_t object)
{
  castTreePacket(view, packet, object);
}

void treePacketAny(const PkdTreeView& view, RayPacket& packet, std::int32_t object)
{
  occludeTreePacket(view, packet, object);
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote
{

HWY_EXPORT(treeBundleNearest);
HWY_EXPORT(treeBundleLods);
HWY_EXPORT(treeBundleAny);
HWY_EXPORT(treePacketNearest);
HWY_EXPORT(treePacketAny);

void PkdTree::cast(RayBundle& bundle, std::int32_t object, double poe) const
{
  if (poe > 0.0 && hasLods() && !sparse_)
    castInParts<PkdTreeView>(*this, bundle, object,
      [poe](const PkdTreeView& view, RayBundle& part, std::int32_t own)
      { return HWY_DYNAMIC_DISPATCH(treeBundleLods)(view, part, own, poe); });
  else
    castInParts<PkdTreeView>(*this, bundle, object, HWY_DYNAMIC_DISPATCH(treeBundleNearest));
}

void PkdTree::occlude(RayBundle& bundle, std::int32_t object) const
{
  castInParts<PkdTreeView>(*this, bundle, object, HWY_DYNAMIC_DISPATCH(treeBundleAny));
}

void PkdTree::cast(RayPacket& packet, std::int32_t object) const
{
  if (count_ > 0)
    HWY_DYNAMIC_DISPATCH(treePacketNearest)(PkdTreeView(*this), packet, object);
}

void PkdTree::occlude(RayPacket& packet, std::int32_t object) const
{
  if (count_ > 0)
    HWY_DYNAMIC_DISPATCH(treePacketAny)(PkdTreeView(*this), packet, object);
}

} // namespace mote

#endif
