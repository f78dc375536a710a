// Whether rays meet anything in an RlodTree, many rays at a time. Included once per SIMD
// instruction set.

#if defined(MOTE_RLOD_TREE_WAVE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_RLOD_TREE_WAVE_INL_H
#undef MOTE_RLOD_TREE_WAVE_INL_H
#else
#define MOTE_RLOD_TREE_WAVE_INL_H
#endif

#include "BundleRays-inl.h"
#include "TreeEntries-inl.h"

#include <algorithm>
#include <bit>
#include <type_traits>
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

/// What the rays of a packet may err by.
struct RayTolerances
{
  Tolerance ofRay[RayPacket::capacity];
  float most = 0.0f; ///< of any ray, anywhere in the tree

  void set(int ray, const Tolerance& tolerance)
  {
    ofRay[ray] = tolerance;
    // z counts from where rays enter the tree, which is two wide.
    most = std::max(most, tolerance.atQ + std::max(0.0f, 2.0f * tolerance.perZ));
  }
};
struct NoTolerances
{
};

/// What the rays of a packet have hit.
struct RaySlots
{
  std::uint64_t of[RayPacket::capacity];
};
struct NoSlots
{
};

/// Takes the rays of a packet through a tree together: a node is made ready once for all rays that
/// visit it, and a cluster too. The visits that wait are worked off in batches from the end, so
/// that memory is fetched for some at a time; and being the last ones they go deep first, so that
/// rays end early. Where the nearest hits are wanted the nearest child is the last one, and batches
/// are small. R-LODs stand for what errs by less than `poe` footprints, if `lods`.
template <typename Policy, bool lods>
class Wave
{
public:
  Wave(const RlodTreeView& view, RayPacket& packet, double poe)
    : view_(view)
    , packet_(packet)
    , all_(view, packet)
    , boxRays_(all_, packet.count)
  {
    const double factor = radiiPerPixel * poe / view.unit;
    for (int i = 0; i < packet.count; ++i)
    {
      rays_[i] = TriangleRay(all_, i);
      if (all_.isAnywhere(i))
        open_ |= std::uint64_t{1} << i;
      if constexpr (lods)
        tolerances_.set(i, all_.tolerance(packet, factor, i));
      if constexpr (!Policy::any)
        slots_.of[i] = RayPacket::noHit;
    }
  }

  void run()
  {
    static thread_local Visits nodes, clusters;
    nodes.shorten(0);
    clusters.shorten(0);
    enter(nodes, clusters);
    if constexpr (!Policy::any)
      visitClusters(clusters);
    while (nodes.size() > 0)
    {
      visitNodes(nodes, clusters);
      if (clusters.size() >= (Policy::any ? batch : 1))
        visitClusters(clusters);
    }
    visitClusters(clusters);
  }

  /// Writes the nearest hits into the packet.
  void keepNearest(std::int32_t object) const
  {
    for (int i = 0; i < packet_.count; ++i)
    {
      if (slots_.of[i] == RayPacket::noHit)
        continue;
      const double t = all_.t0[i] + all_.perZ[i] * static_cast<double>(all_.best[i]);
      // What is as near already may be a little farther in float.
      if (!(t < packet_.t[i]))
        continue;
      packet_.t[i] = t;
      packet_.slot[i] = slots_.of[i];
      packet_.object[i] = object;
    }
  }

private:
  using Nearest = std::conditional_t<Policy::any, NoDepths, LeastDepths>;

