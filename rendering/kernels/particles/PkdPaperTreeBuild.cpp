#include "PkdPaperTree.h"

#include "detail/HeapOrder.h"
#include "detail/KdBuild.h"
#include "detail/RadiusGroups.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <atomic>
#include <cmath>

namespace mote
{

/// One build of one tree: sorts the particles, coordinates being whole numbers in the order of the
/// float numbers that they stand for, so that every subtree's stand in order; turns the numbers
/// back and brings the particles into heap order.
struct PkdPaperTreeBuilder
{
  PkdPaperTree& tree;
  const ParticleSet& particles;
  const PkdPaperTreeOptions& options;
  SharedProgress progress;

  static constexpr std::size_t serialCount = 8192; ///< particles that are one task
  static constexpr int treeletLevels = 12;

  std::atomic<std::size_t> sorted{0}; ///< particles in finished tasks

  void chooseNumbers()
  {
    const ParticleStatistics& s = tree.statistics_;
    tree.count_ = s.valid;
    tree.origin_ = s.centers.center();
    const double edge =
      particleGridEdge(s.centers.size(), static_cast<double>(s.valid), s.largestRadius);
    tree.unit_ = std::exp2(std::round(std::log2(edge)));
    tree.radius_ = static_cast<float>(s.largestRadius / tree.unit_);
    tree.ownRadii_ = static_cast<float>(s.smallestRadius / tree.unit_) != tree.radius_;
    const bool narrow = particles.count() <= std::numeric_limits<std::uint32_t>::max();
    tree.indexWords_ = !options.keepIndices ? 0 : narrow ? 1 : 2;
    tree.wordsAParticle_ = 3 + tree.ownRadii_ + tree.indexWords_;
    tree.words_.resize(tree.count_ * tree.wordsAParticle_);
    tree.axes_.resize((tree.count_ / 2 + 3) / 4);
    std::fill(tree.axes_.begin(), tree.axes_.end(), std::uint8_t{0});
  }

  template <int WORDS>
  KdRecord<WORDS>* records()
  {
    return reinterpret_cast<KdRecord<WORDS>*>(tree.words_.data());
  }

  /// Whole numbers that are ordered as float numbers are.
  static std::uint32_t toKey(float v)
  {
    const auto bits = std::bit_cast<std::uint32_t>(v + 0.0f); // one zero, not two
    return bits >> 31 != 0 ? ~bits : bits | 0x80000000u;
  }
  static float fromKey(std::uint32_t key)
  {
    return std::bit_cast<float>(key >> 31 != 0 ? key & 0x7fffffffu : ~key);
  }

  template <int WORDS>
  KdRecord<WORDS> recordOf(std::size_t i, const Vec3d& p, double r) const
  {
    KdRecord<WORDS> record{};
    const Vec3d place = (p - tree.origin_) / tree.unit_;
    for (int k = 0; k < 3; ++k)
      record.words[static_cast<std::size_t>(k)] = toKey(static_cast<float>(place[k]));
    if constexpr (WORDS > 3)
      if (tree.ownRadii_)
        record.words[3] = std::bit_cast<std::uint32_t>(static_cast<float>(r / tree.unit_));
    if (tree.indexWords_ > 0)
      record.words[WORDS - 1] = static_cast<std::uint32_t>(i);
    if (tree.indexWords_ > 1) // the upper half first, as the order of records wants it
      record.words[WORDS - 2] = static_cast<std::uint32_t>(i >> 32);
    return record;
  }

  int axisFor(const KdRegion& region, int depth) const
  {
    if (options.split == PkdTreeOptions::Split::RoundRobin)
      return depth % 3;
    const auto extent = [&](std::size_t k)
    { return fromKey(region.high[k]) - fromKey(region.low[k]); };
    const std::size_t widest = extent(1) > extent(0) ? 1 : 0;
    return static_cast<int>(extent(2) > extent(widest) ? 2 : widest);
  }

  void setAxis(std::size_t node, int axis)
  {
    std::atomic_ref<std::uint8_t> four(tree.axes_[node / 4]);
    four.fetch_or(static_cast<std::uint8_t>(axis << (2 * (node % 4))), std::memory_order_relaxed);
  }

