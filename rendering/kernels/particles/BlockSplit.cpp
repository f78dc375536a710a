// Splitting some thousand records at a time, compiled once for every SIMD instruction set.

#include "detail/BlockSplit.h"

#include "../core/RawVector.h"

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "particles/BlockSplit.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// The records of a block, a row for each of their words, so that an instruction compares many.
///
/// A range lies in one of two sets of rows. What is below its median is moved together where it
/// is, the rest to the other set. Both are written whole vectors at a time, beyond their ends, and
/// therefore the upper part is finished before the lower is begun.
template <int WORDS>
class BlockSplitter
{
  using Record = KdRecord<WORDS>;
  using D = hn::ScalableTag<std::int32_t>;
  using V = hn::Vec<D>;

public:
  explicit BlockSplitter(KdBlock<WORDS>& block)
    : block_(block)
    , rows_(rowsOfThread())
  {
  }

  void run()
  {
    for (std::size_t i = 0; i < block_.count; ++i)
      set(0, i, block_.first[i]);
    split(0, block_.count, block_.size, block_.axis, 0);
  }

private:
  static constexpr std::size_t padding = 64; ///< more than a vector has lanes
  static constexpr std::size_t stride = blockCapacity + padding;
  /// Coordinates are kept less this, so that signed numbers, which every machine compares, have
  /// their order.
  static constexpr std::uint32_t bias = 0x80000000u;

  /// Bounds of coordinates, both ends included.
  struct Region
  {
    std::int32_t low[3], high[3];

    std::uint32_t extent(int k) const
    {
      return static_cast<std::uint32_t>(high[k]) - static_cast<std::uint32_t>(low[k]);
    }
    int longest() const
    {
      int axis = 0;
      for (int k = 1; k < 3; ++k)
        if (extent(k) > extent(axis))
          axis = k;
      return axis;
    }
  };

  static std::int32_t* rowsOfThread()
  {
    static thread_local RawVector<std::int32_t> rows;
    rows.resize(std::size_t{2} * WORDS * stride);
    return rows.data();
  }

  std::int32_t* row(int set, int word) const
  {
    return rows_ + static_cast<std::size_t>(set * WORDS + word) * stride;
  }

  void set(int to, std::size_t i, const Record& record) const
  {
    for (int k = 0; k < WORDS; ++k)
      row(to, k)[i] =
        static_cast<std::int32_t>(record.words[static_cast<std::size_t>(k)] ^ (k < 3 ? bias : 0u));
  }

  Record get(int from, std::size_t i) const
  {
    Record record;
    for (int k = 0; k < WORDS; ++k)
      record.words[static_cast<std::size_t>(k)] =
        static_cast<std::uint32_t>(row(from, k)[i]) ^ (k < 3 ? bias : 0u);
    return record;
  }

  /// Calls visit(i, mask) for the vectors that cover [first, last).
  template <typename Visit>
  static HWY_INLINE void forVectors(std::size_t first, std::size_t last, const Visit& visit)
  {
    const D d;
    const std::size_t lanes = hn::Lanes(d);
    std::size_t i = first;
    for (; i + lanes <= last; i += lanes)
      visit(i, hn::FirstN(d, lanes));
    if (i < last)
      visit(i, hn::FirstN(d, last - i));
  }

  Region regionOf(std::size_t first, std::size_t last, int from) const
  {
    const D d;
    Region region;
    for (int k = 0; k < 3; ++k)
    {
      const std::int32_t* keys = row(from, k);
      V low = hn::Set(d, keys[first]), high = low;
      forVectors(first, last,
        [&](std::size_t i, auto some)
        {
          const V v = hn::IfThenElse(some, hn::LoadU(d, keys + i), low);
          low = hn::Min(low, v);
          high = hn::Max(high, v);
        });
      region.low[k] = hn::GetLane(hn::MinOfLanes(d, low));
      region.high[k] = hn::GetLane(hn::MaxOfLanes(d, high));
    }
    return region;
  }

  static std::size_t countBelow(
    const std::int32_t* keys, std::size_t first, std::size_t last, std::int32_t bound)
  {
    const D d;
    const V limit = hn::Set(d, bound);
    std::size_t count = 0;
    forVectors(first, last,
      [&](std::size_t i, auto some)
      { count += hn::CountTrue(d, hn::And(some, hn::Lt(hn::LoadU(d, keys + i), limit))); });
    return count;
  }

  /// The least of keys that are not below `bound`, of which there are some.
  static std::int32_t leastFrom(
    const std::int32_t* keys, std::size_t first, std::size_t last, std::int32_t bound)
  {
    const D d;
    const V limit = hn::Set(d, bound);
    V least = hn::Set(d, std::numeric_limits<std::int32_t>::max());
    forVectors(first, last,
      [&](std::size_t i, auto some)
      {
        const V v = hn::LoadU(d, keys + i);
        const auto above = hn::AndNot(hn::Lt(v, limit), some);
        least = hn::Min(least, hn::IfThenElse(above, v, least));
      });
    return hn::GetLane(hn::MinOfLanes(d, least));
  }