  static constexpr std::size_t batch = Policy::any ? 16 : 4;
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
    const TreeEntries entries(
      view_, all_, packet_.count, [this](const RlodNode& node) { return errsLittle(node) == 0; });
    RaysAndThings met;
    met.clear();
    Nearest nearest;
    for (std::uint64_t left = open_; left != 0; left &= left - 1)
    {
      const int ray = std::countr_zero(left);
      met.set(ray, entries.met(boxRays_, ray, nearest));
    }
    add(met, met.any(), nearest,
      [&](int k, std::uint64_t rays)
      { (entries.isNode(k) ? nodes : clusters).add(entries.index(k), rays); });
  }

  /// Calls take(thing, its rays) for some of 16 things; the nearest is the last where that counts.
  template <typename Take>
  static HWY_INLINE void add(
    const RaysAndThings& met, unsigned bits, const Nearest& nearest, const Take& take)
  {
    if constexpr (Policy::any)
      for (; bits != 0; bits &= bits - 1)
        take(std::countr_zero(bits), met.raysOf(std::countr_zero(bits)));
    else
    {
      int order[16], count = 0;
      for (; bits != 0; bits &= bits - 1)
      {
        const int k = std::countr_zero(bits);
        int at = count++;
        for (; at > 0 && nearest.of(order[at - 1]) < nearest.of(k); --at)
          order[at] = order[at - 1];
        order[at] = k;
      }
      for (int i = 0; i < count; ++i)
        take(order[i], met.raysOf(order[i]));
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

  std::uint32_t indexOf(const RlodNode& node) const
  {
    return static_cast<std::uint32_t>(&node - view_.nodes);
  }

  /// Children whose R-LODs may be taken, and err by less than some ray may somewhere.
  HWY_INLINE unsigned errsLittle(const RlodNode& node) const
  {
    if constexpr (lods)
      return fineChildren(
        view_, indexOf(node), view_.mayErr(node) & lowest(node.children), tolerances_.most);
    else
      return 0;
  }

  /// Asks a ray at the R-LODs of those of the children `may` that err by less than it may. Answers
  /// which others it meets; none where an R-LOD is in its way and any hit will do.
  HWY_INLINE unsigned metBesidePlanes(
    const RlodNode& node, const TreeBoxes& boxes, unsigned may, int ray, Nearest& nearest)
  {
    RowDepths<Nearest> enter(nearest);
    const unsigned met = boxRays_.met(boxes, ray, enter);
    const unsigned fine =
      fineChildren(view_, indexOf(node), met & may, tolerances_.ofRay[ray], enter.z);
    if (fine == 0)
      return met;
    return castPlanes(indexOf(node), boxes, fine, ray) ? met & ~fine : 0;
  }

  /// Asks a ray at R-LODs of a node. False where one is in its way and any hit will do.
  HWY_NOINLINE bool castPlanes(std::uint32_t index, const TreeBoxes& boxes, unsigned fine, int ray)
  {
    Row near, far, at;
    boxRays_.met(boxes, ray, near, far);
    const unsigned planes = fine & rays_[ray].planesMet(view_.planes[index], near, far, at);
    if constexpr (!Policy::any)
      keep(ray, planes, at, [&](unsigned k) { return RlodTree::lodSlot(index, k); });
    else if (planes != 0)
    {
      end(ray);
      return false;
    }
    return true;
  }

  HWY_INLINE void end(int ray)
  {
    open_ &= ~(std::uint64_t{1} << ray);
    packet_.t[ray] = -std::numeric_limits<double>::infinity();
  }

  /// Takes the nearest of the places with a bit, where it is nearer than what there is.
  template <typename SlotOf>
  HWY_INLINE void keep(int ray, unsigned bits, const Row& z, const SlotOf& slotOf)
  {
    for (; bits != 0; bits &= bits - 1)
    {
      const auto k = static_cast<unsigned>(std::countr_zero(bits));
      if (!(z.v[k] < rays_[ray].best))
        continue;
      rays_[ray].best = all_.best[ray] = z.v[k];
      slots_.of[ray] = slotOf(k);
    }
  }

  HWY_INLINE void visitNode(
    const RlodNode& node, std::uint64_t rays, Visits& nodes, Visits& clusters)
  {
    const TreeBoxes boxes(node);
    RaysAndThings met;
    met.clear();
    Nearest nearest;
    [[maybe_unused]] const unsigned may = errsLittle(node);
    for (std::uint64_t left = rays; left != 0; left &= left - 1)
    {
      const int ray = std::countr_zero(left);
      unsigned children = 0;
      if constexpr (lods)
        children = may == 0 ? boxRays_.met(boxes, ray, nearest)
                            : metBesidePlanes(node, boxes, may, ray, nearest);
      else
        children = boxRays_.met(boxes, ray, nearest);
      met.set(ray, children);
    }
    const unsigned any = met.any() & lowest(node.children);
    const unsigned clusterBits = any & lowest(node.clusters);
    add(met, clusterBits, nearest,
      [&](int k, std::uint64_t some)
      { clusters.add(node.firstCluster + static_cast<unsigned>(k), some); });
    add(met, any & ~clusterBits, nearest,
      [&](int k, std::uint64_t some) { nodes.add(node.nodeOf(static_cast<unsigned>(k)), some); });
  }

  void visitClusters(Visits& clusters)
  {
    const std::size_t count = clusters.size();
    const auto place = [&](std::size_t i) { return Policy::any ? i : count - 1 - i; };
    for (std::size_t i = 0; i < std::min(ahead, count); ++i)
      fetch(&view_.clusters[clusters[place(i)].index]);
    for (std::size_t i = 0; i < count; ++i)
    {
      if (i + ahead < count)
        fetch(&view_.clusters[clusters[place(i + ahead)].index]);
      const Visits::Visit& visit = clusters[place(i)];
      if (const std::uint64_t rays = visit.rays & open_; rays != 0)
        visitCluster(visit.index, rays);
    }
    clusters.shorten(0);
  }

  HWY_INLINE void visitCluster(std::uint32_t index, std::uint64_t rays)
  {
    const TriangleCluster& cluster = view_.clusters[index];
    const AllCornerIndices corners(cluster);
    Row z;
    for (std::uint64_t left = rays; left != 0; left &= left - 1)
    {
      const int ray = std::countr_zero(left);
      const unsigned met = rays_[ray].template trianglesMet<Policy>(cluster, corners, z);
      if constexpr (!Policy::any)
        keep(ray, met, z,
          [&](unsigned k) { return std::uint64_t{index} * TriangleCluster::capacity + k; });
      else if (met != 0)
        end(ray);
    }
  }

  const RlodTreeView& view_;
  RayPacket& packet_;
  TreeRays all_;
  const BoxRays boxRays_;
  TriangleRay rays_[RayPacket::capacity];
  std::uint64_t open_ = 0; ///< rays that may meet something yet
  std::conditional_t<lods, RayTolerances, NoTolerances> tolerances_;
  std::conditional_t<Policy::any, NoSlots, RaySlots> slots_;
};

inline void castPacketAny(const RlodTreeView& view, RayPacket& packet, double poe)
{
  if (view.takesLods(packet, poe))
    Wave<AnyHit, true>(view, packet, poe).run();
  else
    Wave<AnyHit, false>(view, packet, 0.0).run();
}

template <typename Policy, bool lods>
void castWaveNearest(const RlodTreeView& view, RayPacket& packet, std::int32_t object, double poe)
{
  Wave<Policy, lods> wave(view, packet, poe);
  wave.run();
  wave.keepNearest(object);
}

inline void castPacketNearest(
  const RlodTreeView& view, RayPacket& packet, std::int32_t object, double poe)
{
  if (view.takesLods(packet, poe))
    castWaveNearest<NearestHit, true>(view, packet, object, poe);
  else
    castWaveNearest<NearestHit, false>(view, packet, object, 0.0);
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
