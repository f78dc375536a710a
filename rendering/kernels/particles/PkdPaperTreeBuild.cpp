#include "PkdPaperTree.h"

#include "detail/BuildOrClear.h"
#include "detail/HeapOrder.h"
#include "detail/KdBuild.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <atomic>
#include <bit>

namespace mote
{

/// One build of one tree: sorts the particles, coordinates being whole numbers in the order of the
/// float numbers that they stand for, so that every subtree's stand in order; turns the numbers
/// back and brings the particles into heap order.
struct PkdPaperTree::Builder : KdBuilder<PkdPaperTree>
{
  static constexpr double sortedShare = 0.8;       ///< of the work
  static constexpr std::size_t serialCount = 8192; ///< particles that are one task
  static constexpr int treeletLevels = 12;

  void allocate()
  {
    tree.wordsAParticle_ = static_cast<std::size_t>(3 + tree.ownRadii_ + tree.indexWords_);
    tree.words_.resize(tree.count_ * tree.wordsAParticle_);
    tree.axes_.resize((tree.count_ / 2 + 3) / 4);
    std::fill(tree.axes_.begin(), tree.axes_.end(), std::uint8_t{0});
  }
  void* room() { return tree.words_.data(); }

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

  std::uint32_t keyOf(double v, int axis) const
  {
    return toKey(static_cast<float>((v - tree.origin_[axis]) / tree.unit_));
  }

  int axisFor(const KdRegion& region, int depth) const
  {
    if (options.split == PkdTreeOptions::Split::RoundRobin)
      return depth % 3;
    return longestSide(
      [&](int k)
      {
        const auto side = static_cast<std::size_t>(k);
        return fromKey(region.high[side]) - fromKey(region.low[side]);
      });
  }

  void setAxis(std::size_t node, int axis)
  {
    std::atomic_ref<std::uint8_t> four(tree.axes_[node / 4]);
    four.fetch_or(static_cast<std::uint8_t>(axis << (2 * (node % 4))), std::memory_order_relaxed);
  }

  template <int WORDS>
  void split(KdRecord<WORDS>* all, const KdRegion& region)
  {
    splitNode(all, all + tree.count_, 0, 0, region);
  }

  /// Sorts the subtree of the node, whose records stand at [first, last).
  template <int WORDS>
  void splitNode(KdRecord<WORDS>* first, KdRecord<WORDS>* last, std::size_t node, int depth,
    const KdRegion& region)
  {
    const auto count = static_cast<std::size_t>(last - first);
    if (count < 2 || progress.stopped())
      return;
    KdRecord<WORDS>* middle = first + leftSubtreeSize(count);
    const KdSplit split = splitAtMedian(
      first, middle, last, region, [&](const KdRegion& tight) { return axisFor(tight, depth); });
    setAxis(node, split.axis);
    const auto below = [&] { splitNode(first, middle, 2 * node + 1, depth + 1, split.lower); };
    const auto above = [&] { splitNode(middle + 1, last, 2 * node + 2, depth + 1, split.upper); };
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
    if (const auto count = static_cast<std::size_t>(size); count <= serialCount)
      tellSorted(count);
  }

  template <int WORDS>
  void finish(KdRecord<WORDS>* all)
  {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tree.count_, serialCount),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
          for (std::size_t k = 0; k < 3; ++k)
            all[i].words[k] = std::bit_cast<std::uint32_t>(fromKey(all[i].words[k]));
      });
    HeapOrder<KdRecord<WORDS>>::run(all, tree.count_);
    findRadii();
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
};

void PkdPaperTree::build(
  const ParticleSet& particles, const PkdPaperTreeOptions& options, const Progress& progress)
{
  buildOrClear([this] { clear(); },
    [&] {
      return Builder{{*this, particles, options, SharedProgress(progress)}}.run();
    });
}

} // namespace mote
