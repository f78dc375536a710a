#include "PkdTree.h"

#include "../core/Error.h"
#include "../core/ScratchSpace.h"
#include "detail/BlockSplit.h"
#include "detail/BuildOrClear.h"
#include "detail/KdBuild.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <atomic>
#include <bit>
#include <cmath>
#include <sstream>

namespace mote
{

/// One build of one tree: turns coordinates into whole numbers, splits the particles in place, and
/// makes of each bucket its rows and of each node its bounds.
struct PkdTree::Builder : KdBuilder<PkdTree>
{
  using Form = PkdTreeOptions::Form;

  /// Where particles lie, in whole numbers.
  using Region = KdRegion;

  static constexpr double sortedShare = 0.9;                ///< of the work
  static constexpr double middleKey = 2147483648.0;         ///< of origin(): 2^31
  static constexpr int coarseBits = 10;                     ///< corners of treelets leave these 0
  static constexpr std::size_t serialCount = blockCapacity; ///< particles that are one task
  static constexpr std::size_t longCount = 1 << 24;         ///< particles that take long to split

  double keyStep = 1.0; ///< between neighbouring whole numbers, in the input's unit: a power of two
  double keysPerLength = 1.0; ///< 1 / keyStep
  double unitsAKey = 1.0;
  Row* finished = nullptr;                     ///< what the traversal reads
  int roundedBits = 0;                         ///< low bits that coordinates lose in the end
  std::atomic<std::uint32_t> treeletExtent{0}; ///< the largest, in whole numbers

  void allocate()
  {
    const ParticleStatistics& s = tree.statistics_;
    const Vec3d size = s.centers.size();
    const double extent = std::max({size.x, size.y, size.z, s.largestRadius});
    keyStep = std::exp2(std::ceil(std::log2(extent / (4294967296.0 - 8192.0))));
    keysPerLength = 1.0 / keyStep;
    unitsAKey = keyStep / tree.unit_;
    tree.coarse_ = static_cast<float>(unitsAKey * (1 << coarseBits));
    tree.rowsABucket_ = static_cast<std::size_t>(3 + tree.ownRadii_ + tree.indexWords_);
    this->reserve(tree.nodes_, planLevels(tree.count_, tree.levels_));
    this->reserve(tree.rows_, tree.buckets() * tree.rowsABucket_);
  }

  template <typename T>
  void reserve(StoredArray<T>& array, std::size_t size) const
  {
    array.resize(size, options.space ? options.space->allocate(size * sizeof(T)) : nullptr);
  }

  void* room() { return tree.rows_.own(); }

  template <int WORDS>
  KdRecord<WORDS>* records()
  {
    return static_cast<KdRecord<WORDS>*>(room());
  }

  std::uint32_t keyOf(double v, int axis) const
  {
    return static_cast<std::uint32_t>((v - tree.origin_[axis]) * keysPerLength + (middleKey + 0.5));
  }

  // Splitting.

  template <int WORDS>
  void split(KdRecord<WORDS>*, const Region& region)
  {
    std::size_t size = bucketSize;
    while (size < tree.count_)
      size *= fanout;
    splitNode<WORDS>(0, tree.count_, std::max(size, treeletSize), region, 0);
  }

  /// Splits what belongs to `children` whole children of `size` particles each (the last may have
  /// less) until there is one, and that into its own children.
  template <int WORDS>
  void splitNode(
    std::size_t first, std::size_t last, std::size_t size, const Region& region, int axis)
  {
    if (progress.stopped())
      return;
    const std::size_t count = last - first;
    if (count <= serialCount)
      return finishSplit<WORDS>(first, count, size, axis);
    const std::size_t children = (count + size - 1) / size;
    if (children <= 1)
      return splitNode<WORDS>(first, last, size / fanout, region, axis);
    if (count >= longCount && !progress.report(0.0))
      return;
    KdRecord<WORDS>* from = records<WORDS>();
    const std::size_t middle = first + children / 2 * size;
    const KdSplit split = splitAtMedian(from + first, from + middle, from + last, region,
      [&](const Region& tight)
      {
        if (options.split == PkdTreeOptions::Split::RoundRobin)
          return axis;
        return longestSide(
          [&](int k) {
            return tight.high[static_cast<std::size_t>(k)] - tight.low[static_cast<std::size_t>(k)];
          });
      });
    const int next = split.axis == 2 ? 0 : split.axis + 1;
    tbb::parallel_invoke([&] { splitNode<WORDS>(first, middle, size, split.lower, next); },
      [&] { splitNode<WORDS>(middle, last, size, split.upper, next); });
  }

  /// Splits all that is left to split of a few thousand particles.
  template <int WORDS>
  void finishSplit(std::size_t first, std::size_t count, std::size_t size, int axis)
  {
    KdBlock<WORDS> block{records<WORDS>() + first, count, size, bucketSize, fanout,
      options.split == PkdTreeOptions::Split::MaximumExtent, axis};
    splitBlock(block);
    std::uint32_t largest = treeletExtent;
    while (block.treeletExtent > largest &&
           !treeletExtent.compare_exchange_weak(largest, block.treeletExtent))
    {
    }
    tellSorted(count);
  }

