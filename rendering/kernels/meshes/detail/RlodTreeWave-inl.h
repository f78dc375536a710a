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
#include <cstring>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// Nodes, or clusters, each of which one ray is to visit.
class Visits
{
public:
  std::size_t size() const { return size_; }
  std::uint32_t index(std::size_t i) const { return index_[i]; }
  std::uint32_t ray(std::size_t i) const { return ray_[i]; }
  void shorten(std::size_t size) { size_ = size; }

  /// Adds first + k for each bit k, all for one ray.
  HWY_INLINE void add(std::uint32_t first, unsigned bits, std::uint32_t ray)
  {
    if (index_.size() < size_ + 2 * 16)
    {
      index_.resize(2 * index_.size() + 256);
      ray_.resize(index_.size());
    }
    const DU d;
#if HWY_CAP_GE512
    std::uint8_t bytes[8] = {};
    const auto word = static_cast<std::uint16_t>(bits);
    std::memcpy(bytes, &word, sizeof word); // in one piece: two bytes would have to meet in memory
    const auto mask = hn::LoadMaskBits(d, bytes);
    // Faster than Iota(), which goes by the memory.
    const auto all = hn::Add(hn::Load(d, numbers), hn::Set(d, first));
    hn::StoreU(hn::Compress(all, mask), d, index_.data() + size_);
    hn::StoreU(hn::Set(d, ray), d, ray_.data() + size_);
    size_ += static_cast<std::size_t>(std::popcount(bits));
#else
    (void)d;
    for (; bits != 0; bits &= bits - 1, ++size_)
    {
      index_[size_] = first + static_cast<std::uint32_t>(std::countr_zero(bits));
      ray_[size_] = ray;
    }
#endif
  }

private:
  alignas(64) static constexpr std::uint32_t numbers[16] = {
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

  std::vector<std::uint32_t> index_, ray_;
  std::size_t size_ = 0;
};

/// Takes the rays of a packet through a tree together: the visits that wait are worked off in
/// batches from the end. Those of a batch do not depend on one another, so memory is fetched for
/// many at a time and the processor works on several; and being the last ones they go deep first,
/// so that rays end early.
class Wave
{
public:
  Wave(const RlodTreeView& view, RayPacket& packet)
    : view_(view)
    , packet_(packet)
    , all_(view, packet)
  {
    for (int i = 0; i < packet.count; ++i)
    {
      rays_[i] = TreeRay(all_, i);
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
  static constexpr std::size_t batch = 64;
  static constexpr std::size_t ahead = 10; ///< visits between a fetch and its use

  bool isOpen(std::uint32_t ray) const { return (open_ >> ray & 1) != 0; }

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
    for (std::uint64_t left = open_; left != 0; left &= left - 1)
    {
      const auto ray = static_cast<std::uint32_t>(std::countr_zero(left));
      for (unsigned bits = entries.met(rays_[ray]); bits != 0; bits &= bits - 1)
      {
        const int k = std::countr_zero(bits);
        (entries.isNode(k) ? nodes : clusters).add(entries.index(k), 1, ray);
      }
    }
  }

  void visitNodes(Visits& nodes, Visits& clusters)
  {
    const std::size_t count = std::min(batch, nodes.size()), first = nodes.size() - count;
    std::uint32_t index[batch + ahead], ray[batch];
    for (std::size_t i = 0; i < count; ++i)
    {
      index[i] = nodes.index(first + i);
      ray[i] = nodes.ray(first + i);
    }
    std::fill_n(index + count, ahead, index[0]);
    nodes.shorten(first);
    for (std::size_t i = 0; i < std::min(ahead, count); ++i)
      fetch(&view_.nodes[index[i]]);
    for (std::size_t i = 0; i < count; ++i)
    {
      fetch(&view_.nodes[index[i + ahead]]);
      if (!isOpen(ray[i]))
        continue;
      const RlodNode& node = view_.nodes[index[i]];
      const unsigned bits = rays_[ray[i]].childrenMet(node);
      const unsigned clusterBits = bits & lowest(node.clusters);
      clusters.add(node.firstCluster, clusterBits, ray[i]);
      nodes.add(node.firstNode - node.clusters, bits & ~clusterBits, ray[i]);
    }
  }

  void visitClusters(Visits& clusters)
  {
    for (std::size_t i = 0; i < std::min(ahead, clusters.size()); ++i)
      fetch(&view_.clusters[clusters.index(i)]);
    Row z;
    for (std::size_t i = 0; i < clusters.size(); ++i)
    {
      if (i + ahead < clusters.size())
        fetch(&view_.clusters[clusters.index(i + ahead)]);
      const std::uint32_t ray = clusters.ray(i);
      if (!isOpen(ray) || rays_[ray].trianglesMet(view_.clusters[clusters.index(i)], z) == 0)
        continue;
      open_ &= ~(std::uint64_t{1} << ray);
      packet_.t[ray] = -std::numeric_limits<double>::infinity();
    }
    clusters.shorten(0);
  }

  const RlodTreeView& view_;
  RayPacket& packet_;
  const TreeRays all_;
  TreeRay rays_[RayPacket::capacity];
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
