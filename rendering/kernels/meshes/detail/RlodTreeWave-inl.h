// Whether rays meet anything in an RlodTree, many rays at a time. Included once per SIMD
// instruction set.

#if defined(MOTE_RLOD_TREE_WAVE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_RLOD_TREE_WAVE_INL_H
#undef MOTE_RLOD_TREE_WAVE_INL_H
#else
#define MOTE_RLOD_TREE_WAVE_INL_H
#endif

#include "TreeEntries-inl.h"

#include <algorithm>
#include <bit>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// Nodes, or clusters, each of which some rays are to visit: rays of a packet, as bits.
class Visits
{
public:
  struct Visit
  {
    std::uint64_t rays;
    std::uint32_t index;
  };

  std::size_t size() const { return size_; }
  const Visit& operator[](std::size_t i) const { return visits_[i]; }
  void shorten(std::size_t size) { size_ = size; }

  HWY_INLINE void add(std::uint32_t index, std::uint64_t rays)
  {
    if (visits_.size() == size_)
      visits_.resize(2 * size_ + 256);
    visits_[size_++] = {rays, index};
  }

private:
  std::vector<Visit> visits_;
  std::size_t size_ = 0;
};

/// Which of 16 things each ray of a packet meets, and the other way round.
class RaysAndThings
{
public:
  HWY_INLINE void clear()
  {
    for (int i = 0; i < RayPacket::capacity; i += step)
      hn::Store(hn::Zero(D16()), D16(), things_ + i);
  }
  HWY_INLINE void set(int ray, unsigned things)
  {
    things_[ray] = static_cast<std::uint16_t>(things);
    any_ |= things;
  }
  unsigned any() const { return any_; } ///< things that a ray meets

  /// The rays that meet a thing.
  HWY_INLINE std::uint64_t raysOf(int thing) const
  {
    const D16 d;
    const auto bit = hn::Set(d, static_cast<std::uint16_t>(1U << thing));
    std::uint64_t rays = 0;
    for (int i = 0; i < RayPacket::capacity; i += step)
      rays |= std::uint64_t{bitsOf(d, hn::TestBit(hn::Load(d, things_ + i), bit))} << i;
    return rays;
  }

private:
  using D16 = hn::CappedTag<std::uint16_t, 32>;
  static constexpr int step = static_cast<int>(hn::MaxLanes(D16()));

  alignas(64) std::uint16_t things_[RayPacket::capacity];
  unsigned any_ = 0;
};

/// Takes the rays of a packet through a tree together: a node is made ready once for all rays that
/// visit it, and a cluster too. The visits that wait are worked off in batches from the end, so
/// that memory is fetched for some at a time; and being the last ones they go deep first, so that
/// rays end early.
class Wave
{
public:
  Wave(const RlodTreeView& view, RayPacket& packet)
    : view_(view)
    , packet_(packet)
    , all_(view, packet)
    , boxRays_(all_, packet.count)
  {
    for (int i = 0; i < packet.count; ++i)
    {
      rays_[i] = TriangleRay(all_, i);
      if (all_.isAnywhere(i))
        open_ |= std::uint64_t{1} << i;
    }
  }

  void run()
  {
    static thread_local Visits nodes, clusters;
    nodes.shorten(0);
    clusters.shorten(0);
    enter(nodes, clusters);
    while (nodes.size() > 0)
    {
      visitNodes(nodes, clusters);
      if (clusters.size() >= batch)
        visitClusters(clusters);
    }
    visitClusters(clusters);
  }

private:
  static constexpr std::size_t batch = 16;
  static constexpr std::size_t ahead = 4; ///< visits between a fetch and its use

  template <typename T>
  static HWY_INLINE void fetch(const T* what)
  {
    const char* at = reinterpret_cast<const char*>(what);
    for (std::size_t byte = 0; byte < sizeof(T); byte += 64)
      __builtin_prefetch(at + byte);
  }

