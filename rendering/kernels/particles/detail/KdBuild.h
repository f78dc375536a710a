#pragma once

#include "../../core/Progress.h"
#include "../ParticleSet.h"
#include "MedianSplit.h"

#include <tbb/parallel_for.h>

#include <atomic>
#include <bit>
#include <limits>
#include <numeric>

namespace mote
{

/// Progress of a work on many threads: may be told from any of them, passes on nothing less than
/// what it passed on before, and remembers that the work shall stop.
class SharedProgress
{
public:
  explicit SharedProgress(const Progress& progress)
    : progress_(progress)
  {
  }

  /// False where the work shall stop. While somebody is told, others are not, and do not wait: who
  /// is told may work in parallel, and come here again by way of that.
  bool report(double done)
  {
    if (!progress_ || stopped_ || telling_.exchange(true))
      return !stopped_;
    reported_ = std::max(reported_, done);
    if (!stopped_ && !progress_(reported_))
      stopped_ = true;
    telling_ = false;
    return !stopped_;
  }

  bool stopped() const { return stopped_; }

private:
  const Progress& progress_;
  std::atomic<bool> telling_{false};
  double reported_ = 0.0;
  std::atomic<bool> stopped_{false};
};

/// Where records lie: bounds of their coordinates, both ends included.
struct KdRegion
{
  std::array<std::uint32_t, 3> low, high;

  KdRegion() = default;

  /// Of one record or more.
  template <int WORDS>
  KdRegion(const KdRecord<WORDS>* first, const KdRecord<WORDS>* last)
    : low{first->words[0], first->words[1], first->words[2]}
    , high(low)
  {
    for (; first != last; ++first)
      for (std::size_t k = 0; k < 3; ++k)
      {
        low[k] = std::min(low[k], first->words[k]);
        high[k] = std::max(high[k], first->words[k]);
      }
  }
};

/// Particles up to which a split is worth a look at where they lie: above, the splits before tell
/// well enough.
constexpr std::size_t tightKdCount = std::size_t{1} << 16;

/// Writes recordOf(index, position, radius) of the valid particles, `valid` in number, to `to`, in
/// parallel and in the order of the input.
template <int WORDS, typename RecordOf>
void fillKdRecords(
  const ParticleSet& particles, std::size_t valid, KdRecord<WORDS>* to, const RecordOf& recordOf)
{
  constexpr std::size_t chunk = 1 << 16;
  const std::size_t n = particles.count(), chunks = (n + chunk - 1) / chunk;
  std::vector<std::size_t> place(chunks + 1, 0);
  const auto forChunk = [&](std::size_t c, const auto& visit)
  {
    particles.forRange(c * chunk, std::min(n, (c + 1) * chunk),
      [&](std::size_t i, const Vec3d& p, double r)
      {
        if (isValidParticle(p, r))
          visit(i, p, r);
      });
  };
  for (std::size_t c = 0; c < chunks; ++c)
    place[c] = c * chunk;
  if (valid != n)
  {
    tbb::parallel_for(std::size_t{0}, chunks,
      [&](std::size_t c)
      {
        std::size_t count = 0;
        forChunk(c, [&](std::size_t, const Vec3d&, double) { ++count; });
        place[c] = count;
      });
    std::exclusive_scan(place.begin(), place.end(), place.begin(), std::size_t{0});
  }
  tbb::parallel_for(std::size_t{0}, chunks,
    [&](std::size_t c)
    {
      KdRecord<WORDS>* next = to + place[c];
      forChunk(c, [&](std::size_t i, const Vec3d& p, double r) { *next++ = recordOf(i, p, r); });
    });
}

/// The axis of the longest side, the first of those that are as long: extentOf(k) is that of side
/// k.
template <typename ExtentOf>
int longestSide(const ExtentOf& extentOf)
{
  const int axis = extentOf(1) > extentOf(0) ? 1 : 0;
  return extentOf(2) > extentOf(axis) ? 2 : axis;
}

/// How a k-d tree's records were parted.
struct KdSplit
{
  int axis;
  KdRegion lower, upper; ///< where the records before `middle` lie, and the others
};

/// Parts the records at [first, last), which lie in `region`, at `middle` as MedianSplit does,
/// across the axis axisOf(region) of the region, tightened where that is worth it.
template <int WORDS, typename AxisOf>
KdSplit splitAtMedian(KdRecord<WORDS>* first, KdRecord<WORDS>* middle, KdRecord<WORDS>* last,
  const KdRegion& region, const AxisOf& axisOf)
{
  const bool few = static_cast<std::size_t>(last - first) <= tightKdCount;
  const KdRegion tight = few ? KdRegion(first, last) : region;
  KdSplit split{axisOf(tight), tight, tight};
  const auto k = static_cast<std::size_t>(split.axis);
  MedianSplit<WORDS>::run(first, middle, last, split.axis, tight.low[k], tight.high[k]);
  split.lower.high[k] = split.upper.low[k] = (*middle)[split.axis];
  return split;
}

/// What the builds of the k-d trees have in common: the particles become records, whose coordinates
/// are whole numbers, and are sorted in the tree's own memory.
///
/// Tree::Builder derives from it. It offers keyOf(v, axis), the whole number of a coordinate, which
/// rises with it; allocate(), which makes room for the tree once its numbers are chosen; room(),
/// where the records go; split(records, region), which sorts them all and has done `sortedShare` of
/// the work then; and finish(records), which makes the tree of them.
template <typename Tree>
struct KdBuilder
{
  Tree& tree;
  const ParticleSet& particles;
  const typename Tree::Options& options;
  SharedProgress progress;
  std::atomic<std::size_t> sorted{0}; ///< particles that are in the tree's order