  // What the traversal reads.

  template <int WORDS>
  void chooseStep()
  {
    // Local coordinates need so many bits at most; the corner may lie so much before the treelet.
    const int bits = options.form == Form::Bytes8 ? 20 : 24;
    const std::uint64_t extent = std::uint64_t{treeletExtent} + (1u << coarseBits);
    roundedBits = std::max(0, static_cast<int>(std::bit_width(extent)) - bits);
    if (options.form == Form::Bytes4)
    {
      // Of 511 steps some are lost to rounding. All places are less than 2^24 steps from origin():
      // sums of them are exact in float.
      const double steps = bucketReach<WORDS>() / unitsAKey / 505.0;
      roundedBits = std::max(coarseBits, static_cast<int>(std::ceil(std::log2(steps))));
    }
    tree.step_ = std::ldexp(keyStep, roundedBits);
    if (options.form != Form::Exact)
      checkError();
  }

  void checkError() const
  {
    const double error = tree.positionError(), radius = tree.statistics_.smallestRadius;
    if (!(error > options.mostError * radius))
      return;
    std::ostringstream text;
    text.precision(3);
    text << "The form " << pkdTreeFormNames()[static_cast<std::size_t>(options.form)]
         << " of a P-k-d tree would move particles by up to " << error << ", more than "
         << 100.0 * options.mostError << " % of the smallest radius, " << radius << ".";
    throw Error(text.str());
  }