  /// The key that `rank` of the keys come before; all lie in [low, high]. Counting what lies below
  /// a guess is so fast that some guesses between two known ranks beat moving anything.
  static std::int32_t select(const std::int32_t* keys, std::size_t first, std::size_t last,
    std::size_t rank, std::int32_t low, std::int32_t high)
  {
    constexpr int guesses = 12; ///< after which the interval is halved each time
    std::size_t below = 0, upTo = last - first;
    for (int round = 0; low < high; ++round)
    {
      if (rank == below)
        return leastFrom(keys, first, last, low);
      const auto extent = static_cast<std::uint32_t>(high) - static_cast<std::uint32_t>(low);
      const float part = round < guesses ? (static_cast<float>(rank - below) + 0.5f) /
                                             static_cast<float>(upTo - below)
                                         : 0.5f;
      const auto step = std::min(
        static_cast<std::uint32_t>(static_cast<float>(extent) * (part * 0.9999f)), extent - 1);
      const auto guess = static_cast<std::int32_t>(static_cast<std::uint32_t>(low) + step + 1);
      const std::size_t count = countBelow(keys, first, last, guess);
      if (count <= rank)
      {
        low = guess;
        below = count;
      }
      else
      {
        high = guess - 1;
        upTo = count;
      }
    }
    return low;
  }

  /// Splits what belongs to children of `size` records each, until there is one, and that into its
  /// own, down to buckets, which go back to where the block's records were.
  void split(std::size_t first, std::size_t last, std::size_t size, int axis, int from)
  {
    const std::size_t children = (last - first + size - 1) / size;
    if (children <= 1 && size <= block_.bucket)
    {
      for (std::size_t i = first; i < last; ++i)
        block_.first[i] = get(from, i);
      return;
    }
    if (children <= 1)
      return descend(first, last, size / block_.fanout, axis, from);
    splitInTwo(first, last, size, axis, from, regionOf(first, last, from));
  }

  /// One child becomes its own children.
  void descend(std::size_t first, std::size_t last, std::size_t size, int axis, int from)
  {
    if (size != block_.bucket)
      return split(first, last, size, axis, from);
    const Region region = regionOf(first, last, from);
    block_.treeletExtent = std::max(block_.treeletExtent, region.extent(region.longest()));
    if (last - first <= size)
      return split(first, last, size, axis, from);
    splitInTwo(first, last, size, axis, from, region);
  }

  void splitInTwo(
    std::size_t first, std::size_t last, std::size_t size, int axis, int from, const Region& region)
  {
    if (block_.byExtent)
      axis = region.longest();
    const std::size_t middle = first + (last - first + size - 1) / size / 2 * size;
    const std::int32_t* keys = row(from, axis);
    const std::int32_t median =
      select(keys, first, last, middle - first, region.low[axis], region.high[axis]);
    if (countBelow(keys, first, last, median) == middle - first)
      part(first, last, middle, axis, from, median);
    else
      partTies(first, last, middle, axis, from);
    const int next = axis == 2 ? 0 : axis + 1;
    split(middle, last, size, next, 1 - from);
    split(first, middle, size, next, from);
  }

  void part(std::size_t first, std::size_t last, std::size_t middle, int axis, int from,
    std::int32_t median) const
  {
    const D d;
    const V limit = hn::Set(d, median);
    const std::int32_t* keys = row(from, axis);
    std::size_t lower = first, upper = middle;
    forVectors(first, last,
      [&](std::size_t i, auto some)
      {
        const auto below = hn::Lt(hn::LoadU(d, keys + i), limit);
        const auto low = hn::And(some, below), high = hn::AndNot(below, some);
        for (int k = 0; k < WORDS; ++k)
        {
          const V v = hn::LoadU(d, row(from, k) + i);
          // Into a register first: straight into memory takes some processors ten times as long.
          hn::StoreU(hn::Compress(v, high), d, row(1 - from, k) + upper);
          hn::StoreU(hn::Compress(v, low), d, row(from, k) + lower);
        }
        const std::size_t count = hn::CountTrue(d, low);
        lower += count;
        upper += hn::CountTrue(d, some) - count;
      });
  }

  /// The same where others have the median's coordinate: the whole records decide.
  void partTies(std::size_t first, std::size_t last, std::size_t middle, int axis, int from) const
  {
    std::vector<Record> records(last - first);
    for (std::size_t i = first; i < last; ++i)
      records[i - first] = get(from, i);
    std::nth_element(records.begin(), records.begin() + static_cast<std::ptrdiff_t>(middle - first),
      records.end(), KdLess{axis});
    for (std::size_t i = first; i < last; ++i)
      set(i < middle ? from : 1 - from, i, records[i - first]);
  }

  KdBlock<WORDS>& block_;
  std::int32_t* rows_;
};

void splitBlock3(KdBlock<3>& block)
{
  BlockSplitter<3>(block).run();
}
void splitBlock4(KdBlock<4>& block)
{
  BlockSplitter<4>(block).run();
}
void splitBlock5(KdBlock<5>& block)
{
  BlockSplitter<5>(block).run();
}
void splitBlock6(KdBlock<6>& block)
{
  BlockSplitter<6>(block).run();
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote
{

HWY_EXPORT(splitBlock3);
HWY_EXPORT(splitBlock4);
HWY_EXPORT(splitBlock5);
HWY_EXPORT(splitBlock6);

void splitBlock(KdBlock<3>& block)
{
  HWY_DYNAMIC_DISPATCH(splitBlock3)(block);
}
void splitBlock(KdBlock<4>& block)
{
  HWY_DYNAMIC_DISPATCH(splitBlock4)(block);
}
void splitBlock(KdBlock<5>& block)
{
  HWY_DYNAMIC_DISPATCH(splitBlock5)(block);
}
void splitBlock(KdBlock<6>& block)
{
  HWY_DYNAMIC_DISPATCH(splitBlock6)(block);
}

} // namespace mote

#endif