  void enter(Visits& nodes, Visits& clusters) const
  {
    const TreeEntries entries(view_, all_, packet_.count);
    RaysAndThings met;
    met.clear();
    for (std::uint64_t left = open_; left != 0; left &= left - 1)
    {
      const int ray = std::countr_zero(left);
      met.set(ray, entries.met(boxRays_, ray));
    }
    for (unsigned bits = met.any(); bits != 0; bits &= bits - 1)
    {
      const int k = std::countr_zero(bits);
      (entries.isNode(k) ? nodes : clusters).add(entries.index(k), met.raysOf(k));
    }
  }

  void visitNodes(Visits& nodes, Visits& clusters)
  {
    const std::size_t count = std::min(batch, nodes.size()), first = nodes.size() - count;
    Visits::Visit visits[batch];
    for (std::size_t i = 0; i < count; ++i)
      visits[i] = nodes[first + i];
    nodes.shorten(first);
    for (std::size_t i = 0; i < std::min(ahead, count); ++i)
      fetch(&view_.nodes[visits[i].index]);
    for (std::size_t i = 0; i < count; ++i)
    {
      if (i + ahead < count)
        fetch(&view_.nodes[visits[i + ahead].index]);
      if (const std::uint64_t rays = visits[i].rays & open_; rays != 0)
        visitNode(view_.nodes[visits[i].index], rays, nodes, clusters);
    }
  }

  HWY_INLINE void visitNode(
    const RlodNode& node, std::uint64_t rays, Visits& nodes, Visits& clusters) const
  {
    const TreeBoxes boxes(node);
    RaysAndThings met;
    met.clear();
    for (std::uint64_t left = rays; left != 0; left &= left - 1)
    {
      const int ray = std::countr_zero(left);
      met.set(ray, boxRays_.met(boxes, ray));
    }
    const unsigned any = met.any() & lowest(node.children);
    const unsigned clusterBits = any & lowest(node.clusters);
    for (unsigned bits = clusterBits; bits != 0; bits &= bits - 1)
    {
      const int k = std::countr_zero(bits);
      clusters.add(node.firstCluster + static_cast<unsigned>(k), met.raysOf(k));
    }
    for (unsigned bits = any & ~clusterBits; bits != 0; bits &= bits - 1)
    {
      const int k = std::countr_zero(bits);
      nodes.add(node.nodeOf(static_cast<unsigned>(k)), met.raysOf(k));
    }
  }

  void visitClusters(Visits& clusters)
  {
    for (std::size_t i = 0; i < std::min(ahead, clusters.size()); ++i)
      fetch(&view_.clusters[clusters[i].index]);
    for (std::size_t i = 0; i < clusters.size(); ++i)
    {
      if (i + ahead < clusters.size())
        fetch(&view_.clusters[clusters[i + ahead].index]);
      if (const std::uint64_t rays = clusters[i].rays & open_; rays != 0)
        visitCluster(view_.clusters[clusters[i].index], rays);
    }
    clusters.shorten(0);
  }

  HWY_INLINE void visitCluster(const TriangleCluster& cluster, std::uint64_t rays)
  {
    const AllCornerIndices corners(cluster);
    Row z;
    for (std::uint64_t left = rays; left != 0; left &= left - 1)
    {
      const int ray = std::countr_zero(left);
      if (rays_[ray].trianglesMet(cluster, corners, z) == 0)
        continue;
      open_ &= ~(std::uint64_t{1} << ray);
      packet_.t[ray] = -std::numeric_limits<double>::infinity();
    }
  }

  const RlodTreeView& view_;
  RayPacket& packet_;
  const TreeRays all_;
  const BoxRays boxRays_;
  TriangleRay rays_[RayPacket::capacity];
  std::uint64_t open_ = 0; ///< rays that have met nothing yet
};

inline void castPacketAny(const RlodTreeView& view, RayPacket& packet)
{
  Wave(view, packet).run();
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