  /// How far a particle may lie from the middle of its bucket's bounds, along an axis and before
  /// anything is rounded to steps, in unit().
  template <int WORDS>
  double bucketReach()
  {
    return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, tree.levels_[0].count, 16), 0.0,
      [&](const tbb::blocked_range<std::size_t>& treelets, double reach)
      {
        for (std::size_t t = treelets.begin(); t != treelets.end(); ++t)
        {
          Bounds all;
          std::array<double, 3> inBuckets{};
          forBuckets(t,
            [&](std::size_t, std::size_t first, std::size_t count)
            {
              const Bounds bounds = boundsOf<WORDS>(first, count);
              all.add(bounds);
              const Region region(records<WORDS>() + first, records<WORDS>() + first + count);
              for (std::size_t k = 0; k < 3; ++k)
              {
                const double middle = 0.5 * (bounds.lower[k] + bounds.upper[k]);
                inBuckets[k] = std::max({inBuckets[k], middle - placeOfKey(region.low[k]),
                  placeOfKey(region.high[k]) - middle});
              }
            });
          // Bounds in 8 bits move the middle by up to half their step.
          for (std::size_t k = 0; k < 3; ++k)
            reach = std::max(reach, inBuckets[k] + (all.upper[k] - all.lower[k]) / 254.0);
        }
        return reach;
      },
      [](double a, double b) { return std::max(a, b); });
  }

  /// Calls visit(child, first, count) for the buckets of a treelet.
  template <typename Visit>
  void forBuckets(std::size_t treelet, const Visit& visit) const
  {
    std::size_t first = treelet * treeletSize;
    const std::size_t last = std::min(tree.count_, first + treeletSize);
    for (std::size_t b = 0; first < last; ++b, first += bucketSize)
      visit(b, first, std::min<std::size_t>(bucketSize, last - first));
  }

  double placeOfKey(std::uint64_t key) const
  {
    return (static_cast<double>(key) - middleKey) * unitsAKey;
  }

  std::uint64_t rounded(std::uint32_t key) const
  {
    const std::uint64_t half = roundedBits > 0 ? std::uint64_t{1} << (roundedBits - 1) : 0;
    return (key + half) >> roundedBits << roundedBits;
  }

  template <int WORDS>
  void finishTreelet(std::size_t treelet, Bounds& bounds)
  {
    Node& node = tree.nodes_.own()[tree.levels_[0].first + treelet];
    const std::size_t first = treelet * treeletSize;
    const std::size_t last = std::min(tree.count_, first + treeletSize);
    const Region region(records<WORDS>() + first, records<WORDS>() + last);
    std::array<std::uint64_t, 3> corner;
    for (std::size_t k = 0; k < 3; ++k)
    {
      corner[k] = rounded(region.low[k]) >> coarseBits << coarseBits;
      node.corner[k] = static_cast<float>(placeOfKey(corner[k]));
    }
    std::array<Bounds, fanout> children;
    forBuckets(treelet,
      [&](std::size_t b, std::size_t from, std::size_t count)
      {
        children[b] = boundsOf<WORDS>(from, count);
        bounds.add(children[b]);
      });
    setBounds(node, bounds, children, marginOfSet,
      options.form == Form::Bytes4 ? tree.step_ / tree.unit_ : 0.0);
    forBuckets(treelet, [&](std::size_t b, std::size_t from, std::size_t count)
      { finishBucket<WORDS>(from, count, corner, node, b); });
  }

  template <int WORDS>
  Bounds boundsOf(std::size_t first, std::size_t count)
  {
    Bounds bounds;
    for (std::size_t i = first; i < first + count; ++i)
      addTo(bounds, records<WORDS>()[i]);
    return bounds;
  }

  template <int WORDS>
  void addTo(Bounds& bounds, const KdRecord<WORDS>& record) const
  {
    float r = tree.radius_;
    if constexpr (WORDS > 3)
      r = tree.ownRadii_ ? std::bit_cast<float>(record.words[3]) : r;
    Vec3d center;
    for (int k = 0; k < 3; ++k)
      center[k] = placeOfKey(rounded(record[k]));
    bounds.add(center, double(r));
  }

  /// The words of a place in its bucket, as many as there are rows of them.
  template <int WORDS>
  std::array<std::uint32_t, 3> placeOf(const KdRecord<WORDS>& record,
    const std::array<std::uint64_t, 3>& corner, const Node& treelet, std::size_t bucket) const
  {
    std::array<std::uint64_t, 3> keys;
    for (std::size_t k = 0; k < 3; ++k)
      keys[k] = rounded(record.words[k]) - corner[k];
    std::array<std::uint32_t, 3> words{};
    const auto steps = [&](std::size_t k) {
      return static_cast<std::uint32_t>(std::min<std::uint64_t>(keys[k] >> roundedBits, 0xfffff));
    };
    if (options.form == Form::Bytes8)
      return {steps(0) | steps(2) << 20, steps(1) | steps(2) >> 12 << 20, 0};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double place = static_cast<double>(keys[k]) * unitsAKey;
      if (options.form == Form::Exact)
      {
        words[k] = std::bit_cast<std::uint32_t>(static_cast<float>(place));
        continue;
      }
      const double from = (place - double(treelet.middle(k, bucket))) * tree.unit_ / tree.step_;
      const auto whole = static_cast<std::int32_t>(std::clamp(from, -512.0, 511.0));
      words[0] |= (static_cast<std::uint32_t>(whole) & 0x3ffu) << (10 * k);
    }
    return words;
  }

  /// Turns records into rows.
  template <int WORDS>
  void finishBucket(std::size_t first, std::size_t count,
    const std::array<std::uint64_t, 3>& corner, const Node& treelet, std::size_t bucket)
  {
    std::array<KdRecord<WORDS>, bucketSize> copy;
    std::copy_n(records<WORDS>() + first, count, copy.begin());
    Row* rows = finished + first / bucketSize * tree.rowsABucket_;
    const auto places = static_cast<std::size_t>(tree.placeRows_);
    for (std::size_t i = 0; i < bucketSize; ++i)
    {
      // A place that nothing takes is not a number; rays know how many the last bucket has.
      std::array<std::uint32_t, 3> place;
      place.fill(std::bit_cast<std::uint32_t>(std::numeric_limits<float>::quiet_NaN()));
      if (i < count)
        place = placeOf(copy[i], corner, treelet, bucket);
      for (std::size_t k = 0; k < places; ++k)
        rows[k].words[i] = place[k];
      for (std::size_t k = 3; k < WORDS; ++k)
        rows[places + k - 3].words[i] = i < count ? copy[i].words[k] : place[2];
    }
  }

  double marginOfSet = 0.0; ///< by which rays may be rounded, in unit()

  template <int WORDS>
  void finish(KdRecord<WORDS>*)
  {
    chooseStep<WORDS>();
    const bool exact = options.form == Form::Exact;
    StoredArray<Row> shortRows;
    if (!exact)
    {
      // Shorter rows end up where others' records still are: they get a place of their own.
      tree.placeRows_ = options.form == Form::Bytes8 ? 2 : 1;
      tree.rowsABucket_ -= static_cast<std::size_t>(3 - tree.placeRows_);
      this->reserve(shortRows, tree.buckets() * tree.rowsABucket_);
    }
    finished = exact ? tree.rows_.own() : shortRows.own();
    marginOfSet = tree.roundingMargin();
    std::vector<Bounds> below(tree.levels_[0].count);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, below.size(), 16),
      [&](const tbb::blocked_range<std::size_t>& treelets)
      {
        for (std::size_t t = treelets.begin(); t != treelets.end(); ++t)
          finishTreelet<WORDS>(t, below[t]);
      });
    if (!exact)
      tree.rows_ = std::move(shortRows);
    tree.boundNodes(tree.levels_, tree.nodes_.own(), std::move(below), marginOfSet);
    tree.findRepeats();
  }
};

void PkdTree::build(
  const ParticleSet& particles, const PkdTreeOptions& options, const Progress& progress)
{
  sparseShare_ = options.sparseShare;
  buildOrClear([this] { clear(); },
    [&] {
      return Builder{{*this, particles, options, SharedProgress(progress)}}.run();
    });
}

} // namespace mote
