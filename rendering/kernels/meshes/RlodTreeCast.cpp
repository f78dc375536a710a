// Casting rays through an RlodTree, compiled once for every SIMD instruction set.

#include "RlodTree.h"

#include "../core/BundlePackets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "meshes/RlodTreeCast.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "detail/RlodTreeBundle-inl.h"
#include "detail/RlodTreeWave-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

bool castNearest(const RlodTreeView& view, RayBundle& bundle, std::int32_t object, double poe,
  RlodTree::Counts* counts)
{
  return castBundle<NearestHit>(view, bundle, object, poe, counts);
}

bool castNearestInner(const RlodTreeView& view, RayBundle& bundle, std::int32_t object)
{
  return castBundle<NearestInnerHit>(view, bundle, object, 0.0, nullptr);
}

bool castAny(const RlodTreeView& view, RayBundle& bundle, std::int32_t object, double poe)
{
  return castBundle<AnyHit>(view, bundle, object, poe, nullptr);
}

void castNearestOfPacket(
  const RlodTreeView& view, RayPacket& packet, std::int32_t object, double poe)
{
  castPacketNearest(view, packet, object, poe);
}

void castNearestInnerOfPacket(const RlodTreeView& view, RayPacket& packet, std::int32_t object)
{
  castWaveNearest<NearestInnerHit, false>(view, packet, object, 0.0);
}

void castAnyOfPacket(const RlodTreeView& view, RayPacket& packet, double poe)
{
  castPacketAny(view, packet, poe);
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <glm/geometric.hpp>

#include <algorithm>

namespace mote
{

HWY_EXPORT(castNearest);
HWY_EXPORT(castNearestInner);
HWY_EXPORT(castAny);
HWY_EXPORT(castNearestOfPacket);
HWY_EXPORT(castNearestInnerOfPacket);
HWY_EXPORT(castAnyOfPacket);

namespace
{

/// Whether the rays of a bundle lie so far apart that most meet triangles of their own: a bundle
/// then looks at all that lies between them, and packets are much faster (docs/triangles.md).
bool isSparse(const RayBundle& rays, const RlodTree& tree)
{
  const auto width = [&](const float* places)
  {
    const auto [least, most] = std::minmax_element(places, places + rays.count);
    return double(*most - *least);
  };
  const bool fan = rays.kind == RayBundle::Kind::CommonOrigin;
  const double end = fan ? *std::max_element(rays.t, rays.t + rays.count) : 1.0;
  const double perRay = glm::length(glm::cross(rays.dx, rays.dy)) * width(rays.x) * width(rays.y) *
                        end * end / rays.count;
  const Vec3d size = tree.bounds().size();
  const double perTriangle =
    (size.x * size.y + size.y * size.z + size.z * size.x) / (2.0 * double(tree.size()));
  constexpr double raysPerTriangle = 6.0;
  return perTriangle < raysPerTriangle * perRay;
}

} // namespace

void RlodTree::cast(RayPacket& packet, std::int32_t object, double poe) const
{
  if (size() > 0)
    HWY_DYNAMIC_DISPATCH(castNearestOfPacket)(RlodTreeView(*this), packet, object, poe);
}

void RlodTree::castInner(RayPacket& packet, std::int32_t object) const
{
  if (size() > 0)
    HWY_DYNAMIC_DISPATCH(castNearestInnerOfPacket)(RlodTreeView(*this), packet, object);
}

void RlodTree::castInner(RayBundle& bundle, std::int32_t object) const
{
  if (size() == 0 || HWY_DYNAMIC_DISPATCH(castNearestInner)(RlodTreeView(*this), bundle, object))
    return;
  askInPackets(
    bundle, OnSurface::Neither, [&](RayPacket& packet, int) { castInner(packet, object); });
}

void RlodTree::occlude(RayPacket& packet, std::int32_t, double poe) const
{
  if (size() > 0)
    HWY_DYNAMIC_DISPATCH(castAnyOfPacket)(RlodTreeView(*this), packet, poe);
}

void RlodTree::cast(RayBundle& bundle, std::int32_t object, double poe) const
{
  if (size() == 0 ||
      HWY_DYNAMIC_DISPATCH(castNearest)(RlodTreeView(*this), bundle, object, poe, nullptr))
    return;
  askInPackets(
    bundle, OnSurface::Neither, [&](RayPacket& packet, int) { cast(packet, object, poe); });
}

void RlodTree::cast(RayBundle& bundle, std::int32_t object, double poe, Counts& counts) const
{
  if (size() > 0)
    HWY_DYNAMIC_DISPATCH(castNearest)(RlodTreeView(*this), bundle, object, poe, &counts);
}

void RlodTree::occlude(RayBundle& bundle, std::int32_t object, double poe) const
{
  if (size() == 0 || (!isSparse(bundle, *this) &&
                       HWY_DYNAMIC_DISPATCH(castAny)(RlodTreeView(*this), bundle, object, poe)))
    return;
  askInPackets(
    bundle, OnSurface::End, [&](RayPacket& packet, int) { occlude(packet, object, poe); });
}

} // namespace mote

#endif
