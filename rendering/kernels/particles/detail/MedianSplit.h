#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace mote
{

/// A particle while a k-d tree sorts it: three coordinates, and whatever else belongs to it.
template <int WORDS>
struct KdRecord
{
  std::array<std::uint32_t, WORDS> words;

  std::uint32_t operator[](int k) const { return words[static_cast<std::size_t>(k)]; }
};

/// Orders records by one coordinate, then by the others, then by all else: a total order, but for
/// records that are the same.
struct KdLess
{
  int axis;

  template <int WORDS>
  bool operator()(const KdRecord<WORDS>& a, const KdRecord<WORDS>& b) const
  {
    if (a[axis] != b[axis])
      return a[axis] < b[axis];
    const int next = axis == 2 ? 0 : axis + 1, last = axis == 0 ? 2 : axis - 1;
    if (a[next] != b[next])
      return a[next] < b[next];
    if (a[last] != b[last])
      return a[last] < b[last];
    for (int k = 3; k < WORDS; ++k)
      if (a[k] != b[k])
        return a[k] < b[k];
    return false;
  }
};

/// Puts the records at [first, last) that lie below `bound` along the axis before the others;
/// returns where the others begin. In place and, within large ranges, in parallel; the order that
/// results does not depend on the number of threads.
template <int WORDS>
class KdPartition
{
public:
  using Record = KdRecord<WORDS>;

  static Record* run(Record* first, Record* last, int axis, std::uint64_t bound)
  {
    const auto count = static_cast<std::size_t>(last - first);
    return count < 2 * chunk ? serial(first, last, axis, bound)
                             : parallel(first, count, axis, bound);
  }

  static constexpr std::size_t chunk = std::size_t{1} << 17; ///< records a task

private:
  /// From both ends, a few records at a time: first those that are on the wrong side are noted,
  /// then they are exchanged. So no branch depends on a single record, where a wrong guess would
  /// cost as much as ten records.
  static Record* serial(Record* first, Record* last, int axis, std::uint64_t bound)
  {
    constexpr std::ptrdiff_t few = 128;
    std::uint8_t others[few], lower[few]; // of the records from `first` on; before `last`
    std::ptrdiff_t othersBegin = 0, othersEnd = 0, lowerBegin = 0, lowerEnd = 0;
    while (last - first >= 2 * few)
    {
      if (othersBegin == othersEnd)
      {
        othersBegin = othersEnd = 0;
        for (std::ptrdiff_t i = 0; i < few; ++i)
        {
          others[othersEnd] = static_cast<std::uint8_t>(i);
          othersEnd += first[i][axis] >= bound;
        }
      }
      if (lowerBegin == lowerEnd)
      {
        lowerBegin = lowerEnd = 0;
        for (std::ptrdiff_t i = 0; i < few; ++i)
        {
          lower[lowerEnd] = static_cast<std::uint8_t>(i);
          lowerEnd += last[-1 - i][axis] < bound;
        }
      }
      const std::ptrdiff_t n = std::min(othersEnd - othersBegin, lowerEnd - lowerBegin);
      for (std::ptrdiff_t k = 0; k < n; ++k)
        std::swap(first[others[othersBegin + k]], last[-1 - lower[lowerBegin + k]]);
      othersBegin += n;
      lowerBegin += n;
      if (othersBegin == othersEnd)
        first += few;
      if (lowerBegin == lowerEnd)
        last -= few;
    }
    return oneByOne(first, last, axis, bound);
  }

  static Record* oneByOne(Record* first, Record* last, int axis, std::uint64_t bound)
  {
    Record* below = first;
    for (Record* i = first; i != last; ++i)
    {
      const Record moved = *i;
      *i = *below;
      *below = moved;
      below += moved[axis] < bound;
    }
    return below;
  }

  /// Parts every chunk, and exchanges what lies on the wrong side of the whole.
  static Record* parallel(Record* first, std::size_t count, int axis, std::uint64_t bound)
  {
    const std::size_t chunks = (count + chunk - 1) / chunk;
    std::vector<std::size_t> below(chunks);
    const auto begin = [&](std::size_t c) { return std::min(count, c * chunk); };
    tbb::parallel_for(std::size_t{0}, chunks,
      [&](std::size_t c)
      {
        below[c] = static_cast<std::size_t>(
          serial(first + begin(c), first + begin(c + 1), axis, bound) - first);
      });
    std::size_t middle = 0;
    for (std::size_t c = 0; c < chunks; ++c)
      middle += below[c] - begin(c);
    using Runs = std::vector<std::pair<std::size_t, std::size_t>>;
    Runs early, late; // others before the middle, and what lies below the bound after it
    for (std::size_t c = 0; c < chunks; ++c)
    {
      const std::size_t from = below[c], to = std::min(begin(c + 1), middle);
      if (from < to)
        early.emplace_back(from, to);
      if (const std::size_t start = std::max(begin(c), middle); start < below[c])
        late.emplace_back(start, below[c]);
    }
    exchange(first, early, late);
    return first + middle;
  }

  template <typename Runs>
  static void exchange(Record* first, Runs& early, Runs& late)
  {
    struct Pair
    {
      std::size_t a, b, count;
    };
    std::vector<Pair> pairs;
    for (std::size_t i = 0, j = 0; i < early.size() && j < late.size();)
    {
      auto& [a, aEnd] = early[i];
      auto& [b, bEnd] = late[j];
      const std::size_t n = std::min({aEnd - a, bEnd - b, chunk / 4});
      pairs.push_back({a, b, n});
      a += n;
      b += n;
      i += a == aEnd;
      j += b == bEnd;
    }
    tbb::parallel_for(std::size_t{0}, pairs.size(),
      [&](std::size_t k)
      {
        const Pair& p = pairs[k];
        std::swap_ranges(first + p.a, first + p.a + p.count, first + p.b);
      });
  }
};

/// Puts the records at [first, last) in such an order that by KdLess none at [first, middle) comes
/// after one at [middle, last), and none after `middle` before that at `middle`. All their
/// coordinates along the axis lie in [low, high].
///
/// Histograms find the median: what lies in other bins than the median's is moved once, whatever
/// its order.
template <int WORDS>
class MedianSplit
{
public:
  using Record = KdRecord<WORDS>;

  static void run(
    Record* first, Record* middle, Record* last, int axis, std::uint32_t low, std::uint32_t high)
  {
    while (last - first > few && low < high)
    {
      const int shift = shiftOf(high - low);
      const auto counts = histogram(first, last, axis, low, shift);
      auto before = static_cast<std::uint64_t>(middle - first);
      std::uint32_t bin = 0;
      for (; before >= counts[bin]; ++bin)
        before -= counts[bin];
      const std::uint64_t binLow = low + (std::uint64_t{bin} << shift);
      const std::uint64_t binHigh = binLow + (std::uint64_t{1} << shift);
      if (bin > 0)
        first = KdPartition<WORDS>::run(first, last, axis, binLow);
      last = KdPartition<WORDS>::run(first, last, axis, binHigh);
      low = std::max(low, static_cast<std::uint32_t>(binLow));
      high = std::min(high, static_cast<std::uint32_t>(std::min<std::uint64_t>(binHigh - 1, high)));
      if (first == middle)
      {
        std::iter_swap(middle, std::min_element(middle, last, KdLess{axis}));
        return;
      }
    }
    if (middle != last)
      std::nth_element(first, middle, last, KdLess{axis});
  }

private:
  static constexpr int binBits = 9;
  static constexpr std::ptrdiff_t few = 32;
  using Counts = std::array<std::uint64_t, std::size_t{1} << binBits>;

  static int shiftOf(std::uint32_t extent)
  {
    int shift = 0;
    while ((extent >> shift) >= (std::uint32_t{1} << binBits))
      ++shift;
    return shift;
  }

  static Counts histogram(
    const Record* first, const Record* last, int axis, std::uint32_t low, int shift)
  {
    const auto count = static_cast<std::size_t>(last - first);
    constexpr std::size_t chunk = KdPartition<WORDS>::chunk;
    const auto add = [&](std::size_t from, std::size_t to, Counts& counts)
    {
      std::array<std::uint32_t, std::size_t{1} << binBits> part{};
      for (std::size_t i = from; i < to; ++i)
        ++part[(first[i][axis] - low) >> shift];
      for (std::size_t k = 0; k < part.size(); ++k)
        counts[k] += part[k];
    };
    Counts counts{};
    if (count < 2 * chunk)
    {
      add(0, count, counts);
      return counts;
    }
    std::vector<Counts> parts((count + chunk - 1) / chunk, Counts{});
    tbb::parallel_for(std::size_t{0}, parts.size(),
      [&](std::size_t c) { add(c * chunk, std::min(count, (c + 1) * chunk), parts[c]); });
    for (const Counts& part : parts)
      for (std::size_t k = 0; k < counts.size(); ++k)
        counts[k] += part[k];
    return counts;
  }
};

} // namespace mote
