// The tree over the particles of a PkdTree that are shown, where they are few.

#include "PkdTree.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <bit>
#include <limits>
#include <numeric>

namespace mote
{

namespace
{

constexpr std::size_t bucketsAPart = 4096;

/// Particles shown in an occupied bucket, in the mean, up to which a tree of their own pays.
constexpr std::size_t fullestSparse = 6;

/// Where what is shown in each part of the buckets goes, and, last, how many are; `occupied`
/// becomes the number of buckets with any.
template <typename Bits>
std::vector<std::size_t> placesOf(const RawVector<Bits>& shown, std::size_t& occupied)
{
  std::vector<std::size_t> places((shown.size() + bucketsAPart - 1) / bucketsAPart + 1, 0);
  std::atomic<std::size_t> allOccupied{0};
  tbb::parallel_for(std::size_t{0}, places.size() - 1,
    [&](std::size_t part)
    {
      const std::size_t first = part * bucketsAPart;
      const std::size_t last = std::min(shown.size(), first + bucketsAPart);
      std::size_t here = 0;
      for (std::size_t b = first; b < last; ++b)
      {
        places[part] += static_cast<std::size_t>(std::popcount(shown[b]));
        here += shown[b] != 0;
      }
      allOccupied += here;
    });
  occupied = allOccupied;
  std::exclusive_scan(places.begin(), places.end(), places.begin(), std::size_t{0});
  return places;
}

} // namespace

void PkdTree::makeSparse()
{
  if (sparseShare_ == 0)
    return;
  std::size_t occupied = 0;
  const std::vector<std::size_t> places = placesOf(met(), occupied);
  const std::size_t count = places.back();
  // Where whole buckets are shown, the whole tree is as good.
  if (count == 0 || count > count_ / sparseShare_ || count > fullestSparse * occupied)
    return;
  RawVector<SparseParticle> shown(count);
  RawVector<Vec3d> centers(count);
  tbb::parallel_for(std::size_t{0}, places.size() - 1,
    [&](std::size_t part)
    {
      std::size_t next = places[part];
      const std::size_t first = part * bucketsAPart;
      const std::size_t last = std::min(met().size(), first + bucketsAPart);
      for (std::size_t b = first; b < last; ++b)
        for (unsigned bits = met()[b]; bits != 0; bits &= bits - 1)
        {
          shown[next] =
            particleAt(b * bucketSize + static_cast<std::size_t>(std::countr_zero(bits)));
          centers[next] = Vec3d(shown[next].corner) + Vec3d(shown[next].place);
          ++next;
        }
    });
  auto sparse = std::make_shared<Sparse>();
  sparse->count = count;
  sparse->slots.resize(count);
  // Only the order is taken from this tree: its coordinates are others.
  PkdTree order;
  ParticleSet set;
  set.positions = ArrayView(&centers.data()->x, count, 3);
  order.build(set);
  sparse->nodes.resize(planLevels(sparse->count, sparse->levels));
  sparse->rows.resize((sparse->count + bucketSize - 1) / bucketSize * (6 + ownRadii_));
  std::vector<Bounds> below(sparse->levels[0].count);
  const double margin = roundingMargin();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, below.size(), 16),
    [&](const tbb::blocked_range<std::size_t>& treelets)
    {
      for (std::size_t t = treelets.begin(); t != treelets.end(); ++t)
      {
        std::array<Bounds, fanout> children;
        for (std::size_t b = 0; b < fanout && (t * fanout + b) * bucketSize < sparse->count; ++b)
        {
          children[b] = copyBucket(shown, order, *sparse, t * fanout + b);
          below[t].add(children[b]);
        }
        sparse->nodes[sparse->levels[0].first + t].corner = {};
        setBounds(sparse->nodes[sparse->levels[0].first + t], below[t], children, margin);
      }
    });
  sparse->bounds = boundNodes(sparse->levels, sparse->nodes.data(), std::move(below), margin);
  sparse_ = std::move(sparse);
}

PkdTree::SparseParticle PkdTree::particleAt(std::size_t slot) const
{
  const std::array<float, 3>& corner = treeletOf(slot).corner;
  return {place(slot), storedRadius(slot), {corner[0], corner[1], corner[2]}, slot};
}

PkdTree::Bounds PkdTree::copyBucket(const RawVector<SparseParticle>& shown, const PkdTree& order,
  Sparse& sparse, std::size_t bucket) const
{
  Bounds bounds;
  const std::size_t first = bucket * bucketSize, rowCount = 6 + ownRadii_;
  const std::size_t count = std::min<std::size_t>(bucketSize, sparse.count - first);
  Row* rows = &sparse.rows[bucket * rowCount];
  for (std::size_t i = 0; i < bucketSize; ++i)
  {
    const auto write = [&](std::size_t row, float v)
    { rows[row].words[i] = std::bit_cast<std::uint32_t>(v); };
    if (i >= count)
    {
      // A place that nothing takes is not a number; rays know how many the last bucket has.
      for (std::size_t row = 0; row < rowCount; ++row)
        write(row, std::numeric_limits<float>::quiet_NaN());
      continue;
    }
    const SparseParticle& p = shown[order.inputIndex(first + i)];
    sparse.slots[first + i] = p.slot;
    for (int k = 0; k < 3; ++k)
    {
      write(static_cast<std::size_t>(k), p.place[k]);
      write(rowCount - 3 + static_cast<std::size_t>(k), p.corner[k]);
    }
    if (ownRadii_)
      write(3, p.radius);
    bounds.add(Vec3d(p.corner) + Vec3d(p.place), double(p.radius));
  }
  return bounds;
}

} // namespace mote
