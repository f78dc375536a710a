// Single rays through an RlodTree. Included once per SIMD instruction set.

#if defined(MOTE_RLOD_TREE_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_RLOD_TREE_RAYS_INL_H
#undef MOTE_RLOD_TREE_RAYS_INL_H
#else
#define MOTE_RLOD_TREE_RAYS_INL_H
#endif

#include "BundleFrame.h"
#include "TreeRays-inl.h"

#include <vector>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// Nodes and clusters that wait for a ray, clusters with the highest bit.
struct WaitingNode
{
  std::uint32_t index;
  float z;

  static constexpr std::uint32_t isCluster = 1U << 31;
};

template <typename T>
T* waitingStack(const RlodTreeView& view)
{
  static thread_local std::vector<T> stack;
  if (stack.size() < view.stackSize())
    stack.resize(view.stackSize());
  return stack.data();
}

HWY_INLINE std::uint32_t referenceOf(const RlodNode& node, unsigned child)
{
  return child < node.clusters ? (node.firstCluster + child) | WaitingNode::isCluster
                               : node.nodeOf(child);
}

HWY_INLINE void prefetchReference(const RlodTreeView& view, std::uint32_t reference)
{
  const bool isCluster = (reference & WaitingNode::isCluster) != 0;
  const std::uint32_t index = reference & ~WaitingNode::isCluster;
  const char* at = isCluster ? reinterpret_cast<const char*>(view.clusters + index)
                             : reinterpret_cast<const char*>(view.nodes + index);
  __builtin_prefetch(at);
  __builtin_prefetch(at + 64);
  if (isCluster)
  {
    __builtin_prefetch(at + 128);
    __builtin_prefetch(at + 192);
  }
}

/// Those of the children `may` of a node whose R-LODs err by less than is allowed where the ray
/// meets them first.
HWY_INLINE unsigned fineChildren(const RlodTreeView& view, std::uint32_t index, unsigned may,
  const Tolerance& tolerance, const Row& near)
{
  if (may == 0)
    return 0;
  unsigned bits = 0;
  for (int set = 0; set < laneSets; ++set)
  {
    const VF allowed = hn::MulAdd(near.load(set), all(tolerance.perZ), all(tolerance.atQ));
    bits |= bitsOf(hn::Gt(allowed, errorRadii(view.words[index], view.levels, set)))
            << (set * lanes);
  }
  return bits & may;
}

/// Takes the nearest of the places with a bit, where it is nearer than what there is.
template <typename SlotOf>
HWY_INLINE void keepNearest(
  unsigned bits, const Row& z, const SlotOf& slotOf, TreeRay& ray, std::uint64_t& slot)
{
  for (; bits != 0; bits &= bits - 1)
  {
    const auto k = static_cast<unsigned>(std::countr_zero(bits));
    if (!(z.v[k] < ray.best))
      continue;
    ray.best = z.v[k];
    slot = slotOf(k);
  }
}

/// The slot of the nearest hit, or RayPacket::noHit; ray.best becomes its z. R-LODs count that err
/// by less than the tolerance, if `lods`.
template <bool lods>
std::uint64_t nearestHit(const RlodTreeView& view, TreeRay& ray, const Tolerance& tolerance)
{
  std::uint64_t slot = RayPacket::noHit;
  WaitingNode* const bottom = waitingStack<WaitingNode>(view);
  WaitingNode* top = bottom;
  *top++ = {0, ray.first};
  while (top != bottom)
  {
    const WaitingNode next = *--top;
    if (next.z > ray.best)
      continue;
    Row z;
    if ((next.index & WaitingNode::isCluster) != 0)
    {
      const std::uint32_t cluster = next.index & ~WaitingNode::isCluster;
      const unsigned met = ray.trianglesMet(view.clusters[cluster], z);
      const auto slotOf = [&](unsigned k)
      { return std::uint64_t{cluster} * TriangleCluster::capacity + k; };
      keepNearest(met, z, slotOf, ray, slot);
      continue;
    }
    const RlodNode& node = view.nodes[next.index];
    WaitingNode* const first = top;
    unsigned bits = 0;
    if constexpr (lods)
    {
      Row far, at;
      bits = ray.childrenMet(node, z, far);
      const unsigned may = bits & view.mayErr(node);
      if (const unsigned fine = fineChildren(view, next.index, may, tolerance, z); fine != 0)
      {
        bits &= ~fine;
        const unsigned met = fine & ray.planesMet(view.planes[next.index], z, far, at);
        const auto slotOf = [&](unsigned k) { return RlodTree::lodSlot(next.index, k); };
        keepNearest(met, at, slotOf, ray, slot);
      }
    }
    else
      bits = ray.childrenMet(node, z);
    for (; bits != 0; bits &= bits - 1)
    {
      const auto k = static_cast<unsigned>(std::countr_zero(bits));
      const WaitingNode child = {referenceOf(node, k), z.v[k]};
      WaitingNode* at = top++;
      for (; at != first && at[-1].z < child.z; --at)
        *at = at[-1];
      *at = child;
    }
    if (top != first)
      prefetchReference(view, top[-1].index);
  }
  return slot;
}

inline void castPacketNearest(
  const RlodTreeView& view, RayPacket& packet, std::int32_t object, double poe)
{
  // Rays that are not told how far they lie apart are exact.
  const bool lods =
    poe > 0.0 && view.words != nullptr && (packet.footprint > 0.0 || packet.footprintPerT > 0.0);
  const double factor = radiiPerPixel * poe / view.unit;
  const TreeRays rays(view, packet);
  for (int i = 0; i < packet.count; ++i)
  {
    if (!rays.isAnywhere(i))
      continue;
    TreeRay ray(rays, i);
    const Tolerance tolerance = {
      static_cast<float>(factor * (packet.footprint + rays.t0[i] * packet.footprintPerT)),
      static_cast<float>(factor * (rays.perZ[i] * packet.footprintPerT))};
    const std::uint64_t slot =
      lods ? nearestHit<true>(view, ray, tolerance) : nearestHit<false>(view, ray, tolerance);
    const double t = rays.t0[i] + rays.perZ[i] * static_cast<double>(ray.best);
    // What is as near already may be a little farther in float.
    if (slot == RayPacket::noHit || !(t < packet.t[i]))
      continue;
    packet.t[i] = t;
    packet.slot[i] = slot;
    packet.object[i] = object;
  }
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
