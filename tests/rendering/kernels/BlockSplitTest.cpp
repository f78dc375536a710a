// Splitting a block at once is splitting it one median after another.

#include <kernels/particles/detail/BlockSplit.h>

#include <support/Particles.h>
#include <support/Targets.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr std::size_t bucket = 16, fanout = 16;

template <int WORDS>
using Records = std::vector<KdRecord<WORDS>>;

template <int WORDS>
Records<WORDS> randomRecords(std::size_t count, std::uint32_t values)
{
  Random random(count + values);
  Records<WORDS> records(count);
  for (auto& record : records)
    for (std::size_t k = 0; k < WORDS; ++k)
      // Sides differ, so that not every axis is as long.
      record.words[k] = static_cast<std::uint32_t>(random(0.0, double(values) / double(1 + k)));
  return records;
}

/// The textbook: sorts, and parts in the middle.
template <int WORDS>
struct Oracle
{
  Records<WORDS>& records;
  bool byExtent;
  std::uint32_t treeletExtent = 0;

  std::array<std::uint32_t, 3> extents(std::size_t first, std::size_t last) const
  {
    std::array<std::uint32_t, 3> found;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto [low, high] =
        std::minmax_element(records.begin() + long(first), records.begin() + long(last),
          [k](const auto& a, const auto& b) { return a.words[k] < b.words[k]; });
      found[k] = high->words[k] - low->words[k];
    }
    return found;
  }

  void split(std::size_t first, std::size_t last, std::size_t size, int axis)
  {
    const std::size_t children = (last - first + size - 1) / size;
    if (children <= 1)
    {
      if (size == bucket)
        return;
      const auto all = extents(first, last);
      if (size == bucket * fanout)
        treeletExtent = std::max(treeletExtent, *std::max_element(all.begin(), all.end()));
      return split(first, last, size / fanout, axis);
    }
    const auto all = extents(first, last);
    if (byExtent)
      axis = static_cast<int>(std::max_element(all.begin(), all.end()) - all.begin());
    std::sort(records.begin() + long(first), records.begin() + long(last), KdLess{axis});
    const std::size_t middle = first + children / 2 * size;
    split(first, middle, size, (axis + 1) % 3);
    split(middle, last, size, (axis + 1) % 3);
  }
};

/// Of what is in a bucket the order does not matter.
template <int WORDS>
Records<WORDS> orderedInBuckets(Records<WORDS> records)
{
  for (std::size_t first = 0; first < records.size(); first += bucket)
    std::sort(records.begin() + long(first),
      records.begin() + long(std::min(records.size(), first + bucket)), KdLess{0});
  return records;
}

template <int WORDS>
bool same(const Records<WORDS>& a, const Records<WORDS>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const auto& x, const auto& y) { return x.words == y.words; });
}

template <int WORDS>
void expectAsTheTextbook(std::size_t count, std::uint32_t values, bool byExtent)
{
  SCOPED_TRACE(std::to_string(WORDS) + " words, " + std::to_string(count) + " records, " +
               std::to_string(values) + " values");
  std::size_t size = bucket * fanout;
  while (size < count)
    size *= fanout;
  const Records<WORDS> input = randomRecords<WORDS>(count, values);
  Records<WORDS> wanted = input;
  Oracle<WORDS> oracle{wanted, byExtent};
  oracle.split(0, count, size, 1);
  Records<WORDS> first;
  for (const std::int64_t target : everyTarget())
  {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnlyTargets only(target);
    Records<WORDS> records = input;
    KdBlock<WORDS> block{records.data(), count, size, bucket, fanout, byExtent, 1};
    splitBlock(block);
    ASSERT_TRUE(same(orderedInBuckets(records), orderedInBuckets(wanted)));
    EXPECT_EQ(block.treeletExtent, oracle.treeletExtent);
    if (first.empty())
      first = records;
    ASSERT_TRUE(same(records, first)) << "the order in a bucket depends on the instruction set";
  }
}

template <int WORDS>
void expectAsTheTextbook()
{
  for (const std::size_t count :
    {1u, 15u, 16u, 17u, 33u, 255u, 256u, 257u, 300u, 1000u, 4097u, unsigned(blockCapacity)})
    for (const std::uint32_t values : {1u, 2u, 60u, 4294967295u})
      expectAsTheTextbook<WORDS>(count, values, count % 3 != 0);
}

} // namespace

TEST(BlockSplit, PlacesAlone)
{
  expectAsTheTextbook<3>();
}

TEST(BlockSplit, WithOneNumberMore)
{
  expectAsTheTextbook<4>();
}

TEST(BlockSplit, WithTwoNumbersMore)
{
  expectAsTheTextbook<5>();
}

TEST(BlockSplit, WithThreeNumbersMore)
{
  expectAsTheTextbook<6>();
}