  static constexpr double examinedShare = 0.1, filledShare = 0.2; ///< of the work

  /// Builds the tree. False where it was stopped.
  bool run()
  {
    tree.statistics_ = examine(particles);
    if (!progress.report(examinedShare))
      return false;
    if (tree.statistics_.valid == 0)
      return true;
    chooseNumbers();
    self().allocate();
    switch (3 + tree.ownRadii_ + tree.indexWords_)
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

protected:
  /// Tells that `count` particles more are in the tree's order.
  void tellSorted(std::size_t count)
  {
    const auto done = static_cast<double>(sorted += count) / static_cast<double>(tree.count_);
    progress.report(filledShare + (self().sortedShare - filledShare) * done);
  }

private:
  auto& self() { return static_cast<typename Tree::Builder&>(*this); }
  const auto& self() const { return static_cast<const typename Tree::Builder&>(*this); }

  void chooseNumbers()
  {
    const ParticleStatistics& s = tree.statistics_;
    tree.count_ = s.valid;
    tree.placeByCells(static_cast<double>(s.valid));
    tree.radius_ = static_cast<float>(s.largestRadius / tree.unit_);
    tree.ownRadii_ = static_cast<float>(s.smallestRadius / tree.unit_) != tree.radius_;
    const bool narrow = particles.count() <= std::numeric_limits<std::uint32_t>::max();
    tree.indexWords_ = !options.keepIndices ? 0 : narrow ? 1 : 2;
  }

  template <int WORDS>
  KdRecord<WORDS> recordOf(std::size_t i, const Vec3d& p, double r) const
  {
    KdRecord<WORDS> record{};
    for (int k = 0; k < 3; ++k)
      record.words[static_cast<std::size_t>(k)] = self().keyOf(p[k], k);
    if constexpr (WORDS > 3)
      if (tree.ownRadii_)
        record.words[3] = std::bit_cast<std::uint32_t>(static_cast<float>(r / tree.unit_));
    if (tree.indexWords_ > 0)
      record.words[WORDS - 1] = static_cast<std::uint32_t>(i);
    if (tree.indexWords_ > 1) // the upper half first, as the order of records wants it
      record.words[WORDS - 2] = static_cast<std::uint32_t>(i >> 32);
    return record;
  }

  template <int WORDS>
  bool sort()
  {
    auto* all = static_cast<KdRecord<WORDS>*>(self().room());
    fillKdRecords(particles, tree.count_, all,
      [this](std::size_t i, const Vec3d& p, double r) { return recordOf<WORDS>(i, p, r); });
    if (!progress.report(filledShare))
      return false;
    KdRegion region;
    const Box& centers = tree.statistics_.centers;
    for (int k = 0; k < 3; ++k)
    {
      region.low[static_cast<std::size_t>(k)] = self().keyOf(centers.lower[k], k);
      region.high[static_cast<std::size_t>(k)] = self().keyOf(centers.upper[k], k);
    }
    self().split(all, region);
    if (!progress.report(self().sortedShare))
      return false;
    self().finish(all);
    return progress.report(1.0);
  }
};

} // namespace mote