  /// Sorts the subtree of the node, whose records stand at [first, last).
  template <int WORDS>
  void split(KdRecord<WORDS>* first, KdRecord<WORDS>* last, std::size_t node, int depth,
    const KdRegion& region)
  {
    const auto count = static_cast<std::size_t>(last - first);
    if (count < 2 || progress.stopped())
      return;
    const KdRegion tight = count <= tightKdCount ? KdRegion(first, last) : region;
    const int axis = axisFor(tight, depth);
    const auto k = static_cast<std::size_t>(axis);
    setAxis(node, axis);
    KdRecord<WORDS>* middle = first + leftSubtreeSize(count);
    MedianSplit<WORDS>::run(first, middle, last, axis, tight.low[k], tight.high[k]);
    KdRegion lower = tight, upper = tight;
    lower.high[k] = upper.low[k] = (*middle)[axis];
    const auto below = [&] { split(first, middle, 2 * node + 1, depth + 1, lower); };
    const auto above = [&] { split(middle + 1, last, 2 * node + 2, depth + 1, upper); };
    if (count > serialCount)
    {
      tbb::parallel_invoke(
        [&] { below(), tell(middle - first); }, [&] { above(), tell(last - middle - 1); });
      return;
    }
    below();
    above();
  }

  /// Tells of a subtree that is done, where it was one task.
  void tell(std::ptrdiff_t size)
  {
    const auto count = static_cast<std::size_t>(size);
    if (count > serialCount)
      return;
    const std::size_t done = sorted += count;
    if (done / serialCount != (done - count) / serialCount)
      progress.report(0.2 + 0.6 * static_cast<double>(done) / static_cast<double>(tree.count_));
  }

  template <int WORDS>
  void finish()
  {
    KdRecord<WORDS>* all = records<WORDS>();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tree.count_, serialCount),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
          for (std::size_t k = 0; k < 3; ++k)
            all[i].words[k] = std::bit_cast<std::uint32_t>(fromKey(all[i].words[k]));
      });
    HeapOrder<KdRecord<WORDS>>::run(all, tree.count_);
  }

  /// The treelets' largest radii, then those of all subtrees that hold whole treelets.
  void findRadii()
  {
    const int levels = std::bit_width(tree.count_);
    const std::size_t treelets =
      tree.ownRadii_ ? std::size_t{1} << std::max(0, levels - treeletLevels) : std::size_t{1};
    tree.subtreeRadius_.resize(2 * treelets - 1);
    tree.subtreeRadius_[0] = tree.radius_;
    if (treelets == 1)
      return;
    tbb::parallel_for(std::size_t{0}, treelets,
      [&](std::size_t t)
      {
        float largest = 0.0f;
        // A level of the subtree: places count from 1, so that those of children are twice as much.
        for (std::size_t from = treelets + t, width = 1; from <= tree.count_; from *= 2, width *= 2)
          for (std::size_t i = from; i < from + width && i <= tree.count_; ++i)
            largest = std::max(largest, tree.storedRadius(i - 1));
        tree.subtreeRadius_[treelets - 1 + t] = largest;
      });
    for (std::size_t i = treelets - 1; i-- > 0;)
      tree.subtreeRadius_[i] = std::max(
        {tree.storedRadius(i), tree.subtreeRadius_[2 * i + 1], tree.subtreeRadius_[2 * i + 2]});
  }

  template <int WORDS>
  bool sort()
  {
    KdRecord<WORDS>* all = records<WORDS>();
    fillKdRecords(particles, tree.count_, all,
      [this](std::size_t i, const Vec3d& p, double r) { return recordOf<WORDS>(i, p, r); });
    if (!progress.report(0.2))
      return false;
    KdRegion region;
    const Box& centers = tree.statistics_.centers;
    for (int k = 0; k < 3; ++k)
    {
      const auto keyOf = [&](const Vec3d& p)
      { return toKey(static_cast<float>((p[k] - tree.origin_[k]) / tree.unit_)); };
      region.low[static_cast<std::size_t>(k)] = keyOf(centers.lower);
      region.high[static_cast<std::size_t>(k)] = keyOf(centers.upper);
    }
    split(all, all + tree.count_, 0, 0, region);
    if (!progress.report(0.8))
      return false;
    finish<WORDS>();
    findRadii();
    return progress.report(1.0);
  }

  bool run()
  {
    tree.statistics_ = examine(particles);
    if (!progress.report(0.1))
      return false;
    if (tree.statistics_.valid == 0)
      return true;
    chooseNumbers();
    switch (tree.wordsAParticle_)
    {
    case 3:
      return sort<3>();
    case 4:
      return sort<4>();
    case 5:
      return sort<5>();
    default:
      return sort<6>();
    }
  }
};

void PkdPaperTree::build(
  const ParticleSet& particles, const PkdPaperTreeOptions& options, const Progress& progress)
{
  clear();
  PkdPaperTreeBuilder builder{*this, particles, options, SharedProgress(progress)};
  bool complete = false;
  try
  {
    complete = builder.run();
  }
  catch (...)
  {
    clear();
    throw;
  }
  if (!complete)
    clear();
}

} // namespace mote
